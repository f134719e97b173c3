# shellcheck shell=sh
# Helpers for tests in shell that print TAP. A script sources this file, makes
# checks, and ends with tap_done, which prints the plan. A failed check does not
# end the script.
#
#   . "$(dirname "$0")/../support/tap.sh"
#   run build/host/limber --version
#   expect_status 0
#   expect_out '^limber '
#   tap_done
#
# run keeps the command's output in $out_file and $err_file and its exit status
# in $status. Each expect_ function is one test. Its name begins with the command
# that was run last, or with NAME after "about NAME".

tap_count=0
tap_failed=0
tap_folder=$(mktemp -d "${TMPDIR:-/tmp}/limber-test-XXXXXX")
trap 'rm -rf "$tap_folder"' EXIT
trap 'exit 1' HUP INT TERM
out_file=$tap_folder/out
err_file=$tap_folder/err
status=0
tap_about=

# A folder for the script's own files; it is removed when the script ends.
# shellcheck disable=SC2034 # for the scripts
scratch=$tap_folder/scratch
mkdir "$scratch"

# A number sign is escaped, because TAP would read a directive after it.
tap_line() {
    printf '%s %d - %s\n' "$1" "$tap_count" "$2" | sed 's/#/\\#/g'
}

pass() {
    tap_count=$((tap_count + 1))
    tap_line ok "$1"
}

# fail NAME [WHY]
fail() {
    tap_count=$((tap_count + 1))
    tap_failed=$((tap_failed + 1))
    tap_line 'not ok' "$1"
    [ -z "${2-}" ] || printf '%s\n' "$2" | sed 's/^/# /'
}

# skip NAME WHY
skip() {
    tap_count=$((tap_count + 1))
    echo "ok $tap_count - $1 # SKIP $2"
}

# skip_all WHY: skips the whole script; to be called before any check.
skip_all() {
    echo "1..0 # SKIP $1"
    exit 0
}

# check NAME COMMAND...: the command succeeds.
check() {
    tap_name=$1
    shift
    if tap_said=$("$@" 2>&1); then
        pass "$tap_name"
    else
        fail "$tap_name" "$tap_said"
    fi
}

# run COMMAND...: runs it without input, for at most RUN_SECONDS (300).
run() {
    tap_about=$*
    status=0
    timeout -k 5 "${RUN_SECONDS:-300}" "$@" </dev/null >"$out_file" \
        2>"$err_file" || status=$?
}

# about NAME: begins the names of the checks that follow with NAME.
about() {
    tap_about=$1
}

tap_show() {
    echo "exit status $status; standard output, then standard error:"
    head -n 20 "$out_file"
    echo "--"
    head -n 20 "$err_file"
}

expect_status() {
    if [ "$status" -eq "$1" ]; then
        pass "$tap_about: exit status $1"
    else
        fail "$tap_about: exit status $1" "$(tap_show)"
    fi
}

# expect_out PATTERN, expect_err PATTERN: a line matches the extended regular
# expression.
expect_out() {
    if grep -Eq -e "$1" "$out_file"; then
        pass "$tap_about: says $1"
    else
        fail "$tap_about: says $1" "$(tap_show)"
    fi
}

expect_err() {
    if grep -Eq -e "$1" "$err_file"; then
        pass "$tap_about: complains $1"
    else
        fail "$tap_about: complains $1" "$(tap_show)"
    fi
}

expect_no_out() {
    if [ -s "$out_file" ]; then
        fail "$tap_about: nothing on standard output" "$(tap_show)"
    else
        pass "$tap_about: nothing on standard output"
    fi
}

expect_no_err() {
    if [ -s "$err_file" ]; then
        fail "$tap_about: nothing on standard error" "$(tap_show)"
    else
        pass "$tap_about: nothing on standard error"
    fi
}

# expect_err_lines N
expect_err_lines() {
    if [ "$(wc -l <"$err_file")" -eq "$1" ]; then
        pass "$tap_about: $1 line(s) on standard error"
    else
        fail "$tap_about: $1 line(s) on standard error" "$(tap_show)"
    fi
}

# expect_file FILE: the file exists and is not empty.
expect_file() {
    if [ -s "$1" ]; then
        pass "$tap_about: writes ${1##*/}"
    else
        fail "$tap_about: writes ${1##*/}" "$(tap_show)"
    fi
}

tap_done() {
    echo "1..$tap_count"
    [ "$tap_failed" -eq 0 ] && exit 0
    exit 1
}
