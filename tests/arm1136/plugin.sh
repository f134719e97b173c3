#!/bin/sh
# Tests the model's options, regions and reports, and compares AN4044's loop with
# the cycles of a separate scoreboard (figures.md).
#
#   plugin.sh MODEL AN4044 UNKNOWN REGIONS
set -u
. "$(dirname "$0")/../support/tap.sh"

model=$1
program=$2
unknown=$3
regions=$4

# model_run OPTIONS: runs the program in the model.
model_run() {
    run qemu-arm -cpu arm1136 -plugin "$model$1" "$program"
    about "an4044${1:+ $1}"
}

# value REGION KEY: a number of a region in the report.
value() {
    awk -v name="$1" -v key="$2" '$1 == "region" && $2 == name {
        for (i = 3; i < NF; i += 2)
            if ($i == key) print $(i + 1)
    }' "$err_file"
}

# near NAME GOT LOW HIGH: the value is within LOW to HIGH.
near() {
    if [ -n "$2" ] && [ "$2" -ge "$3" ] && [ "$2" -le "$4" ]; then
        pass "$1"
    else
        fail "$1" "${2:-nothing} is not within $3 to $4"
    fi
}

# 64 vertices of 8 + 46 k cycles each, within 15%.
model_run ''
expect_status 0
for k in 1 2 3 4; do
    cycles=$(value "_start#$k" cycles)
    near "AN4044, $k influences: 8 + 46 k cycles a vertex" \
        "$((${cycles:-0} / 64))" $(((8 + 46 * k) * 85 / 100)) \
        $(((8 + 46 * k) * 115 / 100))
done
warm=$(value _start#4 cycles)
cold=$(value _start#8 cycles)
near "data from memory costs more than from L1" "$cold" \
    $((${warm:-0} * 3 / 2)) $((${warm:-0} * 4))
expect_no_out

model_run ,ddr=110,l2=16
near "slower memory costs more" "$(value _start#8 cycles)" \
    $((${cold:-0} * 11 / 10)) $((${cold:-0} * 2))
near "slower memory costs nothing when all is in L1" "$(value _start#4 cycles)" \
    $((${warm:-0} - 100)) $((${warm:-0} + 100))

model_run ,ideal=on
near "ideal memory leaves no difference" "$(value _start#8 cycles)" \
    $((${warm:-0} - 200)) $((${warm:-0} + 200))

model_run ,begin=an4044_transform
expect_status 0
expect_err '^region an4044_transform entries 16 '
near "a function can be the region" "$(value an4044_transform instructions)" \
    104112 104112

model_run ,whole=on
expect_err '^region whole entries 1 '

model_run ",profile=an4044_transform,report=$scratch/report"
expect_no_err
expect_file "$scratch/report"
check "lists an instruction with what it waits for" \
    grep -Eq '^  [0-9a-f]{8} +512 .*(vldr|flds).*' "$scratch/report"

model_run ",json=$scratch/report.json"
expect_status 0
check "JSON has regions, symbols and parameters" node -e '
    const report = JSON.parse(require("fs").readFileSync(process.argv[1]));
    const regions = report.regions;
    const sum = (all) => all.reduce((a, b) => a + b, 0);
    for (const {name, counts, stalls} of regions) {
        const cycles = counts.instructions - counts.folded +
            sum(Object.values(stalls));
        if (cycles !== counts.cycles)
            throw Error(name + " has " + counts.cycles + ", not " + cycles);
    }
    const all = sum(regions.map((region) => region.counts.cycles));
    if (sum(report.symbols.map((symbol) => symbol.cycles)) !== all)
        throw Error("symbols do not sum to " + all);
    if (regions.length !== 9 || report.parameters.ddr !== 80)
        throw Error("not what was asked for");' "$scratch/report.json"

# A cycle for each instruction, and a line of code from memory with both words of
# its page table.
run qemu-arm -cpu arm1136 -plugin "$model" "$unknown"
about "an instruction that is not decoded"
expect_status 0
expect_err '^region _start entries 1 cycles 251 instructions 3 '
expect_err '^not decoded [0-9a-f]*: f1010000, 1 times'

# What a region beyond the last that there is room for does, and what follows it,
# counts nowhere.
run qemu-arm -cpu arm1136 -plugin "$model,json=$scratch/regions.json" "$regions"
about "more regions than there is room for"
expect_status 0
check "only regions are counted" node -e '
    const report = JSON.parse(require("fs").readFileSync(process.argv[1]));
    const cycles = (all) => all.reduce((sum, one) => sum + one, 0);
    const regions = cycles(report.regions.map((one) => one.counts.cycles));
    const symbols = cycles(report.symbols.map((one) => one.cycles));
    if (report.regions.length !== 512 || symbols !== regions)
        throw Error(report.regions.length + " regions of " + regions +
            " cycles, symbols of " + symbols);' "$scratch/regions.json"

for wrong in nonsense=1 ddr=much l1d=15 ideal=maybe misses=0; do
    model_run ",$wrong"
    expect_status 1
    expect_err "^arm1136: cannot use $wrong"
done
tap_done
