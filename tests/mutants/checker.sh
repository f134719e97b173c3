#!/bin/sh
# Tests which mutants draw.py makes of a small file.
. "$(dirname "$0")/../support/tap.sh"
here=$(cd "$(dirname "$0")" && pwd)

cat >"$scratch/small.c" <<'SOURCE'
/* 1 + 2 < 3 */
#define SIZE (4 + 5)
static const char *const text = "6 + 7";
int small(int *a, int count)
{
	int last[5], sum = 0;

	for (int i = 0; i < count; i++) {
		if (a[i] != '8') {
			sum += a[i] << 1;
		}
	}
	finish(a);
	return sum;
}
SOURCE

# Prints each mutant of the file: the line, and what became of it.
cat >"$scratch/list.py" <<'PYTHON'
import sys
sys.path.insert(0, sys.argv[1])
import draw
text = open(sys.argv[2]).read()
mutants = draw.mutants_of("small.c", text)
for mutant in mutants:
    made = mutant.apply(text).splitlines()
    assert len(made) == len(text.splitlines()), mutant
    print(f"{mutant.line}: {made[mutant.line - 1].strip()}")
print("of", len(mutants))
PYTHON

run python3 -B "$scratch/list.py" "$here" "$scratch/small.c"
about 'mutants of a file'
expect_status 0
expect_out '^8: for \(int i = 0; i <= count; i\+\+\) \{$'
expect_out '^8: for \(int i = 0; i > count; i\+\+\) \{$'
expect_out '^8: for \(int i = 0; i < count; i--\) \{$'
expect_out '^8: for \(int i = 1; i < count; i\+\+\) \{$'
expect_out "^9: if \(a\[i\] == '8'\) \{\$"
expect_out "^9: if \(!\(a\[i\] != '8'\)\) \{\$"
expect_out '^10: sum -= a\[i\] << 1;$'
expect_out '^10: sum \+= a\[i\] >> 1;$'
expect_out '^10: ;$'
expect_out '^13: ;$'
expect_out '^6: int last\[4\], sum = 0;$'
expect_out '^of 14$'
check 'comments, texts, directives and returns stay' \
    test -z "$(grep -E '^(1|2|3|14):' "$out_file")"
tap_done
