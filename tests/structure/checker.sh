#!/bin/sh
# The checks of this folder, held against trees and files that break the rules.
. "$(dirname "$0")/../support/tap.sh"
here=$(cd "$(dirname "$0")" && pwd)
tree=$scratch/tree

# given [FILE LINE]: makes a clean tree, with one more line in that file.
given() {
    rm -rf "$tree"
    for folder in app/model app/anim/kernel app/scene app/demo app/cmd \
        platform/base platform/gl/soft; do
        mkdir -p "$tree/$folder"
        printf '#include <string.h>\n' >"$tree/$folder/a.c"
    done
    printf '#include "app/cmd/a.h"\n' >"$tree/app/main.c"
    printf '#include <jansson.h>\n' >"$tree/app/model/json.c"
    printf '#include "platform/gl/gl.h"\n#include "app/anim/a.h"\n#include <cglm/cglm.h>\n' \
        >"$tree/app/scene/b.c"
    printf '#include "app/anim/a.h"\n#include "platform/base/a.h"\n' \
        >"$tree/app/anim/kernel/b.c"
    printf '#include <SDL2/SDL.h>\n#include "gl_drivers.h"\n' \
        >"$tree/platform/gl/b.c"
    [ $# -eq 0 ] || printf '%s\n' "$2" >>"$tree/$1"
    TREE=$tree run "$here/includes.sh"
}

# refuses FILE LINE: that line breaks a rule, and the test says so.
refuses() {
    given "$1" "$2"
    about "$1 with $2"
    expect_status 1
    expect_out '^not ok '
    expect_out "# $1 includes "
}

given
about 'a clean tree'
expect_status 0
refuses app/model/a.c '#include "app/anim/pose.h"'
refuses app/anim/a.c '#include "app/scene/draw/draw.h"'
refuses app/anim/kernel/a.c '#include "app/demo/demo.h"'
refuses app/scene/a.c '#include "app/demo/demo.h"'
refuses app/demo/a.c '#include "app/cmd/options/options.h"'
refuses app/demo/a.c '#include "app/other/x.h"'
refuses platform/base/a.c '#include "app/model/model.h"'
refuses platform/gl/soft/a.c '#  include "app/model/model.h"'
refuses app/anim/a.c '#include "platform/gl/gl.h"'
refuses app/model/a.c '#include "platform/display/display.h"'
refuses app/scene/a.c '#include "platform/gl/soft/soft.h"'
refuses app/scene/a.c '#include "draw.h"'
refuses app/scene/a.c '#include <GLES/gl.h>'
refuses app/cmd/a.c '#include <SDL2/SDL.h>'
refuses app/scene/a.c '#include <jansson.h>'
refuses app/model/a.c '#include <linux/fb.h>'
refuses app/anim/a.c '#include <stdio.h>'

rm -r "$tree/app" "$tree/platform"
mkdir "$tree/app" "$tree/platform"
TREE=$tree run "$here/includes.sh"
about 'an empty tree'
expect_out '^1..0$'

# One object that calls the C library's maths, one that does not.
mkdir "$scratch/objects"
compile() {
    printf '%s\n' "$2" | arm-linux-gnueabi-gcc -O2 -c -x c -o \
        "$scratch/objects/$1.o" -
}
compile good 'float twice(float x) { return x + x; }'
OBJECTS=$scratch/objects run "$here/libm.sh"
about 'objects without maths'
expect_status 0
compile bad 'float sinf(float); float both(float x) { return sinf(x) + x; }'
OBJECTS=$scratch/objects run "$here/libm.sh"
about 'an object that calls sinf'
expect_status 1
expect_out '^not ok .*bad.o'
expect_out '^ok .*good.o'
expect_out '^# calls sinf'
rm "$scratch"/objects/*
OBJECTS=$scratch/objects run "$here/libm.sh"
about 'no objects'
expect_status 1

# laid_out LINE STATUS: a tree with that line passes the check of the layout or not.
laid_out() {
    given platform/base/a.c "$1"
    mkdir "$tree/tests"
    find "$tree" -name b.c -delete
    TREE=$tree run "$here/format.sh"
    about "a layout with $1"
    expect_status "$2"
}
if command -v clang-format-14 >/dev/null; then
    laid_out 'int count;' 0
    laid_out 'int  count;' 1
    expect_out '^# run clang-format-14 -i platform/base/a.c'
    laid_out "/*
 *a comment
 */" 1
    expect_out 'platform/base/a.c:3: \*a comment'
fi

# analysed TEXT STATUS: a tree with that text passes the analysers or not.
analysed() {
    rm -rf "$tree"
    mkdir -p "$tree/app" "$tree/platform"
    printf '%s\n' "$1" >"$tree/platform/a.c"
    TREE=$tree run "$here/analysis.sh"
    about "$(echo "$1" | tr '\n' ' ') for the analysers"
    expect_status "$2"
}
if command -v clang-tidy-14 >/dev/null && command -v cppcheck >/dev/null; then
    analysed 'int first(const int *a); int first(const int *a) { return a[0]; }' 0
    analysed 'int same(int a); int same(int a) { return a ? 1 : 1; }' 1
    expect_out '^not ok .*clang-tidy'
    analysed 'int past(void); int past(void) { int a[2] = {1, 2}; return a[2]; }' 1
    expect_out '^not ok .*cppcheck'
    expect_out '^# platform/a.c:1: '
    for macro in __ARM_FEATURE_DSP __SSE2__; do
        analysed "#ifdef $macro
int past(void); int past(void) { int a[2] = {1, 2}; return a[2]; }
#endif" 1
        expect_out '^not ok .*cppcheck'
    done
fi

# workflow FILE SCRIPT: the check of a workflow file that sed has changed.
workflow() {
    sed "$2" "$here/../../$1" >"$scratch/workflow"
    FILES=$scratch/workflow run "$here/ci.sh"
    about "$1 after $2"
}
for file in .github/workflows/check.yml .gitlab-ci.yml; do
    workflow "$file" ''
    expect_status 0
    workflow "$file" 's/debian:12/debian:13/'
    expect_out 'does not run in debian:12'
    workflow "$file" 's/\.ci\/run/make/'
    expect_out 'does not run .ci/run'
    workflow "$file" 's/ git make/ git make gcc/'
    expect_out 'does not install git, make and certificates alone'
    workflow "$file" 's/180$/18/; s/3 hours/1 hour/'
    expect_out 'does not allow three hours'
    workflow "$file" '$a cache: here'
    expect_out 'relies on a cache'
    expect_status 1
done

tap_done
