#!/bin/sh
# run.sh FUZZER [FOLDER...]: a short run of a libFuzzer program, seeded with the
# small files of tests/fixtures and assets (or the given folders). RUNS inputs
# from a fixed seed, at most FUZZ_SECONDS. Speaks TAP; an input that fails is
# kept beside the program.
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
# Large seeds would only slow it down. The name tells equal ones apart.
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
    echo "ok 1 - $name survives"
else
    sed 's/^/# /' "$work/log"
    echo "not ok 1 - $name survives: run it on the file named above"
    exit 1
fi
