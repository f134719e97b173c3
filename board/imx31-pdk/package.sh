#!/bin/sh
# package.sh ROOT SYSROOT DIR: limber as a Debian package for armel, in DIR.
# ROOT holds it as the board's root file system has it.
set -eu

root=$1
sysroot=$2
out=$3
stage=$out/deb.new
top=$(dirname "$0")/../..
trap 'rm -rf "$stage"' EXIT
version=$(qemu-arm -cpu arm1136 -L "$sysroot" "$root/usr/bin/limber" --version |
    sed -n '1s/^limber \([^ ]*\).*/\1/p')

# Which Debian 13 packages the libraries come in, for those that limber names.
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
        echo "limber: package.sh does not know what brings $library" >&2
        exit 1
        ;;
    esac
    case ", $depends," in
    *", $package,"*) ;;
    *) depends=${depends:+$depends, }$package ;;
    esac
done

rm -rf "$stage"
mkdir -p "$stage/usr/bin" "$stage/usr/share/limber" \
    "$stage/usr/share/doc/limber"
cp "$root/usr/bin/limber" "$stage/usr/bin"
cp "$root"/usr/share/limber/* "$stage/usr/share/limber"
[ ! -f "$root/etc/limber.conf" ] ||
    cp "$root/etc/limber.conf" "$stage/usr/share/doc/limber/imx31-pdk.conf"
cp "$top/LICENSE" "$stage/usr/share/doc/limber/copyright"
"$top/toolchain/package/pack.sh" "$stage" "$out" "$version" armel "$depends" >/dev/null
