#!/bin/sh
# Tests in what folders limber can be built. A copy of what one object file needs is
# made in each.
. "$(dirname "$0")/../support/tap.sh"
top=$(cd "$(dirname "$0")/../.." && pwd)

# built FOLDER: makes the object file of arena.c in a copy at that path.
built() {
    mkdir -p "$scratch/$1"
    cp -r "$top/Makefile" "$top/toolchain" "$top/app" "$top/platform" "$scratch/$1"
    mkdir -p "$scratch/$1/board" "$scratch/$1/tests" "$scratch/$1/build/host"
    cp -r "$top/board/imx31-pdk" "$scratch/$1/board"
    cp -r "$top/tests/support" "$scratch/$1/tests"
    cp "$top/build/host/cflags" "$scratch/$1/build/host"
    touch "$scratch/$1/build/host/packages.stamp"
    run make -C "$scratch/$1" build/host/obj/platform/base/arena.o
    about "a folder called $1"
}

for folder in 'my limber' 'a"b' 'a$b' 'a#b' 'a\b' 'a:b;c&d(e)'; do
    built "$folder"
    expect_status 0
    check "$folder: there is an object file" \
        test -s "$scratch/$folder/build/host/obj/platform/base/arena.o"
done
built "a'b"
expect_status 2
expect_err 'path has an apostrophe: rename it'

# Linux's own Makefile refuses such folders, in a log.
: >"$scratch/tarball"
run "$top/board/imx31-pdk/kernel/build.sh" "$scratch/tarball" "$scratch/a kernel"
about 'a kernel in a folder with a space'
expect_status 1
expect_err 'path has a space or a colon; move limber to another folder$'
tap_done
