#!/bin/sh
# Tests limber compare: recomputes its figures from the files that it writes, and
# tests its formats and what it refuses.
. "$(dirname "$0")/../support/cli.sh"

samples=${SAMPLES:-../shared}/models
here=$(cd "$(dirname "$0")" && pwd)

# run_with_glb CODE ARGUMENTS: Python that may read files by compare_check's Glb.
run_with_glb() {
    code=$1
    shift
    PYTHONPATH=$here python3 -B -c "import glob, sys
from compare_check import Glb
$code" "$@"
}

# In qemu-arm a large model takes half a minute, beside other suites more. There, and
# under the sanitizers, small models go the same ways where the figures are not the
# machine's. Only the sanitizers compare a large one too, the walker.
# Poses in floats are the same bytes on both machines (tests/conformance/fixed.sh).
poses=$limber
emulated=false
case $limber in
qemu-*) slow=true emulated=true poses=build/host/limber ;;
*asan*) slow=true ;;
*) slow=false ;;
esac

# compare ARGUMENTS...: compares in a small picture, as most of the time of a small
# model goes into drawing it.
compare() {
    limber compare --size 160x96 "$@"
}

# recomputed MODEL CLIP COUNT: recomputes COUNT figures from the baked models.
recomputed() {
    name=$(basename "$1")
    if [ ! -f "$1" ]; then
        skip "$name: figures recomputed" "no such sample model"
        return
    fi
    rm -rf "$scratch/baked"
    limber compare "$1" --clip "$2" --error 2 --format json \
        --export "$scratch/baked"
    expect_status 0
    cp "$out_file" "$scratch/report.json"
    # shellcheck disable=SC2086 # a command and its arguments
    python3 "$here/compare_check.py" "$scratch/report.json" "$1" \
        "$scratch/baked" $poses >"$scratch/checked" 2>&1 || true
    while read -r line; do
        case $line in
        'ok '*) pass "$name: recomputed: ${line#* - }" ;;
        'not ok '*) fail "$name: recomputed: ${line#* - }" "$(cat "$scratch/checked")" ;;
        esac
    done <"$scratch/checked"
    check "$name: all figures were recomputed" grep -qx "1..$3" "$scratch/checked"
}

$slow || recomputed "$samples/CesiumMan.glb" 0 32
if $emulated; then
    recomputed "$samples/RiggedFigure.glb" 0 32
else
    recomputed "$here/../../assets/walker.glb" walk 33
fi
$emulated || for file in skin-1.glb skin.glb morph-even-20.glb; do
    limber info "$scratch/baked/$file"
    expect_status 0
    check "$file has the levels of the model's file" grep -q \
        '^ *levels: .* at .*mm, .* at .*mm for shadows' "$out_file"
done

# walk_away: the walker with a walk that goes 1.65 m, in $scratch/away.glb.
walk_away() {
    # shellcheck disable=SC2016 # Python
    run_with_glb '
import struct
glb = Glb(sys.argv[1])
clip, = (c for c in glb.json["animations"] if c["name"] == "walk")
hips, = (n for n, node in enumerate(glb.json["nodes"]) if node.get("name") == "hips")
sampler, = (clip["samplers"][c["sampler"]] for c in clip["channels"]
            if c["target"] == {"node": hips, "path": "translation"})
view = glb.json["bufferViews"][glb.json["accessors"][sampler["output"]]["bufferView"]]
data = bytearray(glb.binary)
for k, ((t,), (x, y, z)) in enumerate(zip(glb.read(sampler["input"]),
                                          glb.read(sampler["output"]))):
    struct.pack_into("<3f", data, view.get("byteOffset", 0) + 12 * k, x, y, z + 1.5 * t)
whole = open(sys.argv[1], "rb").read()
open(sys.argv[2], "wb").write(whole[:-len(data)] + data)
' "$here/../../assets/walker.glb" "$scratch/away.glb"
}

