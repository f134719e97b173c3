#!/bin/sh
# demo.sh LIMBER FOLDER: shows the demos one after another in a window where
# there is a desktop; otherwise writes an animation and a picture of each into
# FOLDER and names them.
set -eu
limber=$1
folder=$2
demos='walker face arm crowd duel tuner'

show_windows() {
    number=0
    for demo in $demos; do
        number=$((number + 1))
        printf '\nDemo %d of 6. Esc, or closing the window, goes on; Ctrl-C here ends.\n' \
            "$number"
        "$limber" play --demo "$demo" || return 1
    done
}

write_pictures() {
    mkdir -p "$folder"
    for demo in $demos; do
        echo "Drawing $demo"
        "$limber" render --demo "$demo" --time 1 -o "$folder/$demo.png"
        "$limber" render --demo "$demo" --size 360x480 -o "$folder/$demo.gif"
    done
    printf '\nThe demos, as pictures and animations:\n'
    for demo in $demos; do
        printf '  %s\n  %s\n' "$folder/$demo.png" "$folder/$demo.gif"
    done
}

# Ctrl-C ends the demos, not only the one that runs.
trap 'exit 130' INT

if [ -n "${WAYLAND_DISPLAY-}${DISPLAY-}" ]; then
    show_windows && exit 0
    echo "No window to be had here: writing pictures instead."
fi
write_pictures
