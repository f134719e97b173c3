#!/bin/sh
# pose.sh MODEL.so POSE_COST FILE CLIP...: prints a line for each file and clip:
# the ARM instructions of a pose for each joint and frame, on the timing model,
# for sampling the clip, world matrices and palettes, their sum, and the cycles.
# SYSROOT is the folder of the program's libraries.
set -eu
model=$1
program=$2
shift 2
while [ $# -gt 1 ]; do
    qemu-arm -cpu arm1136 -L "${SYSROOT:-build/sysroot}" -plugin "$model" \
        "$program" "$1" "$2" 20 2>&1 |
        awk -v name="$(basename "$1") $2" '
            $1 == "joints" { joints = $2 }
            $1 == "region" {
                for (i = 3; i < NF; i++) {
                    value[$i] = $(i + 1)
                }
                frames = value["entries"] * joints
                cycles += value["cycles"] / frames
                each = value["instructions"] / frames
                all += each
                text = text sprintf(" %6.1f", each)
            }
            END {
                printf "%-24s sample, world, palette:%s", name, text
                printf " instructions: %.1f cycles: %.1f\n", all, cycles
            }'
    shift 2
done
