#!/usr/bin/env bash
# Tries to bring the package down: kills, damaged files, bad disks, random placements, boxes not as planned, memory that runs out, data
# races, bad clouds, clocks and transforms, load, fuzzers. Prints one table: what was tried, how much of it survived.
# usage: scripts/torture.sh [--long] [--only NAME[=COUNT]]... [--seed N] [--write]
#   --long   hours instead of minutes      --only   one of the tests below, and how much of it; may be repeated
#   --seed   of everything random (1)      --write  puts the table, its command and date into docs/reliability.md: with --only beside
#                                                   the rows of the other tests, which keep theirs
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib/common.sh"

# One line for a test: torture NAME COMMAND... A test prints what it found, and `ROW {...}` lines for the table
# (test/torture/report_row.py); it fails when anything was lost.
tests() {
  local rostest=$root/test/torture/rostest_row.py fuzz=$root/scripts/fuzz.sh
  torture kill_planner /usr/bin/python3 "$root/test/torture/kill_planner.py" --kills "$(amount 200 1000 kill_planner)" --seed "$seed"
  torture kill_cell /usr/bin/python3 "$root/test/torture/kill_cell.py" --kills "$(amount 40 1000 kill_cell)" --seed "$seed"
  torture journal_damage "$build/journal_damage" --cut-step 1 --flips "$(amount 10000 100000 journal_damage)" \
    --draws "$(amount 5 50)" --seed "$seed"
  torture invariants "$build/invariants" --placements "$(amount 1000000 10000000 invariants)" --seeds "$(amount 1000 10000)" \
    --deviations "$(amount 20000 1000000)" --seed "$seed"
  torture out_of_memory "$build/out_of_memory" --tries "$(amount 500 20000 out_of_memory)" --seed "$seed"
  torture threads "$root/scripts/tsan.sh" --rows --seeds "$(amount 20 1000 threads)"
  torture bad_clouds "$rostest" bad_clouds.test
  torture time_and_tf "$rostest" time_and_tf.test rounds:="$(amount 5 500 time_and_tf)" seed:="$seed"
  torture load "$rostest" load.test cycles:="$(amount 4000 100000 load)" growth:=0.01 seed:="$seed"
  torture fuzz_cloud "$fuzz" --rows --runs "$(amount 100000 10000000 fuzz_cloud)" --seconds "$(amount 60 36000)" cloud
  torture fuzz_journal "$fuzz" --rows --runs "$(amount 1000000 10000000 fuzz_journal)" --seconds "$(amount 60 36000)" journal
  torture fuzz_order "$fuzz" --rows --runs "$(amount 1000000 10000000 fuzz_order)" --seconds "$(amount 60 36000)" order
  torture fuzz_scene "$fuzz" --rows --runs "$(amount 1000000 10000000 fuzz_scene)" --seconds "$(amount 60 36000)" scene
}

names=$(sed -n 's/^  torture \([a-z_]*\) .*/\1/p' "${BASH_SOURCE[0]}")
long= only= seed=1 write= command="scripts/torture.sh $*"
declare -A counts
usage="usage: scripts/torture.sh [--long] [--only NAME[=COUNT]]... [--seed N] [--write]"
while [ $# -gt 0 ]; do
  case $1 in
    --long) long=yes ;;
    --write) write=yes ;;
    --only)
      name=${2:?--only needs the name of a test}
      name=${name%%=*}
      grep -qxF -- "$name" <<<"$names" || die "--only: there is no test '$name'; there are: ${names//$'\n'/, }"
      [[ $2 == "$name" || $2 =~ =[1-9][0-9]*$ ]] || die "--only: '${2#*=}' is no number above 0"
      [ "$2" = "$name" ] || counts[$name]=${2#*=}
      only+=" $name "
      shift ;;
    --seed) seed=${2:?--seed needs a number}; shift ;;
    *) die "unknown argument '$1'; $usage" ;;
  esac
  shift
done
[[ $seed =~ ^[0-9]+$ ]] || die "--seed: '$seed' is no number"

# amount DEFAULT LONG [NAME]: how much of it, which --only NAME=COUNT may say
amount() {
  local asked=${3:+${counts[$3]:-}}
  if [ -n "$asked" ]; then echo "$asked"; elif [ -n "$long" ]; then echo "$2"; else echo "$1"; fi
}

results=$(mktemp -d)
master=
finish() {
  [ -z "$master" ] || kill "$master" 2>/dev/null || true
  rm -rf "$results"
}
trap finish EXIT

failed=
torture() {
  local name=$1
  shift
  [ -z "$only" ] || [[ $only == *" $name "* ]] || return 0
  say "$name: $*"
  "$@" | tee "$results/$name.log" || failed="$failed $name"
  sed -n 's/^ROW //p' "$results/$name.log" >>"$results/rows"
}

install_packages build test
CATKIN_ENABLE_TESTING=ON make_workspace mixed_palletizing_generate_messages pick_planner pallet_journal journal_damage invariants out_of_memory \
  mixed_palletizing_nodelets cell_simulator
use_workspace
build=$workspace/devel/lib/mixed_palletizing
export ROS_HOME=$results/ros ROS_MASTER_URI=http://localhost:$(free_port)
/usr/bin/python3 "$(command -v rosmaster)" --core -p "${ROS_MASTER_URI##*:}" >"$results/master.log" 2>&1 &
master=$!
until rosparam list >/dev/null 2>&1; do kill -0 "$master" || die "no master: $(tail -n 3 "$results/master.log")"; done

touch "$results/rows"
tests
table=("$root/test/torture/print_table.py" --rows "$results/rows" --command "$command")
[ -z "$write" ] || table+=(--write "$root/docs/reliability.md")
[ -z "$only" ] || table+=(--keep)
/usr/bin/python3 "${table[@]}"
[ -z "$failed" ] || die "lost something, or was too late:$failed"
