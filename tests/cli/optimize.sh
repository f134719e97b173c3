#!/bin/sh
# Tests limber optimize: what it prints, writes and refuses.
. "$(dirname "$0")/../support/cli.sh"
here=$(cd "$(dirname "$0")" && pwd)
fixtures=$here/../fixtures/gltf
# A figure that an emulated ARM optimizes in a few seconds.
figure=${SAMPLES:-../shared}/models/CesiumMan.glb
test -f "$figure" || figure=$here/../../assets/walker.glb

# member FILE EXPRESSION: prints a value of a .glb's JSON, which is called j.
member() {
    python3 - "$1" "$2" <<'PYTHON'
import json
import struct
import sys
with open(sys.argv[1], 'rb') as file:
    data = file.read()
size, = struct.unpack_from('<I', data, 12)
j = json.loads(data[20:20 + size])
print(eval(sys.argv[2]))
PYTHON
}

limber optimize "$figure" -o "$scratch/figure.glb"
expect_status 0
expect_no_err
expect_out '^  KiB +before +after$'
# To a tenth of a KiB for each of the four parts.
check 'the parts make up the whole file' awk '
    /^  (keys|vertices|indices|all else) / { parts++; before += $(NF - 1); after += $NF }
    /^  the whole file / { whole++; before -= $(NF - 1); after -= $NF }
    END { exit !(parts == 4 && whole == 1 && before * before < 0.09 &&
        after * after < 0.09) }' "$out_file"
expect_out 'keys are left\. No vertex moves by more than 0\.[0-4][0-9]* px in 480x640\.$'
check 'the file is a quarter smaller' test "$(wc -c <"$scratch/figure.glb")" -lt \
    $(($(wc -c <"$figure") * 3 / 4))
check 'all clips keep their names' test \
    "$(member "$scratch/figure.glb" "[a.get('name') for a in j['animations']]")" = \
    "$(member "$figure" "[a.get('name') for a in j['animations']]")"
check 'all nodes keep their names' test \
    "$(member "$scratch/figure.glb" "[n.get('name') for n in j['nodes']]")" = \
    "$(member "$figure" "[n.get('name') for n in j['nodes']]")"
check 'the file states its error' test \
    "$(member "$scratch/figure.glb" "j['asset']['extras']['limber_error_px']")" = 0.5

limber optimize "$scratch/figure.glb" -o "$scratch/again.glb"
expect_status 0
expect_out 'No vertex moves by more than 0\.000 px'
expect_out '^An earlier run has used 0\.5 px of --error 0\.5 already\.$'
check 'a second run saves nothing' test "$(wc -c <"$scratch/again.glb")" -eq \
    "$(wc -c <"$scratch/figure.glb")"
limber info "$scratch/again.glb"
expect_status 0
expect_no_err

limber optimize "$fixtures/scene/cameras.gltf" -o "$scratch/cameras.glb"
expect_status 0
limber info "$fixtures/scene/cameras.gltf" --json
grep -c '"camera' "$out_file" >"$scratch/wanted"
limber info "$scratch/cameras.glb" --json
check 'cameras stay' test "$(grep -c '"camera' "$out_file")" = "$(cat "$scratch/wanted")"

# An image that nothing shows may be missing; an unknown extension is left out.
limber optimize "$fixtures/material/textures.gltf" -o "$scratch/textures.glb"
expect_status 0
expect_err 'limber does not know the extension EXT_unheard_of and leaves it out$'

# The file is read several times; what it lacks is said once.
sed '1s/{/&"extensionsRequired": ["KHR_lights_punctual"],/' "$slider" \
    >"$scratch/lit.gltf"
limber optimize "$scratch/lit.gltf" -o "$scratch/lit.glb"
expect_status 0
check 'a warning about the file is written once' \
    test "$(grep -c 'requires KHR_lights_punctual' "$err_file")" = 1

# A file with no room for the members that limber adds stays as it is.
python3 - "$scratch/tiny.glb" <<'PYTHON'
import json
import struct
import sys
data = struct.pack('<9f', 0, 0, 0, 1, 0, 0, 0, 1, 0)
text = json.dumps({
    'asset': {'version': '2.0'}, 'nodes': [{'mesh': 0}],
    'meshes': [{'primitives': [{'attributes': {'POSITION': 0}}]}],
    'accessors': [{'bufferView': 0, 'componentType': 5126, 'count': 3,
                   'type': 'VEC3', 'min': [0, 0, 0], 'max': [1, 1, 0]}],
    'bufferViews': [{'buffer': 0, 'byteLength': 36}],
    'buffers': [{'byteLength': 36}]}, separators=(',', ':')).encode()
