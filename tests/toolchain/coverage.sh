#!/bin/sh
# Tests coverage.py with sources and counts that are made here.
. "$(dirname "$0")/../support/tap.sh"
script=$PWD/toolchain/coverage.py

mkdir -p "$scratch/app/toy" "$scratch/counts"
cat >"$scratch/app/toy/toy.c" <<'END'
int toy(int size)
{
	void *memory = malloc(size);

	if (!memory) {
		log_error(log, "there is not enough memory");
		return -ENOMEM;
	}
	if (size == 7) {
		/* Not counted: a kernel
		 * without sevens. */
		size = 8;
	}
	if (size == 9) {
		log_error(log, "nine");
		return -EINVAL;
	}
	return 0;
}
END
{
    echo "SF:$scratch/app/toy/toy.c"
    for count in 3,2 5,2 6,0 7,0 9,2 12,0 14,2 15,0 16,0 18,2; do
        echo "DA:$count"
    done
    echo end_of_record
} >"$scratch/counts/lines.info"
run env -C "$scratch" python3 -B "$script" "$scratch/counts" \
    "$scratch/counts/lines.info"
about 'a file with lines of each kind'
expect_status 0
expect_out '^  50\.0%      10                      2       1        2  app/toy$'
expect_out '^  50\.0% .*  app and platform$'
listing=$scratch/counts/unreached.txt
check 'what only passes on a failure is named as that' \
    grep -q '^app/toy/toy.c:6: failure$' "$listing"
check 'a stated reason is repeated' \
    grep -q '^app/toy/toy.c:12: a kernel without sevens\.$' "$listing"
check 'the refusal of an input needs a test, with its lines' \
    sh -c 'grep -A 1 "^app/toy/toy.c:15: a test is missing$" "$1" |
        grep -q nine' sh "$listing"
tap_done
