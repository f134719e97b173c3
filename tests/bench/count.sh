#!/bin/sh
# count.sh PLUGIN PROGRAM ARGUMENTS...: prints the millions of ARM instructions
# that a frame takes. The word FRAMES among the arguments stands for the number
# of frames; the result is (instructions of 9 frames - of 1 frame) / 8. SYSROOT
# is the folder of the program's libraries.
set -eu
plugin=$1
shift

# run FRAMES PROGRAM ARGUMENTS...: prints the instructions of a run.
run() {
    frames=$1
    shift
    for argument in "$@"; do
        shift
        [ "$argument" != FRAMES ] || argument=$frames
        set -- "$@" "$argument"
    done
    LP_NUM_THREADS=0 qemu-arm -cpu arm1136 -L "${SYSROOT:-build/sysroot}" \
        -plugin "$plugin" -d plugin "$@" 2>&1 >/dev/null |
        sed -n 's/^instructions: //p'
}

one=$(run 1 "$@")
nine=$(run 9 "$@")
echo "$one $nine" | awk '{ printf "%.2f\n", ($2 - $1) / 8e6 }'
