#!/bin/sh
# Tests which mutants draw.py makes of a small file, which of its functions reach.py
# says that a program calls, and which objects mutants.py replaces.
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

cat >"$scratch/calls.c" <<'SOURCE'
#include <stdlib.h>
#include <unistd.h>
#define FUNCTION(name) static int name(int a)
int table[] = {1, 2, 3};

static int inner(int a)
{
	return a + table[a & 1];
}

/* Calls the other one,
 * which GCC may put here. */
static int outer(int a,
                 int (*next)(int))
{
	return next(a) * 2;
}

FUNCTION(made)
{
	return a - 1;
}

int never(int a)
{
	return a - 2;
}

int main(int argc, char **argv)
{
	if (argc > 1) {
		return never(made(atoi(argv[1])));
	}
	_exit(outer(argc, inner) == 0);
}
SOURCE
mkdir -p "$scratch/tree/build/reached/obj" "$scratch/tree/tests/mutants"
cp "$here/reached.c" "$scratch/tree/tests/mutants"
cp "$scratch/calls.c" "$scratch/tree/calls.c"

# Prints for each line of calls.c whether the program calls its function, and how
# often the program was run.
cat >"$scratch/calls.py" <<'PYTHON'
import collections, pathlib, subprocess, sys
sys.path.insert(0, sys.argv[1])
import draw, reach
tree, arguments = pathlib.Path(sys.argv[2]), sys.argv[3:]
program, text = tree / "program", (tree / "calls.c").read_text()
suite = collections.namedtuple("Suite", "name command")("calls", arguments)
runs = 0

def run_noted():
    global runs
    runs += 1
    noted = "build/reached/obj/calls.o"
    subprocess.run(["gcc", "-pie", "-o", program, noted, reach.NOTER], cwd=tree,
                   check=True)
    return subprocess.run([program, *arguments]).returncode == 0

subprocess.run(["gcc", "-O1", "-fPIE", "-fno-inline", "-finstrument-functions",
                "-c", "-o", "build/reached/obj/calls.o", "calls.c"], cwd=tree,
               check=True)
for _ in range(2):
    calls = reach.Reach(tree, tree)
    calls.build()
    lines = [line for line in range(1, len(text.splitlines()) + 1)
             if calls.calls(suite, tree / "calls.c",
                            draw.Mutant("calls.c", line, 0, 0, ""), run_noted,
                            program)]
print("lines", *lines)
print("runs", runs)
PYTHON

# lines_but FIRST LAST...: all lines of calls.c but those from each FIRST to its LAST.
lines_but() {
    awk -v ranges="$*" 'BEGIN { count = split(ranges, end, " ") }
        { for (i = 1; i < count; i += 2) if (NR >= end[i] && NR <= end[i + 1]) next
          line = line " " NR } END { print "^lines" line "$" }' "$scratch/calls.c"
}
run python3 -B "$scratch/calls.py" "$here" "$scratch/tree"
about 'functions that a program calls before it exits at once'
expect_status 0
expect_out "$(lines_but 25 27)"
expect_out '^runs 1$'
run python3 -B "$scratch/calls.py" "$here" "$scratch/tree" 3
about 'functions that macros make, or that stand between others'
expect_out "$(lines_but 7 9 15 17)"
run python3 -B "$scratch/calls.py" "$here" "$scratch/tree" 4
about 'a program that fails may have called everything'
expect_out "$(lines_but)"
expect_out '^runs 1$'

# Prints a link command without the objects of a source file.
cat >"$scratch/link.py" <<'PYTHON'
import sys
sys.path.insert(0, sys.argv[1])
import mutants
print(mutants.without_source(sys.argv[3], sys.argv[2]))
PYTHON
link='cc -o t build/host/obj/t.o build/host/obj/v1/a/b.o build/host/obj/v1/a/bb.o lib.a'
run python3 -B "$scratch/link.py" "$here" a/b.c "$link"
about 'a mutant replaces an object that a test compiles by itself'
expect_out '^cc -o t build/host/obj/t.o build/host/obj/v1/a/bb.o lib.a$'
run python3 -B "$scratch/link.py" "$here" b.c "$link"
about 'objects of other sources stay'
expect_out "^$link\$"
tap_done
