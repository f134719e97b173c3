#!/bin/sh
# count.sh PLUGIN PROGRAM ARGUMENTS...: millions of ARM instructions a frame,
# where FRAMES among the arguments stands for the number of frames: what nine
# frames need more than one, by eight. SYSROOT is where its libraries are.
set -eu
plugin=$1
shift

# run FRAMES PROGRAM ARGUMENTS...: how many instructions that takes.
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
