# mp_unit_test(ROOM SOURCES LIBRARIES): one gtest binary for a room, run by ctest.
function(mp_unit_test room)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  catkin_add_gtest(${room}_test ${ARG_SOURCES})
  target_include_directories(${room}_test PRIVATE ${PROJECT_SOURCE_DIR}/test/support)
  target_link_libraries(${room}_test ${ARG_LIBRARIES} ${PROJECT_NAME}_warnings ${GTEST_MAIN_LIBRARIES} gtest gtest_main pthread)
endfunction()

# mp_test_program(NAME SOURCES LIBRARIES): a program that is built with the tests and run by hand or by a script.
function(mp_test_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} EXCLUDE_FROM_ALL ${ARG_SOURCES})
  target_link_libraries(${name} ${ARG_LIBRARIES} ${PROJECT_NAME}_warnings)
  add_dependencies(tests ${name})
endfunction()
