#!/bin/sh
# The links of README pages lead to files and folders that exist.
. "$(dirname "$0")/../support/tap.sh"

# links FILE: prints its links into this tree, a line each.
links() {
    grep -oE '\]\([^)]+\)|src="[^"]+"' "$1" |
        sed 's/^](//; s/)$//; s/^src="//; s/"$//; s/#.*//' |
        grep -vE '^$|^[a-z]+:' || true
}

# broken FILE: prints those of its links that lead nowhere.
broken() {
    links "$1" | while read -r link; do
        [ -e "$(dirname "$1")/$link" ] || echo "$link"
    done
}

cd "$(dirname "$0")/../.." || exit 1
for page in $(find . -path ./build -prune -o -name README.md -print | sort); do
    check "$page leads where it says" test -z "$(broken "$page")"
done

mkdir -p "$scratch/page"
echo '[a](there.md#part) ![b](gone.png) [c](https://example.com)
<img src="there.md"> <img src="lost.png">' \
    >"$scratch/page/README.md"
: >"$scratch/page/there.md"
check 'a link that leads nowhere is noticed' \
    test "$(broken "$scratch/page/README.md" | tr '\n' ' ')" = 'gone.png lost.png '
tap_done
