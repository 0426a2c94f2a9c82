#!/usr/bin/env bash
# The rostest of bad clouds in every layout, with the row of its counts for the table.
# usage: bad_clouds.sh
set -euo pipefail
table=$(mktemp)
trap 'rm -f "$table"' EXIT
rostest --text mixed_palletizing bad_clouds.test table:="$table" >"$table.log" 2>&1 || { tail -n 60 "$table.log" >&2; status=1; }
rm -f "$table.log"
[ ! -s "$table" ] || echo "ROW $(cat "$table")"
exit "${status:-0}"
