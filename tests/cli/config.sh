#!/bin/sh
# Tests limber.conf: which file limber reads, what overrides it and how errors
# are reported. Tests that --script plays back what --record-buttons wrote.
. "$(dirname "$0")/../support/cli.sh"
conf=$scratch/limber.conf

# given LINE...: writes a limber.conf of these lines.
given() {
    printf '%s\n' "$@" >"$conf"
}

# expect_demo NAME: play prints that it shows this demo.
expect_demo() {
    expect_status 0
    expect_out "^$1: "
}

given '[start]' 'demo = face' '[display]' 'display = null' '[options]' \
    'frames = 1' 'clock = fixed:25'
limber play --config "$conf"
expect_demo face
limber play --config "$conf" --demo arm
expect_demo arm
limber play --config "$conf" "$slider"
expect_demo viewer

# The character file of limber.conf is that of its model, not of others.
printf '%s\n' '[state stand]' 'clip = no such clip' \
    >"$scratch/other.character"
given '[start]' 'demo = face' '[display]' 'display = null' '[options]' \
    'frames = 1' 'clock = fixed:25' "character = $scratch/other.character"
limber play --config "$conf"
expect_refusal 1 'other.character:'
limber play --config "$conf" "$slider"
expect_demo viewer
limber play --config "$conf" --demo arm
expect_demo arm
limber play --config "$conf" --demo arm --character "$scratch/other.character"
expect_refusal 1 'other.character:'
given '[start]' 'demo = face' '[display]' 'display = null' '[options]' \
    'frames = 1' 'clock = fixed:25' 'character = none'
limber play --config "$conf" "$slider"
expect_demo viewer
given '[start]' 'demo = face' '[display]' 'display = null' '[options]' \
    'frames = 1' 'clock = fixed:25'

# Names are looked up later, when the line is forgotten; the file is not.
given '[display]' 'display = nosuch'
limber play --config "$conf"
expect_status 2
expect_err '^limber: --display nosuch: no such display'
expect_err "^limber: $conf: it sets options, too$"
limber play --config none --display nosuch
expect_refusal 2 '--display nosuch: no such display'
given '[start]' 'demo = face' '[display]' 'display = null' '[options]' \
    'frames = 1' 'clock = fixed:25'

LIMBER_CONFIG=$conf limber play
expect_demo face
unset LIMBER_CONFIG
mkdir -p "$scratch/home/.config/limber" "$scratch/xdg/limber"
given '[start]' 'demo = arm' '[display]' 'display = null' '[options]' \
    'frames = 1' 'clock = fixed:25'
cp "$conf" "$scratch/xdg/limber"
HOME=$scratch/home XDG_CONFIG_HOME=$scratch/xdg limber play
expect_demo arm
mv "$scratch/xdg/limber/limber.conf" "$scratch/home/.config/limber"
HOME=$scratch/home XDG_CONFIG_HOME='' limber play
expect_demo arm
HOME=$scratch/home XDG_CONFIG_HOME='' limber play --config none \
    --display null --frames 1 --demo face
expect_demo face
export LIMBER_CONFIG=none

given '[start]' 'dmeo = arm'
limber play --config "$conf"
expect_refusal 1 'limber.conf:2: dmeo: .*did you mean demo\?$'
given '[display]' 'gl = soft' 'size = 480'
limber play --config "$conf"
expect_refusal 1 'limber.conf:3: size = 480: give'
limber play --config "$scratch/missing.conf"
expect_refusal 1 'missing.conf: cannot be read'
LIMBER_CONFIG=$(printf '%05000d' 0) limber play
expect_refusal 1 'has more than 4095 characters: give a shorter one'

# Runs twice: with a script, then with the record of the first run.
printf '%s\n' '40 RIGHT down' '130 RIGHT up' '200 ENTER down' '210 ENTER up' \
    '300 UP down' '303 UP up' '304 UP down' '700 UP up' >"$scratch/run.txt"
