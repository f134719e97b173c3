#!/bin/sh
# The C of app, platform and tests is laid out as .clang-format says. TREE is the
# folder to look at. Other releases of clang-format differ in small things, so it
# is Debian 12's.
. "$(dirname "$0")/../support/tap.sh"
here=$(cd "$(dirname "$0")/../.." && pwd)
format=clang-format-14

if ! command -v "$format" >/dev/null; then
    skip_all "$format is not installed: run toolchain/install.sh check"
fi
cd "${TREE:-$here}"

# Left out are tables whose columns are aligned, and headers for assembly, which
# clang-format takes for Objective-C.
find app platform tests -name '*.[ch]' ! -path 'tests/arm1136/micro/cases.h' \
    ! -path 'platform/gl/soft/arm/*.h' \
    ! -path 'platform/gl/soft/span/instances.h' | sort >"$scratch/files"
check 'there are files to look at' test -s "$scratch/files"
xargs "$format" --style="file:$here/.clang-format" --dry-run \
    <"$scratch/files" 2>"$scratch/log" || true
sed -n 's/^\([^:]*\):.*code should be clang-formatted.*/\1/p' "$scratch/log" |
    sort -u >"$scratch/offences"
grep ': error:\|not support\|No such' "$scratch/log" >"$scratch/errors" || true
if [ -s "$scratch/errors" ]; then
    fail "$format reads every file" "$(head -5 "$scratch/errors")"
else
    pass "$format reads every file"
fi
if [ -s "$scratch/offences" ]; then
    fail 'files have the layout of .clang-format' \
        "run $format -i $(tr '\n' ' ' <"$scratch/offences")"
else
    pass 'files have the layout of .clang-format'
fi
# clang-format joins the lines of a table in a comment that are too long for it,
# and leaves this.
if xargs grep -HnE '^ \*[A-Za-z]' <"$scratch/files" >"$scratch/joined"; then
    fail 'lines of comments have a space after their star' \
        "$(head -5 "$scratch/joined")"
else
    pass 'lines of comments have a space after their star'
fi
tap_done
