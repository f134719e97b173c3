#!/bin/sh
# fixed.sh SAMPLES HOST BOARD...: checks that `limber pose` writes the same bytes
# on this machine and on ARM. HOST is the program for this machine, BOARD the
# command that runs the program for ARM. The script poses every model of
# SAMPLES/models and assets at several times of its clips, with each fixed-point
# kernel and in float. Floats agree too, because both use one order of operations.
. "$(dirname "$0")/../support/tap.sh"
samples=$1
host=$2
shift 2
times='0.21 1.3'
influences='--influences 2'

# pose_with NAME COMMAND...: writes the pose to $scratch/NAME.obj.
pose_with() {
    file=$scratch/$1.obj
    shift
    rm -f "$file"
    "$@" -o "$file" 2>"$scratch/messages" && [ -s "$file" ]
}

# same_as_host MODEL OPTION...: compares the host's kernel fixed with each kernel
# of the board, then float with float.
same_as_host() {
    words="pose $*"
    # shellcheck disable=SC2086 # words
    pose_with host "$host" $words --kernel fixed || return 1
    for kernel in fixed armv6; do
        # shellcheck disable=SC2086
        pose_with board $board $words --kernel "$kernel" || return 1
        cmp "$scratch/host.obj" "$scratch/board.obj" || return 1
    done
    # shellcheck disable=SC2086
    pose_with host "$host" $words --math float &&
        pose_with board $board $words --math float &&
        cmp "$scratch/host.obj" "$scratch/board.obj"
}

# clips MODEL: prints the numbers of the clips.
clips() {
    "$host" info "$1" --json 2>/dev/null | python3 -c '
import json, sys
for clip, _ in enumerate(json.load(sys.stdin)["clips"]):
    print(clip)'
}

board=$*
checked=0
for model in assets/*.glb "$samples"/models/*.gl* "$samples"/models/x/*.x; do
    [ -f "$model" ] || continue
    case $model in
    *malformed*) continue ;;
    esac
    check "${model##*/} at rest" same_as_host "$model"
    check "${model##*/} at rest, two influences" \
        same_as_host "$model" $influences
    for clip in $(clips "$model"); do
        for time_s in $times; do
            check "${model##*/}, clip $clip at $time_s s" \
                same_as_host "$model" --clip "$clip" --time "$time_s"
        done
    done
    checked=$((checked + 1))
done
check 'the models of assets were checked' test "$checked" -ge 3
tap_done
