#!/bin/sh
# check-arm.sh READELF FILE: fails unless FILE's build attributes say that it
# needs at most ARMv6 and VFPv2.
set -eu
readelf=$1
file=$2

attributes=$("$readelf" -A "$file")
value_of() {
    printf '%s\n' "$attributes" | sed -n "s/^ *$1: //p"
}

architecture=$(value_of Tag_CPU_arch)
case $architecture in
v4 | v4T | v5T | v5TE | v5TEJ | v6) ;;
*)
    echo "limber: $file: it needs ARM $architecture, but the board has v6" >&2
    exit 1
    ;;
esac
floating=$(value_of Tag_FP_arch)
case $floating in
'' | VFPv1 | VFPv2) ;;
*)
    echo "limber: $file: it needs $floating, but the board has VFPv2" >&2
    exit 1
    ;;
esac
if [ -n "$(value_of Tag_Advanced_SIMD_arch)" ]; then
    echo "limber: $file: it needs NEON, which the board lacks" >&2
    exit 1
fi
