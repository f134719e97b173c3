#!/bin/sh
# Tests screenshots.sh: it makes all pictures, and the same ones each time except
# for those with measured times.
. "$(dirname "$0")/../support/tap.sh"
script=$(dirname "$0")/../../toolchain/screenshots.sh
limber=build/host/limber
page=app/compare/example.md

# rows FILE: prints the rows of limber compare on a page.
rows() {
    sed -n '/^      a frame takes/,/^      \.\.\.$/p' "$1"
}

for time in once again; do
    cp "$page" "$scratch/$time.md"
    run "$script" "$limber" "$scratch/$time" "$scratch/$time.md"
    expect_status 0
    expect_no_err
    expect_file "$scratch/$time/compare.svg"
    check "the graph of frame times is a picture, $time" sh -c \
        "head -c 8 '$scratch/$time/frame-times.png' | grep -q PNG"
done
check 'the comparison is the same again' \
    cmp "$scratch/once/compare.svg" "$scratch/again/compare.svg"

rows "$page" >"$scratch/wanted"
rows "$scratch/once.md" >"$scratch/got"
check 'there are rows to look at' test "$(wc -l <"$scratch/got")" -ge 6
if cmp -s "$scratch/wanted" "$scratch/got"; then
    pass 'the table on the page is what limber compare says'
else
    fail 'the table on the page is what limber compare says' \
        "make screenshots renews it: $(diff "$scratch/wanted" "$scratch/got")"
fi
check 'nothing else of the page is touched' test \
    "$(diff "$page" "$scratch/once.md" | grep -c '^[<>] [A-Za-z#]')" -eq 0

printf '#!/bin/sh\necho "no such demo" >&2\nexit 1\n' >"$scratch/limber"
chmod +x "$scratch/limber"
run "$script" "$scratch/limber" "$scratch/failed" "$scratch/once.md"
expect_status 1
expect_err 'no such demo'

echo 'a page' >"$scratch/page.md"
run "$script" "$limber" "$scratch/other" "$scratch/page.md"
expect_status 1
expect_err 'page.md has no table'
tap_done
