# How U-Boot is told (mx31pdk). Numbers are hexadecimal to it.
# shellcheck shell=bash disable=SC2034,SC2154 # flash.sh's variables

load_address=0x81000000
initramfs_address=0x82000000
check_address=0x84000000

loader_network() {
    [ -z "$address" ] || attempt network tell "setenv ipaddr $address"
    [ -z "$server" ] || attempt network tell "setenv serverip $server"
}

# Gives up rather than trying for ever, which is U-Boot's own way.
loader_load() {
    tell "setenv netretry no" || return 1
    tell "tftpboot $2 $1" || return 1
    $dry_run && return 0
    if ! [[ $heard =~ "Bytes transferred = "([0-9]+) ]]; then
        reason=$(uboot_network_reason)
        return 1
    fi
    if [ "${BASH_REMATCH[1]}" -ne "$(file_size "$1")" ]; then
        reason="${BASH_REMATCH[1]} bytes came instead of $(file_size "$1"): is the server's copy old? (--tftp copies it)"
        return 1
    fi
}

uboot_network_reason() {
    case $heard in
    *"File not found"*) echo 'the TFTP server has no such file (--tftp copies it)' ;;
    *"TFTP error"*) echo "the TFTP server refused: $(grep -o "TFTP error.*" <<<"$heard" | head -n 1)" ;;
    *serverip* | *ipaddr*) echo 'the boot loader knows no address: give --server and --address' ;;
    *"Retry count exceeded"* | *" T "*) echo 'the TFTP server does not answer' ;;
    *) echo 'the transfer failed' ;;
    esac
}

# loader_verify NAME ADDRESS: the board's memory holds the file.
loader_verify() {
    tell "crc32 $2 $(hex "$(file_size "$1")")" || return 1
    if ! [[ $heard =~ "==> "([0-9a-f]{8}) ]] ||
        [ "${BASH_REMATCH[1]}" != "$(file_crc32 "$1")" ]; then
        reason='its sum on the board is wrong'
        return 1
    fi
}

loader_verify_nand() {
    tell "nand read $check_address $(hex "$3") $(hex "$(paged_size "$1")")" &&
        loader_verify "$1" $check_address && return 0
    reason="what the NAND holds is not $1"
    return 1
}

# loader_write NAME PARTITION OFFSET SIZE
loader_write() {
    local way=write
    # Pages that are all 0xff stay erased, as UBI wants it.
    [ "$2" != rootfs ] || way=write.trimffs
    tell "nand erase $(hex "$3") $(hex "$4")" 120 || return 1
    if ! $dry_run && [[ $heard != *OK* ]]; then
        reason='the NAND could not be erased'
        return 1
    fi
    tell "nand $way $load_address $(hex "$3") $(hex "$(paged_size "$1")")" 120 ||
        return 1
    if ! $dry_run && [[ $heard != *"written: OK"* ]]; then
        reason='the NAND could not be written'
        return 1
    fi
}

loader_run() {
    attempt bootargs tell "setenv bootargs $run_arguments"
    start_kernel "bootz $load_address $initramfs_address:$(hex "$(file_size "$initramfs")")"
}

loader_start_from_nand() {
    local offset size
    read -r offset size <<<"$(partition_range kernel)"
    confirm 'Start limber at every power-up (setenv bootcmd, saveenv)?' || return 0
    attempt bootargs tell "setenv bootargs $nand_arguments"
    attempt bootcmd tell "setenv bootcmd 'nand read $load_address $(hex "$offset") $(hex "$(paged_size "$kernel")"); bootz $load_address'"
    attempt saveenv tell saveenv
    echo 'Done: reset the board.'
}
