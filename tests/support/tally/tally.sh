#!/bin/sh
# tally.sh LIST FOLDER [JOBS]: runs every suite of LIST, JOBS at a time, and
# keeps their logs and counts in FOLDER (see suite.sh). Then it prints the output
# of the suites that failed, what was skipped and why, the aims that are not
# reached, and the line "N passed, N failed". It fails when a test failed or no
# test ran. BEGAN is the time in seconds since the epoch from which the printed
# duration counts.
set -eu
here=$(dirname "$0")
list=$1
folder=$2
jobs=${3:-1}
: "${BEGAN:=$(date +%s)}"

[ -n "${REMEMBER-}" ] || rm -rf "$folder"
mkdir -p "$folder"
count=$(grep -c . "$list" || true)
seq 1 "$count" | xargs -P "$jobs" -I '{}' \
    "$here/suite.sh" "$list" '{}' "$folder" || true

seconds=$(($(date +%s) - BEGAN))
passed=0
failed=0
skips=$folder/skipped
aims=$folder/not-reached
: >"$skips"
: >"$aims"
while read -r suite rest; do
    if ! read -r good bad skipped 2>/dev/null <"$folder/$suite.count"; then
        echo "fail $suite: it could not be run" >"$folder/$suite.count"
        good=0
        bad=1
        skipped=0
    fi
    passed=$((passed + good))
    failed=$((failed + bad))
    sed -n 's/^todo //p' "$folder/$suite.count" >>"$aims"
    [ "$skipped" -eq 0 ] || sed -n 's/^skip //p' "$folder/$suite.count" >>"$skips"
    if [ "$bad" -ne 0 ]; then
        echo
        echo "---- $suite: $rest"
        cat "$folder/$suite.log" 2>/dev/null || true
        sed -n 's/^fail /---- /p' "$folder/$suite.count"
    fi
done <"$list"

if [ -s "$skips" ]; then
    echo
    sort "$skips" | sed 's/^/  skipped: /'
fi
if [ -s "$aims" ]; then
    echo
    sort "$aims" | sed 's/^/  not reached: /'
fi
echo
printf '  %d min %02d s\n' $((seconds / 60)) $((seconds % 60))
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
