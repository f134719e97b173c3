#!/bin/sh
# Tests sysroot.sh with replacements of apt-get, mmdebstrap and id.
. "$(dirname "$0")/../support/tap.sh"
script=$(dirname "$0")/../../toolchain/sysroot.sh
root=$scratch/build/sysroot
KEYRING=$scratch/keyring
export KEYRING
mkdir "$scratch/bin" "$scratch/build"
: >"$KEYRING"

stub() {
    printf '#!/bin/sh\n%s\n' "$2" >"$scratch/bin/$1"
    chmod +x "$scratch/bin/$1"
}

# given USER_ID SOURCE...: sets apt's sources and their release information.
given() {
    stub id "echo $1"
    shift
    stub apt-get "case \"\$*\" in
        *--no-release-info*) printf '%s\n' '$2' ;;
        *) printf '%s\n' '$1' ;;
        esac"
    stub mmdebstrap "echo \"\$*\" >$scratch/call
        for d; do :; done
        mkdir -p $root.new/usr/lib $root.new/dev"
}

sysroot() {
    rm -f "$scratch/call"
    run env PATH="$scratch/bin:$PATH" "$script" "$root"
}

called() {
    check "$tap_about: calls mmdebstrap with $1" grep -Eq -e "$1" \
        "$scratch/call"
}

given 0 http://one.example/debian 'http://two.example/debian bookworm'
sysroot
about 'root'
expect_status 0
expect_no_out
expect_no_err
called '--mode=root '
called "trixie $root.new deb \[signed-by=$KEYRING\] http://one.example/debian trixie main$"
called '--include=libc6-dev,.*,libcmocka-dev,'
check 'the loader finds its libraries' test "$(readlink "$root/lib")" = usr/lib
check 'no devices stay' test ! -e "$root/dev"
check 'nothing else stays' test ! -e "$root.new"

given 1000 http://one.example/debian ''
sysroot
about 'a user'
expect_status 0
called '--mode=chrootless '

given 0 '' 'http://two.example/debian bookworm'
sysroot
about 'before an apt-get update'
expect_status 0
called 'http://two.example/debian trixie main$'

given 0 "$(printf 'cdrom:disc/\nhttp://one.example/debian-security\nhttp://three.example/debian')" ''
sysroot
about 'a disc and the security archive come first'
expect_status 0
called 'http://three.example/debian trixie main$'

given 0 '' 'http://two.example/ubuntu jammy'
sysroot
about 'no Debian mirror'
expect_status 1
expect_err_lines 1
expect_err '^limber: no Debian mirror .*: set MIRROR=URL$'

MIRROR=http://four.example/debian
export MIRROR
sysroot
about 'a mirror that is given'
expect_status 0
called 'http://four.example/debian trixie main$'

stub mmdebstrap "echo \"\$*\" >$scratch/call
    for d; do :; done
    mkdir -p $root.new/usr
    case \"\$d\" in *' trixie main') : >$root.new/half; exit 1 ;; esac"
sysroot
about 'a mirror in the midst of a point release'
expect_status 0
expect_no_err
called "stable $root.new deb .* http://four.example/debian stable main$"
called 'Codename: trixie'
check 'nothing of the failed attempt stays' test ! -e "$root/half"
rm -rf "$root"

stub mmdebstrap 'echo "E: no route" >&2; exit 1'
sysroot
about 'mmdebstrap fails'
expect_status 1
expect_err '^E: no route$'
expect_err '^limber: mmdebstrap could not make '
check 'no half sysroot stays' test ! -e "$root" -a ! -e "$root.new"

rm "$KEYRING"
sysroot
about 'no keyring'
expect_status 1
expect_err "^limber: $KEYRING is missing: apt-get install debian-archive-keyring$"

tap_done
