#!/bin/sh
# Tests what limber info prints, as text and as JSON.
. "$(dirname "$0")/../support/cli.sh"

limber info "$slider"
expect_status 0
expect_no_err
expect_out 'slider\.gltf'
expect_out 'triangle'
expect_out 'slide'
expect_out 'rise'
expect_out ' 2\.0+ '

expect_out 'slider\.gltf: .*, 1 node, 3 vertices, 1 triangle, '

# The names that a character file uses, each below its parent.
limber info assets/arm.glb --nodes
expect_status 0
expect_no_err
expect_out '^  Arm  mesh 5$'
expect_out '^    Forearm  mesh 4$'
limber info tests/fixtures/gltf/skin/and_morph.gltf --nodes
expect_out '^  .*  joint$'
expect_out '^  .*  mesh 0$'
limber info "$slider"
check 'nodes are listed only when asked for' sh -c '! grep -q "^nodes" "$1"' \
    sh "$out_file"
limber info assets/arm.glb --nodes --json
expect_out '"hierarchy"'
expect_out '"parent": -1'
limber info assets/arm.glb --json
check 'JSON has nodes only when asked for' sh -c '! grep -q hierarchy "$1"' \
    sh "$out_file"

# Targets without names are counted, not listed.
targets=tests/fixtures/gltf/mesh/weights.gltf
limber info "$targets"
expect_status 0
check 'no list of (unnamed) targets' sh -c '! grep -q "targets: (unnamed)" "$1"' \
    sh "$out_file"

# One name among them is enough for a list.
sed 's/"up"/""/' tests/fixtures/gltf/skin/and_morph.gltf >"$scratch/first.gltf"
limber info "$scratch/first.gltf"
expect_status 0
expect_out 'targets: out, \(unnamed\)$'

# An image that is larger than textures is halved.
python3 -c '
import json, struct, sys, zlib
def chunk(kind, data):
    return (struct.pack(">I", len(data)) + kind + data +
            struct.pack(">I", zlib.crc32(kind + data)))
with open(sys.argv[2] + "/large.png", "wb") as png:
    png.write(b"\x89PNG\r\n\x1a\n" +
              chunk(b"IHDR", struct.pack(">IIBBBBB", 4095, 2048, 8, 0, 0, 0, 0)) +
              chunk(b"IDAT", zlib.compress(bytes(4096 * 2048))) +
              chunk(b"IEND", b""))
file = json.load(open(sys.argv[1]))
file["images"] = [{"uri": "large.png", "name": "large"}]
file["textures"] = [{"source": 0}]
file["materials"] = [{"normalTexture": {"index": 0}}]
json.dump(file, open(sys.argv[2] + "/large_image.gltf", "w"))' "$slider" "$scratch"
limber info "$scratch/large_image.gltf"
expect_status 0
expect_out '^ +0 +4095x2048 \(read as 2048x1024\)  large$'
echo 'GIF89a, say' >"$scratch/large.png"
limber info "$scratch/large_image.gltf"
expect_refusal 1 'gltf: /images/0 \(large.png\): the image is neither PNG nor JPEG: convert'

limber info "$slider" --json
expect_status 0
expect_no_err
# shellcheck disable=SC2016 # JavaScript
check 'the JSON has the clips' node -e '
    const info = JSON.parse(require("fs").readFileSync(process.argv[1]));
    const names = info.clips.map((clip) => clip.name);
    if (names.join() !== "slide,rise") { throw new Error(names.join()); }
' "$out_file"

levels=tests/fixtures/gltf/mesh/levels.gltf
limber info "$levels"
expect_status 0
expect_no_err
expect_out 'levels: 6 at 10 mm, 2 at 100 mm, 1 at 50 mm for shadows'

python3 -c '
import json, sys
file = json.load(open(sys.argv[1]))
for node in file["nodes"]:
    if "mesh" in node:
        node["scale"] = [2, 2, 2]
json.dump(file, open(sys.argv[2], "w"))' "$levels" "$scratch/large.gltf"
limber info "$scratch/large.gltf"
expect_out 'levels: 6 at 20 mm, 2 at 200 mm, 1 at 100 mm for shadows'

# has_levels MODEL LEVELS: the JSON has triangles, error and shape of each.
has_levels() {
    limber info "$1" --json
    # shellcheck disable=SC2016 # JavaScript
    check 'the JSON has the levels of detail' node -e '
        const info = JSON.parse(require("fs").readFileSync(process.argv[1]));
        const told = info.meshes[0].levels.map((level) =>
            `${level.triangles} ${level.error_m.toFixed(3)} ${level.shape}`);
        if (told.join() !== process.argv[2]) {
            throw new Error(told.join());
        }
    ' "$out_file" "$2"
}

has_levels "$levels" '6 0.010 false,2 0.100 false,1 0.050 true'
has_levels "$scratch/large.gltf" '6 0.020 false,2 0.200 false,1 0.100 true'

# report MODEL: the whole report is that of standard input. How many bytes limber
# takes is its own affair; that pictures are decoded to 4 bytes a pixel is not.
report() {
    cat >"$scratch/expected"
    limber info "tests/fixtures/gltf/$1"
    expect_status 0
    sed 's|^tests/fixtures/gltf/||; /^bytes in memory/,/clips  /d' \
        "$out_file" >"$scratch/report"
    check 'the report' cmp "$scratch/expected" "$scratch/report"
}

report skin/and_morph.gltf <<'REPORT'
skin/and_morph.gltf: glTF 2.0, 2 nodes, 3 vertices, 1 triangle, 1 material

meshes     parts vertices triangles targets
    0          1        3         1       2  (unnamed)
           targets: out, up

skins      joints
    0           1  (unnamed)
vertices by their number of influences: 3 with 1

clips      seconds  30 Hz  ticks channels  keys
    0         1.00   30.0   4800        2     4  both

REPORT

limber info tests/fixtures/gltf/skin/odd_weights.gltf
expect_out '^vertices by their number of influences: 3 with 1 \| 1 with 2$'
limber info tests/fixtures/gltf/skin/shared_mesh.gltf
expect_out '^    1           3  \(unnamed\)$'
limber info tests/fixtures/gltf/material/textures.gltf
expect_out '^    0      2x2 with alpha  beside$'
expect_out '^    1      1x1  inside$'
expect_out '^    2      16x8  jpeg$'
expect_out '^  images +532  decoded$'

limber info tests/fixtures/gltf/skin/and_morph.gltf --json
# shellcheck disable=SC2016 # JavaScript
check 'the JSON says the same' node -e '
    const info = JSON.parse(require("fs").readFileSync(process.argv[1]));
    delete info.bytes;
    const expected = {file: "tests/fixtures/gltf/skin/and_morph.gltf",
        format: "glTF 2.0", nodes: 2, vertices: 3, triangles: 1,
        materials: 1, joints: 1,
        meshes: [{name: "", primitives: 1, vertices: 3, triangles: 1,
            targets: ["out", "up"], levels: []}],
        skins: [{name: "", joints: 1}], influences: [0, 3],
        clips: [{name: "both", duration_s: 1, channels: 2, keys: 4}],
        images: []};
    if (JSON.stringify(info) !== JSON.stringify(expected)) {
        throw new Error(JSON.stringify(info));
    }
' "$out_file"
tap_done
