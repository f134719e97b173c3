#!/bin/sh
# coverage.sh DIR: turns what the programs in DIR have counted into the pages
# DIR/html, and prints the covered lines of each folder of app and platform.
set -eu
directory=$1

# quietly COMMAND...: shows what a command has to say only if it fails.
quietly() {
    "$@" >"$directory/log" 2>&1 || {
        cat "$directory/log" >&2
        exit 1
    }
}

quietly lcov --quiet --capture --directory "$directory/obj" \
    --base-directory . --no-external --ignore-errors source \
    --output-file "$directory/all.info"
quietly lcov --quiet --extract "$directory/all.info" "$PWD/app/*" \
    "$PWD/platform/*" --output-file "$directory/lines.info"
quietly genhtml --quiet --ignore-errors source --prefix "$PWD" --title limber \
    --output-directory "$directory/html" "$directory/lines.info"
awk -F: -v top="$PWD/" '
    /^SF:/ {
        name = substr($2, length(top) + 1)
        count = split(name, part, "/")
        folder = part[1] "/" (count > 2 ? part[2] : "")
    }
    /^LF:/ { lines[folder] += $2; all += $2 }
    /^LH:/ { hit[folder] += $2; hits += $2 }
    END {
        for (name in lines) {
            printf "%5.1f%%  %6d of %6d  %s\n", 100 * hit[name] / lines[name],
                hit[name], lines[name], name | "sort -k 5"
        }
        close("sort -k 5")
        printf "%5.1f%%  %6d of %6d  app and platform\n", 100 * hits / all,
            hits, all
    }' "$directory/lines.info" | tee "$directory/table"
echo "The lines that no test reaches: $directory/html/index.html"
