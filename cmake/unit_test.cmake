# mp_unit_test(ROOM SOURCES LIBRARIES): one gtest binary for a room, run by ctest.
function(mp_unit_test room)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  catkin_add_gtest(${room}_test ${ARG_SOURCES})
  target_include_directories(${room}_test PRIVATE ${PROJECT_SOURCE_DIR}/test/support)
  target_link_libraries(${room}_test ${ARG_LIBRARIES} ${PROJECT_NAME}_warnings ${GTEST_MAIN_LIBRARIES} gtest gtest_main pthread)
endfunction()
