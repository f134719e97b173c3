#!/bin/sh
# install.sh SET...: installs the Debian packages of toolchain/packages/SET.txt.
#
# It does nothing when all of them are installed. It runs apt-get as root or
# through sudo, and otherwise prints the command to run. A line of a list is
# "PACKAGE" or "PACKAGE ?THING"; the second package is needed only when THING, a
# command or the absolute path of a file, is missing.
set -eu

lists=$(dirname "$0")/packages

is_installed() {
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

has() {
    case $1 in
    '') return 1 ;;
    /*) [ -e "$1" ] ;;
    *) command -v "$1" >/dev/null ;;
    esac
}

# Prints the missing packages of the sets, each once and after a space.
missing_of() {
    for set in "$@"; do
        while read -r package rest; do
            case $package in
            '' | '#'*) continue ;;
            esac
            has "${rest#\?}" || is_installed "$package" || echo "$package"
        done <"$lists/$set.txt"
    done | awk '!seen[$0]++ { printf " %s", $0 }'
}

if [ $# -eq 0 ]; then
    echo "usage: $0 SET... (one of $(cd "$lists" && echo ./*.txt |
        sed 's|\./||g; s|\.txt||g'))" >&2
    exit 2
fi
for set in "$@"; do
    if [ ! -f "$lists/$set.txt" ]; then
        echo "limber: no package list $lists/$set.txt" >&2
        exit 2
    fi
done

missing=$(missing_of "$@")
[ -n "$missing" ] || exit 0

if ! command -v apt-get >/dev/null; then
    echo "limber: this machine has no apt-get; install what Debian calls$missing" >&2
    exit 0
fi

if [ "$(id -u)" -eq 0 ]; then
    as_root=
elif command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
    as_root='sudo -n'
elif command -v sudo >/dev/null && [ -t 0 ]; then
    as_root=sudo
else
    echo "limber: packages are missing; run as root: apt-get update && apt-get install --no-install-recommends$missing" >&2
    exit 1
fi

# Two parts of a parallel build may run this at once: the second waits for the
# first and installs what is still missing.
exec 9<"$lists"
flock 9
missing=$(missing_of "$@")
[ -n "$missing" ] || exit 0

echo "  APT    $missing"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
run_apt() {
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get \
        -o DPkg::Lock::Timeout=600 "$@" >"$log" 2>&1 9<&-
}
# shellcheck disable=SC2086 # the list is words on purpose
if run_apt update && run_apt install -y --no-install-recommends $missing; then
    exit 0
fi
cat "$log" >&2
echo "limber: apt-get could not install$missing (its messages are above)" >&2
exit 1
