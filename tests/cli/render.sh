#!/bin/sh
# limber render: each kind of file, without a desktop. GL_DRIVERS are those that
# this target has.
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

limber render "$slider" --size 33x17 --frames 3 -o "$scratch/many.png"
expect_quiet
for number in 0001 0002 0003; do
    expect_png "$scratch/many-$number.png" 33 17
done
check 'no fourth picture' test ! -e "$scratch/many-0004.png"

limber render "$slider" --size 33x17 --frames 3 -o "$out.gif"
expect_quiet
check 'a GIF of 33 x 17' test "$(bytes "$out.gif" 0 10)" = 47494638396121001100
limber render "$slider" --size 34x18 --frames 2 --clock fixed:10 -o "$out.y4m"
expect_quiet
check 'a Y4M of 34 x 18 at 10 frames a second' \
    sh -c 'head -n 1 "$1" | grep -aq "^YUV4MPEG2 W34 H18 F10:1 "' sh "$out.y4m"
check 'two frames' test "$(grep -ao FRAME "$out.y4m" | wc -l)" -eq 2

for gl in ${GL_DRIVERS:-osmesa gles1}; do
    limber render "$slider" --size 33x17 --gl $gl -o "$out-$gl.png"
    expect_quiet
    expect_png "$out-$gl.png" 33 17
done

printf '0 ENTER down\n20 ENTER up\n' >"$scratch/script.txt"
limber render "$slider" --size 33x17 --script "$scratch/script.txt" -o "$out.png"
expect_quiet
limber render "$slider" --size 33x17 --buttons "script:$scratch/script.txt" \
    -o "$out.png"
expect_quiet

limber play "$slider" --display null --frames 3 --clock fixed:30
expect_status 0
expect_no_err
tap_done
