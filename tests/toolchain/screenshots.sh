#!/bin/sh
# screenshots.sh: the pictures are there, and the same each time where they can.
. "$(dirname "$0")/../support/tap.sh"
script=$(dirname "$0")/../../toolchain/screenshots.sh
limber=build/host/limber

for time in once again; do
    run "$script" "$limber" "$scratch/$time"
    expect_status 0
    expect_no_err
    expect_file "$scratch/$time/compare.svg"
    check "the graph of frame times is a picture, $time" sh -c \
        "head -c 8 '$scratch/$time/frame-times.png' | grep -q PNG"
done
check 'the comparison is the same again' \
    cmp "$scratch/once/compare.svg" "$scratch/again/compare.svg"

printf '#!/bin/sh\necho "no such demo" >&2\nexit 1\n' >"$scratch/limber"
chmod +x "$scratch/limber"
run "$script" "$scratch/limber" "$scratch/failed"
expect_status 1
expect_err 'no such demo'
tap_done
