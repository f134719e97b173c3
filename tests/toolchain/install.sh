#!/bin/sh
# Tests install.sh with replacements of apt-get, dpkg-query, sudo and id, so that
# no package of this machine is changed.
. "$(dirname "$0")/../support/tap.sh"

# A copy of toolchain/ with other package lists.
mkdir -p "$scratch/toolchain/packages" "$scratch/bin"
cp "$(dirname "$0")/../../toolchain/install.sh" "$scratch/toolchain"
printf '# a comment\n\nalpha\nbeta\n' >"$scratch/toolchain/packages/two.txt"
printf 'gamma ?gamma-run\ndelta ?%s\n' "$scratch/delta-file" \
    >"$scratch/toolchain/packages/things.txt"

# Only these commands can be found.
for tool in sh awk env dirname cat rm mktemp sed flock printf; do
    ln -s "$(command -v $tool)" "$scratch/bin/$tool"
done
stub() {
    printf '#!/bin/sh\n%s\n' "$2" >"$scratch/bin/$1"
    chmod +x "$scratch/bin/$1"
}

# given USER_ID PACKAGE...: a machine with these packages installed, and an
# apt-get that can install others.
given() {
    rm -f "$scratch/installed" "$scratch/calls" "$scratch/bin/sudo" \
        "$scratch/bin/gamma-run" "$scratch/delta-file"
    : >"$scratch/calls"
    stub id "echo $1"
    shift
    printf '%s\n' "$@" >"$scratch/installed"
    stub dpkg-query "while [ \"\${1#-}\" != \"\$1\" ]; do shift; done
        while read -r p; do [ \"\$p\" != \"\$1\" ] || printf installed
        done <$scratch/installed"
    stub apt-get "echo \"apt-get \$* (\$DEBIAN_FRONTEND)\" >>$scratch/calls
        case \"\$*\" in *install*) for p; do echo \"\$p\"
        done >>$scratch/installed;; esac"
}

install() {
    run env PATH="$scratch/bin" "$scratch/toolchain/install.sh" "$@"
}

called() {
    check "$tap_about: calls $1" grep -Eqx -e "$1" "$scratch/calls"
}

calls_nothing() {
    if [ -s "$scratch/calls" ]; then
        fail "$tap_about: calls nothing" "$(cat "$scratch/calls")"
    else
        pass "$tap_about: calls nothing"
    fi
}

given 1000 alpha beta
install two
about 'all packages are there'
expect_status 0
expect_no_out
expect_no_err
calls_nothing

given 0 beta
install two
about 'root'
expect_status 0
expect_out '^  APT +alpha$'
expect_no_err
called 'apt-get .*update \(noninteractive\)'
called 'apt-get .*install -y --no-install-recommends alpha \(noninteractive\)'

given 1000 beta
stub sudo "echo \"sudo \$*\" >>$scratch/calls
    [ \"\$1\" != -n ] || shift; \"\$@\""
install two
about 'a user who may use sudo'
expect_status 0
called 'sudo -n env DEBIAN_FRONTEND=noninteractive apt-get .*update'
called 'apt-get .*install -y .* alpha \(noninteractive\)'

given 1000
stub sudo "exit 1"
install two
about 'a user whom sudo asks for a password, without a terminal'
expect_status 1
expect_err_lines 1
expect_err '^limber: .*run as root: apt-get update && apt-get install --no-install-recommends alpha beta$'
calls_nothing

given 1000
install two
about 'a user without sudo'
expect_status 1
expect_err_lines 1
expect_err 'apt-get install --no-install-recommends alpha beta$'
calls_nothing

given 0
rm "$scratch/bin/apt-get" "$scratch/bin/dpkg-query"
install two
about 'a machine without apt-get'
expect_status 0
expect_err '^limber: this machine has no apt-get; install .* alpha beta$'

given 0
stub apt-get 'echo "E: no network"; exit 100'
install two
about 'apt-get fails'
expect_status 1
expect_err '^E: no network$'
expect_err '^limber: apt-get could not install alpha beta'

given 0
stub gamma-run ''
: >"$scratch/delta-file"
install things
about 'a command and a file from elsewhere'
expect_status 0
expect_no_out
calls_nothing

given 0 delta
install things
about 'a missing command; a package without its file'
expect_status 0
called 'apt-get .*install -y --no-install-recommends gamma .*'

given 0
printf 'beta\nomega\n' >"$scratch/toolchain/packages/also.txt"
install two also
about 'a package in two sets'
expect_status 0
called 'apt-get .*install -y --no-install-recommends alpha beta omega .*'

given 0
install two things
about 'two sets at once'
expect_status 0
called 'apt-get .*install -y --no-install-recommends alpha beta gamma delta .*'

install
about 'no set'
expect_status 2
expect_err '^usage: .*two'

install two other
about 'an unknown set'
expect_status 2
expect_err 'no package list .*/other.txt'

given 0
stub apt-get "echo \"apt-get \$*\" >>$scratch/calls
    /bin/sleep 0.2
    case \"\$*\" in *install*) for p; do echo \"\$p\"
    done >>$scratch/installed;; esac"
PATH=$scratch/bin "$scratch/toolchain/install.sh" two >"$scratch/first" 2>&1 &
install two
wait
about 'two at once'
expect_status 0
if [ "$(grep -c install "$scratch/calls")" -eq 1 ]; then
    pass 'two at once: one of them installs'
else
    fail 'two at once: one of them installs' "$(cat "$scratch/calls")"
fi

tap_done
