#!/bin/sh
# check-hardened.sh READELF FILE...: fails unless each program is hardened. It
# prints a sentence for each measure that a program lacks:
#   its addresses can change with every run (a position-independent executable);
#   the linker's tables are read-only before main() runs (full RELRO);
#   no memory is writable and executable;
#   the stack and calls of the C library are checked;
#   no path of the folder in which it was built is in it.
set -eu
readelf=$1
shift
result=0

lacks() {
    echo "limber: $file: $1" >&2
    result=1
}

for file; do
    header=$("$readelf" -hW "$file")
    parts=$("$readelf" -lW "$file")
    dynamic=$("$readelf" -dW "$file")
    symbols=$("$readelf" --dyn-syms -W "$file")
    case $header in
    *'DYN ('*) ;;
    *) lacks 'its addresses are fixed: compile with -fPIE and link with -pie' ;;
    esac
    case $parts in
    *GNU_RELRO*) ;;
    *) lacks 'the linker tables stay writable: link with -z relro' ;;
    esac
    case $dynamic in
    *BIND_NOW* | *'Flags: NOW'*) ;;
    *) lacks 'calls are bound while it runs: link with -z now' ;;
    esac
    case $dynamic in
    *TEXTREL*) lacks 'its code is changed when it is loaded' ;;
    esac
    if printf '%s\n' "$parts" | grep -Eq '(LOAD|GNU_STACK) .* RWE '; then
        lacks 'it has memory that is writable and executable'
    fi
    case $symbols in
    *__stack_chk_fail*) ;;
    *) lacks 'its stack is not checked: compile with -fstack-protector-strong' ;;
    esac
    case $symbols in
    *printf_chk*) ;;
    *) lacks 'calls of the C library are not checked: compile with -D_FORTIFY_SOURCE=2' ;;
    esac
    if grep -aqF "$(pwd -P)/" "$file"; then
        lacks "it contains the path $(pwd -P): compile with -ffile-prefix-map"
    fi
done
exit $result
