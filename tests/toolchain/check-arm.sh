#!/bin/sh
# Tests check-arm.sh: it accepts only programs that the board can run.
. "$(dirname "$0")/../support/tap.sh"
script=$(dirname "$0")/../../toolchain/check-arm.sh

# compiled OPTION...: runs the script on an object file for that processor.
compiled() {
    printf 'float twice(float x) { return x + x; }\n' |
        arm-linux-gnueabi-gcc "$@" -c -x c -o "$scratch/object.o" -
    run "$script" arm-linux-gnueabi-readelf "$scratch/object.o"
    about "$*"
}

compiled -mcpu=arm1136jf-s -mfpu=vfpv2 -mfloat-abi=softfp -marm
expect_status 0
expect_no_err
compiled -mcpu=arm926ej-s -mfloat-abi=soft -marm
expect_status 0
compiled -mcpu=cortex-a8 -mfpu=vfpv3 -mfloat-abi=softfp -marm
expect_status 1
expect_err 'needs ARM v7, but the board has v6$'
compiled -march=armv6 -mfpu=vfpv3 -mfloat-abi=softfp -marm
expect_status 1
expect_err 'needs VFPv3, but the board has VFPv2$'
compiled -mcpu=cortex-a8 -mfpu=neon -mfloat-abi=softfp -marm
expect_status 1
compiled -mcpu=arm1136jf-s -mfpu=neon -mfloat-abi=softfp -marm
expect_status 1
tap_done
