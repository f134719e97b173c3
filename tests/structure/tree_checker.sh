#!/bin/sh
# Shows that tree.py fails for a tree that breaks one of its rules.
. "$(dirname "$0")/../support/tap.sh"
here=$(cd "$(dirname "$0")" && pwd)
TREE=$scratch/tree
OBJECTS=$scratch/objects
export TREE OBJECTS

# given: a clean tree. add FILE TEXT: appends a line to one of its files.
given() {
    rm -rf "$TREE" "$OBJECTS"
    mkdir -p "$TREE/app/anim" "$TREE/platform/gl"
    add app/anim/pose.h 'int pose_mix(int from);'
    add app/anim/pose.c '#include "app/anim/pose.h"'
    add app/anim/pose.c 'int gl_draw(int); int pose_mix(int from) { return gl_draw(from); }'
    add platform/gl/gl.c 'int gl_draw(int); int gl_draw(int x) { return x; }'
    add app/README.md '- a bullet'
}
add() {
    printf '%s\n' "$2" >>"$TREE/$1"
}

# check_tree NAME: compiles the tree and runs the checks.
check_tree() {
    for file in $(cd "$TREE" && find . -name '*.c'); do
        mkdir -p "$OBJECTS/$(dirname "$file")"
        gcc -I "$TREE" -c -o "$OBJECTS/${file%.c}.o" "$TREE/$file"
    done
    run "$here/tree.sh"
    about "$1"
}

# refuses NAME SENTENCE: the tree breaks one rule, and the sentence says where.
refuses() {
    check_tree "$1"
    expect_status 1
    expect_out "^# $2\$"
    check "$1: one rule is broken" \
        test "$(grep -c '^not ok' "$out_file")" -eq 1
}

given
check_tree 'a clean tree'
expect_status 0
expect_out '^1\.\.9$'

given
for number in $(seq 25); do add "app/anim/pose_$number.h" ''; done
refuses 'a folder of 27 files' 'app/anim has 27 source files'

given
seq 500 | sed 's/.*//' >>"$TREE/app/anim/pose.h"
refuses 'a file of 501 lines' 'app/anim/pose.h has 501 lines'

given
mkdir -p "$TREE/tests/unit/anim" "$TREE/tests/unit/gl"
add tests/unit/anim/test_parts.c ''
add tests/unit/gl/test_parts.c ''
refuses 'two unit tests of one name' \
    'tests/unit/anim/test_parts.c and tests/unit/gl/test_parts.c have one name'

given
add app/anim/pose.h '#include "app/anim/clip.h"'
add app/anim/clip.h '#pragma once'
add app/anim/clip.h '#include "app/anim/pose.h"'
refuses 'headers that include each other' 'app/anim/clip.h and app/anim/pose.h'

given
mkdir "$TREE/platform/gl/soft"
add platform/gl/soft/row.h '#include "platform/gl/soft/point.h"'
add platform/gl/soft/point.h 'int gl_point(void);'
add platform/gl/soft/point.c '#include "platform/gl/soft/row.h"'
refuses 'a source file that includes what includes its header' \
    'platform/gl/soft/point and platform/gl/soft/row'

given
add platform/gl/gl.c 'int pose_mix(int); int gl_flush(void); int gl_flush(void) { return pose_mix(1); }'
refuses 'files that call each other' 'app/anim/pose.c and platform/gl/gl.c'

given
add app/anim/pose.c 'int mix(void); int mix(void) { return 0; }'
refuses 'a name without a prefix' 'app/anim/pose.c exports mix'

given
add app/README.md "- $(printf 'word %.0s' $(seq 30))"
add app/README.md "  $(printf 'word %.0s' $(seq 20))"
refuses 'a long bullet' 'app/README.md:2 has a bullet of 251 characters'

given
add app/anim/pose.c 'const char *pose_text = "The first half of"'
add app/anim/pose.c '    " a sentence.";'
refuses 'a broken sentence' 'app/anim/pose.c:3 breaks a sentence'

given
add app/anim/pose.c 'const char *pose_text = "A line.\n"'
add app/anim/pose.c '    "Another line.\n";'
check_tree 'a literal for each line'
expect_status 0

rm -r "$TREE" "$OBJECTS"
mkdir -p "$TREE" "$OBJECTS"
run "$here/tree.sh"
about 'an empty tree'
expect_status 1
tap_done
