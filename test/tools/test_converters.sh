#!/usr/bin/env bash
# Builds the converters on top of the built package with stand-ins for the messages of other packages (test/stand_ins), and runs their
# unit tests and their rostest there.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/../../scripts/lib/common.sh"
use_workspace
export ROS_LANG_DISABLE=geneus:genlisp:gennodejs
devel=$workspace/devel results=${1:-$workspace/build/test_results/converters}  # of the built package; folder for JUnit files
overlay=$workspace/converters
rm -rf "$results" "$overlay/src" "$overlay/devel/lib/mixed_palletizing"
mkdir -p "$overlay/src" "$overlay/devel/lib/mixed_palletizing" "$overlay/devel/lib/python3/dist-packages" "$results"

# manifest PACKAGE DEPENDENCIES...: its package.xml
manifest() {
  local package=$1 dependency
  shift
  cat <<XML
<package format="2">
  <name>$package</name>
  <version>0.0.0</version>
  <description>Stand-in for tests</description>
  <maintainer email="maintainers@mixed-palletizing.org">mixed_palletizing maintainers</maintainer>
  <license>BSD</license>
  <buildtool_depend>catkin</buildtool_depend>
$(for dependency in "$@"; do printf '  <depend>%s</depend>\n' "$dependency"; done)
</package>
XML
}

# messages PACKAGE DEPENDENCIES...: a package of the messages in test/stand_ins/PACKAGE
messages() {
  local package=$1 folder=$overlay/src/$1
  mkdir "$folder"
  ln -s "$root/test/stand_ins/$package/msg" "$folder/msg"
  manifest "$@" message_generation >"$folder/package.xml"
  cat >"$folder/CMakeLists.txt" <<CMAKE
cmake_minimum_required(VERSION 3.16)
project($package)
find_package(catkin REQUIRED COMPONENTS message_generation ${*:2})
add_message_files(FILES $(cd "$root/test/stand_ins/$package/msg" && echo *.msg))
generate_messages(DEPENDENCIES ${*:2})
catkin_package(CATKIN_DEPENDS ${*:2})
CMAKE
}

messages vision_msgs geometry_msgs std_msgs
messages jsk_recognition_msgs geometry_msgs std_msgs
messages object_recognition_msgs std_msgs
messages moveit_msgs geometry_msgs object_recognition_msgs shape_msgs std_msgs
mkdir "$overlay/src/converters_in_test"
ln -s "$root/test/stand_ins/converters/CMakeLists.txt" "$overlay/src/converters_in_test/CMakeLists.txt"
manifest converters_in_test mixed_palletizing roscpp vision_msgs jsk_recognition_msgs moveit_msgs >"$overlay/src/converters_in_test/package.xml"

for target in all tests; do
  (cd "$overlay" && catkin_make -j"$jobs" -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 \
    -DCATKIN_ENABLE_TESTING=ON -DCMAKE_BUILD_TYPE=Release "$target")
done
set +u
# shellcheck disable=SC1091
. "$overlay/devel/setup.bash"
set -u
export PATH=/usr/bin:$PATH

for room in vision_detections jsk_boxes pallet_scene; do
  "$overlay/devel/lib/mixed_palletizing/${room}_test" --gtest_output="xml:$results/$room.xml"
done
# roslaunch looks for a package's programs in the first workspace that has any.
for program in "$devel"/lib/mixed_palletizing/*; do
  [ -e "$overlay/devel/lib/mixed_palletizing/$(basename "$program")" ] || ln -s "$program" "$overlay/devel/lib/mixed_palletizing/"
done
rostest --pkgdir="$root" --package=mixed_palletizing --results-filename=rostest.xml --results-base-dir="$results" "$root/test/node/converters.test"
echo "converters: built and tested with stand-ins"
