#!/bin/sh
# Tests run.sh with a script in place of a libFuzzer program.
. "$(dirname "$0")/../support/tap.sh"
runner=$(dirname "$0")/run.sh

# given STATUS: writes a fuzzer that records its arguments and seeds and exits
# with STATUS.
given() {
    cat >"$scratch/fuzz_toy" <<END
#!/bin/sh
echo "\$*" >$scratch/arguments
for last; do :; done
ls "\$last" >$scratch/seeds
echo 'stat::number_of_executed_units: 12'
echo 'SUMMARY: what went wrong' >&2
exit $1
END
    chmod +x "$scratch/fuzz_toy"
}

mkdir -p "$scratch/first/deeper" "$scratch/second"
echo small >"$scratch/first/deeper/a.bin"
echo other >"$scratch/second/a.bin"
echo script >"$scratch/second/make.py"
dd if=/dev/zero of="$scratch/second/large.bin" bs=1024 count=100 2>/dev/null

given 0
run "$runner" "$scratch/fuzz_toy" "$scratch/first" "$scratch/second"
about 'a run that finds nothing'
expect_status 0
expect_out '^1..2$'
expect_out '^ok 2 - fuzz_toy finds no error'
expect_out '^# stat::number_of_executed_units: 12'
check 'the number of runs and the seed are fixed, the time is limited' grep -Eq -e \
    '-runs=[0-9]+ -seed=1 -max_total_time=[0-9]+ ' "$scratch/arguments"
check 'small files of all folders are seeds' test "$(wc -l <"$scratch/seeds")" -eq 2

CORPUS=$scratch/corpus
export CORPUS
run "$runner" "$scratch/fuzz_toy" "$scratch/first"
check 'a corpus is kept' test -d "$scratch/corpus"
unset CORPUS

given 77
run "$runner" "$scratch/fuzz_toy" "$scratch/first"
about 'a run that finds something'
expect_status 1
expect_out '^not ok 2 - fuzz_toy finds no error'
expect_out '^# SUMMARY: what went wrong'

run "$runner" "$scratch/none" "$scratch/first"
about 'a program that does not exist'
expect_status 1
expect_out '^not ok 2'
tap_done
