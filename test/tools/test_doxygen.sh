#!/usr/bin/env bash
# Doxygen has nothing to complain about.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$root"
{ cat docs/Doxyfile; echo "OUTPUT_DIRECTORY = $scratch"; } | doxygen - >/dev/null 2>"$scratch/warnings"
[ ! -s "$scratch/warnings" ] || { head -n 40 "$scratch/warnings"; exit 1; }
ls "$scratch"/html/structmixed__palletizing_1_1detection_1_1*.html >/dev/null
echo "doxygen: $(ls "$scratch"/html/*.html | wc -l) pages, no warning"
