#!/usr/bin/env bash
# flash.sh: sends commands to the boot loader over the board's serial console, to
# load limber by TFTP and run it, or to write it to the NAND. See flash.sh --help.
#
# The board's checksum verifies every step. A step whose result is on the board
# already is skipped, so after a failure the same command continues.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=board/imx31-pdk/flash/console.sh
. "$here/flash/console.sh"
# shellcheck source=board/imx31-pdk/flash/files.sh
. "$here/flash/files.sh"

usage() {
    cat <<'END'
usage: flash.sh run|write [options]
  run                load kernel and root file system by TFTP and start them,
                     without touching the NAND
  write              write both to the NAND, after asking
  --port DEVICE      the serial line (/dev/ttyUSB0), at 115200 baud
  --loader NAME      uboot or redboot (by default recognized by its prompt)
  --images DIR       the folder that make image made (build/board/imx31-pdk)
  --tftp DIR         copy the images to this folder of the TFTP server (without
                     this option they must be there already)
  --server ADDRESS   the TFTP server, if the boot loader does not know it
  --address ADDRESS  the board's address, if the boot loader does not know it
  --seconds N        how long to wait for a silent console (30)
  --tries N          how often to try each step (3)
  --yes              erase without asking
  --dry-run          show the commands and send none
END
}

# Set by flash/LOADER.sh.
load_address=
initramfs_address=

action=
port=/dev/ttyUSB0
loader=
images=$here/../../build/board/imx31-pdk
tftp=
server=
address=
seconds=30
tries=3
yes=false
dry_run=false

wrong_usage() {
    echo "flash.sh: $1: see flash.sh --help" >&2
    exit 2
}

fail() {
    echo "flash.sh: $1" >&2
    exit 1
}

is_count() {
    [[ $1 =~ ^[1-9][0-9]{0,5}$ ]]
}

is_address() {
    [[ $1 =~ ^[0-9]{1,3}(\.[0-9]{1,3}){3}$ ]]
}

read_options() {
    while [ $# -gt 0 ]; do
        case $1 in
        run | write)
            [ -z "$action" ] || wrong_usage "$1: give either run or write, not both"
            action=$1
            ;;
        --yes) yes=true ;;
        --dry-run) dry_run=true ;;
        --help | -h)
            usage
            exit 0
            ;;
        --port | --loader | --images | --tftp | --server | --address | \
            --seconds | --tries)
            [ $# -ge 2 ] || wrong_usage "$1 needs a value"
            printf -v "${1#--}" %s "$2"
            shift
            ;;
        *) wrong_usage "$1: no such option" ;;
        esac
        shift
    done
    [ -n "$action" ] || wrong_usage 'give run or write'
    is_count "$seconds" || wrong_usage "--seconds $seconds: not a number"
    is_count "$tries" || wrong_usage "--tries $tries: not a number"
    for value in $server $address; do
        is_address "$value" || wrong_usage "$value: not an address like 192.168.1.2"
    done
    case $loader in
    '' | uboot | redboot) ;;
    *) wrong_usage "--loader $loader: choose uboot or redboot" ;;
    esac
    if $dry_run && [ -z "$loader" ]; then
        wrong_usage '--dry-run cannot recognize the boot loader: give --loader'
    fi
}

# confirm QUESTION: asks the user; true for y.
confirm() {
    local answer=
    if $yes || $dry_run; then
        return 0
    fi
    printf '%s [y/N] ' "$1"
    read -r answer || true
    [[ $answer == [yY]* ]]
}

# attempt WHAT COMMAND...: runs the command up to $tries times until it succeeds.
attempt() {
    local what=$1 try
    shift
    for ((try = 1; try <= tries; try++)); do
        if "$@"; then
            return 0
        fi
        echo "flash.sh: $what: $reason (try $try of $tries)" >&2
        console_settle
    done
    fail "$what: $reason: correct that and start the same command again, which skips the finished steps"
}

# load NAME ADDRESS: loads a file into the board's memory, unless that has it.
load() {
    if ! $dry_run && loader_verify "$1" "$2"; then
        echo "$1 is in memory already"
        return 0
    fi
    attempt "$1" load_once "$1" "$2"
}

# fetch NAME ADDRESS: sets up the network, which the board forgets in a reset, and
# loads a file.
fetch() {
    loader_network && loader_load "$@"
}

load_once() {
    fetch "$1" "$2" && { $dry_run || loader_verify "$1" "$2"; }
}

# write_part NAME PARTITION: loads the file and writes it to the NAND.
write_part() {
    local offset size
    read -r offset size <<<"$(partition_range "$2")"
    if ! $dry_run && loader_verify_nand "$1" "$2" "$offset"; then
        echo "$2 holds $1 already"
        return 0
    fi
    load "$1" "$load_address"
    confirm "Erase $2 ($(hex "$size") bytes of the NAND at $(hex "$offset"))?" ||
        fail "$2 was not changed"
    attempt "$2" write_once "$1" "$2" "$offset" "$size"
}

write_once() {
    # A failed try may have changed the memory.
    $dry_run || loader_verify "$1" "$load_address" ||
        fetch "$1" "$load_address" || return 1
    loader_write "$@" && { $dry_run || loader_verify_nand "$1" "$2" "$3"; }
}

# start_kernel COMMAND: sends the command that starts Linux.
start_kernel() {
    echo "  > $1"
    $dry_run && return 0
    console_type "$1" || fail "$reason"
    console_wait "$seconds" 'Linux version|Starting kernel|Uncompressing Linux' ||
        fail "the kernel did not answer within $seconds s on its console ttymxc0: look for messages on $port"
    echo 'The kernel has started.'
}

read_options "$@"
files_check
$dry_run || files_publish
$dry_run || console_open "$port"
[ -n "$loader" ] || console_find_loader
# shellcheck source=/dev/null
. "$here/flash/$loader.sh"
$dry_run || console_want_prompt
case $action in
run)
    load "$kernel" "$load_address"
    load "$initramfs" "$initramfs_address"
    loader_run
    ;;
write)
    write_part "$kernel" kernel
    write_part "$rootfs" rootfs
    loader_start_from_nand
    ;;
esac
