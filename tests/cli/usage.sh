#!/bin/sh
# Tests wrong command lines: limber exits with 2, after one sentence that says what
# is wrong and what would be right, and writes no file.
. "$(dirname "$0")/../support/cli.sh"

refused() {
    pattern=$1
    shift
    limber "$@"
    expect_refusal 2 "$pattern"
}

out=$scratch/out.png
obj=$scratch/out.obj

refused 'play' plai
refused 'render' rendr "$slider"
refused '--help' zzzzzz
refused '--size' render "$slider" --siez 10x10 -o "$out"
refused 'mean --size' render "$slider" --SIZE 10x10 -o "$out"
refused '--clip' pose "$slider" --clpi 0 -o "$obj"
refused '--help' render "$slider" --zzzzzz -o "$out"
refused '--help' render "$slider" -z -o "$out"
refused '--json' info "$slider" --jsn
refused '--json' render "$slider" --json -o "$out"
refused '--size' pose "$slider" --size 10x10 -o "$obj"
refused '--demo: its value is missing' render --demo -o "$out"
refused '--output: its value is missing' render "$slider" -o --size
refused '--demo' pose --demo walker -o "$obj"
refused '--display' render "$slider" --display window -o "$out"

for size in '' x 10 10x 0x10 10x0 -1x10 10x-1 axb 10x10x10 99999x10 \
    99999999999999999999x10 '10x10 '; do
    refused '--size' render "$slider" --size "$size" -o "$out"
done
for seconds in '' one -1 nan inf 1s 1e99 '1 2'; do
    refused '--time' render "$slider" --time "$seconds" -o "$out"
    refused '--time' pose "$slider" --time "$seconds" -o "$obj"
done
for frames in '' 0 -1 one 1.5 99999999999999999999; do
    refused '--frames' render "$slider" --frames "$frames" -o "$out"
done
for clock in '' fixed fixed: fixed:0 fixed:-1 fixed:x fixed:nan fixed:1e9 \
    fixed:1e-300 unreal; do
    refused '--clock' render "$slider" --clock "$clock" -o "$out"
done
for influences in 0 9 x; do
    refused '--influences' pose "$slider" --influences "$influences" -o "$obj"
done
for format in '' rgb RGB565 rgb565x; do
    refused 'rgba8888' render "$slider" --format "$format" -o "$out"
done
for fps in 0 -1 x 1e9; do
    refused '--fps' play "$slider" --fps "$fps"
done
for gl in soft osmesa; do
    refused "egl with --gl $gl" play "$slider" --display egl --gl "$gl"
done
refused 'takes no argument' play "$slider" --display null:/dev/fb0
refused '--math' pose "$slider" --math double -o "$obj"
refused 'float' pose "$slider" --kernel none -o "$obj"
refused 'fixed point' pose "$slider" --math float --kernel fixed -o "$obj"
refused 'in float' pose "$slider" --math fixed --kernel float -o "$obj"
refused 'in float' render "$slider" --math fixed --kernel float -o "$out"
limber --version
case $(cat "$out_file") in
*armv6*) refused 'fixed point' pose "$slider" --math float --kernel armv6 -o "$obj" ;;
*) refused 'ARM' pose "$slider" --kernel armv6 -o "$obj" ;;
esac
refused 'osmesa' render "$slider" --gl none -o "$out"
refused 'no such source' play "$slider" --buttons piano
refused 'give CHIP/LINE' play "$slider" --buttons gpiod:UP=a/1/pul-up
refused 'no such key' play "$slider" --buttons evdev:UP=KEY_NO
refused 'null' play "$slider" --display none
refused 'from 1 to 50' play --demo crowd --walkers 0
refused 'from 1 to 50' play --demo crowd --walkers 51
refused 'from 1 to 1000' play --budget-ms nothing
refused 'walker' render --demo wlaker -o "$out"
refused 'walker' render --demo zzzzzz -o "$out"

refused 'no such camera' play "$slider" --camera piano
refused 'no such format' play "$slider" --camera pattern,rgb
refused '.png, .gif, .y4m' render "$slider" -o "$scratch/out.bmp"
refused '.png, .gif, .y4m' play "$slider" --display image -o "$scratch/out.bmp"
refused 'add -o' play "$slider" --display image
refused '-o' render "$slider"
refused '-o' pose "$slider"
refused '[Mm]odel|nothing to show' render -o "$out"
refused '[Mm]odel' pose -o "$obj"
refused '[Mm]odel' info
refused 'one model' info "$slider" "$slider"
for demo in walker arm face; do
    refused 'a model of its own' render "$slider" --demo "$demo" -o "$out"
done
refused 'chooses its own clips' render --demo walker --clip walk -o "$out"
for option in -o --size --time --clip --frames --gl --script --clock --format; do
    refused 'missing' render "$slider" "$option"
done
refused 'no value' info "$slider" --json=1

about 'wrong usage'
check 'wrong usage writes nothing' test ! -e "$out" -a ! -e "$obj"
tap_done
