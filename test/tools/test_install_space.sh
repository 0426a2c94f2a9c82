#!/usr/bin/env bash
# Installs the package and runs it from there alone: tools, files that launch files need, the nodelet.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/../../scripts/lib/common.sh"

CATKIN_ENABLE_TESTING=ON make_workspace install
unset ROS_PACKAGE_PATH CMAKE_PREFIX_PATH LD_LIBRARY_PATH
use_workspace install
share=$workspace/install/share/mixed_palletizing
[ "$(rospack find mixed_palletizing)" = "$share" ] || die "rospack finds $(rospack find mixed_palletizing), not $share"
for file in nodelet_plugins.xml launch/cell.launch launch/demo.launch launch/replay.launch; do
  [ -f "$share/$file" ] || die "not installed: $file"
done
[ -x "$workspace/install/lib/mixed_palletizing/simple_executive.py" ] || die "the example executive is not installed"
ls "$share"/rviz/*.rviz "$share"/config/*.yaml >/dev/null
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
rosrun mixed_palletizing generate_instances --height_mm 600 --count 2 --seed 1 --out "$scratch/i.jsonl"
rosrun mixed_palletizing plan_picks --instances "$scratch/i.jsonl" --method dblf --out "$scratch/r.jsonl"
rosrun mixed_palletizing check_packing --instances "$scratch/i.jsonl" --results "$scratch/r.jsonl"
rosrun mixed_palletizing simulate_scene --scene "$share/config/scenes/three_boxes.yaml" --out "$scratch/c.pcd" --truth "$scratch/t.json"
rosrun mixed_palletizing detect_boxes --cloud "$scratch/c.pcd" --base marker --json "$scratch/d.json"
/usr/bin/python3 - "$scratch/d.json" <<'PY'
import json, sys
boxes = json.load(open(sys.argv[1]))['boxes']
assert len(boxes) == 3, f'{len(boxes)} boxes of 3'
PY
rosrun mixed_palletizing run_experiments detection --quiet --count 1 --only truncated --out "$scratch/report"
[ -s "$scratch/report/detection.html" ] || die "run_experiments wrote no report"
library=$(sed -n 's/.*library path="\([^"]*\)".*/\1/p' "$share/nodelet_plugins.xml")
[ -f "$workspace/install/$library.so" ] || die "the nodelet's library $library.so is not installed"
! ldd "$workspace/install/$library.so" | grep 'not found' || die "the nodelet's library misses others"
for launch in "$share"/launch/*.launch; do
  arguments=()
  [ "$(basename "$launch")" != replay.launch ] || arguments=(bag:=/none.bag)  # it has no default
  roslaunch --files "$launch" "${arguments[@]}" >/dev/null
done
echo "install space: complete"
