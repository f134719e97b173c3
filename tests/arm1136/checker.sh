#!/bin/sh
# Shows that micro.sh fails for a wrong model and for a wrong case.
#
#   checker.sh MODEL FOLDER    FOLDER holds the programs of cases
set -u
folder=$(dirname "$0")
. "$folder/../support/tap.sh"

model=$1
programs=$2

# failures: prints the names of the tests that failed in the last run.
failures() {
    sed -n 's/^not ok [0-9]* - \([a-z0-9_]*\).*/\1/p' "$out_file" | tr '\n' ' '
}

# expect_failures NAME LIST: the last run failed in just these tests.
expect_failures() {
    if [ "$status" -ne 0 ] && [ "$(failures)" = "$2 " ]; then
        pass "$1"
    else
        fail "$1" "failed: $(failures)"
    fi
}

run "$folder/micro.sh" "$model,byte=0" "$programs/memory" \
    "$folder/micro/memory.S"
expect_failures "bytes that come early are noticed" "ldrb_use ldrsh_use"

run "$folder/micro.sh" "$model,fold=off" "$programs/branch" \
    "$folder/micro/branch.S"
expect_failures "branches that never fold are noticed" \
    "loop_folded loop_one_between loop_two_between dynamic_not_taken branch_always_folded branch_to_branch"

run "$folder/micro.sh" "$model,ddr=81" "$programs/cache" \
    "$folder/micro/cache.S"
expect_failures "slower memory is noticed" \
    "ddr_use two_misses ddr_streaming store_miss_does_not_allocate pld_late"

run "$folder/micro.sh" "$model,tlb=9" "$programs/pages" \
    "$folder/micro/pages.S"
expect_failures "slower translation is noticed" \
    "eleven_pages page_walk_in_l2 page_walk_in_memory no_hit_under_page_walk store_waits_for_page main_tlb_has_two_ways"

sed 's/CASE ldr_use, 16/CASE ldr_use, 15/; s/CASE ldr_to_str,/CASE ldr_to_nothing,/' \
    "$folder/micro/memory.S" >"$scratch/memory.S"
run "$folder/micro.sh" "$model" "$programs/memory" "$scratch/memory.S"
expect_failures "a wrong case and a missing one are noticed" \
    "ldr_use ldr_to_nothing"

run "$folder/micro.sh" "$scratch/none.so" "$programs/memory" \
    "$folder/micro/memory.S"
expect_status 1
tap_done
