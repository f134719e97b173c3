#!/bin/sh
# reproduce.sh FOLDER TARGET...: builds the targets of make from two copies of
# the sources in FOLDER, whose paths, times, time zones, locales and umasks
# differ, and fails unless the programs and packages have the same bytes.
set -eu
folder=$1
shift
here=$(pwd -P)
rm -rf "$folder"
mkdir -p "$folder"

# copy NAME: copies the sources and this folder's sysroot.
copy() {
    copy=$folder/$1
    mkdir -p "$copy/build"
    tar -C "$here" --exclude=./build --exclude=./.git --exclude='*.pyc' -cf - . |
        tar -C "$copy" -xf -
    if [ -d "$here/.git" ] || [ -f "$here/.git" ]; then
        cp -a "$here/.git" "$copy/.git"
    fi
    cp -al "$here/build/sysroot" "$copy/build/sysroot"
    find "$copy" -path "$copy/build" -prune -o -type f -exec touch {} +
    touch "$copy/build/sysroot.stamp"
}

# build NAME ENVIRONMENT...: builds a copy.
build() {
    copy=$folder/$1
    shift
    env -C "$copy" "$@" make --no-print-directory -j"$(nproc)" $targets \
        >"$folder/log" 2>&1 || {
        cat "$folder/log" >&2
        exit 1
    }
}

# sums NAME: the sums of what was built there.
sums() {
    (cd "$folder/$1" && find build/host/limber build/arm/limber \
        build/package build/board/imx31-pdk -maxdepth 1 -type f \
        \( -name limber -o -name '*.deb' -o -name '*.ubi' -o -name '*.lz4' \
        -o -name '*.dtb' -o -name 'zImage*' \) -exec sha256sum {} + 2>/dev/null | sort -k 2)
}

targets=$*
copy a
copy a-folder-with-a-longer-name
build a TZ=UTC LC_ALL=C
sleep 1
build a-folder-with-a-longer-name TZ=Pacific/Kiritimati LC_ALL=C.UTF-8 \
    sh -c 'umask 077; exec "$@"' sh
sums a >"$folder/first"
sums a-folder-with-a-longer-name >"$folder/second"
if [ ! -s "$folder/first" ] || ! cmp -s "$folder/first" "$folder/second"; then
    echo 'limber: two builds differ:' >&2
    diff "$folder/first" "$folder/second" >&2 || true
    exit 1
fi
sed 's/^\(................\)[^ ]*/  \1/' "$folder/first"