text += b' ' * (-len(text) % 4)
with open(sys.argv[1], 'wb') as file:
    file.write(struct.pack('<4sII', b'glTF', 2, 28 + len(text) + len(data)) +
               struct.pack('<I4s', len(text), b'JSON') + text +
               struct.pack('<I4s', len(data), b'BIN') + data)
PYTHON
limber optimize "$scratch/tiny.glb" -o "$scratch/out.glb"
expect_status 0
expect_out '^limber found no smaller form: the file is written as it was\.$'
check 'a file that would grow is copied' cmp "$scratch/tiny.glb" "$scratch/out.glb"
echo '{"asset": {"version": "2.0"}, "nodes": [{}]}' >"$scratch/bare.gltf"
limber optimize "$scratch/bare.gltf" -o "$scratch/out.glb"
expect_status 0
expect_out "^The file is $(($(wc -c <"$scratch/out.glb") - $(wc -c <"$scratch/bare.gltf"))) bytes larger"

# A jump between two keys of one time stays.
limber optimize "$fixtures/clip/jump.gltf" -o "$scratch/jump.glb"
expect_status 0
for time in 0 0.9999 1; do
    limber pose "$fixtures/clip/jump.gltf" --clip 0 --time $time -o "$scratch/before.obj"
    limber pose "$scratch/jump.glb" --clip 0 --time $time -o "$scratch/after.obj"
    sed -i '/^#/d' "$scratch/before.obj" "$scratch/after.obj"
    check "at $time s a clip with a jump has the same vertices" \
        cmp "$scratch/before.obj" "$scratch/after.obj"
done

# idle CHANGE: writes idle.gltf, whose first clip moves an empty node that follows
# nothing and slides the triangle; a Python statement changes the node.
idle() {
    python3 - "$slider" "$scratch/idle.gltf" "$1" <<'PYTHON'
import json
import sys
model = json.load(open(sys.argv[1]))
node = {'name': 'hook'}
exec(sys.argv[3])
model['nodes'].append(node)
model['scenes'][0]['nodes'].append(1)
model['animations'][0]['channels'].append(
    {'sampler': 0, 'target': {'node': 1, 'path': 'translation'}})
json.dump(model, open(sys.argv[2], 'w'))
PYTHON
    limber optimize "$scratch/idle.gltf" -o "$scratch/idle.glb"
    expect_status 0
}

# Keys of a node that nothing drawn depends on are left out, but not where another
# program or the character file may use the node.
idle ''
expect_out '^4 of 6 keys are left'
idle 'node["extras"] = {"socket": 1}'
expect_out '^6 of 6 keys are left'
idle 'node["camera"] = 0; model["cameras"] = [{"type": "perspective",
    "perspective": {"yfov": 1, "znear": 1}}]'
expect_out '^6 of 6 keys are left'
idle 'node["children"] = [0]; model["scenes"][0]["nodes"] = []'
expect_out '^6 of 6 keys are left'
printf '[target hook]\n' >"$scratch/idle.character"
idle ''
expect_out '^6 of 6 keys are left'
# An included file names nodes as well, and a broken one is refused as by play.
printf 'include = shared.character\n' >"$scratch/idle.character"
printf '[names]\ntarget = "hook"\n' >"$scratch/shared.character"
idle ''
expect_out '^6 of 6 keys are left'
printf '[names]\ntarget = "hook\n' >"$scratch/shared.character"
limber optimize "$scratch/idle.gltf" -o "$scratch/idle.glb"
expect_status 1
expect_err 'shared.character:2: .*a quotation mark is missing'
rm "$scratch/idle.character" "$scratch/shared.character"

limber optimize
expect_refusal 2 'no model is given: use limber optimize MODEL -o FILE\.glb'
limber optimize "$slider"
expect_refusal 2 'there is no file to write: add -o FILE\.glb'
limber optimize "$slider" -o "$scratch/one.gltf"
expect_refusal 2 'the name of the file to write shall end in \.glb'
limber optimize "$slider" -o "$scratch/none/one.glb"
expect_refusal 1 'none'
limber optimize "$slider" -o "$scratch/one.glb" --error 0
expect_refusal 2 '--error'
limber optimize "$here/../fixtures/xfile/tower_binary_packed.x" -o "$scratch/x.glb"
expect_refusal 1 'limber optimizes glTF files only; this one is DirectX'
check 'nothing is written after a refusal' test ! -e "$scratch/x.glb"
tap_done
