#!/bin/sh
# sysroot.sh DIR: makes the armel sysroot, Debian 13 with the packages of
# packages/sysroot.txt, unpacked and not configured. Takes about 20 seconds.
#
# Debian 13 is the last release with an armel port. It cannot be added to the
# build machine as a foreign architecture, because the versions of the shared
# packages differ; a tree of its own has no such trouble. The mirror is the one
# this machine already uses, or MIRROR where that is set.
set -eu

directory=${1:?usage: sysroot.sh DIR}
here=$(dirname "$0")
keyring=${KEYRING:-/usr/share/keyrings/debian-archive-trixie-stable.gpg}

# Where apt gets Debian from; the second form answers before an apt-get update.
sources() {
    apt-get indextargets --format '$(SITE)' 'Created-By: Packages' \
        'Origin: Debian' 'Component: main'
    apt-get indextargets --no-release-info --format '$(SITE) $(RELEASE)' \
        'Created-By: Packages' 'Component: main' |
        sed -nE 's/ (bookworm|trixie|(old)?stable|testing|sid)$//p'
}
mirror=${MIRROR:-$(sources | grep -E '^(https?|mirror)' |
    grep -v security | head -n 1)}
if [ -z "$mirror" ]; then
    echo "limber: no Debian mirror in this machine's apt sources: set MIRROR=URL" >&2
    exit 1
fi
if [ ! -f "$keyring" ]; then
    echo "limber: $keyring is missing: apt-get install debian-archive-keyring" >&2
    exit 1
fi

# Unpacking needs no root, and no user namespaces either.
mode=chrootless
[ "$(id -u)" -ne 0 ] || mode=root

packages=$(sed '/^#/d; /^$/d' "$here/packages/sysroot.txt" | paste -sd, -)
scratch=$directory.new
rm -rf "$scratch" "$directory"
trap 'rm -rf "$scratch"' EXIT

if ! mmdebstrap --quiet --mode="$mode" --architectures=armel --variant=extract \
    --include="$packages" trixie "$scratch" \
    "deb [signed-by=$keyring] $mirror trixie main" 2>"$directory.log"; then
    cat "$directory.log" >&2
    echo "limber: mmdebstrap could not make $directory from $mirror (MIRROR=URL names another mirror)" >&2
    exit 1
fi
# No package makes this link; the dynamic loader's path goes through it.
[ -e "$scratch/lib" ] || ln -s usr/lib "$scratch/lib"
rm -rf "$scratch/dev"
mv "$scratch" "$directory"
