#!/bin/sh
# Tests make install and the Debian package: the files that they install, and that
# limber works from there, without the sources.
. "$(dirname "$0")/../support/tap.sh"
root=$scratch/root

run make --no-print-directory install DESTDIR="$root" prefix=/usr
expect_status 0
for file in bin/limber share/limber/walker.glb share/limber/face.character \
    share/limber/characters/CesiumMan.character share/limber/presets.ini \
    share/man/man1/limber.1 share/bash-completion/completions/limber \
    share/applications/limber.desktop share/doc/limber/copyright \
    share/icons/hicolor/scalable/apps/limber.svg; do
    check "make install brings $file" test -s "$root/usr/$file"
done

installed=$root/usr/bin/limber
cd "$scratch" || exit 1
run "$installed" render --demo arm --size 48x64 --frames 1 -o arm.png
expect_status 0
expect_no_err
check 'the installed program finds its models' test -s arm.png

page=$root/usr/share/man/man1/limber.1
for command in $("$installed" --help | sed -n 's/^  limber \([a-z]*\) .*/\1/p'); do
    check "the manual page has limber $command" grep -q "^\.SS limber $command" "$page"
    for option in $("$installed" "$command" --help |
        sed -n 's/^  [- ][a-zA-Z, ] *--\([a-z-]*\).*/\1/p'); do
        grep -q "^\.B .*$(echo "$option" | sed 's/-/\\\\-/g')" "$page" ||
            fail "the manual page has --$option of limber $command"
    done
done

check 'the manual page says where limber.conf is' grep -q '^\.I /etc/limber.conf' "$page"

# completed WORD...: prints bash's completions of the last word.
completed() {
    PATH=$root/usr/bin:$PATH bash -c '
        source "$0"
        COMP_WORDS=("$@")
        COMP_CWORD=$(($# - 1))
        _limber "$1" "${COMP_WORDS[$COMP_CWORD]}" "${COMP_WORDS[$COMP_CWORD - 1]}"
        printf "%s\n" "${COMPREPLY[@]}"
    ' "$root/usr/share/bash-completion/completions/limber" "$@"
}
: >robot.glb
: >notes.txt
check 'bash completes commands' test "$(completed limber co)" = compare
check 'bash completes options' test "$(completed limber pose --interp)" = --interpolation
check 'bash completes demos' test "$(completed limber play --demo wal)" = walker
check 'bash completes formats' test "$(completed limber compare --format j)" = json
check 'bash completes kernels' test "$(completed limber bench --kernel fl)" = float
check 'bash completes help' test "$(completed limber pose --he)" = --help
check 'bash offers any file to write' test "$(completed limber render -o not)" = notes.txt
check 'bash offers nothing for a number' test -z "$(completed limber play --frames '')"
check 'bash offers models' test "$(completed limber play rob)" = robot.glb
check 'bash offers no other files' test -z "$(completed limber play not)"

cd - >/dev/null || exit 1
for variable in $(grep -rhoE '"LIMBER_[A-Z]+"' app platform | tr -d '"' | sort -u); do
    check "the manual page has $variable" grep -q "$variable" "$page"
done
run make --no-print-directory uninstall DESTDIR="$root" prefix=/usr
expect_status 0
check 'make uninstall leaves no file' test -z "$(find "$root" -type f)"

run make --no-print-directory deb
expect_status 0
deb=$(echo build/package/limber_*_"$(dpkg --print-architecture)".deb)
check 'the package names what it needs' sh -c \
    "dpkg-deb -f '$deb' Depends | grep -q 'libc6 .*libjansson4'"
check 'the package can do without SDL, which windows need' sh -c \
    "dpkg-deb -f '$deb' Recommends | grep -qx libsdl2-2.0-0 &&
    ! dpkg-deb -f '$deb' Depends | grep -q sdl"
mkdir -p "$scratch/system" "$scratch/admin/info" "$scratch/admin/updates" \
    "$scratch/admin/triggers"
: >"$scratch/admin/status"
: >"$scratch/admin/available"
# The package database of the test has none of the libraries' packages.
run dpkg --force-not-root --force-depends --force-script-chrootless \
    --log=/dev/null --admindir="$scratch/admin" --instdir="$scratch/system" -i "$deb"
expect_status 0
run "$scratch/system/usr/bin/limber" --version
expect_status 0
expect_out '^limber '
tap_done
