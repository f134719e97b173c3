#!/bin/sh
# Tests check-hardened.sh: it accepts the programs that were built, and misses
# each measure in a program that lacks it.
. "$(dirname "$0")/../support/tap.sh"
script=$(cd "$(dirname "$0")/../.." && pwd)/toolchain/check-hardened.sh

run "$script" readelf build/host/limber
expect_quiet_success() {
    expect_status 0
    expect_no_err
}
expect_quiet_success
run "$script" arm-linux-gnueabi-readelf build/arm/limber
expect_quiet_success

cat >"$scratch/program.c" <<'END'
#include <stdio.h>
#include <string.h>

int main(int argc, char **argv)
{
	char copy[16];

	(void)argc;
	strncpy(copy, argv[0], sizeof(copy) - 1);
	copy[15] = '\0';
	printf("%s %s\n", copy, __FILE__);
	return 0;
}
END
cd "$scratch" || exit 1

# compiled OPTION...: runs the script on a program that is hardened but for the
# options.
compiled() {
    gcc -O2 -g -fPIE -fstack-protector-strong -U_FORTIFY_SOURCE \
        -D_FORTIFY_SOURCE=2 -ffile-prefix-map="$scratch"=. "$scratch/program.c" \
        -pie -Wl,-z,relro,-z,now -o program "$@"
    run "$script" readelf program
    about "$*"
}

compiled
expect_quiet_success
compiled -no-pie -fno-pie
expect_err 'addresses are fixed'
compiled -Wl,-z,norelro
expect_err 'tables stay writable'
compiled -Wl,-z,lazy
expect_err 'bound while it runs'
compiled -Wl,-z,execstack
expect_err 'writable and executable'
compiled -fno-stack-protector
expect_err 'stack is not checked'
compiled -U_FORTIFY_SOURCE
expect_err 'C library are not checked'
compiled -ffile-prefix-map="$scratch"="$scratch"
expect_err 'contains the path'
expect_status 1
tap_done
