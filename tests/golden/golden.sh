#!/bin/sh
# golden.sh check GL FOLDER LIMBER...: draws each picture of pictures.txt with
# the driver GL and compares it with its reference in osmesa/. The pictures,
# and the differences of those outside the tolerance, go into FOLDER.
#
# golden.sh exact FOLDER LIMBER...: the same with the soft driver and the
# references in soft/, which must match bit for bit on every machine.
#
# golden.sh make LIMBER...: draws all references again, those in osmesa/ with
# the osmesa driver, those in soft/ with the soft driver.
#
# LIMBER may be several words. check and exact print TAP. The environment may
# set GOLDEN, the folder of pictures.txt and the references, COMPARE, the program
# that compares two pictures, and PICTURES, an extended regular expression of the
# names of the only pictures to check.
set -eu
here=$(dirname "$0")
golden=${GOLDEN:-$here}
compare=${COMPARE:-build/host/compare_png}

# The tolerance of each driver, as compare_png.c takes it: a step in 8-bit
# units, the percentage of pixels that may differ by more than the step, the
# mean difference, the mean difference of the worst 16 x 16 block, the stray
# pixels of a 16 x 16 block. Rasterisers differ along edges: a little between
# processors, more between drivers. A seam one pixel wide makes 16 strays.
tolerance_of() {
    case $1 in
    osmesa) echo 8 1.0 0.5 12 8 ;;
    # On ARM, Mesa uses softpipe. It changes mipmap levels on the floor at
    # other pixels: up to 1.3% of arm-1.
    softpipe) echo 8 1.5 0.5 12 40 ;;
    gles1) echo 8 1.5 0.5 20 8 ;;
    # The driver draws in RGB565; 16 is two steps of 5 bits. Seams are left to
    # the exact references.
    soft) echo 16 0.5 2.0 20 20 ;;
    exact) echo 0 0 0 0 0 ;;
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
        # In RGB565 the soft driver does not filter the camera's picture, for
        # speed. The reference is filtered, so compare in RGBA8888.
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
    mkdir -p "$golden/osmesa" "$golden/soft"
    pictures | {
        failed=0
        while read -r name arguments; do
            echo "  PICTURE $golden/osmesa/$name.png"
            # shellcheck disable=SC2086 # arguments are words
            draw osmesa "$golden/osmesa/$name.png" $arguments || failed=1
            # shellcheck disable=SC2086 # arguments are words
            draw exact "$golden/soft/$name.png" $arguments || failed=1
        done
        exit "$failed"
    }
}

# Prints the measured differences; fails when they exceed the tolerance.
check_picture() {
    reference=$references/$name.png
    if [ ! -f "$reference" ]; then
        echo "$reference does not exist: check $folder/$name.png by eye, then run make golden"
        return 1
    fi
    # shellcheck disable=SC2046 # five words
    "$compare" $(tolerance_of "$gl") "$reference" "$folder/$name.png" \
        "$folder/$name-difference.png"
}

# Fails when a reference has no line in pictures.txt any more.
check_leftovers() {
    for file in "$references"/*.png; do
        name=$(basename "$file" .png)
        if [ -f "$file" ] && ! pictures | grep -q "^$name "; then
            echo "$file: pictures.txt does not list this reference"
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
    references=$golden/osmesa
    [ "$gl" != exact ] || references=$golden/soft
    if [ -z "$(tolerance_of "$gl")" ]; then
        echo "golden.sh: there is no tolerance for the driver $gl" >&2
        exit 2
    fi
    chosen=$(pictures | grep -E "^(${PICTURES:-[^ ]*}) ") || {
        echo "golden.sh: no picture is called $PICTURES" >&2
        exit 2
    }
    mkdir -p "$folder"
    rm -f "$folder"/*.png
    while read -r name arguments; do
        status=0
        # shellcheck disable=SC2086 # arguments are words
        text=$(draw "$gl" "$folder/$name.png" $arguments 2>&1 &&
            check_picture) || status=$?
        verdict "$status" "$name" "$text"
    done <<END
$chosen
END
    status=0
    text=$(check_leftovers) || status=$?
    verdict "$status" 'every reference is listed' "$text"
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
