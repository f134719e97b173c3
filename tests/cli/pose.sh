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
# Models 1,000 km from the origin, where floats are 6 cm apart, are posed as exactly
# as near it, and the file's coordinates are written.
cat >"$scratch/far.py" <<'END'
"""far.py SLIDER FOLDER: writes the slider far away, in four ways."""
import base64, copy, json, struct, sys
near = json.load(open(sys.argv[1], encoding="utf-8"))
AT = [1000000.5, 256.25, -500000.0]
def write(name, model):
    json.dump(model, open(f"{sys.argv[2]}/{name}.gltf", "w", encoding="utf-8"))
def moved(model, views):
    data = bytearray(base64.b64decode(model["buffers"][0]["uri"].split(",")[1]))
    for number in views:
        view = model["bufferViews"][number]
        span = range(view["byteOffset"], view["byteOffset"] + view["byteLength"], 4)
        for i, at in enumerate(span):
            value, = struct.unpack_from("<f", data, at)
            struct.pack_into("<f", data, at, value + AT[i % 3])
    model["buffers"][0]["uri"] = "data:application/octet-stream;base64," + \
        base64.b64encode(data).decode()
    return model
def turned(model):
    model["nodes"][0]["rotation"] = [0, 0, 0.19509032, 0.98078528]
    return model
below = turned(copy.deepcopy(near))
below["nodes"].append({"children": [0], "translation": AT})
below["scenes"][0]["nodes"] = [1]
write("near", turned(copy.deepcopy(near)))
write("node", below)
keys = turned(moved(copy.deepcopy(near), [3, 4]))
keys["nodes"][0]["translation"] = AT
write("keys", keys)
write("vertices", moved(copy.deepcopy(near), [0]))
write("straight", near)
END
mkdir "$scratch/far"
python3 "$scratch/far.py" "$slider" "$scratch/far"
moved_away() {
    awk '$1 == "v" { printf "v %.6f %.6f %.6f\n", $2 + 1000000.5, $3 + 256.25, $4 - 500000; next }
        { print }' "$1"
}
for pair in near:node near:keys straight:vertices; do
    for math in float fixed; do
        for name in "${pair%:*}" "${pair#*:}"; do
            limber pose "$scratch/far/$name.gltf" --clip rise --time 1.3 \
                --math $math -o "$scratch/$name.obj"
            expect_quiet
        done
        moved_away "$scratch/${pair%:*}.obj" >"$scratch/expected.obj"
        check "far $name, $math: only the place differs" \
            cmp "$scratch/expected.obj" "$scratch/$name.obj"
    done
done
limber doctor "$scratch/far/node.gltf"
expect_status 0
expect_out 'a place far from the origin \(1\.12e\+06 m\): limber poses'
# What limber exports is where the model is.
limber compare "$scratch/far/node.gltf" --clip rise --size 48x64 \
    --export "$scratch/far/out"
expect_status 0
limber pose "$scratch/far/node.gltf" --clip rise --time 2 -o "$scratch/node.obj"
for file in "$scratch"/far/out/*.glb; do
    limber pose "$file" --clip rise --time 2 -o "$scratch/exported.obj"
    expect_quiet
    check "${file##*/} is at the same place" sh -c '
        sed -n 2,4p "$1" >"$1.v"; grep "^v" "$2" | paste - "$1.v" |
        awk "{ for (i = 2; i < 5; i++) { d = \$i - \$(i + 4); if (d * d > 1e-4) exit 1 } }"' \
        sh "$scratch/node.obj" "$scratch/exported.obj"
done
limber optimize "$scratch/far/keys.gltf" -o "$scratch/far/small.glb"
expect_status 0
limber pose "$scratch/far/small.glb" --clip rise --time 1.3 -o "$scratch/small.obj"
limber pose "$scratch/far/keys.gltf" --clip rise --time 1.3 -o "$scratch/keys.obj"
check 'an optimized model is where it was' cmp "$scratch/keys.obj" "$scratch/small.obj"
limber export "$scratch/far/keys.gltf" --clip rise --c "$scratch/keys.c"
expect_status 0
check 'C source states the keys of the file' grep -q '1000000\.5' "$scratch/keys.c"
# It says nothing of a model that it cannot draw.
limber render "$scratch/far/node.gltf" --size 64x64 --frames 1 --no-labels \
    --gl soft -o "$scratch/far.png"
expect_quiet
tap_done
