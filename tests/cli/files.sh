#!/bin/sh
# Files that are missing, unreadable, no model, or cannot be written: exit
# status 1, one sentence with the file's name and the reason.
. "$(dirname "$0")/../support/cli.sh"

out=$scratch/out

# refused PATTERN FILE: by every command that reads a model.
refused() {
    limber info "$2"
    expect_refusal 1 "$1"
    limber pose "$2" -o "$out.obj"
    expect_refusal 1 "$1"
    limber render "$2" -o "$out.png"
    expect_refusal 1 "$1"
    limber play "$2" --display null --frames 1
    expect_status 1
    expect_err "^limber: .*$1"
}

refused 'none\.glb: .*[Nn]o such file' "$scratch/none.glb"
limber "$scratch/none.glb" --display null
expect_status 1
expect_err 'none\.glb: '
# Before a display is looked for, of which there may be none.
limber play "$scratch/none.glb" --display kms:/dev/none
expect_status 1
expect_err '^limber: .*none\.glb: No such file'

mkdir "$scratch/folder.glb"
refused 'folder\.glb: .*(directory|regular file)' "$scratch/folder.glb"

: >"$scratch/empty.glb"
refused 'empty\.glb: .*empty' "$scratch/empty.glb"

echo 'no model at all' >"$scratch/text.gltf"
refused 'text\.gltf: ' "$scratch/text.gltf"

head -c 700 "$slider" >"$scratch/half.gltf"
refused 'half\.gltf: ' "$scratch/half.gltf"

printf 'glTF\002\000\000\000\377\377\377\177' >"$scratch/head.glb"
refused 'head\.glb: ' "$scratch/head.glb"

cp "$slider" "$scratch/locked.gltf"
chmod 0 "$scratch/locked.gltf"
if [ -r "$scratch/locked.gltf" ]; then
    skip 'a file that may not be read' 'this user reads everything'
else
    refused 'locked\.gltf: .*[Pp]ermission' "$scratch/locked.gltf"
fi

limber pose "$slider" --clip dance -o "$out.obj"
expect_refusal 1 'dance'
limber render "$slider" --clip 7 -o "$out.png"
expect_refusal 1 '7'

# Places that cannot be written.
limber pose "$slider" -o "$scratch/nowhere/out.obj"
expect_refusal 1 'nowhere/out\.obj: .*[Nn]o such'
limber render "$slider" -o "$scratch/nowhere/out.png"
expect_refusal 1 'nowhere/out.*\.png: .*[Nn]o such'
limber render "$slider" --frames 2 -o "$scratch/nowhere/out.gif"
expect_refusal 1 'nowhere/out\.gif: '
limber render "$slider" --frames 2 -o "$scratch/nowhere/out.y4m"
expect_refusal 1 'nowhere/out\.y4m: .*[Nn]o such'
if [ -c /dev/full ]; then
    limber pose "$slider" -o /dev/full
    expect_refusal 1 '/dev/full: .*[Nn]o space'
    # shellcheck disable=SC2086 # a command and its arguments
    run sh -c '"$@" >/dev/full' sh $limber info "$slider"
    about 'limber info onto a full disk'
    expect_status 1
    expect_err '^limber: .*[Nn]o space'
fi
limber render "$slider" -o "$out.bmp"
expect_err '^limber: .*\.bmp: .*png.*gif.*y4m'
expect_no_out

# A watchdog: fed by frames, and dismissed; without one it goes on.
: >"$scratch/watchdog"
limber play "$slider" --display null --frames 2 --watchdog "$scratch/watchdog"
expect_status 0
expect_no_err
check 'a watchdog is fed and dismissed' \
    test "$(bytes "$scratch/watchdog" 0 9)" = 0056
limber play "$slider" --display null --frames 2 --watchdog "$scratch/none"
expect_status 0
expect_err '^limber: --watchdog .*none: No such file'

# Button scripts.
limber render "$slider" --script "$scratch/none.txt" -o "$out.png"
expect_refusal 1 'none\.txt: .*[Nn]o such file'
printf '0 UP down\n10 SIDEWAYS down\n' >"$scratch/bad.txt"
limber render "$slider" --script "$scratch/bad.txt" -o "$out.png"
expect_refusal 1 'bad\.txt.*2.*SIDEWAYS'
limber render "$slider" --buttons nonsense -o "$out.png"
expect_err '^limber: .*nonsense: .*script'
expect_no_out

for kind in obj png bmp; do
    check "nothing is left of a failed $kind" test ! -e "$out.$kind"
done
tap_done