# A clip of 20,000 s.
python3 -c '
import base64, json, struct, sys
model = json.load(sys.stdin)
head, data = model["buffers"][0]["uri"].split(",")
data = bytearray(base64.b64decode(data))
data[44:52] = struct.pack("<2f", 0, 20000)
model["buffers"][0]["uri"] = head + "," + base64.b64encode(data).decode()
model["accessors"][2]["max"] = [20000]
json.dump(model, sys.stdout)
' <"$slider" >"$scratch/long.gltf"
limber compare "$scratch/long.gltf"
expect_status 1
expect_err 'lasts more than five hours: choose another one with --clip$'
limber optimize "$scratch/long.gltf" -o "$scratch/x.glb"
expect_refusal 1 ': clip 0 [a-z]* *lasts longer than five hours: shorten it'
limber play --demo duel --display null --frames 1 "$scratch/long.gltf"
expect_status 0
expect_err 'clip 0 lasts 20000 s: the duel plays its first 30 s'

# limber play lets the ground move below a figure that walks away.
if ! $slow; then
    walk_away
    limber compare "$scratch/away.glb" --clip walk --error 2 --format json
    expect_status 0
    expect_err 'clip 3 walk goes 1\.[67][0-9]* m over the ground: it is compared and exported on the spot'
    # shellcheck disable=SC2016 # Python
    check 'a walk that goes away is compared on the spot' python3 -c '
import json, sys
away, still = (json.load(open(path))["candidates"] for path in sys.argv[1:])
assert [row["name"] for row in away] == [row["name"] for row in still]
for a, b in zip(away, still):
    for key in "arm11_drawing", "arm11_predicted":
        told, wanted = a[key]["us_per_frame"], b[key]["us_per_frame"]
        assert abs(told / wanted - 1) < 0.002, (a["name"], told, wanted)
    assert abs(a["peak_px"] - b["peak_px"]) < 0.01 + 0.01 * b["peak_px"], a["name"]
' "$out_file" "$scratch/report.json"
    for figure in away still; do
        test $figure = away || cp "$here/../../assets/walker.glb" "$scratch/still.glb"
        limber play "$scratch/$figure.glb" --demo duel --gl soft --size 160x120 \
            --clock fixed:5 --frames 6 --display image -o "$scratch/$figure.png"
        expect_status 0
    done
    # shellcheck disable=SC2016 # Python
    check 'in the duel a walk that goes away stays in its place' run_with_glb '
from compare_check import png_rows
away, still = (b"".join(png_rows(f"{sys.argv[1]}/{name}-0006.png"))
               for name in ("away", "still"))
off = sum(abs(a - b) > 8 for a, b in zip(away, still))
assert len(away) == len(still) and off < 100, off
' "$scratch"
    echo '[nonsense' >"$scratch/away.character"
    limber compare "$scratch/away.glb" --clip walk --error 2
    expect_status 0
    expect_err 'away\.glb: limber play refuses its character file: clips that go over the ground are compared with their way over it'
fi
$slow || recomputed "$samples/x/anim_test.x" 0 28

limber compare "$slider" --fps 10 --plot "$scratch/plot.svg"
expect_status 0
expect_out '^>'
expect_out '^Take "'
expect_out '^"ARM11" is the whole frame without labels, which is posing and drawing, predicted$'
expect_out '^for an ARM1136 at 532 MHz by the timing model, not measured\. '
expect_out '^Board imx31-pdk: ARM1136 at 532 MHz, 128 MiB; limits: 81920 KiB, 33\.3 ms, 0\.5 px'
expect_out '^On the ARM1136 its frame takes [0-9]* us to sample the clip, [0-9]* us for matrices,$'
expect_out '^[0-9]* us for vertices and [1-9][0-9]* us to draw it\.'
expect_out '^  a frame takes  *ARM11 us  *posing  *drawing  *KiB RAM  *KiB file  *peak px$'
expect_out '^  how it looks; posing here  *mean px  *outline  *normal  *shade  *us here  *k instr\.$'
check 'the tables fit 80 columns' test \
    -z "$(grep '^[ >]' "$out_file" | grep -E '^.{81}')"
expect_out 'AN4044.s example, 20 key frames of 4000 vertices, is 80000 vertices'
check 'the plot has a point for each technique' \
    test "$(grep -c '<circle' "$scratch/plot.svg")" -ge 4
