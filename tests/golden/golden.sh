#!/bin/sh
# golden.sh check GL FOLDER LIMBER...: draws each picture of pictures.txt with the
# GL driver and holds it against its reference; the pictures, and differences
# of those that are too far, go into FOLDER. Speaks TAP.
#
# golden.sh exact FOLDER LIMBER...: draws them with the soft driver, whose
# pictures are the same to the bit on every machine: its references are those
# in soft/.
#
# golden.sh make LIMBER...: draws the references again, with the osmesa driver,
# and soft's own. LIMBER may be several words.
#
# GOLDEN is the folder of pictures.txt and the references, COMPARE the program
# that compares.
set -eu
here=$(dirname "$0")
golden=${GOLDEN:-$here}
compare=${COMPARE:-build/host/compare_png}

# How far a driver's picture may be from the reference (compare_png.c): step,
# percent of pixels further off, mean, mean of the worst 16 x 16 block. The
# rasterisers differ a little between processors, of which ARM takes another
# one of Mesa's, and more between drivers, along edges.
tolerance_of() {
    case $1 in
    osmesa) echo 8 1.0 0.5 12 ;;
    # Mesa's rasteriser on ARM goes over from one level of detail to the next
    # at other pixels of the floor: up to 1.3% of arm-1.
    softpipe) echo 8 1.5 0.5 12 ;;
    gles1) echo 8 1.5 0.5 20 ;;
    # Two steps of RGB565, which it draws in.
    soft) echo 16 0.5 2.0 20 ;;
    exact) echo 0 0 0 0 ;;
    esac
}

pictures() {
    sed '/^#/d; /^$/d' "$golden/pictures.txt"
}

# draw GL FILE ARGUMENTS...
draw() (
    gl=$1
    file=$2
    shift 2
    rm -f "$file"
    case $gl in
    softpipe) set -- "$@" --gl osmesa ;;
    exact) set -- "$@" --gl soft --format rgb565 ;;
    soft)
        # In RGB565 a camera's picture is not filtered, for speed; the
        # reference's is.
        case $* in
        *--camera*) set -- "$@" --gl soft --format rgba8888 ;;
        *) set -- "$@" --gl soft --format rgb565 ;;
        esac
        ;;
    *) set -- "$@" --gl "$gl" ;;
    esac
    # shellcheck disable=SC2086 # a command and its arguments
    $limber render "$@" -o "$file" </dev/null && [ -s "$file" ]
)

make_references() {
    mkdir -p "$golden/soft"
    pictures | {
        failed=0
        while read -r name arguments; do
            echo "  PICTURE $golden/$name.png"
            # shellcheck disable=SC2086 # arguments are words
            draw osmesa "$golden/$name.png" $arguments || failed=1
            # shellcheck disable=SC2086 # arguments are words
            draw exact "$golden/soft/$name.png" $arguments || failed=1
        done
        exit "$failed"
    }
}

# Prints what is wrong and fails, or prints the figures.
check_picture() {
    reference=$references/$name.png
    if [ ! -f "$reference" ]; then
        echo "no reference $reference: look at $folder/$name.png, then make golden"
        return 1
    fi
    # shellcheck disable=SC2046 # four words
    "$compare" $(tolerance_of "$gl") "$reference" "$folder/$name.png" \
        "$folder/$name-difference.png"
}

# Every reference must be of a picture that is still drawn.
check_leftovers() {
    for file in "$references"/*.png; do
        name=$(basename "$file" .png)
        if [ -f "$file" ] && ! pictures | grep -q "^$name "; then
            echo "$file is a reference for nothing in pictures.txt"
            return 1
        fi
    done
}

count=0
failed=0
# verdict STATUS NAME TEXT
verdict() {
    count=$((count + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $count - $2"
    else
        failed=1
        echo "not ok $count - $2"
    fi
    [ -z "$3" ] || printf '%s\n' "$3" | sed 's/^/# /'
}

check_references() {
    gl=$1
    folder=$2
    references=$golden
    [ "$gl" != exact ] || references=$golden/soft
    if [ -z "$(tolerance_of "$gl")" ]; then
        echo "golden.sh: no tolerance for $gl" >&2
        exit 2
    fi
    mkdir -p "$folder"
    rm -f "$folder"/*.png
    while read -r name arguments; do
        status=0
        # shellcheck disable=SC2086 # arguments are words
        text=$(draw "$gl" "$folder/$name.png" $arguments 2>&1 &&
            check_picture) || status=$?
        verdict "$status" "$name" "$text"
    done <<END
$(pictures)
END
    status=0
    text=$(check_leftovers) || status=$?
    verdict "$status" 'no reference is left over' "$text"
    echo "1..$count"
    exit "$failed"
}

usage() {
    echo "usage: $0 check GL FOLDER LIMBER... | exact FOLDER LIMBER... | make LIMBER..." >&2
    exit 2
}

case ${1-} in
check)
    [ $# -ge 4 ] || usage
    gl=$2
    folder=$3
    shift 3
    limber=$*
    check_references "$gl" "$folder"
    ;;
exact)
    [ $# -ge 3 ] || usage
    folder=$2
    shift 2
    limber=$*
    check_references exact "$folder"
    ;;
make)
    [ $# -ge 2 ] || usage
    shift
    limber=$*
    make_references
    ;;
*) usage ;;
esac
