#!/bin/sh
# suite.sh LIST NUMBER FOLDER: runs the suite of line NUMBER of LIST, keeps its
# output in FOLDER/NAME.log and its figures in FOLDER/NAME.count, and prints
# one line about it. A line of LIST is a suite's name, then a shell command.
set -eu
list=$1
folder=$3
line=$(sed -n "$2p" "$list")
suite=${line%% *}
command=${line#* }

log=$folder/$suite.log
mkdir -p "$(dirname "$log")"
# No suite takes a tenth of this; one that hangs must not hang the rest.
limit=${SUITE_SECONDS:-600}
begin=$(date +%s%N)
status=0
timeout -k 10 "$limit" sh -c "$command" </dev/null >"$log" 2>&1 || status=$?
end=$(date +%s%N)

awk -v suite="$suite" -v status="$status" -f "$(dirname "$0")/count_tap.awk" \
    "$log" >"$folder/$suite.count"
read -r passed failed skipped <"$folder/$suite.count"
text="$passed passed"
[ "$failed" -eq 0 ] || text="$text, $failed FAILED"
[ "$skipped" -eq 0 ] || text="$text, $skipped skipped"
printf '  %-34s %-36s %6s s\n' "$suite" "$text" "$(awk -v ns=$((end - begin)) \
    'BEGIN { printf "%.1f", ns / 1e9 }')"
