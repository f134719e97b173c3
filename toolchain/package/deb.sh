#!/bin/sh
# deb.sh STAGE OUT: the installed tree STAGE as a Debian package for this
# machine in the folder OUT.
set -eu
stage=$1
out=$2
version=$("$stage/usr/bin/limber" --version | sed -n '1s/^limber \([^ ]*\).*/\1/p')
architecture=$(dpkg --print-architecture)

# dpkg-shlibdeps wants to stand in a source package.
work=$stage.control
rm -rf "$work"
mkdir -p "$work/debian" "$stage/DEBIAN"
trap 'rm -rf "$work"' EXIT
printf 'Source: limber\n\nPackage: limber\nArchitecture: any\n' \
    >"$work/debian/control"
program=$(cd "$stage" && pwd)/usr/bin/limber
depends=$(cd "$work" && dpkg-shlibdeps -O "$program" 2>/dev/null |
    sed -n 's/^shlibs:Depends=//p')
[ -n "$depends" ] || {
    echo "limber: dpkg-shlibdeps does not know the libraries of $program" >&2
    exit 1
}

cat >"$stage/DEBIAN/control" <<END
Package: limber
Version: $version
Architecture: $architecture
Maintainer: The limber project <limber@localhost>
Depends: $depends
Suggests: libosmesa6, libegl1, libgles1
Section: graphics
Priority: optional
Description: 3D character animation for ARM11 boards and desktops
 Plays glTF and DirectX .x models with skeletal, hierarchical and morph
 animation, on boards without a GPU driver and on desktops.
END
find "$stage" -exec touch -h -d @0 {} +
SOURCE_DATE_EPOCH=0 dpkg-deb --root-owner-group -Zgzip --build "$stage" \
    "$out/limber_${version}_${architecture}.deb" >/dev/null
echo "  DEB     $out/limber_${version}_${architecture}.deb"
