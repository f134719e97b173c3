#!/usr/bin/env bash
# flash.sh: over the board's serial console, tells its boot loader to load
# limber by TFTP and run it, or to write it to the NAND. `flash.sh --help`.
#
# Every step is checked by its sum on the board and left out when the board
# already holds the right bytes; so after a time-out, simply start it again.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=board/imx31-pdk/flash/console.sh
. "$here/flash/console.sh"
# shellcheck source=board/imx31-pdk/flash/files.sh
. "$here/flash/files.sh"

usage() {
    cat <<'END'
usage: flash.sh run|write [options]
  run                load kernel and root file system by TFTP and start them;
                     the NAND is not touched
  write              write both to the NAND, after asking
  --port DEVICE      the serial line (/dev/ttyUSB0), 115200 baud
  --loader NAME      uboot or redboot (found out by its prompt)
  --images DIR       what `make image` made (build/board/imx31-pdk)
  --tftp DIR         where the TFTP server's files lie: the images are copied
                     there (otherwise they must be there already)
  --server ADDRESS   the TFTP server, if the boot loader does not know it
  --address ADDRESS  the board's own address, if it does not know it
  --seconds N        how long to wait for a silent console (30)
  --tries N          how often to try each step (3)
  --yes              erase without asking
  --dry-run          show the commands, send none
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
            [ -z "$action" ] || wrong_usage "$1: $action was asked for already"
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
            [ $# -ge 2 ] || wrong_usage "$1 wants a value"
            printf -v "${1#--}" %s "$2"
            shift
            ;;
        *) wrong_usage "$1: no such option" ;;
        esac
        shift
    done
    [ -n "$action" ] || wrong_usage 'run or write?'
    is_count "$seconds" || wrong_usage "--seconds $seconds: not a number"
    is_count "$tries" || wrong_usage "--tries $tries: not a number"
    for value in $server $address; do
        is_address "$value" || wrong_usage "$value: not an address like 192.168.1.2"
    done
    case $loader in
    '' | uboot | redboot) ;;
    *) wrong_usage "--loader $loader: uboot or redboot" ;;
    esac
    if $dry_run && [ -z "$loader" ]; then
        wrong_usage '--dry-run has no prompt to go by: give --loader'
    fi
}

# confirm QUESTION: true for y.
confirm() {
    local answer=
    if $yes || $dry_run; then
        return 0
    fi
    printf '%s [y/N] ' "$1"
    read -r answer || true
    [[ $answer == [yY]* ]]
}

# attempt WHAT COMMAND...: up to $tries times, each with the console quiet.
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
    fail "$what: $reason. What is done is not done again: mend this and start the same command anew"
}

# load NAME ADDRESS: into the board's memory, unless it is there already.
load() {
    if ! $dry_run && loader_verify "$1" "$2"; then
        echo "$1 is in memory already"
        return 0
    fi
    attempt "$1" load_once "$1" "$2"
}

load_once() {
    loader_load "$1" "$2" && { $dry_run || loader_verify "$1" "$2"; }
}

# write_part NAME PARTITION: the file, which is at the load address, to NAND.
write_part() {
    local offset size
    read -r offset size <<<"$(partition_range "$2")"
    if ! $dry_run && loader_verify_nand "$1" "$2" "$offset"; then
        echo "$2 holds $1 already"
        return 0
    fi
    load "$1" "$load_address"
    confirm "Erase $2 ($(hex "$size") bytes of the NAND at $(hex "$offset"))?" ||
        fail "$2 was left as it is"
    attempt "$2" write_once "$1" "$2" "$offset" "$size"
}

write_once() {
    # What a failed try left in memory may be anything.
    $dry_run || loader_verify "$1" "$load_address" ||
        loader_load "$1" "$load_address" || return 1
    loader_write "$@" && { $dry_run || loader_verify_nand "$1" "$2" "$3"; }
}

# start_kernel COMMAND: the boot loader's last one; Linux speaks next.
start_kernel() {
    echo "  > $1"
    $dry_run && return 0
    console_type "$1" || fail "$reason"
    console_wait "$seconds" 'Linux version|Starting kernel|Uncompressing Linux' ||
        fail "no kernel answered within $seconds s: its console is ttymxc0 (see panic messages on $port)"
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
loader_network
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
