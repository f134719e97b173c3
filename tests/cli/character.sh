#!/bin/sh
# Tests limber character, and the character files that play, render and doctor
# read.
. "$(dirname "$0")/../support/cli.sh"
assets=$(dirname "$0")/../../assets

cp "$slider" "$scratch/slider.gltf"
model=$scratch/slider.gltf
file=$scratch/slider.character

# frame FILE OPTION...: renders one small frame of the model.
frame() {
    out=$1
    shift
    limber render "$model" --size 40x40 --frames 1 --time 0.5 --no-labels "$@" -o "$out"
}

limber character "$model"
expect_status 0
expect_no_err
expect_out '^\[state slide\]$'
expect_out '^\[state rise\]$'
expect_out '^UP = previous '
limber character "$model" -o "$file"
cp "$file" "$scratch/before"
echo '; edited' >>"$file"
limber character "$model" -o "$file"
expect_refusal 1 'this file exists and may have been edited: give another name'
check 'an edited file stays' grep -q '^; edited$' "$file"
rm "$file"
limber character "$model" -o "$file"
check 'the same file again' cmp "$file" "$scratch/before"
expect_quiet
limber doctor "$model"
expect_status 0
expect_out 'slider.character: it fits the model. States: 2, layers: 0, '

# The file that was written, none, and another one.
frame "$scratch/beside.png"
expect_quiet
expect_png "$scratch/beside.png" 40 40
frame "$scratch/none.png" --character none
expect_quiet
printf '%s\n' '[state up]' 'clip = rise' >"$scratch/other.character"
frame "$scratch/other.png" --character "$scratch/other.character"
expect_quiet
check 'another file shows another clip' \
    sh -c "! cmp -s '$scratch/beside.png' '$scratch/other.png'"
frame "$scratch/clip.png" --clip slide
expect_quiet

# Errors name the file, the line and what there is; doctor finds them too.
printf '%s\n' '[state a]' 'clip = slied' >"$file"
frame "$scratch/wrong.png"
expect_refusal 1 'slider.character:2: \[state a\] clip: there is no clip named slied: there are slide, rise, rest'
check 'no picture was written' test ! -e "$scratch/wrong.png"
limber doctor "$model"
expect_status 1
expect_out 'slider.character:2: .*slied'
limber doctor "$model" --json
expect_status 1
expect_out 'slider.character:2: .*slied'
frame "$scratch/wrong.png" --character "$scratch/missing.character"
expect_refusal 1 'missing.character: cannot be read'

# doctor checks any file that play takes.
limber doctor "$model" --character "$scratch/other.character"
expect_status 0
expect_out 'other.character: it fits the model. States: 1, '
limber doctor "$model" --character none
expect_status 0
limber doctor "$model" --character "$scratch/missing.character"
expect_status 1
expect_out '^- .*missing.character: cannot be read'
limber doctor --character "$scratch/other.character"
expect_refusal 2 'doctor: --character .*: there is no model: '
printf '%s\n' 'include = ../slider.character' >"$file"
frame "$scratch/wrong.png"
expect_refusal 1 'slider.character:1: include: give the name of a file in the same folder'
printf '%s\n' '; more' 'include = nothere.character' >"$file"
frame "$scratch/wrong.png"
expect_refusal 1 'slider.character:2: include: .*nothere.character cannot be read: No such file'
printf '%s\n' 'include = slider.character' >"$file"
frame "$scratch/wrong.png"
expect_refusal 1 'slider.character:1: include: .* none may include itself'

# Events write lines; play prints what the buttons do.
printf '%s\n' '[state up]' 'clip = rise' 'enter = line hello' '[clip rise]' \
    'event = 0 line "one round"' '[buttons]' 'UP long = pause "hold still"' >"$file"
limber play "$model" --display null --size 40x40 --clock fixed:10 --frames 30
expect_status 0
expect_out '^hello$'
expect_out '^one round$'
expect_out '^  UP held hold still$'

# A button does what the file says, not what a file that it includes says.
printf '%s\n' '[buttons]' 'UP = line base' 'DOWN = line both' >"$scratch/base.character"
printf '%s\n' 'include = base.character' '[buttons]' 'UP = line mine' >"$file"
printf '%s\n' '100 UP down' '200 UP up' '300 DOWN down' >"$scratch/run.buttons"
limber play "$model" --display null --size 40x40 --clock fixed:10 --frames 8 \
    --script "$scratch/run.buttons"
expect_status 0
expect_out '^mine$'
check 'the line of the included file is replaced' sh -c '! grep -qx base "$1"' sh "$out_file"
expect_out '^both$'

# The demo face is data.
limber play --demo face --display null --size 40x40 --clock fixed:10 --frames 3
expect_status 0
expect_out '^  RIGHT  show the next expression$'
frame "$scratch/memory.png" --memory 1000
expect_refusal 1 'memory'

# A terminal must not execute what a name holds.
sed 's/"slide"/"\\u001b[2Jslide"/' "$slider" >"$scratch/escape.gltf"
limber character "$scratch/escape.gltf"
expect_status 0
expect_out '^\[state "clip 0"\]$'
check 'limber character: prints no escape sequence' \
    sh -c '! grep -q "$(printf "\033")" "$1"' sh "$out_file"

# The example of the documentation fits the walker.
cp "$assets/walker.glb" "$scratch/walker.glb"
sed -n '/^```ini$/,/^```$/p' "$assets/../app/character/format.md" | grep -v '^```' \
    >"$scratch/walker.character"
limber doctor "$scratch/walker.glb"
expect_status 0
expect_out 'walker.character: it fits the model. States: 2, layers: 1, effects and expressions: 1, buttons: 7$'

limber character
expect_refusal 2 'character'
limber character "$assets/none.glb"
expect_refusal 1 'none.glb'
tap_done
