#!/bin/sh
# Tests how the clip of a model is played: --interpolation, --repeat, and the
# length of a film without --frames.
. "$(dirname "$0")/../support/cli.sh"

# posed TIME MODE X: the first vertex, which slides from 0 to 4 in two seconds,
# is at X.
posed() {
    limber pose "$slider" --clip slide --time "$1" --interpolation "$2" \
        -o "$scratch/posed.obj"
    expect_quiet
    check "$tap_about: at $3" grep -q "^v $3 0\.000000 0\.000000" \
        "$scratch/posed.obj"
}
posed 0.5 auto 1.000000
posed 0.5 linear 1.000000
posed 1.5 cubic 3.000000
posed 0.5 nearest 0.000000
posed 1.5 nearest 4.000000
posed 1.5 step 0.000000
limber pose "$slider" --interpolation bent -o "$scratch/posed.obj"
expect_refusal 2 'give auto, nearest, step, linear or cubic'

# shown NAME OPTION...: draws a picture without the labels, which tell the time.
shown() {
    shown_name=$1
    shift
    limber render "$slider" --clip rise --size 32x32 --no-labels --gl soft \
        "$@" -o "$scratch/$shown_name.png"
    expect_status 0
}
shown early --time 0.5
shown late --time 1.5
shown loop --time 2.5 --repeat loop
shown back --time 2.5 --repeat ping-pong
shown end --time 2 --repeat once
shown once --time 2.5 --repeat once
check 'a loop begins again' cmp "$scratch/loop.png" "$scratch/early.png"
check 'ping-pong plays backwards' cmp "$scratch/back.png" "$scratch/late.png"
check 'a clip that is played once stays at its end' \
    cmp "$scratch/once.png" "$scratch/end.png"
check 'and these pictures differ' sh -c '! cmp -s "$1/early.png" "$1/late.png" &&
    ! cmp -s "$1/late.png" "$1/end.png"' sh "$scratch"
limber render "$slider" --repeat often -o "$scratch/often.png"
expect_refusal 2 'give loop, ping-pong or once'

# film RATE FRAMES ARGUMENT...: without --frames a film is one period long.
film() {
    rate=$1
    frames=$2
    shift 2
    limber render "$@" --size 16x16 --clock "fixed:$rate" --gl soft \
        -o "$scratch/film.y4m"
    expect_status 0
    check "$tap_about: $frames frames" test "$frames" -eq \
        "$(grep -ao 'FRAME' "$scratch/film.y4m" | wc -l)"
}
film 5 10 "$slider"
film 5 20 "$slider" --speed 0.5
film 5 20 "$slider" --repeat ping-pong
film 1 18 --demo walker
film 1 15 --demo arm
film 1 14 --demo face
film 1 8 --demo crowd
film 1 7 --demo duel
film 1 6 --demo tuner

# Where a character file or a demo says how clips play, options do not.
cp "$slider" "$scratch/slider.gltf"
echo '[state a]' >"$scratch/slider.character"
echo 'clip = slide' >>"$scratch/slider.character"
one() {
    limber render "$@" --size 16x16 --gl soft -o "$scratch/one.png"
    expect_status 0
}
one "$scratch/slider.gltf" --speed 2
check 'the character file is named' grep -q \
    'change nothing, as .*slider.character says how clips play' "$err_file"
one "$scratch/slider.gltf" --speed 2 --character none
expect_no_err
one "$scratch/slider.gltf" --repeat once --clip rise
expect_no_err
one "$slider" --speed 2
expect_no_err
one --demo tuner --repeat once
check 'the demo is named' grep -q 'change nothing in the demo tuner' "$err_file"
tap_done
