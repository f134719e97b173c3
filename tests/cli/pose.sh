#!/bin/sh
# limber pose: what it writes, and when.
. "$(dirname "$0")/../support/cli.sh"

# posed X Y: the triangle of the slider, moved there.
posed() {
    awk -v x="$1" -v y="$2" 'BEGIN {
        print "o node0_prim0"
        printf "v %.6f %.6f %.6f\n", x, y, 0
        printf "v %.6f %.6f %.6f\n", x + 1, y, 0
        printf "v %.6f %.6f %.6f\n", x, y + 1, 0
        print "f 1 2 3"
    }'
}

# expect_pose X Y ARGUMENTS...
expect_pose() {
    posed "$1" "$2" >"$scratch/expected"
    shift 2
    limber pose "$slider" "$@" -o "$scratch/out.obj"
    expect_quiet
    grep -v '^#' "$scratch/out.obj" >"$scratch/actual"
    check "$tap_about: the expected vertices" \
        diff "$scratch/expected" "$scratch/actual"
}

expect_pose 0 0
expect_pose 0 0 --time 1
expect_pose 0 0 --clip slide
expect_pose 2 0 --clip slide --time 1
expect_pose 2 0 --clip 0 --time 1
expect_pose 0 1 --clip rise --time 1
expect_pose 0 1 --clip 1 --time 1
expect_pose 4 0 --clip slide --time 2
expect_pose 4 0 --clip slide --time 5
expect_pose 0.5 0 --clip=slide --time=0.25

cp "$slider" "$scratch/-strange name.gltf"
limber pose --clip slide --time 1 -o "$scratch/out.obj" -- "$scratch/-strange name.gltf"
expect_quiet
expect_file "$scratch/out.obj"

# Its first part is points, which are not drawn.
limber pose tests/fixtures/gltf/mesh/modes.gltf -o "$scratch/out.obj"
expect_status 0
check 'parts keep the numbers of the file' \
    grep -qx 'o node0_prim1' "$scratch/out.obj"
tap_done
