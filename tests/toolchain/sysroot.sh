#!/bin/sh
# Tests sysroot.sh with replacements of apt-get, mmdebstrap and id.
. "$(dirname "$0")/../support/tap.sh"
script=$(dirname "$0")/../../toolchain/sysroot.sh
root=$scratch/build/sysroot
KEYRING=$scratch/keyring
export KEYRING
RECORD=$scratch/record
export RECORD
printf '%s  %s\n' aa libone_1_armel.deb bb libtwo_2_armel.deb >"$RECORD"
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
        mkdir -p $root.new/usr/lib $root.new/dev
        cp $scratch/packages $root.new/packages.sha256"
}

cp "$RECORD" "$scratch/packages"
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

printf '%s  %s\n' aa libone_1_armel.deb cc libtwo_3_armel.deb >"$scratch/packages"
sysroot
about 'a version that is not recorded'
expect_status 0
expect_err_lines 1
expect_err '^limber: .* has other versions than .* make sysroot-record accepts libtwo_3_armel.deb$'
check 'the sysroot tells what it holds' cmp -s "$scratch/packages" \
    "$root/packages.sha256"

printf '%s  %s\n' aa libone_1_armel.deb cc libtwo_2_armel.deb >"$scratch/packages"
sysroot
about 'a recorded version with other bytes'
expect_status 1
expect_err_lines 1
expect_err '^limber: .* has other bytes than .* lists for libtwo_2_armel.deb$'
check 'there is no sysroot of it' test ! -e "$root" -a ! -e "$root.new"
# Other packages than those of the sysroot have no record.
echo linux-image >"$scratch/list"
record=$RECORD
RECORD=
PACKAGES=$scratch/list
export PACKAGES
sysroot
about 'a list of packages without a record'
expect_status 0
expect_no_err
called '--include=linux-image '
RECORD=$record
unset PACKAGES
cp "$RECORD" "$scratch/packages"

stub mmdebstrap "echo \"\$*\" >$scratch/call
    for d; do :; done
    mkdir -p $root.new/usr
    cp $scratch/packages $root.new/packages.sha256
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
