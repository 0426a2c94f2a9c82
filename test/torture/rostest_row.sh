#!/usr/bin/env bash
# A rostest with the row of its counts for the table of scripts/torture.sh.
# usage: rostest_row.sh NAME.test [ARGUMENT:=VALUE...]
set -euo pipefail
table=$(mktemp)
trap 'rm -f "$table"' EXIT
rostest --text mixed_palletizing "$@" table:="$table" >"$table.log" 2>&1 || { tail -n 60 "$table.log" >&2; status=1; }
rm -f "$table.log"
[ ! -s "$table" ] || echo "ROW $(cat "$table")"
exit "${status:-0}"
