# A Debian package of the installed tree: `cpack -G DEB` in the build folder. It goes to a prefix of its own, whose setup.bash
# is sourced like that of any catkin workspace.
if(CPack_CMake_INCLUDED)
  return()
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME mixed-palletizing)
set(CPACK_PACKAGE_VERSION ${${PROJECT_NAME}_VERSION})
set(CPACK_PACKAGE_VENDOR "${PROJECT_NAME} authors")
set(CPACK_PACKAGE_CONTACT "${PROJECT_NAME} maintainers <maintainers@mixed-palletizing.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Box detection and pick planning for mixed palletizing")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /opt/${PROJECT_NAME} CACHE STRING "Where the Debian package installs to")
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION misc)
# What nobody links: launch, nodelets, the Python programs, frames. Debian's names; on Ubuntu the ROS distribution's.
set(debian_runtime python3-roslaunch python3-rosservice rosbash libnodeletlib-tools python3-rospy python3-rosbag python3-geometry-msgs
  python3-std-msgs python3-visualization-msgs tf2-tools)
set(noetic_runtime ros-noetic-roslaunch ros-noetic-rosservice ros-noetic-rosbash ros-noetic-nodelet ros-noetic-rospy ros-noetic-rosbag ros-noetic-tf2-ros)
if(EXISTS "/opt/ros/noetic")
  list(JOIN noetic_runtime ", " CPACK_DEBIAN_PACKAGE_DEPENDS)
else()
  list(JOIN debian_runtime ", " CPACK_DEBIAN_PACKAGE_DEPENDS)
endif()
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "rviz, python3-matplotlib, python3-pil")
if(NOT CMAKE_VERSION VERSION_LESS 3.20)  # before it, our own libraries are not found
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CATKIN_DEVEL_PREFIX}/lib)
endif()
include(CPack)
