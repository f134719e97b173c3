#!/bin/sh
# trust.sh FUZZER...: prints how well limber stands faults and hostile input, as
# a table: how much was tried and how much of it failed. The environment sets
# MOST, the number of faults of each kind and case (0: all sites), SECONDS for each
# fuzz target, DAYS to play, N and SEED of the mutants (N=0: none), and
# REPRODUCED, the targets of make that are built twice (empty: none). It fails
# when anything failed; a mutant that survives is no failure. Logs stay in
# build/trust.
set -u
logs=build/trust
mkdir -p "$logs"
result=0

# row WHAT TRIED FAILED COMMAND
row() {
    printf '| %-38s | %10s | %6s | %-32s |\n' "$1" "$2" "$3" "$4"
    [ "$3" = 0 ] || result=1
}

row 'What' 'tried' 'failed' 'command'
result=0
row '---' '---' '---' '---'
result=0

python3 -B tests/faults/faults.py build/faults/faults.so build/faults/asan/limber \
    --most "${MOST:-0}" --table "$logs/faults.table" >"$logs/faults.log" 2>&1
read -r tried failed <"$logs/faults.table" || failed=1
row 'calls that fail' "${tried:-0}" "$failed" 'make faults'

for fuzzer; do
    name=${fuzzer##*/}
    failed=0
    CORPUS=build/fuzz/corpus/$name SEED=0 RUNS=-1 FUZZ_SECONDS=${SECONDS:-60} \
        tests/fuzz/run.sh "$fuzzer" >"$logs/$name.log" 2>&1 ||
        failed=$(grep -c '^not ok' "$logs/$name.log")
    tried=$(sed -n 's/^# stat::number_of_executed_units: *//p' "$logs/$name.log")
    row "random inputs of $name" "${tried:-0}" "$failed" 'make fuzz'
done

months=0
SEED=1 tests/months/months.py build/months/host.so build/host/limber \
    >"$logs/months.log" 2>&1 || months=1
row 'days of playing' "${DAYS:-30}" "$months" 'make months'

hardened() {
    failed=0
    toolchain/check-hardened.sh "$1" "$2" >"$logs/hardened.log" 2>&1 ||
        failed=$(wc -l <"$logs/hardened.log")
    row "hardening of $2" 7 "$failed" 'toolchain/check-hardened.sh'
}
hardened readelf build/host/limber
hardened arm-linux-gnueabi-readelf build/arm/limber

REPRODUCED=${REPRODUCED-host arm deb image}
if [ -n "$REPRODUCED" ]; then
    failed=0
    # shellcheck disable=SC2086 # these are words
    toolchain/reproduce.sh build/reproduce $REPRODUCED \
        >"$logs/reproduce.log" 2>&1 || failed=1
    row 'files built twice, in two folders' \
        "$(grep -c 'build/' "$logs/reproduce.log")" "$failed" 'make reproduce'
fi
failures=$result

if [ "${N:-0}" -gt 0 ]; then
    python3 -B tests/mutants/mutants.py --number "$N" --seed "${SEED:-1}" \
        >"$logs/mutants.log" 2>&1
    row 'mutants, of which survive' "$N" \
        "$(grep -c ' SURVIVES ' "$logs/mutants.log")" 'make mutants'
fi
exit $failures
