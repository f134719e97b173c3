#!/bin/sh
# Tests limber render with each kind of file, without a desktop. GL_DRIVERS lists
# the GL drivers of this target.
. "$(dirname "$0")/../support/cli.sh"

out=$scratch/out
limber render "$slider" -o "$out.png"
expect_quiet
expect_png "$out.png" 480 640

limber render "$slider" --size 33x17 --time 0.5 --clip rise -o "$out.png"
expect_quiet
expect_png "$out.png" 33 17

cp "$out.png" "$scratch/first.png"
limber render "$slider" --size 33x17 --time 0.5 --clip rise -o "$out.png"
check 'the same command gives the same picture' cmp "$scratch/first.png" \
    "$out.png"
limber render "$slider" --size 33x17 --time 1.5 --clip rise -o "$out.png"
check 'another time gives another picture' \
    sh -c '! cmp -s "$1" "$2"' sh "$scratch/first.png" "$out.png"

# A camera's distance from the origin fits GL's numbers only so far.
sed 's/"name": "slider",/& "translation": [100000, 0, 0],/' "$slider" \
    >"$scratch/far.gltf"
limber render "$scratch/far.gltf" --size 33x17 -o "$out.png"
expect_status 0
expect_err 'far.gltf: it stands 100000 m from the origin, .*: move it'

# A still node that is scaled to nothing, at the origin and far from it, where its
# place is named first: rounding may have taken the size.
for place in 0 100000; do
    python3 -c '
import json, sys
model = json.load(sys.stdin)
del model["animations"]
model["nodes"][0].update(scale=[0, 0, 0], translation=[0, int(sys.argv[1]), 0])
json.dump(model, sys.stdout)
' "$place" <"$slider" >"$scratch/point.gltf"
    limber render "$scratch/point.gltf" --size 33x17 -o "$out.png"
    expect_status 0
    case $place in
    0) expect_err 'all its vertices are in one place, .*: look for a scale of 0$' ;;
    *) expect_err 'it stands 100000 m from the origin, where limber cannot' ;;
    esac
    check 'one sentence says so' test "$(wc -l <"$err_file")" -eq 1
done

limber render "$slider" --size 33x17 --frames 3 -o "$scratch/many.png"
expect_quiet
for number in 0001 0002 0003; do
    expect_png "$scratch/many-$number.png" 33 17
done
check 'no fourth picture' test ! -e "$scratch/many-0004.png"

# The case of the extension does not matter.
limber render "$slider" --size 33x17 -o "$scratch/one.PNG"
expect_quiet
expect_png "$scratch/one.PNG" 33 17
check 'one picture' test ! -e "$scratch/one-0001.png"

limber render "$slider" --size 33x17 --frames 3 -o "$out.gif"
expect_quiet
check 'a GIF of 33 x 17' test "$(bytes "$out.gif" 0 10)" = 47494638396121001100
limber render "$slider" --size 34x18 --frames 2 --clock fixed:10 -o "$out.y4m"
expect_quiet
check 'a Y4M of 34 x 18 at 10 frames a second' \
    sh -c 'head -n 1 "$1" | grep -aq "^YUV4MPEG2 W34 H18 F10:1 "' sh "$out.y4m"
check 'two frames' test "$(grep -ao FRAME "$out.y4m" | wc -l)" -eq 2

# A clip of 2 s lasts 3 h at this speed. The exact number of frames is no mistake.
limber render "$slider" --size 33x17 --clip rise --speed 0.0002 -o "$scratch/years.gif"
expect_refusal 1 'years.gif: the animation takes 250000 frames, .*: say with --frames'
check 'no film of years is begun' test -z "$(find "$scratch" -name 'years*')"
limber render "$slider" --size 33x17 --clip rise --speed 0.0002 --frames 2 \
    -o "$scratch/years.gif"
expect_quiet

