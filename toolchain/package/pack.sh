#!/bin/sh
# pack.sh STAGE OUT VERSION ARCHITECTURE DEPENDS [RECOMMENDS]: packs the tree
# STAGE as limber's Debian package in the folder OUT and prints the package's
# name. The same tree always gives the same bytes.
set -eu
stage=$1
package=$2/limber_$3_$4.deb

mkdir -p "$stage/DEBIAN"
# A field without a value is left out.
sed '/: $/d' >"$stage/DEBIAN/control" <<END
Package: limber
Version: $3
Architecture: $4
Maintainer: The limber project <limber@localhost>
Depends: $5
Recommends: ${6-}
Suggests: libosmesa6, libegl1, libgles1
Section: graphics
Priority: optional
Description: 3D character animation for ARM11 boards and desktops
 limber plays glTF and DirectX .x models with skeletal, hierarchical and morph
 animation, on boards without a GPU driver and on desktops.
END
# Whatever the umask of who builds.
chmod -R u=rwX,go=rX "$stage"
find "$stage" -exec touch -h -d @0 {} +
SOURCE_DATE_EPOCH=0 dpkg-deb --root-owner-group -Zgzip --build "$stage" \
    "$package" >/dev/null
echo "$package"
