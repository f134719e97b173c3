#!/bin/sh
# Runs a program of cases under the timing model and compares the cycles of each
# case with those that its CASE line states.
#
#   micro.sh MODEL PROGRAM SOURCE
set -u
. "$(dirname "$0")/../support/tap.sh"

model=$1
program=$2
source=$3

run qemu-arm -cpu arm1136 -plugin "$model" "$program"
expect_status 0
cp "$err_file" "$scratch/report"

# found NAME: prints the cycles that the model counted in a case's last run.
found() {
    awk -v name="$1" '$1 == "region" && $2 == name {
        for (i = 3; i < NF; i += 2)
            if ($i == "last") print $(i + 1)
    }' "$scratch/report"
}

sed -n 's/^[[:space:]]*CASE \([a-z0-9_]*\), \([0-9]*\)$/\1 \2/p' "$source" \
    >"$scratch/cases"
while read -r name cycles; do
    got=$(found "$name")
    if [ "$got" = "$cycles" ]; then
        pass "$name: $cycles cycles"
    else
        fail "$name: $cycles cycles" "the model says ${got:-nothing}"
    fi
done <"$scratch/cases"

about "$(basename "$program")"
if grep -q 'not decoded' "$scratch/report"; then
    fail "every instruction is decoded" "$(grep 'not decoded' "$scratch/report")"
else
    pass "every instruction is decoded"
fi

# The addresses that the model computed were those that the program used.
if awk '$2 == "foretold" && $5 { exit 1 }' "$scratch/report"; then
    pass "no address is mistaken"
else
    fail "no address is mistaken" "$(grep foretold "$scratch/report")"
fi

# cycles = instructions - folded + stalls, in every region.
if awk '
    $1 == "region" { name = $2; cycles = $6; want = $8; seen++ }
    $1 == "stalls" && name { for (i = 3; i <= NF; i += 2) want += $i }
    $1 == "branches" { if (cycles != want - $4) { print name; bad = 1 } }
    END { exit bad || !seen }' "$scratch/report" >"$scratch/unequal"; then
    pass "stalls account for all cycles"
else
    fail "stalls account for all cycles" "$(cat "$scratch/unequal")"
fi
tap_done
