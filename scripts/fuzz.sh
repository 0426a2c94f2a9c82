#!/usr/bin/env bash
# Builds the fuzzers with clang's sanitizers and runs each on its corpus: any crash, leak, undefined behaviour or undocumented
# exception ends it with the input that did it.
# usage: scripts/fuzz.sh [--runs N] [--seconds S] [NAME...]     N runs (default 100000) or S seconds (default 300) a fuzzer, what comes first
#        names: cloud journal order scene (default: all)
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib/common.sh"

rows=  # for the table of scripts/torture.sh
runs=100000
seconds=300
names=()
while [ $# -gt 0 ]; do
  case $1 in
    --runs) runs=${2:?--runs needs a number}; shift ;;
    --rows) rows=yes ;;
    --seconds) seconds=${2:?--seconds needs a number}; shift ;;
    cloud|journal|order|scene) names+=("$1") ;;
    *) die "unknown argument '$1'; usage: scripts/fuzz.sh [--runs N] [--seconds S] [cloud|journal|order|scene ...]" ;;
  esac
  shift
done
[[ $runs =~ ^[1-9][0-9]*$ && $seconds =~ ^[1-9][0-9]*$ ]] || die "--runs and --seconds need whole numbers above 0"
[ ${#names[@]} -gt 0 ] || names=(cloud journal order scene)

install_packages build fuzz
export PATH=/usr/bin:$PATH
build=$workspace/fuzz
mkdir -p "$build" "$workspace/fuzz_corpus"
say "building the fuzzers in $build"
{ cmake -S "$root" -B "$build" -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ -DMIXED_PALLETIZING_FUZZ=ON \
    -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 &&
  make -C "$build" -j"$jobs" "${names[@]/%/_fuzzer}"; } >"$build.log" 2>&1 ||
  { grep -E -A6 'error|Error' "$build.log" | head -n 60 >&2; die "the build failed; the whole log is $build.log"; }

fuzzers=("${names[@]/#/$build/devel/lib/mixed_palletizing/}")
use_libraries_of "$build" "${fuzzers[@]/%/_fuzzer}"

# Half the time went into long call stacks of allocations, freed memory that is kept, and the choice of the next input.
export ASAN_OPTIONS=malloc_context_size=4:quarantine_size_mb=8:${ASAN_OPTIONS:-}

# What a fuzzer finds interesting stays in the workspace; the committed corpus is read only.
failed=0
for name in "${names[@]}"; do
  found=$workspace/fuzz_corpus/$name
  log=$workspace/fuzz_corpus/$name.log
  mkdir -p "$found"
  start=$SECONDS
  if "$build/devel/lib/mixed_palletizing/${name}_fuzzer" -runs="$runs" -max_total_time="$seconds" -max_len=65536 -entropic=0 \
    -artifact_prefix="$workspace/fuzz_corpus/$name-" "$found" "$root/test/fuzz/corpus/$name" >"$log" 2>&1; then
    verdict='0 findings'
    lost=0
  else
    verdict="FOUND a fault: $log"
    failed=1
    lost=1
  fi
  done_runs=$(grep -oE 'Done [0-9]+ runs' "$log" | grep -oE '[0-9]+' || grep -oE '^#[0-9]+' "$log" | tail -n 1 | tr -d '#')
  printf '%-8s %10s runs in %5s s, coverage %s, %s\n' "$name" "${done_runs:-0}" $((SECONDS - start)) \
    "$(grep -oE 'cov: [0-9]+' "$log" | tail -n 1 | grep -oE '[0-9]+' || echo 0)" "$verdict"
  [ -z "$rows" ] || printf 'ROW {"test": "fuzzed %s", "tried": %s, "survived": %s, "lost": %s, "p99_s": null, "slowest_s": null}\n' \
    "$name" "${done_runs:-0}" $((${done_runs:-0} - lost)) "$lost"
done
exit $failed
