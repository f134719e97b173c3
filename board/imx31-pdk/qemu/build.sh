#!/bin/sh
# build.sh DIR: builds QEMU with the machine imx31-pdk as DIR/qemu-system-arm, from
# Debian's source package of the version that is installed, qemu.patch and the
# files in devices/, with the compiler of cc.sh. It does nothing when none of them
# has changed.
#
# Where the source cannot be had, it removes DIR/qemu-system-arm, says why and
# succeeds: the emulation then uses the installed QEMU's machine kzm.
set -eu

directory=${1:?usage: build.sh DIR}
here=$(cd "$(dirname "$0")" && pwd)
: "${JOBS:=$(nproc)}"
mkdir -p "$directory"
directory=$(cd "$directory" && pwd)
source=$directory/source
log=$directory/build.log

# The version of the source from which Debian built the installed emulator.
version=$(dpkg-query -W -f '${source:Version}' qemu-system-arm 2>/dev/null || true)

base=$(cat "$here/build.sh" "$here/cc.sh" "$here/qemu.patch" | sha256sum)-$version
all=$(cat "$here"/devices/* | sha256sum)-$base
if [ -x "$directory/qemu-system-arm" ] && [ -f "$directory/made-from" ] &&
    [ "$(cat "$directory/made-from")" = "$all" ]; then
    exit 0
fi
rm -f "$directory/qemu-system-arm" "$directory/made-from"
: >"$log"

skip() {
    echo "limber: the machine imx31-pdk is not built, because $1; the emulation uses QEMU's machine kzm, which has neither panel, keypad nor flash (see $log)" >&2
    exit 0
}

fail() {
    tail -n 30 "$log" | cut -c1-200 >&2
    echo "limber: QEMU cannot be built: see $log" >&2
    exit 1
}

# apt with lists of its own, so that the machine's configuration stays as it is.
# Apt verifies the source with Debian's archive key.
apt_here() {
    apt-get -q -o Dir::Etc::SourceList="$directory/sources.list" \
        -o Dir::Etc::SourceParts=/dev/null -o Dir::State::Lists="$directory/lists" \
        -o Dir::Cache="$directory/cache" -o APT::Sandbox::User=root \
        -o Acquire::http::Timeout=20 -o Acquire::Retries=1 "$@" >>"$log" 2>&1
}

fetch() {
    key=/usr/share/keyrings/debian-archive-keyring.gpg
    mirror=${MIRROR:-http://deb.debian.org/debian}
    command -v apt-get >/dev/null || skip 'this machine has no apt-get'
    [ -n "$version" ] || skip 'the package qemu-system-arm is not installed'
    rm -rf "$directory/package"
    mkdir -p "$directory/lists/partial" "$directory/cache/archives/partial" \
        "$directory/package"
    {
        echo "deb-src [signed-by=$key] $mirror bookworm main"
        echo "deb-src [signed-by=$key] $mirror bookworm-updates main"
        echo "deb-src [signed-by=$key] ${mirror%/debian}/debian-security bookworm-security main"
    } >"$directory/sources.list"
    apt_here update || skip "no Debian source packages can be had from $mirror"
    cd "$directory/package"
    apt_here source --download-only "qemu=$version" ||
        apt_here source --download-only qemu ||
        skip "Debian's source of QEMU $version cannot be had"
    cd "$directory"
}

# Firmware for other machines is not in the package, and is not needed.
unpack() {
    rm -rf "$source" "$directory/obj"
    mkdir "$source"
    cd "$source"
    tar -xJf "$directory/package"/qemu_*.orig.tar.xz --strip-components=1
    tar -xJf "$directory/package"/qemu_*.debian.tar.xz
    while read -r patch; do
        case $patch in
        '' | '#'*) ;;
        *) patch -s -p1 <"debian/patches/$patch" >>"$log" 2>&1 || fail ;;
        esac
    done <debian/patches/series
    patch -s -p1 <"$here/qemu.patch" >>"$log" 2>&1 || fail
    sed -i "/^ *'edk2-.*\.fd',$/d" pc-bios/meson.build
    cat >configs/devices/arm-softmmu/imx31-pdk.mak <<'END'
CONFIG_IMX31_PDK=y
CONFIG_SEMIHOSTING=y
CONFIG_ARM_COMPATIBLE_SEMIHOSTING=y
CONFIG_ARM_V7M=y
END
    cd "$directory"
}

configure() {
    mkdir -p "$directory/obj"
    cd "$directory/obj"
    ../source/configure --cc="$here/cc.sh" --target-list=arm-softmmu \
        --without-default-features --without-default-devices \
        --with-devices-arm=imx31-pdk --enable-tcg \
        --enable-plugins --enable-system --disable-user --enable-fdt=system \
        --enable-vnc --disable-docs --disable-install-blobs --disable-debug-info \
        >>"$log" 2>&1 || fail
    cd "$directory"
}

# Compiles the header with which every file of QEMU begins: for files that are
# optimized and for others (cc.sh), each with and without the processor's
# definitions. GCC takes the one that fits, or else reads the header's text.
precompile() {
    header=$source/include/qemu/osdep.h
    mkdir -p "$header.gch"
    cd "$directory/obj"
    ninja config-poison.h >>"$log" 2>&1 || fail
    for object in libqemu-arm-softmmu.fa.p/tcg_tcg.c.o \
        libqemu-arm-softmmu.fa.p/gdbstub_gdbstub.c.o \
        libcommon.fa.p/hw_core_loader.c.o libblock.fa.p/block.c.o; do
        command=$(ninja -t commands -s "$object")
        eval "${command%% -MD *}" -x c-header \
            -o '"$header.gch/${object##*/}" "$header"' >>"$log" 2>&1 || fail
    done
    cd "$directory"
}

# Copies the devices that differ, so that only these are compiled again.
copy_devices() {
    devices=$source/hw/arm/imx31-pdk
    mkdir -p "$devices"
    for file in "$here"/devices/*; do
        cmp -s "$file" "$devices/${file##*/}" || cp "$file" "$devices"
    done
}

if [ ! -f "$source/made-from" ] || [ "$(cat "$source/made-from")" != "$base" ]; then
    fetch
    unpack
    copy_devices
    configure
    precompile
    echo "$base" >"$source/made-from"
fi
copy_devices
ninja -C "$directory/obj" -j "$JOBS" qemu-system-arm >>"$log" 2>&1 || fail
cp "$directory/obj/qemu-system-arm" "$directory/qemu-system-arm"
echo "$all" >"$directory/made-from"
