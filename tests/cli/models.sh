#!/bin/sh
# Runs every command on every sample and every fixture. Each one succeeds, or
# fails with sentences on standard error; none is ended by a signal.
. "$(dirname "$0")/../support/cli.sh"
samples=${SAMPLES:-../shared}

# expect_orderly_end: exit status 0, or 1 with only sentences of limber.
expect_orderly_end() {
    if [ "$status" -eq 0 ] ||
        { [ "$status" -eq 1 ] && grep -q '^limber: ' "$err_file" &&
            ! grep -vq '^limber: ' "$err_file"; }; then
        pass "$tap_about: ends in order"
    else
        fail "$tap_about: ends in order" "$(tap_show)"
    fi
}

# commands_for MODEL: prints the command lines to run on it.
#
# What every command does with a model begins as in pose and render. In qemu-arm a
# start takes a tenth of a second, and a large model half a minute to compare: there
# fixtures go no further, and of what compares large models only cli/compare.sh runs.
commands_for() {
    nothing_shown="--size 32x32 --display null"
    demo_frames="$nothing_shown --frames 3 --clock fixed:9"
    size=$(wc -c <"$1")
    echo "pose -o $out.obj"
    echo "render --size 32x32 --frames 1 -o $out.png"
    case $limber:$1 in
    qemu-*/fixtures/*) return ;;
    qemu-*) ;;
    *)
        # Texts are made from the same figures as JSON.
        printf '%s\n' info doctor "doctor --json"
        echo "play $nothing_shown --frames 1 --clock fixed:30"
        size=0
        ;;
    esac
    echo "info --json"
    # In qemu-arm one demo after the other gets a model.
    case $limber:$((turn % 3)) in
    qemu-*:0) demos=crowd ;;
    qemu-*:1) demos=duel ;;
    qemu-*:2) demos=tuner ;;
    *) demos="crowd duel tuner" ;;
    esac
    for demo in $demos; do
        echo "play --demo $demo $demo_frames"
    done
    echo "export --c $out.c"
    echo "bench --runs 1"
    [ "$size" -ge 200000 ] || echo "compare --size 32x32 --fps 4"
}

find "$samples/models" "$(dirname "$0")/../fixtures" \
    "$(dirname "$0")/slider.gltf" -name '*.glb' -o -name '*.gltf' -o \
    -name '*.x' 2>/dev/null | sort >"$scratch/models"
out=$scratch/out
turn=0
while read -r model; do
    turn=$((turn + 1))
    commands_for "$model" >"$scratch/commands"
    while read -r command; do
        # shellcheck disable=SC2086 # a command and its options
        limber $command "$model"
        expect_orderly_end
    done <"$scratch/commands"
done <"$scratch/models"
check 'there are models' test -s "$scratch/models"

tap_done
