#!/bin/sh
# Tests limber doctor. With a model: a sound one has no findings, and each pitfall
# has its own. Without a model: it lists what the machine has and lacks.
. "$(dirname "$0")/../support/cli.sh"

python3 "$(dirname "$0")/doctor_models.py" "$scratch" >"$scratch/pitfalls"
limber doctor "$scratch/sound.gltf"
expect_status 0
expect_no_err
expect_out 'it contains nothing that players are known to get wrong'
cp "$out_file" "$scratch/sound.out"

printf '{"asset":{"version":"2.0"},"nodes":[{"name":"Camera"}]}' \
    >"$scratch/bare.gltf"
limber doctor "$scratch/bare.gltf"
expect_status 0
expect_out 'the file has no triangles, so limber shows an empty stage'
limber render "$scratch/bare.gltf" --size 32x32 -o "$scratch/bare.png"
expect_status 0
expect_err 'it has no triangles, so the stage stays empty: export'
limber render --demo duel "$scratch/bare.gltf" -o "$scratch/bare.png"
expect_status 1
expect_err 'this model has no clip: give one with both meshes and clips'

while read -r name pattern; do
    limber doctor "$scratch/$name.gltf"
    expect_out "^- .*$pattern"
    check "$name: the sound model has no such finding" sh -c "! grep -q '$pattern' '$scratch/sound.out'"
done <"$scratch/pitfalls"
check 'every pitfall has a model' test "$(wc -l <"$scratch/pitfalls")" -ge 24

limber doctor "$scratch/none.glb"
expect_refusal 1 'none.glb: '
limber doctor "$scratch/sound.gltf" --json
expect_status 0
check 'a sound model in JSON' python3 -c '
import json, sys
assert json.load(open(sys.argv[1]))["findings"] == []' "$out_file"

latin=$scratch/$(printf 'l\351.gltf')
cp "$scratch/sound.gltf" "$latin"
limber doctor "$latin" --json
expect_refusal 1 'this name is not UTF-8'

# Without a desktop, and with a window that SDL only simulates.
unset DISPLAY WAYLAND_DISPLAY SDL_VIDEODRIVER
limber doctor
cp "$out_file" "$scratch/machine"
expect_no_err
for title in Displays 'GL drivers' Kernels Buttons Cameras Watchdogs \
    Configuration "The demos' files"; do
    expect_out "^$title$"
done
expect_out '^  works    soft: .*; the processor draws$'
expect_out '^  works    auto: takes '
expect_out '^  works    float: '
expect_out '^  works    .*; this is the default$'
check 'one kernel is the default' test \
    "$(grep -c '; this is the default$' "$out_file")" -eq 1
expect_out '^  works    walker\.glb: /.*/walker\.glb$'
expect_out '^  works    presets\.ini: /'
check 'everything that is missing or broken has a remedy' awk '
    wants && !/^           -> ./ { print last; bad = 1 }
    { wants = /^  (missing|broken) /; last = $0 }
    END { exit bad }' "$out_file"
case $(limber --version; cat "$out_file") in
*window*) has_window=yes ;;
*) has_window=no ;;
esac
if ls /dev/fb* /dev/dri/card* >/dev/null 2>&1; then
    skip 'limber doctor: a bare machine' 'this one has a screen'
else
    run $limber doctor
    about 'limber doctor on a bare machine'
    expect_status 1
    expect_out '^  missing  kms /dev/dri/card\*: '
    expect_out '^  missing  fbdev /dev/fb\*: '
    expect_out '^limber cannot play here: no display works: limber render '
fi
if [ $has_window = yes ]; then
    SDL_VIDEODRIVER=dummy limber doctor
    expect_status 0
    expect_out '^  works    window: SDL_VIDEODRIVER=dummy$'
    expect_out '^limber plays here, on window$'
fi

SDL_VIDEODRIVER=dummy limber doctor --json
check 'the JSON is well formed and agrees with the exit status' \
    python3 -c '
