#!/bin/sh
# clang-tidy and cppcheck find nothing in app and platform. .clang-tidy and
# cppcheck.txt say what is left out, and why. TREE is the folder to look at, with
# the generated headers of build/host/gen in this one.
#
# The analyzer that follows every path takes a quarter of an hour:
#	CHECKS='-*,clang-analyzer-core.*,clang-analyzer-unix.*' tests/structure/analysis.sh
. "$(dirname "$0")/../support/tap.sh"
here=$(cd "$(dirname "$0")/../.." && pwd)
tidy=clang-tidy-14

for tool in "$tidy" cppcheck; do
    command -v "$tool" >/dev/null ||
        skip_all "$tool is not installed: run toolchain/install.sh check"
done
cd "${TREE:-$here}"

# The board's libraries have the headers of the second generation of libgpiod, and
# arm/ is for its compiler.
find app platform -name '*.c' ! -path '*/gpiod/v2/*' ! -path '*/arm/*' | sort >"$scratch/files"
check 'there are files to look at' test -s "$scratch/files"

# nothing_found WHAT: a tool has said nothing that begins with a file's name.
nothing_found() {
    if grep -E '^[^ ].*: (error|warning|performance|portability): ' \
        "$scratch/log" | sort -u >"$scratch/found" &&
        [ -s "$scratch/found" ]; then
        fail "$1" "$(sed "s|^$PWD/||" "$scratch/found" | head -8)"
    else
        pass "$1"
    fi
}

# shellcheck disable=SC2046 # flags are words
xargs "$tidy" --quiet --config-file="$here/.clang-tidy" ${CHECKS:+"--checks=$CHECKS"} \
    --extra-arg-before=-std=c11 --extra-arg=-D_POSIX_C_SOURCE=200809L \
    --extra-arg=-DCGLM_ALL_UNALIGNED --extra-arg=-I. \
    --extra-arg="-I$here/build/host/gen" \
    $(sed 's/^/--extra-arg=/; s/ \(.\)/ --extra-arg=\1/g' "$here/build/host/cflags") \
    <"$scratch/files" >"$scratch/log" 2>&1 || true
nothing_found "$tidy finds nothing"

# cppcheck looks at a file once for each macro that it asks for. Most files ask for
# those of ARM, through one header, and are the same with and without. So only files
# that name them are looked at with all of them, which is what the board has.
arm='__arm__ __ARM_ARCH=6 __ARM_FEATURE_DSP __ARM_FEATURE_SAT __ARM_FEATURE_SIMD32'

# run_cppcheck FLAG...: looks at the files of standard input.
run_cppcheck() {
    xargs -r cppcheck --std=c11 --language=c --enable=warning,performance,portability \
        --quiet --template='{file}:{line}: {severity}: {message} [{id}]' \
        --suppressions-list="$here/tests/structure/cppcheck.txt" "$@" \
        -I. "-I$here/build/host/gen" >>"$scratch/log" 2>&1 || true
}
: >"$scratch/log"
# shellcheck disable=SC2046,SC2086 # flags are words
run_cppcheck $(printf -- '-U%s ' $arm | sed 's/=[0-9]*//g') <"$scratch/files"
# shellcheck disable=SC2046,SC2086
find app platform -name '*.[ch]' ! -path '*/gpiod/v2/*' ! -path '*/arm/*' \
    -exec grep -lE '__(arm_|ARM_)' {} + | sort |
    run_cppcheck $(printf -- '-D%s ' $arm)
nothing_found 'cppcheck finds nothing'
tap_done
