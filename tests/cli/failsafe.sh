#!/bin/sh
# --failsafe: a model that ended limber twice within a minute of its start gives
# way to the built-in demo, which says so.
. "$(dirname "$0")/../support/cli.sh"

count=$scratch/starts
model=$scratch/robot.gltf
cp "$slider" "$model"
showed="$model: it ended limber 2 times within a minute of its start"

# play [OPTION...]: what the board's init starts.
play() {
    limber play --display null --failsafe "$count" "$@"
}

# crash: a start that a signal ends before anything is in order.
crash() {
    run sh -c '"$@" & pid=$!; n=0
        until [ -s "$0" ] && [ "$(cut -c 17 "$0")" = "$number" ] ||
            [ $n = 500 ]; do sleep 0.02; n=$((n + 1)); done
        sleep 0.1; kill -KILL $pid; wait $pid' \
        "$count" $limber play --display null --failsafe "$count" "$model"
    about "a start that is killed"
    expect_status 137
}

play "$model" --frames 2
expect_status 0
expect_no_err
check 'a start that ends in order is not counted' test ! -e "$count"

export number=1
crash
check 'a start that is killed is counted' \
    grep -q "^limber failsafe 1 .* $model\$" "$count"
play "$model" --frames 2
expect_no_err
check 'an end in order begins the count anew' test ! -e "$count"

crash
number=2
crash
play "$model" --frames 2
expect_status 0
expect_err "^limber: $showed: limber shows its demo walker instead, until the file changes or you delete $count"
limber play --display null --demo walker --frames 1 --clock fixed:25 \
    --size 240x320 --record "$scratch/demo.y4m"
play "$model" --frames 1 --clock fixed:25 --size 240x320 --no-labels \
    --record "$scratch/instead.y4m"
limber play --display null --demo walker --frames 1 --clock fixed:25 \
    --size 240x320 --no-labels --record "$scratch/plain.y4m"
expect_status 0
check 'a sentence stands in the picture, without labels too' \
    sh -c '! cmp -s "$1/instead.y4m" "$1/plain.y4m"' sh "$scratch"
check 'the rest of it is the demo' test "$(cmp -l "$scratch/instead.y4m" \
    "$scratch/plain.y4m" | wc -l)" -lt 40000
play "$model" --frames 2
expect_err "$showed"
play --demo arm --frames 2
expect_no_err
printf ' ' >>"$model"
play "$model" --frames 2
expect_status 0
expect_no_err
check 'a model that has changed is tried again' test ! -e "$count"

# An error counts like a crash; so does a missing file.
for start in 1 2; do
    play "$scratch/none.glb"
    expect_refusal 1 'none\.glb: .*[Nn]o such file'
done
play "$scratch/none.glb" --frames 2
expect_status 0
expect_err 'none\.glb: it ended limber 2 times'

play --demo walker --frames 2
expect_no_err
check 'the built-in demo itself is not counted' \
    grep -q 'none\.glb$' "$count"

# A file of something else, and one that cannot be written.
echo 'limber failsafe 9 0 0 x' >"$count"
play "$model" --frames 2
expect_no_err
echo 'my notes' >"$count"
play "$model" --frames 2
expect_status 0
expect_err "^limber: --failsafe $count: limber did not write this file: starts are not counted"
check 'a file of something else stays' grep -q '^my notes$' "$count"
limber play --display null --frames 2 --failsafe "$scratch/none/starts" "$model"
expect_status 0
expect_err '^limber: --failsafe [^ ]*none/starts: '
mkdir "$scratch/starts.d"
limber play --display null --frames 2 --failsafe "$scratch/starts.d" "$model"
expect_status 0
expect_err '^limber: --failsafe [^ ]*starts\.d: Is a directory: '

# A device stays what it is, and so does a link; what it leads to is emptied.
# unchanged FILE: it is what it was, after limber ended in order.
unchanged() {
    before=$(stat -c '%F %t:%T %N' "$1")
    limber play --display null --frames 2 --failsafe "$1" "$model"
    expect_status 0
    check "${1##*/} stays" test "$(stat -c '%F %t:%T %N' "$1")" = "$before"
}

mkfifo "$scratch/pipe"
unchanged "$scratch/pipe"
if mknod "$scratch/null" c 1 3 2>/dev/null; then
    unchanged "$scratch/null"
else
    skip 'a device' 'this user may not make one'
fi
ln -s linked "$scratch/link"
unchanged "$scratch/link"
number=1
count=$scratch/link
crash
check 'starts are counted where a link leads to' test -s "$scratch/linked"
unchanged "$scratch/link"
check 'and are forgotten there' test ! -s "$scratch/linked"
tap_done