import json, sys
report = json.load(open(sys.argv[1]))
assert report["version"].startswith("limber ")
assert report["plays"] == (sys.argv[2] == "0")
states = {"works", "unused", "taken", "missing", "broken"}
sections = set()
for finding in report["findings"]:
    sections.add(finding["section"])
    assert finding["state"] in states, finding
    assert finding["subject"] and finding["text"], finding
    if finding["state"] in ("missing", "broken"):
        assert finding["remedy"], finding
assert sections == {"displays", "gl", "kernels", "buttons", "cameras",
    "watchdogs", "configuration", "files"}, sections' "$out_file" "$status"

# drivers NAME: the drivers that limber --version lists there.
drivers() {
    limber --version
    sed -n "s/^$1 *//p" "$out_file"
}

displays=$(drivers displays) gl=$(drivers gl) kernels=$(drivers kernels)
buttons=$(drivers buttons) cameras=$(drivers cameras)
limber doctor --json
check 'each driver that looks for a device has a finding' python3 -c '
import json, sys
found = {(finding["section"], name)
    for finding in json.load(open(sys.argv[1]))["findings"]
    for name in (finding.get("driver"), finding["subject"])}
made_up = {"image", "null", "script", "pattern"}
for section, names in zip(("displays", "gl", "kernels", "buttons", "cameras"),
        sys.argv[2:]):
    assert names, section
    for name in set(names.split()) - made_up:
        assert (section, name) in found, (section, name)' \
    "$out_file" "$displays" "$gl" "$kernels" "$buttons" "$cameras"

# limber.conf: which file, and its first error.
limber doctor
expect_out '^  unused   limber\.conf: there is none'
printf '%s\n' '[start]' 'demo = face' >"$scratch/limber.conf"
limber doctor --config "$scratch/limber.conf"
expect_out '^  works    .*/limber\.conf: limber play reads it'
printf '%s\n' '[start]' 'dmeo = face' >"$scratch/limber.conf"
LIMBER_CONFIG=$scratch/limber.conf limber doctor
expect_no_err
expect_out '^  broken   .*limber\.conf: .*limber\.conf:2: dmeo: there is no such key$'
expect_out '^           -> did you mean demo\?$'
printf '%s\n' '[display]' 'gl = mesa' >"$scratch/limber.conf"
limber doctor --config "$scratch/limber.conf"
expect_out '^  broken   .*--gl mesa: no such driver$'
# What limber play refuses is not "without errors".
for line in 'demo = nosuch' 'clip = walk' 'model = /nosuch.glb'; do
    printf '%s\n' '[start]' "$line" >"$scratch/limber.conf"
    limber doctor --config "$scratch/limber.conf"
    expect_out '^  broken   .*/limber\.conf: '
done
printf '%s\n' '[camera]' 'camera = nosuch' >"$scratch/limber.conf"
limber doctor --config "$scratch/limber.conf"
expect_out '^  broken   .*/limber\.conf: --camera nosuch: no such camera'
printf '%s\n' '[options]' "record = $scratch/a.gif" "stats = $scratch/a.gif" \
    >"$scratch/limber.conf"
limber doctor --config "$scratch/limber.conf"
expect_out '^  broken   .*/limber\.conf: --stats .*: --record names the same file'
limber doctor --config "$scratch/none.conf"
expect_out '^  broken   .*none\.conf: cannot be read: '
expect_out '^           -> name another file with --config FILE'

limber doctor --egl-library "$scratch/no.so"
expect_out '^  broken   gles1: .*cannot be opened'

limber doctor --jsno
expect_refusal 2 'did you mean --json'
limber doctor --display null
expect_refusal 2 '--display'
limber doctor
check 'each file of the demos is listed once' test -z \
    "$(sed -n "/^The demos' files/,/^$/p" "$out_file" | sort | uniq -d | sed '/^$/d')"
tap_done
