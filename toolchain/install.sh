#!/bin/sh
# install.sh SET...: installs the Debian packages of toolchain/packages/SET.txt.
#
# Does nothing when all are there. Runs apt-get as root or through sudo, and
# otherwise prints the line to run. A list's line is "PACKAGE" or
# "PACKAGE ?COMMAND"; the second is needed only where COMMAND is missing.
set -eu

lists=$(dirname "$0")/packages

is_installed() {
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

missing_of() {
    while read -r package rest; do
        case $package in
        '' | '#'*) continue ;;
        esac
        command=${rest#\?}
        if [ -n "$command" ] && command -v "$command" >/dev/null; then
            continue
        fi
        is_installed "$package" || printf ' %s' "$package"
    done <"$1"
}

if [ $# -eq 0 ]; then
    echo "usage: $0 SET... (one of $(cd "$lists" && echo ./*.txt | sed 's|\./||g; s|\.txt||g'))" >&2
    exit 2
fi

missing=
for set in "$@"; do
    if [ ! -f "$lists/$set.txt" ]; then
        echo "limber: no package list $lists/$set.txt" >&2
        exit 2
    fi
    missing=$missing$(missing_of "$lists/$set.txt")
done
[ -n "$missing" ] || exit 0

if ! command -v apt-get >/dev/null; then
    echo "limber: install what Debian calls:$missing" >&2
    exit 1
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

echo "  APT    $missing"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
run_apt() {
    DEBIAN_FRONTEND=noninteractive $as_root apt-get "$@" >"$log" 2>&1
}
# shellcheck disable=SC2086 # the list is words on purpose
if run_apt update && run_apt install -y --no-install-recommends $missing; then
    exit 0
fi
cat "$log" >&2
echo "limber: apt-get could not install:$missing (its messages are above)" >&2
exit 1
