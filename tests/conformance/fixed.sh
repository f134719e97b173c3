#!/bin/sh
# fixed.sh SAMPLES HOST BOARD...: `limber pose --math fixed` gives the same bytes
# wherever it runs. HOST is the program for this machine, BOARD the command that
# runs the one for ARM; every model of SAMPLES/models and assets is posed at
# several times of its clips, with each fixed-point kernel and, since what comes
# before the vertex loops is float everywhere, in float too.
. "$(dirname "$0")/../support/tap.sh"
samples=$1
host=$2
shift 2
times='0 0.21 0.5 1.3'
influences='--influences 2'

# pose_with NAME WORDS...: a pose by WORDS into the file NAME.
pose_with() {
    file=$scratch/$1.obj
    shift
    rm -f "$file"
    "$@" -o "$file" 2>"$scratch/said" && [ -s "$file" ]
}

# same_as_host MODEL WORDS...: the host's bytes by kernel fixed, and the board's
# by each of its kernels.
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

# clips MODEL: their numbers, as options.
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
check 'the models of the project are among them' test "$checked" -ge 3
tap_done
