# shellcheck shell=sh
# Helpers for tests of the command line, on top of tap.sh. $limber is the command
# under test; $slider is a small model with the clips slide and rise.
. "$(dirname "$0")/../support/tap.sh"
limber=${LIMBER:-build/host/limber}

# A limber.conf of this machine must not change the results.
export LIMBER_CONFIG=none
slider=$(dirname "$0")/slider.gltf

# limber ARGUMENTS...: runs the command under test.
limber() {
    # shellcheck disable=SC2086 # a command and its arguments
    run $limber "$@"
    about "limber $(echo "$*" | sed "s|$scratch/||g")"
}

# expect_refusal STATUS PATTERN: the command ended with that exit status and
# printed nothing but one matching sentence "limber: WHAT: WHY" on standard
# error.
expect_refusal() {
    if [ "$status" -eq "$1" ] && [ ! -s "$out_file" ] &&
        [ "$(wc -l <"$err_file")" -eq 1 ] &&
        grep -Eq '^limber: [^:]+.*: .+[^.]$' "$err_file" &&
        grep -Eq -e "$2" "$err_file"; then
        pass "$tap_about: refused with status $1 and a sentence with $2"
    else
        fail "$tap_about: refused with status $1 and a sentence with $2" \
            "$(tap_show)"
    fi
}

# expect_quiet: the command succeeded and printed nothing.
expect_quiet() {
    expect_status 0
    expect_no_out
    expect_no_err
}

# bytes FILE OFFSET COUNT: prints bytes of a file as hexadecimal digits.
bytes() {
    od -An -tx1 -j "$2" -N "$3" "$1" 2>/dev/null | tr -d ' \n'
}

# expect_png FILE WIDTH HEIGHT: the file is a PNG of that size.
expect_png() {
    size=$(printf '%08x%08x' "$2" "$3")
    if [ "$(bytes "$1" 0 8)" = 89504e470d0a1a0a ] &&
        [ "$(bytes "$1" 16 8)" = "$size" ]; then
        pass "$tap_about: a PNG of $2 x $3"
    else
        fail "$tap_about: a PNG of $2 x $3" "$(tap_show)"
    fi
}