check 'the plot names its second axis' grep -qE \
    'against us of posing on an ARM1136 \(predicted\)<' \
    "$scratch/plot.svg"
check 'the plot is well formed' python3 -c \
    'import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.argv[1])' \
    "$scratch/plot.svg"

compare "$slider" --fps 10 --format csv
expect_status 0
expect_out '^technique,kind,us_per_frame,instructions_per_frame,arm11_us_predicted,arm11_instructions_predicted,arm11_drawing_us_predicted,ram_bytes'
cp "$out_file" "$scratch/report.csv"
compare "$slider" --fps 10 --format json
check 'CSV and JSON agree on the prediction' python3 -c '
import csv, json, sys
rows = list(csv.DictReader(open(sys.argv[1], newline="")))
listed = [c for c in json.load(open(sys.argv[2]))["candidates"] if c["listed"]]
assert len(rows) == len(listed) > 0
for row, candidate in zip(rows, listed):
    told = candidate["arm11_predicted"]
    assert told["us_per_frame"] > 0
    assert abs(float(row["arm11_us_predicted"]) - told["us_per_frame"]) < 0.006
    assert abs(float(row["arm11_instructions_predicted"]) - told["instructions_per_frame"]) < 0.6
' "$scratch/report.csv" "$out_file"
compare "$slider" --fps 10 --format md
expect_status 0
expect_out '^\|---\|---\|---:\|'
compare "$slider" --fps 10 --ram 1
expect_status 0
expect_out 'nothing fits the memory'

# What a person would advise, without any option: walking has no expressions, and
# idling blinks. Advice is the same on every machine.
$slow || for advised in "walk skin" "idle skin . morph"; do
    limber compare "$here/../../assets/walker.glb" --clip "${advised%% *}"
    expect_status 0
    expect_out "^Take \"${advised#* }\": it takes [0-9]* us and [0-9]* KiB; (\"[^\"]*\" would save ([0-9]* KiB but take|[0-9]* us, which is 0\.[0-9]% of a frame of 33\.3 ms, but take [0-9]* KiB more)|nothing that keeps within 0\.5 px is faster or smaller; \"(morph, |skin . morph\" takes ))"
done
compare "$here/../fixtures/gltf/skin/and_morph.gltf"
expect_out '^Take "skin \+ morph": '
if $slow; then
    limber compare "$samples/AnimatedMorphCube.glb"
else
    limber compare "$here/../../assets/face.glb" --clip talk
fi
expect_out '^Take "morph targets": '
limber compare "$samples/RiggedFigure.glb" --format json
check 'too little is saved to convert a model for' python3 -c '
import json, sys
report = json.load(open(sys.argv[1]))
assert report["advice"] == "skin"
assert report["advised_by"] == "arm11_predicted"
assert "too little to convert the model for" in report["reason"], report["reason"]
' "$out_file"

# All clips are compared at once; what they share is counted once.
clips=$here/../../assets/walker.glb
! $slow || clips=$slider
limber compare "$clips" --format json
expect_status 0
check 'all clips share their mesh' python3 -c '
import json, sys
report = json.load(open(sys.argv[1]))
walker = sys.argv[2].endswith("walker.glb")
assert [clip["name"] for clip in report["clips"]] == (
    ["idle", "jump", "run", "walk", "wave"] if walker else ["slide", "rise"])
first = report["candidates"][0]
shared = first["clips"][0]["ram_bytes_shared"]
own = sum(clip["ram_bytes_own"] for clip in first["clips"])
assert first["ram_bytes"] == shared + own and shared > own > 0
assert first["peak_px"] == max(clip["peak_px"] for clip in first["clips"])
fitted = next(row for row in report["candidates"]
              if row["name"].endswith("fitted"))
assert fitted["peak_px"] <= report["bound_px"]
if walker:
    assert report["advice"] == "skin + morph", report["advice"]
    assert not report["mixed_plan"]["better"]
' "$out_file" "$clips"

