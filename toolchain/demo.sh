#!/bin/sh
# demo.sh LIMBER FOLDER: shows the demos one after another in a window. Without a
# desktop, it writes an animation and a picture of each into FOLDER instead and
# lists them.
set -eu
limber=$1
folder=$2
demos='walker face arm crowd duel tuner'

show_windows() {
    number=0
    for demo in $demos; do
        number=$((number + 1))
        printf '\nDemo %d of 6: %s. Press Esc or close the window for the next one; press Ctrl-C here to stop.\n' \
            "$number" "$demo"
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
    printf '\nThese are pictures and animations of the demos:\n'
    for demo in $demos; do
        printf '  %s\n  %s\n' "$folder/$demo.png" "$folder/$demo.gif"
    done
}

# Ctrl-C ends all demos, not only the current one.
trap 'exit 130' INT

if [ -n "${WAYLAND_DISPLAY-}${DISPLAY-}" ]; then
    show_windows && exit 0
    echo "limber could not open a window; it draws pictures instead."
fi
write_pictures
