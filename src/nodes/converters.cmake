# Converters for the messages of other packages, where those are.
foreach(converter boxes_to_vision_msgs boxes_to_jsk pallet_to_moveit)
  if(TARGET ${PROJECT_NAME}_${converter})
    mp_executable(${converter} ${CMAKE_CURRENT_LIST_DIR}/${converter}.cpp ${PROJECT_NAME}_${converter})
  endif()
endforeach()
