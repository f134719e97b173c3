#!/bin/sh
# sysroot.sh DIR: makes the armel sysroot: unpacks the packages of
# packages/sysroot.txt, or of the file that the environment's PACKAGES names, from
# Debian 13 into DIR, without configuring them. It takes about 20 seconds.
#
# Debian 13 is the last release with an armel port. It cannot be added to the
# build machine as a foreign architecture, because shared packages would need the
# same version. The mirror is MIRROR or, where that is not set, the one that this
# machine's apt uses. apt checks the archive's signature.
#
# DIR/packages.sha256 lists what was unpacked. packages/sysroot.sha256 is the list
# that limber's own figures and packages were made with: a package of the same name
# and version with other bytes is refused, and other versions are named, since a
# mirror keeps only the newest. The environment's RECORD is that list; if it is empty,
# any version is accepted.
set -eu

directory=${1:?usage: sysroot.sh DIR}
here=$(dirname "$0")
record=${RECORD-$here/packages/sysroot.sha256}
keyring=${KEYRING:-/usr/share/keyrings/debian-archive-trixie-stable.gpg}

# Prints the mirrors that apt uses; the second form works before an apt-get
# update.
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

# Unpacking needs neither root nor user namespaces.
mode=chrootless
[ "$(id -u)" -ne 0 ] || mode=root

packages=$(sed '/^#/d; /^$/d' "${PACKAGES:-$here/packages/sysroot.txt}" |
    paste -sd, -)
scratch=$directory.new
rm -rf "$scratch" "$directory"
trap 'rm -rf "$scratch"' EXIT

# unpack NAME: unpacks the release that the mirror calls NAME, if it is Debian 13.
unpack() {
    rm -rf "$scratch"
    mmdebstrap --quiet --mode="$mode" --architectures=armel --variant=extract \
        --include="$packages" \
        --extract-hook='grep -qx "Codename: trixie" "$1"/var/lib/apt/lists/*Release' \
        --extract-hook='cd "$1"/var/cache/apt/archives && sha256sum *.deb >../../../../packages.sha256' \
        "$1" "$scratch" "deb [signed-by=$keyring] $mirror $1 main" \
        2>>"$directory.log"
}

# In the hours in which a mirror takes over a point release, what it lists under
# one of its two names for the release may not match what it has; the other works.
: >"$directory.log"
if ! unpack trixie && ! unpack stable; then
    cat "$directory.log" >&2
    echo "limber: mmdebstrap could not make $directory from $mirror (MIRROR=URL names another mirror)" >&2
    exit 1
fi
# No package makes this link, and the path of the dynamic loader needs it.
[ -e "$scratch/lib" ] || ln -s usr/lib "$scratch/lib"
rm -rf "$scratch/dev"

# compare STATE: prints the packages that the record knows by another hash
# (changed), or does not know (new).
compare() {
    awk -v state="$1" 'FILENAME == ARGV[1] { known[$2] = $1; next }
        { found = !($2 in known) ? "new" : known[$2] != $1 ? "changed" : "" }
        found == state { print $2 }' "$record" "$scratch/packages.sha256"
}
changed=$([ -z "$record" ] || compare changed)
if [ -n "$changed" ]; then
    echo "limber: $mirror has other bytes than $record lists for" $changed >&2
    exit 1
fi
new=$([ -z "$record" ] || compare new)
if [ -n "$new" ]; then
    echo "limber: $mirror has other versions than $record lists, so the board's files will differ from a release's: make sysroot-record accepts" $new >&2
fi
mv "$scratch" "$directory"
