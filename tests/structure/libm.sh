#!/bin/sh
# Code that runs every frame calls no maths of the C library, which computes in
# software on the board. OBJECTS are the folders and files to look at; LIBM is the
# library whose functions must not be called.
. "$(dirname "$0")/../support/tap.sh"
objects=${OBJECTS:-build/arm/obj/app/anim build/arm/obj/platform/base/scalar.o}
libm=${LIBM:-build/sysroot/usr/lib/arm-linux-gnueabi/libm.so.6}
nm=${NM:-arm-linux-gnueabi-nm}

"$nm" -D --defined-only "$libm" | awk '{ sub(/@.*/, "", $3); print $3 }' |
    sort -u >"$scratch/names"
check 'the names of the library can be read' grep -qx sinf "$scratch/names"

# shellcheck disable=SC2086 # a list
find $objects -name '*.o' >"$scratch/objects"
check 'there are objects to look at' test -s "$scratch/objects"
while read -r object; do
    wanted=$("$nm" -u "$object" | awk '{ print $2 }' | sort -u |
        comm -12 - "$scratch/names")
    if [ -z "$wanted" ]; then
        pass "$object"
    else
        fail "$object" "calls $(echo $wanted): platform/base/scalar.h has substitutes"
    fi
done <"$scratch/objects"

tap_done
