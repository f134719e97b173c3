#!/bin/sh
# run.sh FUZZER [FOLDER...]: runs a libFuzzer program for a short time, with the
# small files of the folders (tests/fixtures and assets) as seed inputs. The
# environment may set RUNS, the number of inputs, and FUZZ_SECONDS, the longest
# time. The random seed is fixed. Prints TAP. An input that fails stays beside
# the program.
set -eu
fuzzer=$1
shift
[ $# -gt 0 ] || set -- tests/fixtures assets
name=$(basename "$fuzzer")
runs=${RUNS:-20000}
seconds=${FUZZ_SECONDS:-30}

work=$(mktemp -d "${TMPDIR:-/tmp}/limber-fuzz-XXXXXX")
trap 'rm -rf "$work"' EXIT
mkdir "$work/seeds" "$work/found"
# Large seeds would slow the run down. Names keep the folder, to be unique.
find "$@" -type f -size -64k ! -name '*.py' ! -name '*.md' 2>/dev/null |
    while read -r seed; do
        cp "$seed" "$work/seeds/$(printf '%s' "$seed" | tr / _)"
    done

echo "1..1"
if "$fuzzer" -runs="$runs" -seed=1 -max_total_time="$seconds" -max_len=65536 \
    -timeout=10 -rss_limit_mb=2048 -verbosity=0 -print_final_stats=1 \
    -artifact_prefix="$fuzzer-" "$work/found" "$work/seeds" \
    >"$work/log" 2>&1; then
    grep '^stat::number_of_executed_units' "$work/log" | sed 's/^/# /' || true
    echo "ok 1 - $name finds no error"
else
    sed 's/^/# /' "$work/log"
    echo "not ok 1 - $name finds no error: run it with the file named above"
    exit 1
fi
