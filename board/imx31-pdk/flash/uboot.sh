# The commands of U-Boot (mx31pdk), whose numbers are hexadecimal.
# shellcheck shell=bash disable=SC2034,SC2154 # flash.sh's variables

load_address=0x81000000
initramfs_address=0x82000000
check_address=0x84000000

loader_network() {
    [ -z "$address" ] || console_run "setenv ipaddr $address" || return 1
    [ -z "$server" ] || console_run "setenv serverip $server"
}

# netretry makes U-Boot give up instead of trying for ever.
loader_load() {
    console_run "setenv netretry no" || return 1
    console_run "tftpboot $2 $1" || return 1
    $dry_run && return 0
    if ! [[ $received =~ "Bytes transferred = "([0-9]+) ]]; then
        reason=$(uboot_network_reason)
        return 1
    fi
    if [ "${BASH_REMATCH[1]}" -ne "$(file_size "$1")" ]; then
        reason="the board received ${BASH_REMATCH[1]} bytes instead of $(file_size "$1"): copy the file to the server again (--tftp)"
        return 1
    fi
}

uboot_network_reason() {
    case $received in
    *"File not found"*) echo 'the TFTP server has no such file (--tftp copies it)' ;;
    *"TFTP error"*) echo "the TFTP server refused: $(grep -o "TFTP error.*" <<<"$received" | head -n 1)" ;;
    *serverip* | *ipaddr*) echo 'the boot loader knows no address: give --server and --address' ;;
    *"Retry count exceeded"* | *" T "*) echo 'the TFTP server does not answer' ;;
    *) echo 'the transfer failed' ;;
    esac
}

# loader_verify NAME ADDRESS: checks that the board's memory holds the file.
loader_verify() {
    console_run "crc32 $2 $(hex "$(file_size "$1")")" || return 1
    if ! [[ $received =~ "==> "([0-9a-f]{8}) ]] ||
        [ "${BASH_REMATCH[1]}" != "$(file_crc32 "$1")" ]; then
        reason='its checksum on the board is wrong'
        return 1
    fi
}

loader_verify_nand() {
    # After an error the memory may hold an older copy of the file.
    console_run "nand read $check_address $(hex "$3") $(hex "$(paged_size "$1")")" &&
        [[ $received == *"read: OK"* ]] && loader_verify "$1" $check_address && return 0
    reason="the content of the NAND differs from $1"
    return 1
}

# loader_write NAME PARTITION OFFSET SIZE
loader_write() {
    local write=write
    # UBI requires that pages of 0xff stay erased.
    [ "$2" != rootfs ] || write=write.trimffs
    console_run "nand erase $(hex "$3") $(hex "$4")" 120 || return 1
    if ! $dry_run && [[ $received != *OK* ]]; then
        reason='the NAND could not be erased'
        return 1
    fi
    console_run "nand $write $load_address $(hex "$3") $(hex "$(paged_size "$1")")" 120 ||
        return 1
    if ! $dry_run && [[ $received != *"written: OK"* ]]; then
        reason='the NAND could not be written'
        return 1
    fi
}

loader_run() {
    attempt bootargs console_run "setenv bootargs $run_arguments"
    start_kernel "bootz $load_address $initramfs_address:$(hex "$(file_size "$initramfs")")"
}

loader_start_from_nand() {
    local offset size
    read -r offset size <<<"$(partition_range kernel)"
    confirm 'Start limber at every power-up (setenv bootcmd, saveenv)?' || return 0
    attempt bootargs console_run "setenv bootargs $nand_arguments"
    attempt bootcmd console_run "setenv bootcmd 'nand read $load_address $(hex "$offset") $(hex "$(paged_size "$kernel")"); bootz $load_address'"
    attempt saveenv console_run saveenv
    echo 'Done: reset the board.'
}