# The playback rate is no measure: the error between keys is found at any rate.
compare "$slider" --fps 4 --format csv
cp "$out_file" "$scratch/four.csv"
compare "$slider" --fps 240 --format csv --jobs 1
check 'the same errors at any playback rate and number of threads' python3 -c '
import csv, sys
slow, fast = ([(r["peak_px"], r["normal_deg"], r["ram_bytes"])
               for r in csv.DictReader(open(f, newline=""))]
              for f in sys.argv[1:])
assert slow == fast and len(slow) >= 3, (slow, fast)
' "$scratch/four.csv" "$out_file"

# Figures line up under their heads, and what is small does not read as 0.
sed 's/"slide"/"slide from the left to the right"/' "$slider" >"$scratch/names.gltf"
compare "$scratch/names.gltf"
expect_status 0
expect_out 'names\.gltf, 2 clips: .*; 3 vertices, 1 node$'
expect_out '^Take .*: it takes [0-9]+ us and 0\.[1-9] KiB;'
check 'the table of clips lines up' awk '
    / ARM11 us  peak px  technique/ { end = index($0, " ARM11 us"); next }
    end && NF < 5 { exit }
    end { rows++; bad = bad || substr($0, end - 3, 4) !~ /\.[0-9][0-9] $/ }
    END { exit bad || rows != 2 }' "$out_file"

# Values that jump, and a normal of a node that is scaled unevenly.
sed 's/"output": [0-9]*/&, "interpolation": "STEP"/' "$slider" >"$scratch/step.gltf"
compare "$scratch/step.gltf" --export "$scratch/step"
expect_status 0
expect_out '^ [ *]morph, [0-9]+ keys fitted +[0-9.]+ +[0-9.]+ +[0-9.]+ +[0-9.]+ +[0-9.]+ +0\.0'
check 'a model of nodes alone has no rigid parts beside them' \
    test ! -e "$scratch/step/rigid.glb"
sed 's/"name": "slider",/& "scale": [1, 3, 0.5],/
    s/"POSITION": 0/&, "NORMAL": 0/
    s/"indices": 1/&, "targets": [{"POSITION": 0}]/' "$slider" >"$scratch/uneven.gltf"
compare "$scratch/uneven.gltf" --format csv --export "$scratch/uneven"
expect_status 0
check 'rigid parts have the normals of their nodes' python3 -c '
import csv, sys
rows = list(csv.DictReader(open(sys.argv[1], newline="")))
rigid, = [row for row in rows if row["technique"] == "rigid parts"]
assert float(rigid["normal_deg"]) < 0.5 and float(rigid["peak_px"]) < 0.1, rigid
' "$out_file"

# A mirrored node turns its triangles round, and so do key frames in the world.
sed 's/"name": "slider",/& "scale": [-1, 1, 1],/' "$slider" >"$scratch/mirror.gltf"
sed -i 's/"POSITION": 0/&, "NORMAL": 0/' "$scratch/mirror.gltf"
compare "$scratch/mirror.gltf" --format csv
check 'normals of a mirrored node are those of the picture' python3 -c '
import csv, sys
rows = list(csv.DictReader(open(sys.argv[1], newline="")))
assert len(rows) >= 3
assert all(float(row["normal_deg"]) < 2 for row in rows), rows
' "$out_file"
compare "$scratch/mirror.gltf" --export "$scratch/mirrored"
expect_status 0
# shellcheck disable=SC2016 # Python
check 'key frames of a mirrored node face as the model does' run_with_glb '
file, = glob.glob(sys.argv[1] + "/morph-even-*.glb")
glb = Glb(file)
indices = glb.json["meshes"][0]["primitives"][0]["indices"]
assert glb.json["accessors"][indices]["componentType"] == 5123
index = [i for i, in glb.read(indices)][:3]
assert index in ([0, 2, 1], [2, 1, 0], [1, 0, 2]), index
' "$scratch/mirrored"

# The player follows a clip that goes far, which a comparison shows as a whole.
compare "$here/../fixtures/gltf/clip/far.gltf"
expect_status 0
expect_err 'far\.gltf: its clips go 61 times as far as it is large: .*limber play'
compare "$here/../fixtures/gltf/skin/and_morph.gltf" --format csv
expect_no_err

