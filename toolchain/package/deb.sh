#!/bin/sh
# deb.sh STAGE OUT: packs the installed tree STAGE as a Debian package for this
# machine, in the folder OUT.
set -eu
stage=$1
out=$2
version=$("$stage/usr/bin/limber" --version | sed -n '1s/^limber \([^ ]*\).*/\1/p')
architecture=$(dpkg --print-architecture)

strip --strip-unneeded "$stage/usr/bin/limber"

# dpkg-shlibdeps has to run in the tree of a source package.
work=$stage.control
rm -rf "$work"
mkdir -p "$work/debian"
trap 'rm -rf "$work"' EXIT
printf 'Source: limber\n\nPackage: limber\nArchitecture: any\n' \
    >"$work/debian/control"
program=$(cd "$stage" && pwd)/usr/bin/limber
depends=$(cd "$work" && dpkg-shlibdeps -O "$program" 2>/dev/null |
    sed -n 's/^shlibs:Depends=//p')
[ -n "$depends" ] || {
    echo "limber: dpkg-shlibdeps finds no libraries of $program: reinstall dpkg-dev" >&2
    exit 1
}

# dpkg-shlibdeps does not see SDL, which limber opens with its first window.
made=$("$(dirname "$0")/pack.sh" "$stage" "$out" "$version" "$architecture" \
    "$depends" libsdl2-2.0-0)
echo "  DEB     $made"
