#!/bin/sh
# run.sh FUZZER [FOLDER...]: runs a libFuzzer program for a short time, with the
# small files of the folders (tests/fixtures and assets) as seed inputs, after
# the inputs that once failed (findings/NAME). The environment may set RUNS, the number of inputs,
# FUZZ_SECONDS, the longest time, SEED, and CORPUS, a folder that keeps inputs
# that reached new code. Prints TAP. An input that fails stays beside the program.
# An input may take 60 seconds: comparing a clip of a minute takes 20 of them with
# the sanitizers, and 0.4 without.
set -eu
fuzzer=$1
shift
[ $# -gt 0 ] || set -- tests/fixtures assets
name=$(basename "$fuzzer")
runs=${RUNS:-20000}
seconds=${FUZZ_SECONDS:-9}
found=${CORPUS:-}
findings=$(dirname "$0")/findings

work=$(mktemp -d "${TMPDIR:-/tmp}/limber-fuzz-XXXXXX")
trap 'rm -rf "$work"' EXIT
[ -n "$found" ] || found=$work/found
mkdir -p "$work/seeds" "$found"
# Large seeds would slow the run down. Names keep the folder, to be unique.
find "$@" -type f -size -64k ! -name '*.py' ! -name '*.md' 2>/dev/null |
    while read -r seed; do
        cp "$seed" "$work/seeds/$(printf '%s' "$seed" | tr / _)"
    done

set --
[ ! -d "$findings/${name#fuzz_}" ] || set -- "$findings/${name#fuzz_}"/*
result=0

echo "1..2"
if [ $# -eq 0 ] || "$fuzzer" "$@" >"$work/log" 2>&1; then
    echo "ok 1 - $name survives the $# inputs that once failed"
else
    sed 's/^/# /' "$work/log"
    echo "not ok 1 - $name survives the $# inputs that once failed"
    result=1
fi
if "$fuzzer" -runs="$runs" -seed="${SEED:-1}" -max_total_time="$seconds" -max_len=65536 \
    -timeout=60 -rss_limit_mb=2048 -verbosity=0 -print_final_stats=1 \
    -artifact_prefix="$fuzzer-" "$found" "$work/seeds" \
    >"$work/log" 2>&1; then
    grep '^stat::number_of_executed_units' "$work/log" | sed 's/^/# /' || true
    echo "ok 2 - $name finds no error"
else
    sed 's/^/# /' "$work/log"
    echo "not ok 2 - $name finds no error: run it with the file named above"
    result=1
fi
exit $result
