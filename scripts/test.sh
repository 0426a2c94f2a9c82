#!/usr/bin/env bash
# Installs what is missing, builds with warnings as errors, and runs every test: unit tests, rostests, tools, converters, install space, style.
# usage: scripts/test.sh [--fast]     (--fast leaves out the rostests, the converters and the install space)
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib/common.sh"

fast=
case ${1:-} in
  '') ;;
  --fast) fast=yes ;;
  *) die "unknown argument '$1'; usage: scripts/test.sh [--fast]" ;;
esac

install_packages build test screenshot experiments
if [ -z "${MIXED_PALLETIZING_DATA:-}" ] && [ -d "$root/../shared/data" ]; then
  MIXED_PALLETIZING_DATA=$(cd "$root/../shared/data" && pwd -P)
fi
if [ -n "${MIXED_PALLETIZING_DATA:-}" ]; then
  export MIXED_PALLETIZING_DATA
  say "recorded data: $MIXED_PALLETIZING_DATA"
else
  say "no recorded data (MIXED_PALLETIZING_DATA is not set): the tests on recordings are skipped"
fi

CATKIN_ENABLE_TESTING=ON make_workspace all tests
use_workspace

results=$workspace/build/test_results
checks=$workspace/checks
rm -rf "$results" "$checks"
mkdir -p "$checks"

# check NAME COMMAND...: one check that counts as one test; its output is shown when it fails.
check() {
  local name=$1
  shift
  if "$@" >"$checks/$name.log" 2>&1; then
    echo passed >"$checks/$name.result"
    printf 'passed  %s\n' "$name"
  else
    echo failed >"$checks/$name.result"
    printf 'FAILED  %s\n' "$name"
    tail -n 40 "$checks/$name.log"
  fi
}

formatted() { git -C "$root" ls-files -z '*.hpp' '*.cpp' | (cd "$root" && xargs -0 clang-format --dry-run --Werror); }
# Left out: the checkout's folder may have any name, scripts/ is for developers, CMAKE_BUILD_TYPE is CMake's own
# idiom, and the include paths of a target here reach nobody but targets of this package.
linted() {
  catkin_lint --offline --strict -W2 --ignore package_path_name --ignore uninstalled_script \
    --ignore global_var_collision --ignore external_interface_path "$root"
}
# What ctest says of all counts as one more test: a test that dies, or a failed subTest of a rostest, is in no file of results.
verdict() {
  local name=$1
  shift
  if tested "$@"; then echo passed >"$checks/$name.result"; else echo failed >"$checks/$name.result"; fi
}
tested() { (cd "$workspace/build" && ctest --output-on-failure --timeout 900 "$@"); }

say "checks"
check layers "$root/scripts/check_layers.py"
check layer_check_itself /usr/bin/python3 "$root/test/tools/test_check_layers.py"
check show_report /usr/bin/python3 "$root/test/tools/test_show_report.py"
check meshes /usr/bin/python3 "$root/test/tools/test_make_meshes.py"
check docs /usr/bin/python3 "$root/test/tools/test_docs.py"
check doxygen "$root/test/tools/test_doxygen.sh"
check doc_commands /usr/bin/python3 "$root/test/tools/test_doc_commands.py"
check pallet_report /usr/bin/python3 "$root/test/tools/test_pallet_report.py"
check experiment_modules /usr/bin/python3 "$root/test/tools/test_experiment_modules.py"
check run_experiments /usr/bin/python3 "$root/test/tools/test_run_experiments.py"
check clang_format formatted
check journal_damage "$workspace/devel/lib/mixed_palletizing/journal_damage" --cut-step 500 --flips 500 --draws 1
check invariants "$workspace/devel/lib/mixed_palletizing/invariants" --placements 20000 --seeds 20 --deviations 1000
check out_of_memory "$workspace/devel/lib/mixed_palletizing/out_of_memory" --tries 20
check catkin_lint linted

say "unit tests"
verdict unit_tests -j2 -E 'rostest'
if [ -z "$fast" ]; then
  say "rostests"
  verdict rostests -R 'rostest'
  say "converters, with stand-ins for the messages of other packages"
  check converters "$root/test/tools/test_converters.sh"
  say "install space"
  check install_space "$root/test/tools/test_install_space.sh"
  check debian_package "$root/test/tools/test_debian_package.sh"
fi

/usr/bin/python3 "$root/scripts/lib/count_tests.py" "$results" "$checks"
