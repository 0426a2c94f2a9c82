#!/usr/bin/env bash
# Makes the Debian package of the installed tree, unpacks it below a folder of its own, and runs it from there alone.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/../../scripts/lib/common.sh"

build=${1:-$workspace/build} install=${2:-$workspace/install}  # a configured folder, and the tree that `make install` made
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
(cd "$build" && cpack -G DEB -B "$scratch" -D CPACK_INSTALL_CMAKE_PROJECTS= -D "CPACK_INSTALLED_DIRECTORIES=$install;opt/mixed_palletizing" \
  -D CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS="$install/lib" >"$scratch/cpack.log" 2>&1) || { tail -n 20 "$scratch/cpack.log"; die "cpack failed"; }
package=$(ls "$scratch"/mixed-palletizing_*.deb)
for field in Package Version Architecture Maintainer Depends Description; do
  [ -n "$(dpkg-deb -f "$package" $field)" ] || die "the package has no $field"
done
# On Debian the dependencies are all there: the package could be installed as it is.
[ -f "$noetic" ] || apt-get install -s "$package" >"$scratch/apt.log" 2>&1 || { tail -n 20 "$scratch/apt.log"; die "apt could not install it"; }

dpkg-deb -x "$package" "$scratch/root"
prefix=$scratch/root/opt/mixed_palletizing
unset ROS_PACKAGE_PATH CMAKE_PREFIX_PATH LD_LIBRARY_PATH PYTHONPATH
set +u
# shellcheck disable=SC1091
. "$prefix/setup.bash"
set -u
export PATH=/usr/bin:$PATH
[ "$(rospack find mixed_palletizing)" = "$prefix/share/mixed_palletizing" ] || die "rospack finds $(rospack find mixed_palletizing)"
for program in "$prefix"/lib/mixed_palletizing/* "$prefix"/lib/*.so; do
  file -L "$program" | grep -q ELF || continue
  # Not by LD_LIBRARY_PATH: programs find our libraries by themselves.
  ! LD_LIBRARY_PATH='' ldd "$program" | grep 'not found' || die "$program misses libraries"
done
cd "$scratch"
rosrun mixed_palletizing generate_instances --height_mm 600 --count 1 --seed 1 --out i.jsonl
rosrun mixed_palletizing plan_picks --instances i.jsonl --method dblf --out r.jsonl
rosrun mixed_palletizing pallet_report r.jsonl --instances i.jsonl --out r.html
rosrun mixed_palletizing simulate_scene --scene "$prefix/share/mixed_palletizing/config/scenes/three_boxes.yaml" --out c.pcd --truth t.json
rosrun mixed_palletizing detect_boxes --cloud c.pcd --base marker --json d.json
grep -q top_center d.json || die "no box in the cloud of the installed scene"
# The whole cell: nodelets, planner, executive and the page of its pallet.
export ROS_MASTER_URI=http://127.0.0.1:$(free_port) ROS_IP=127.0.0.1 ROS_HOME=$scratch/ros
timeout 240 roslaunch --no-summary mixed_palletizing demo.launch rviz:=false move_s:=0 instances:="$root/test/node/small_order.jsonl" \
  width_px:=960 height_px:=600 report:="$scratch/report.json" || die "demo.launch did not come to its end"
[ -s "$scratch/report.html" ] || die "demo.launch left no page of its pallet"
rosmsg show mixed_palletizing/Box >/dev/null
python3 -c 'import mixed_palletizing.msg' || die "the Python messages are not found"
echo "debian package: $(basename "$package") complete"
