#!/bin/sh
# suite.sh LIST NUMBER FOLDER: runs the suite of line NUMBER of LIST, keeps its
# output in FOLDER/NAME.log and its counts in FOLDER/NAME.count, and prints one
# line about it. A line of LIST is the name of a suite and a shell command.
#
# SUITE_SECONDS limits the time of a suite. When REMEMBER is set, a suite that
# passed is not run again until REMEMBER, its command or a file that the command
# names has changed; FOLDER/NAME.key records what they were.
set -eu
list=$1
folder=$3
line=$(sed -n "$2p" "$list")
suite=${line%% *}
command=${line#* }

# A digest of the command and of the files that it names.
key_of() {
    {
        echo "$REMEMBER $1"
        for word in $1; do
            word=${word#*=}
            [ ! -f "$word" ] || sha256sum "$word"
        done
    } | sha256sum
}

# say TIME: one line about the suite.
say() {
    read -r passed failed skipped <"$folder/$suite.count"
    text="$passed passed"
    [ "$failed" -eq 0 ] || text="$text, $failed FAILED"
    [ "$skipped" -eq 0 ] || text="$text, $skipped skipped"
    printf '  %-34s %-36s %8s\n' "$suite" "$text" "$1"
}

log=$folder/$suite.log
[ -d "${log%/*}" ] || mkdir -p "${log%/*}"
key=
if [ -n "${REMEMBER-}" ]; then
    key=$(key_of "$command")
    if [ "$(cat "$folder/$suite.key" 2>/dev/null)" = "$key" ]; then
        say before
        exit
    fi
fi
[ ! -e "$folder/$suite.key" ] || rm "$folder/$suite.key"

# The slowest suite takes a fifth of this; one that hangs must not stop the rest.
limit=${SUITE_SECONDS:-1200}
read -r begin _ </proc/uptime
status=0
timeout -k 10 "$limit" sh -c "$command" </dev/null >"$log" 2>&1 || status=$?
read -r end _ </proc/uptime

awk -v suite="$suite" -v status="$status" -f "$(dirname "$0")/count_tap.awk" \
    "$log" >"$folder/$suite.count"
# Two digits follow the point of both times.
tenths=$(((${end%.*}${end#*.} - ${begin%.*}${begin#*.} + 5) / 10))
say "$((tenths / 10)).$((tenths % 10)) s"
if [ -n "$key" ] && [ "$failed" -eq 0 ]; then
    echo "$key" >"$folder/$suite.key"
fi
