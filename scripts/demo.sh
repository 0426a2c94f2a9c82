#!/usr/bin/env bash
# Installs what is missing, builds, and runs the simulated cell: boxes are captured, detected, chosen and packed until one order is complete.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib/common.sh"

usage() {
  cat <<EOF
usage: scripts/demo.sh [options]
  --headless            no rviz window (also the case without a display)
  --screenshot [FILE]   picture of rviz at the end, made under Xvfb (default: demo.png in the workspace); implies --headless
  --report FILE         JSON report of the pallet, an HTML page beside it (default: demo.json in the workspace)
  --height_mm H         height of the order's packing volume: 600 (default), 800, 1200, ...
  --seed N              which order, and where the boxes lie (default: 1)
  --method M            how the planner chooses: best (default), ga, dblf
EOF
}

headless= screenshot= report=$workspace/demo.json height=600 seed=1 method=
[ -n "${DISPLAY:-}" ] || headless=yes
need() { [ $# -ge 2 ] || die "$1 needs a value (--help shows the options)"; }
while [ $# -gt 0 ]; do
  case $1 in
    --help) usage; exit 0 ;;
    --headless) headless=yes ;;
    --screenshot)
      screenshot=$workspace/demo.png headless=yes
      case ${2:-} in ''|--*) ;; *) screenshot=$2; shift ;; esac ;;
    --report) need "$@"; report=$2; shift ;;
    --height_mm) need "$@"; height=$2; shift ;;
    --seed) need "$@"; seed=$2; shift ;;
    --method) need "$@"; method=$2; shift ;;
    *) die "unknown argument '$1' (--help shows the options)" ;;
  esac
  shift
done
for number in "$height" "$seed"; do
  case $number in ''|*[!0-9]*) die "'$number' is no whole number" ;; esac
done

times=
# timed NAME COMMAND...: runs the command in this shell and notes how long it took.
timed() {
  local name=$1 start=$SECONDS
  shift
  "$@"
  times+="${times:+, }$name $((SECONDS - start)) s"
}

timed install install_packages build ${screenshot:+screenshot}
timed build make_workspace all
use_workspace

absolute() { mkdir -p "$(dirname "$1")"; printf '%s/%s\n' "$(cd "$(dirname "$1")" && pwd)" "$(basename "$1")"; }
report=$(absolute "$report")
rm -f "$report"
export ROS_MASTER_URI=http://127.0.0.1:$(free_port) ROS_IP=127.0.0.1 ROS_HOME=$workspace/ros_home
mkdir -p "$ROS_HOME"

children=()
cleanup() {
  local pid
  for pid in "${children[@]}"; do kill "$pid" 2>/dev/null || true; done
  wait 2>/dev/null || true
}
trap cleanup EXIT
trap 'exit 130' INT TERM

arguments=(height_mm:="$height" seed:="$seed" report:="$report")
[ -z "$method" ] || arguments+=(method:="$method")
if [ -n "$screenshot" ]; then
  screenshot=$(absolute "$screenshot")
  rm -f "$screenshot"
  # Xvfb names the first free display on its descriptor 3.
  exec 3>"$workspace/display"
  Xvfb -displayfd 3 -screen 0 1600x1000x24 -nolisten tcp >"$workspace/xvfb.log" 2>&1 &
  children+=($!)
  for _ in $(seq 100); do [ -s "$workspace/display" ] && break; sleep 0.1; done
  [ -s "$workspace/display" ] || die "Xvfb did not start; see $workspace/xvfb.log"
  DISPLAY=:$(cat "$workspace/display")
  export DISPLAY LIBGL_ALWAYS_SOFTWARE=1 QT_X11_NO_MITSHM=1
  arguments+=(rviz:=true hold_s:=20)
elif [ -n "$headless" ]; then
  arguments+=(rviz:=false)
else
  arguments+=(rviz:=true hold_s:=30)
fi

start=$SECONDS
say "starting the simulated cell"
roslaunch --no-summary mixed_palletizing demo.launch "${arguments[@]}" &
launch=$!
children+=("$launch")

# The report is written when the order is complete; the executive then holds the cell, for the picture or for those who look.
while kill -0 "$launch" 2>/dev/null && [ ! -s "$report" ]; do sleep 0.5; done
if [ -n "$screenshot" ] && [ -s "$report" ]; then
  sleep 12  # rviz draws slowly without a graphics card
  import -window root "$screenshot"
fi
times+=", run $((SECONDS - start)) s"
code=0
wait "$launch" || code=$?
[ "$code" -eq 0 ] || die "the cell ended with exit code $code"
[ -s "$report" ] || die "the order was not completed: no report was written"
/usr/bin/python3 "$root/scripts/lib/show_report.py" "$report"
say "report: ${report%.json}.html, $report${screenshot:+, picture: $screenshot}"
say "times: $times; to go on: source $workspace/devel/setup.bash"
