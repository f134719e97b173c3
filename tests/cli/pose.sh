#!/bin/sh
# Tests the vertices that limber pose writes at different times.
. "$(dirname "$0")/../support/cli.sh"

# posed X Y: prints the triangle of the slider, moved to X and Y.
posed() {
    awk -v x="$1" -v y="$2" 'BEGIN {
        print "o node0_prim0"
        printf "v %.6f %.6f %.6f\n", x, y, 0
        printf "v %.6f %.6f %.6f\n", x + 1, y, 0
        printf "v %.6f %.6f %.6f\n", x, y + 1, 0
        print "f 1 2 3"
    }'
}

# expect_pose X Y ARGUMENT...: limber pose writes that triangle.
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

# Poses serve as references for other programs.
for math in float fixed; do
    limber pose "assets/walker.glb" --clip walk --time 0.4 --math $math -o "$scratch/$math.obj"
    expect_quiet
done
limber pose "assets/walker.glb" --clip walk --time 0.4 -o "$scratch/out.obj"
expect_quiet
check 'without --math, poses are computed in float' \
    cmp "$scratch/float.obj" "$scratch/out.obj"
check 'fixed point gives other digits' \
    test "$(cksum <"$scratch/float.obj")" != "$(cksum <"$scratch/fixed.obj")"

# A model smaller than a micrometre has as many digits as others.
sed 's/"name": "slider",/&"scale": [1.25e-7, 1.25e-7, 1.25e-7],/' \
    "$slider" >"$scratch/small.gltf"
limber pose "$scratch/small.gltf" -o "$scratch/out.obj"
expect_quiet
check 'a small model keeps its digits' \
    grep -qx 'v 0.000000125000 0.000000000000 0.000000000000' "$scratch/out.obj"

# sized SCALE: writes the pose of the slider of that scale.
sized() {
    sed "s/\"name\": \"slider\",/&\"scale\": [$1, $1, $1],/" \
        "$slider" >"$scratch/sized.gltf"
    limber pose "$scratch/sized.gltf" -o "$scratch/out.obj"
    expect_quiet
}

sized 1.25e-42
check 'the least float has 45 decimals, and no model more' \
    grep -qx 'v 0.0\{41\}1250 0.0\{45\} 0.0\{45\}' "$scratch/out.obj"
sized 0
check 'a model without a size has 6 decimals' \
    grep -qx 'v 0.000000 0.000000 0.000000' "$scratch/out.obj"
sized 0.1
check 'a model of 10 cm has 6 decimals' \
    grep -qx 'v 0.100000 0.000000 0.000000' "$scratch/out.obj"

# Programs that read the file know nothing of a node that mirrors.
sed 's/"name": "slider",/&"scale": [-1, 1, 1],/' "$slider" >"$scratch/mirror.gltf"
limber pose "$scratch/mirror.gltf" -o "$scratch/out.obj"
expect_quiet
check 'a mirrored triangle faces outwards' grep -qx 'f 1 3 2' "$scratch/out.obj"

# The first primitive of this model is points, which limber does not draw.
limber pose tests/fixtures/gltf/mesh/modes.gltf -o "$scratch/out.obj"
expect_status 0
check 'primitives keep the numbers of the file' \
    grep -qx 'o node0_prim1' "$scratch/out.obj"

# KHR_node_visibility
limber pose tests/fixtures/gltf/scene/hidden.gltf -o "$scratch/out.obj"
expect_status 0
check 'hidden nodes are left out' test "$(grep '^o ' "$scratch/out.obj")" = 'o node0_prim0'
tap_done