for gl in ${GL_DRIVERS:-osmesa gles1} soft auto; do
    limber render "$slider" --size 33x17 --gl $gl -o "$out-$gl.png"
    expect_quiet
    expect_png "$out-$gl.png" 33 17
done

# The two pixel formats give pictures that differ by rounding.
limber render "$slider" --size 33x17 --gl soft --format rgb565 -o "$out-565.png"
expect_quiet
expect_png "$out-565.png" 33 17
limber render "$slider" --size 33x17 --gl soft --format rgba8888 -o "$out-8888.png"
expect_quiet
check 'another format gives another picture' \
    sh -c '! cmp -s "$1" "$2"' sh "$out-565.png" "$out-8888.png"
limber render "$slider" --size 33x17 -o "$out.png"
check 'without --gl and --format, soft draws in rgba8888' \
    cmp "$out.png" "$out-8888.png"

printf '0 ENTER down\n20 ENTER up\n' >"$scratch/script.txt"
limber render "$slider" --size 33x17 --script "$scratch/script.txt" -o "$out.png"
expect_quiet
limber render "$slider" --size 33x17 --buttons "script:$scratch/script.txt" \
    -o "$out.png"
expect_quiet

limber play "$slider" --display null --frames 3 --clock fixed:30 --format rgb565
expect_status 0
expect_no_err
limber play "$slider" --display null --frames 3 --clock fixed:30
expect_status 0
expect_no_err

# The tuner's button for saving writes nothing while render presses it.
mkdir "$scratch/assets"
cp "${LIMBER_ASSETS:-assets}/walker.glb" "${LIMBER_ASSETS:-assets}/presets.ini" \
    "$scratch/assets"
printf '%s\n' '0 RIGHT down' '50 RIGHT up' '100 ENTER down' '150 ENTER up' \
    >"$scratch/save.txt"
before=$(cksum <"$scratch/assets/presets.ini")
kept_assets=${LIMBER_ASSETS-}
LIMBER_ASSETS=$scratch/assets
export LIMBER_ASSETS
limber render --demo tuner --script "$scratch/save.txt" --size 40x40 --frames 10 \
    -o "$scratch/tuner.gif"
expect_status 0
check 'render saves no presets' \
    test "$before" = "$(cksum <"$scratch/assets/presets.ini")"
limber play --demo tuner --script "$scratch/save.txt" --size 40x40 --frames 10 \
    --clock fixed:25 --display null
expect_status 0
check 'play saves the presets' \
    test "$before" != "$(cksum <"$scratch/assets/presets.ini")"
LIMBER_ASSETS=$kept_assets
[ -n "$kept_assets" ] || unset LIMBER_ASSETS