play() {
    limber play --demo arm --display image --size 60x80 --clock fixed:30 \
        --frames 25 --no-labels "$@"
    expect_status 0
}
play --script "$scratch/run.txt" --record-buttons "$scratch/said.txt" \
    -o "$scratch/first.y4m"
play --script "$scratch/said.txt" --record-buttons "$scratch/again.txt" \
    -o "$scratch/second.y4m"
play -o "$scratch/idle.y4m"
about 'a recorded run'
expect_file "$scratch/said.txt"
check 'both presses within a frame are recorded' test \
    "$(grep -c UP "$scratch/said.txt")" -eq 4
check 'the second record equals the first' cmp "$scratch/said.txt" "$scratch/again.txt"
check 'the second film equals the first' cmp "$scratch/first.y4m" "$scratch/second.y4m"
if cmp -s "$scratch/first.y4m" "$scratch/idle.y4m"; then
    fail 'the buttons change the film'
else
    pass 'the buttons change the film'
fi

given '[actions]' 'F6 = RIGHT' 'RIGHT = none'
sed s/RIGHT/F6/ "$scratch/run.txt" >"$scratch/moved.txt"
play --config "$conf" --script "$scratch/moved.txt" -o "$scratch/moved.y4m"
check 'an action moves to another button' cmp "$scratch/first.y4m" \
    "$scratch/moved.y4m"

# On the real clock, too, the first frame is at --time, and loading takes none.
printf '%s\n' '200 UP down' '400 UP up' '5100 RIGHT down' >"$scratch/late.txt"
limber play --demo arm --display null --size 60x80 --frames 1 \
    --script "$scratch/late.txt" --record-buttons "$scratch/first.txt"
expect_status 0
check 'no button is pressed in the first frame' test ! -s "$scratch/first.txt"
limber play --demo arm --display null --size 60x80 --fps 100 --frames 60 \
    --time 5 --script "$scratch/late.txt" --record-buttons "$scratch/late-5.txt"
expect_status 0
check 'the third button is pressed after five seconds' \
    cmp "$scratch/late.txt" "$scratch/late-5.txt"

limber play --demo arm --display null --frames 1 \
    --record-buttons "$scratch/missing/x.txt"
expect_status 1
expect_err 'x.txt: cannot be written'

# Limits of a file and of its lists.
awk 'BEGIN { for (i = 0; i <= 100000; i++) print "; a line" }' >"$conf"
limber play --config "$conf"
expect_refusal 1 'limber.conf:100001: the file has more than 100000 lines'
given '[buttons]' "UP = gpio gpiochip0 $(printf '%0200d' 7)"
limber play --config "$conf"
expect_refusal 1 'limber.conf:2: this line has more than 198 characters'
awk 'BEGIN { print "[buttons]"
    for (i = 0; i < 400; i++) print "UP = key KEY_W, key KEY_A" }' >"$conf"
limber play --config "$conf"
expect_refusal 1 'UP: there are too many buttons: remove some'

# A run that fails keeps an older record and an older film.
echo old >"$scratch/kept.txt"
echo old >"$scratch/kept.gif"
limber play --demo arm --display kms:/dev/none --frames 1 \
    --record-buttons "$scratch/kept.txt" --record "$scratch/kept.gif"
expect_status 1
check 'the older record is kept' test "$(cat "$scratch/kept.txt")" = old
check 'the older film is kept' test "$(cat "$scratch/kept.gif")" = old
# shellcheck disable=SC2086,SC2016 # a command and its arguments
run sh -c '(ulimit -f 0; exec "$@") 2>&1 >/dev/null | cat' sh $limber play \
    --demo arm --display null --clock fixed:30 --frames 30 \
    --script "$scratch/run.txt" --record-buttons "$scratch/kept.txt"
about 'a record on a full disk'
expect_out '^limber: .*kept.txt: cannot be written: .*too large'
check 'the older record is kept' test "$(cat "$scratch/kept.txt")" = old
check 'no temporary file is left' \
    test -z "$(find "$scratch" -name '*.part')"

tap_done
