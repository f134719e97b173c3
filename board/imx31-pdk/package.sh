#!/bin/sh
# package.sh ROOT SYSROOT DIR: makes a Debian package of limber for armel in DIR.
# ROOT is the board's root file system.
set -eu

root=$1
sysroot=$2
out=$3
tree=$out/deb.new
top=$(dirname "$0")/../..
trap 'rm -rf "$tree"' EXIT
version=$(qemu-arm -cpu arm1136 -L "$sysroot" "$root/usr/bin/limber" --version |
    sed -n '1s/^limber \([^ ]*\).*/\1/p')

# The Debian 13 packages of the libraries that limber needs.
depends=
for library in $(arm-linux-gnueabi-readelf -d "$root/usr/bin/limber" |
    sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p') libv4lconvert.so.0; do
    case $library in
    ld-linux.so.* | libc.so.* | libm.so.*) package='libc6 (>= 2.41)' ;;
    libjpeg.so.62) package=libjpeg62-turbo ;;
    libgpiod.so.3) package=libgpiod3 ;;
    libdrm.so.2) package=libdrm2 ;;
    libv4lconvert.so.0) package=libv4lconvert0t64 ;;
    libinih.so.1) package=libinih1 ;;
    *)
        echo "limber: package.sh does not know the package of $library" >&2
        exit 1
        ;;
    esac
    case ", $depends," in
    *", $package,"*) ;;
    *) depends=${depends:+$depends, }$package ;;
    esac
done

rm -rf "$tree"
mkdir -p "$tree/usr/bin" "$tree/usr/share/limber" \
    "$tree/usr/share/doc/limber"
cp "$root/usr/bin/limber" "$tree/usr/bin"
cp "$root"/usr/share/limber/* "$tree/usr/share/limber"
[ ! -f "$root/etc/limber.conf" ] ||
    cp "$root/etc/limber.conf" "$tree/usr/share/doc/limber/imx31-pdk.conf"
cp "$top/LICENSE" "$tree/usr/share/doc/limber/copyright"
"$top/toolchain/package/pack.sh" "$tree" "$out" "$version" armel "$depends" >/dev/null
