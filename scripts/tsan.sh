#!/usr/bin/env bash
# Builds the tests that use threads with the thread sanitizer and runs them: searches, playouts, thinking ahead, the simulated camera, and
# detectors side by side. Any data race, lock taken in two orders or leaked thread ends it with the report.
# usage: scripts/tsan.sh [--seeds N] [--rows]     N orders and scenes answered by one thread and by two (default 20)
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib/common.sh"

rows=  # for the table of scripts/torture.sh
seeds=20
while [ $# -gt 0 ]; do
  case $1 in
    --rows) rows=yes ;;
    --seeds) seeds=${2:?--seeds needs a number}; shift ;;
    *) die "unknown argument '$1'; usage: scripts/tsan.sh [--seeds N] [--rows]" ;;
  esac
  shift
done
[[ $seeds =~ ^[1-9][0-9]*$ ]] || die "--seeds needs a whole number above 0"

install_packages build test
export PATH=/usr/bin:$PATH
build=$workspace/tsan
mkdir -p "$build"
say "building with the thread sanitizer in $build"
{ cmake -S "$root" -B "$build" -DMIXED_PALLETIZING_TSAN=ON -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCATKIN_ENABLE_TESTING=ON \
    -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 &&
  make -C "$build" -j"$jobs" invariants planning_test; } >"$build.log" 2>&1 ||
  { grep -E -A6 'error|Error' "$build.log" | head -n 60 >&2; die "the build failed; the whole log is $build.log"; }

export TSAN_OPTIONS="second_deadlock_stack=1 ${TSAN_OPTIONS:-}"
programs=$build/devel/lib/mixed_palletizing
use_libraries_of "$build" "$programs/invariants" "$programs/planning_test"
tried=0
lost=0
# run COMMAND...: one test; lost when it fails or the sanitizer reports anything.
run() {
  local log
  log=$build/$(basename "$1").log
  tried=$((tried + 1))
  if "$@" >"$log" 2>&1 && ! grep -q 'WARNING: ThreadSanitizer' "$log"; then
    printf 'clean  %s\n' "$(basename "$1")"
  else
    lost=$((lost + 1))
    printf 'FOUND  %s: %s\n' "$(basename "$1")" "$log"
    grep -m 1 -A 12 'WARNING: ThreadSanitizer' "$log" || tail -n 12 "$log"
  fi
}
run "$programs/invariants" --placements 0 --deviations 0 --seeds "$seeds"
run "$programs/planning_test" --gtest_filter='Ponderer*:TunePolicy*:*hread*'
[ -z "$rows" ] || printf 'ROW {"test": "thread sanitizer", "tried": %s, "survived": %s, "lost": %s, "p99_s": null, "slowest_s": null}\n' \
  "$tried" $((tried - lost)) "$lost"
[ "$lost" -eq 0 ]
