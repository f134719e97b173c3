#!/bin/sh
# screenshots.sh LIMBER FOLDER PAGE: draws the pictures of README pages that are
# not references of the tests, into FOLDER: the graph of frame times and a
# comparison; and writes the comparison's table into PAGE. The times are this
# machine's and differ from run to run; all else is the same in every run.
set -eu
limber=$(realpath "$1")
assets=$(realpath "$(dirname "$0")/../assets")
mkdir -p "$2"
folder=$(realpath "$2")
page_file=$(realpath "$3")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# F8 while F9 is held saves a picture as limber-0001.png in the current folder.
cd "$scratch"
cat >buttons <<END
0 UP down
100 UP up
2000 F9 down
2400 F8 down
2500 F8 up
END
"$limber" play --demo walker --hud --gl soft --display null --format rgb565 \
    --clock fixed:25 --script buttons --frames 70 >log 2>&1 || {
    cat log >&2
    exit 1
}
mv limber-0001.png "$folder/frame-times.png"

"$limber" compare "$assets/walker.glb" --plot "$folder/compare.svg" >table

# Replace the rows of the page, from "a frame takes" on.
sed -n '/^  a frame takes/,/^$/p' table | sed '/^$/d; s/^/    /' >rows
grep -q '^      a frame takes' "$page_file" || {
    echo "limber: $3 has no table of limber compare" >&2
    exit 1
}
awk -v rows=rows '
    /^      a frame takes/ {
        while ((getline row <rows) > 0) {
            print row
        }
        old = 1
    }
    /^      \.\.\.$/ { old = 0 }
    !old { print }' "$page_file" >new
cat new >"$page_file"