# What a lamp emits is exported, with what it reflects.
sed -e '1s/{/&"materials": [{"emissiveFactor": [1, 0.5, 0]}],/' \
    -e 's/"attributes": {/"material": 0, &/' "$slider" >"$scratch/lamp.gltf"
compare "$scratch/lamp.gltf" --export "$scratch/lamp"
expect_status 0
# shellcheck disable=SC2016 # Python
check 'key frames of a lamp shine as the model does' run_with_glb '
file, = glob.glob(sys.argv[1] + "/morph-even-*.glb")
materials = Glb(file).json["materials"]
assert materials[0]["emissiveFactor"] == [1, 0.5, 0], materials
' "$scratch/lamp"

# Joints need not be in the scene, but the rigid parts that they move are shown.
sed 's/"nodes": \[/"scene": 0, "scenes": [{"nodes": [0]}], &/' \
    "$here/../fixtures/gltf/skin/and_morph.gltf" >"$scratch/joints.gltf"
compare "$scratch/joints.gltf" --export "$scratch/joints"
expect_status 0
# shellcheck disable=SC2016 # Python
check 'the nodes of rigid parts are in the scene' run_with_glb '
gltf = Glb(sys.argv[1]).json
shown = gltf["scenes"][0]["nodes"]
assert any("mesh" in gltf["nodes"][i] for i in shown), gltf["nodes"]
' "$scratch/joints/rigid.glb"

# A strip of one vertex has no triangle. glTF has no lists without any.
python3 - "$here/../fixtures/gltf/skin/and_morph.gltf" "$scratch/strip.gltf" <<'EOF'
import json, sys
gltf = json.load(open(sys.argv[1]))
gltf["accessors"].append({"componentType": 5123, "count": 3, "type": "SCALAR"})
primitives = gltf["meshes"][0]["primitives"]
primitives.append(dict(primitives[0], mode=5, indices=len(gltf["accessors"]) - 1))
json.dump(gltf, open(sys.argv[2], "w"))
EOF
compare "$scratch/strip.gltf" --export "$scratch/strip"
expect_status 0
expect_no_err
for file in "$scratch"/strip/*.glb; do
    limber info "$file"
    expect_status 0
done

limber compare
expect_refusal 2 'no model'
compare "$slider" --format xml
expect_refusal 2 'text, json, csv or md'
compare "$slider" --error 0
expect_refusal 2 'from 0.001 to 1000'
compare "$slider" --ram lots
expect_refusal 2 'a number of bytes'
compare "$slider" --board pc
expect_refusal 2 'the name of a board: imx31-pdk'
compare "$slider" --jobs 0
expect_refusal 2 'from 1 to 64'
compare "$slider" --ms 0.001 --error 0.001
expect_status 0
expect_out 'drawing alone takes [0-9.]* ms, where a frame may take 0\.001 ms; of what keeps within 0\.001 px, it has the least price of time and memory'
compare "$slider" --clip none
expect_refusal 1 'no such clip'
# Nothing is compared for a file that cannot be written.
compare "$slider" --fps 10 --plot "$scratch/none/plot.svg"
expect_refusal 1 'plot.svg: cannot be written'
compare "$slider" --fps 10 --export "$scratch/none/baked"
expect_refusal 1 'baked: the folder cannot be made'
compare "$slider" --fps 10 --export "$scratch/plot.svg"
expect_refusal 1 'plot.svg: the folder cannot be made: Not a directory: name another'
compare "$slider" --plot "$scratch/plot.png"
expect_refusal 2 '--plot .*plot.png: give a file name that ends in \.svg'
compare "$(dirname "$0")/../../assets/arm.glb"
expect_refusal 1 'it has no clip'
sed 's/"mesh": 0/"extras": 0/' "$slider" >"$scratch/unseen.gltf"
compare "$scratch/unseen.gltf"
expect_refusal 1 'unseen.gltf: it shows no triangles: give a model with a mesh'
tap_done
