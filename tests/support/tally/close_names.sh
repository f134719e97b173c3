#!/bin/sh
# close_names.sh "WANTED..." NAME...: says that no test is called WANTED and
# which of the names are close to it, a sentence for each, and fails.
set -eu
wanted=$1
shift
for name; do
    name=${name#test_}
    echo "${name#cli/}"
done | sort -u | awk -v wanted="$wanted" '
# The edits (insert, remove, replace a letter) that make b of a.
function distance(a, b,    i, j, above, left, corner, row) {
    for (j = 0; j <= length(b); j++) {
        row[j] = j
    }
    for (i = 1; i <= length(a); i++) {
        corner = row[0]
        row[0] = i
        for (j = 1; j <= length(b); j++) {
            above = row[j]
            left = row[j - 1]
            row[j] = corner + (substr(a, i, 1) != substr(b, j, 1))
            row[j] = above + 1 < row[j] ? above + 1 : row[j]
            row[j] = left + 1 < row[j] ? left + 1 : row[j]
            corner = above
        }
    }
    return row[length(b)]
}

# The names close to word, the closest first, at most six of them.
function close_to(word,    i, d, far, text, count) {
    far = int(length(word) / 3) + 1
    for (d = 0; d <= far; d++) {
        for (i = 1; i <= names && count < 6; i++) {
            if (d == (index(name[i], word) ? 0 : distance(word, name[i]))) {
                text = text (count++ ? ", " : "") name[i]
            }
        }
    }
    sub(/, [^,]*$/, " or" substr(text, match(text, / [^ ]*$/)), text)
    return text
}

{ name[++names] = $0 }

END {
    words = split(wanted, word)
    for (w = 1; w <= words; w++) {
        sub(/^(test_|cli\/)/, "", word[w])
        close_ones = close_to(tolower(word[w]))
        print "limber: no test is called \"" word[w] "\"; " \
            (close_ones ? "did you mean " close_ones "?" : \
            "the tests are tests/unit/**/test_NAME.c and tests/cli/NAME.sh")
    }
}' >&2
exit 2