# The row of shapes of a crowd or a duel shows one figure, which fills the height
# of the small pictures. filled FILE: the part of the row's height, in percent,
# in which a picture differs from its background.
filled() {
    python3 - "$1" <<'PYTHON'
import sys
width, height, row = 240, 320, 36
luma = open(sys.argv[1], 'rb').read().split(b'FRAME\n')[1][:width * height]
lines = [luma[y * width:y * width + width // 9] for y in range(height - row, height)]
print(100 * sum(max(line) - min(line) > 20 for line in lines) // row)
PYTHON
}
for demo in crowd duel; do
    limber render --demo "$demo" assets/face.glb --show keys --size 240x320 \
        --gl soft -o "$scratch/row.y4m" --frames 1 --no-labels
    expect_status 0
    check "the row of shapes in $demo is filled to $(filled "$scratch/row.y4m")%" \
        test "$(filled "$scratch/row.y4m")" -gt 50
done

# A terminal shows how many frames are written. The pipe takes the first one for more
# than a second, after which the bar appears.
mkfifo "$scratch/slow.y4m"
{
    head -c 1000 >"$scratch/begin"
    sleep 1.1
    cat >"$scratch/rest"
} <"$scratch/slow.y4m" &
reader=$!
run script -qec "$limber render '$slider' --size 256x256 --frames 3 \
    -o '$scratch/slow.y4m'" /dev/null
kill "$reader" 2>/dev/null
about 'limber render, on a terminal'
expect_status 0
expect_out '\[#{13}-{27}\] 1/3 frames'

# A signal stops it: it reports that and leaves no file.
half=$scratch/half.gif
# shellcheck disable=SC2086,SC2016 # a command and its arguments
run sh -c 'file=$1; shift; "$@" & while ! ls "$file".*.part; do sleep 0.1
    done >/dev/null 2>&1; kill -TERM $!; wait $!' sh "$half" $limber render \
    "$slider" --frames 100000 -o "$half"
about 'limber render until a signal'
expect_status 1
expect_err '^limber: .*stopped'
check 'no incomplete file is left' test -z "$(find "$scratch" -name 'half*')"

# A lamp above a slope of the model's own casts its shadow on it.
cat >"$scratch/slope.py" <<'END'
"""slope.py FOLDER: writes a lawn that slopes, below a block, and how it is seen."""
import base64, json, struct, sys
lawn = [[-2, 0, 2], [2, .3, 2], [2, .6, -2], [-2, .3, -2]]
block = [[x, y, z] for y in (.8, 1.6) for x in (-.5, .5) for z in (-.5, .5)]
sides = [0, 1, 3, 0, 3, 2, 4, 7, 5, 4, 6, 7, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6,
         0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3]
data = struct.pack("<12f", *sum(lawn, [])) + struct.pack("<24f", *sum(block, [])) + \
    struct.pack("<42H", 0, 1, 2, 0, 2, 3, *sides)
def view(start, size):
    return {"buffer": 0, "byteOffset": start, "byteLength": size}
def mesh(position, indices, material):
    return {"primitives": [{"attributes": {"POSITION": position},
                            "indices": indices, "material": material}]}
def material(*color):
    return {"doubleSided": True, "pbrMetallicRoughness": {
        "baseColorFactor": [*color, 1], "metallicFactor": 0}}
json.dump({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
    "nodes": [{"mesh": 0}, {"mesh": 1}], "meshes": [mesh(0, 1, 0), mesh(2, 3, 1)],
    "materials": [material(.05, .5, .05), material(.6, .1, .1)],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
        {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"},
        {"bufferView": 1, "componentType": 5126, "count": 8, "type": "VEC3"},
        {"bufferView": 3, "componentType": 5123, "count": 36, "type": "SCALAR"}],
    "bufferViews": [view(0, 48), view(48, 96), view(144, 12), view(156, 72)],
    "buffers": [{"byteLength": len(data), "uri":
                 "data:application/octet-stream;base64," +
                 base64.b64encode(data).decode()}],
}, open(sys.argv[1] + "/slope.gltf", "w", encoding="utf-8"))
END
python3 "$scratch/slope.py" "$scratch"
printf '%s\n' '[scene]' 'shadow = no' >"$scratch/dark.character"
for gl in soft osmesa; do
    for character in none "$scratch/dark.character"; do
        limber render "$scratch/slope.gltf" --size 160x160 --frames 1 --gl $gl \
            --no-labels --character "$character" \
            -o "$scratch/slope-$(basename "$character").y4m"
        expect_status 0
    done
    # Of the two pictures' green pixels, those that differ are in the shadow.
    check "$gl: a slope of the model's own has a shadow on it" python3 -c '
import sys
def planes(path):
    data = open(path, "rb").read()
    data = data[data.index(b"FRAME\n") + 6:]
    return data[:25600], data[25600:32000], data[32000:38400]
a, b = (planes(path) for path in sys.argv[1:])
def green(p, i):
    c = i // 320 * 80 + i % 160 // 2
    return p[1][c] < 118 and p[2][c] < 118
count = sum(green(a, i) and green(b, i) and a[0][i] < b[0][i] - 10
            for i in range(25600))
sys.exit(not 100 < count < 2500)' \
        "$scratch/slope-none.y4m" "$scratch/slope-dark.character.y4m"
done
tap_done
