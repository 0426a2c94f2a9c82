# mp_executable(NAME SOURCE LIBRARIES...): one node or tool, installed for rosrun.
function(mp_executable name source)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE ${ARGN} ${PROJECT_NAME}_warnings)
  install(TARGETS ${name} RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
endfunction()
