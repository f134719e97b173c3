#!/bin/sh
# trust.sh FUZZER...: prints how well limber stands faults and hostile input, as
# a table: how much was tried and how much of it failed. The environment sets
# MOST, the number of faults of each kind and case (0: all), SECONDS for each
# fuzz target, and REPRODUCE=0 to leave out the two builds that are compared.
# It fails when anything failed. Logs stay in build/trust.
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

python3 -B tests/faults/faults.py build/faults/faults.so build/asan/limber \
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

hardened() {
    failed=0
    toolchain/check-hardened.sh "$1" "$2" >"$logs/hardened.log" 2>&1 ||
        failed=$(wc -l <"$logs/hardened.log")
    row "hardening of $2" 7 "$failed" 'toolchain/check-hardened.sh'
}
hardened readelf build/host/limber
hardened arm-linux-gnueabi-readelf build/arm/limber

if [ "${REPRODUCE:-1}" = 1 ]; then
    failed=0
    toolchain/reproduce.sh build/reproduce host arm deb \
        >"$logs/reproduce.log" 2>&1 || failed=1
    row 'files built twice, in two folders' \
        "$(grep -c 'build/' "$logs/reproduce.log")" "$failed" 'make reproduce'
fi
exit $result
