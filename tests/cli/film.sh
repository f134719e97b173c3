#!/bin/sh
# Tests limber play --record, pictures kept with F8, and the frame times.
. "$(dirname "$0")/../support/cli.sh"

case $limber in
/* | *' '*) ;;
*) limber=$PWD/$limber ;;
esac
slider=$(cd "$(dirname "$slider")" && pwd)/${slider##*/}

# play OPTION...: plays ten frames at fixed times without showing them.
play() {
    limber play "$slider" --display null --format rgba8888 --size 40x30 \
        --clock fixed:10 --frames 10 --gl soft "$@"
    expect_status 0
    expect_no_err
}

render() {
    limber render "$slider" --format rgba8888 --size 40x30 --frames 10 \
        --clock fixed:10 --gl soft --script /dev/null "$@"
    expect_status 0
}

for kind in y4m gif; do
    play --record "$scratch/film.$kind"
    render -o "$scratch/rendered.$kind"
    check "a film is what render writes: .$kind" \
        cmp "$scratch/film.$kind" "$scratch/rendered.$kind"
done
check 'no temporary file is left' test ! -e "$scratch/film.gif.part"

limber play "$slider" --record film.mp4 --frames 1 --display null
expect_refusal 2 'gif or .y4m'
limber play "$slider" --record "$scratch/none/film.gif" --frames 1 \
    --display null --size 40x30
expect_status 1
expect_err 'none/film.gif'

# Pictures are written to the current folder.
if [ "${limber#/}" != "$limber" ]; then
    (
        cd "$scratch" || exit 1
        printf '100 F9 down\n200 F8 down\n300 F8 up\n400 F9 up\n' >keep
        "$limber" play "$slider" --display null --format rgba8888 \
            --size 40x30 --clock fixed:10 --frames 10 --gl soft \
            --script keep >/dev/null
        "$limber" play "$slider" --display null --format rgba8888 \
            --size 40x30 --clock fixed:10 --frames 10 --gl soft \
            --script keep >/dev/null
        "$limber" render "$slider" --time 0.2 --format rgba8888 \
            --size 40x30 --gl soft --script /dev/null --clock fixed:10 \
            -o rendered.png
    )
    about 'F8 while F9 is held'
    check 'keeps the picture of that moment' \
        cmp "$scratch/limber-0001.png" "$scratch/rendered.png"
    check 'uses the next free name' test -e "$scratch/limber-0002.png"
fi

# Holding F9 shows the graph; holding it again hides the graph.
printf '0 F9 down\n800 F9 up\n' >"$scratch/hold"
printf '0 F9 down\n800 F9 up\n1000 F9 down\n1800 F9 up\n' >"$scratch/twice"
printf '0 F9 down\n300 F9 up\n' >"$scratch/tap"
for script in hold twice tap; do
    limber render "$slider" --size 240x320 --time 2 --no-labels --gl soft \
        --script "$scratch/$script" -o "$scratch/$script.png"
    expect_status 0
done
check 'holding F9 shows the graph' \
    sh -c '! cmp -s "$1" "$2"' sh "$scratch/hold.png" "$scratch/tap.png"
check 'holding F9 again hides it' cmp "$scratch/twice.png" "$scratch/tap.png"

# No frame takes a second.
budget() {
    limber play "$slider" --display null --size 320x240 --clock fixed:10 \
        --frames 2 --gl soft "$@"
    expect_status 0
}
budget --hud --budget-ms 1000
budget --no-labels --budget-ms 1000 --record "$scratch/plain.y4m"
budget --no-labels --record "$scratch/without.y4m"
check 'a budget that is kept changes nothing' \
    cmp "$scratch/plain.y4m" "$scratch/without.y4m"
tap_done
