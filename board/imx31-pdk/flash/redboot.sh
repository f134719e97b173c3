# The commands of RedBoot. Its RAM begins at 0, and it asks before it erases.
# shellcheck shell=bash disable=SC2034,SC2154 # flash.sh's variables

load_address=0x100000
initramfs_address=0x2000000
check_address=0x4000000

loader_network() {
    [ -z "$address$server" ] || console_run \
        "ip_address${address:+ -l $address}${server:+ -h $server}"
}

loader_load() {
    console_run "load -r -b $2 $1" || return 1
    $dry_run && return 0
    if ! [[ $received =~ "Raw file loaded "(0x[0-9a-f]+)-(0x[0-9a-f]+) ]]; then
        reason="the transfer failed: $(grep -m 1 -iE "can't|error|timed out" <<<"$received" || echo 'no reason given')"
        return 1
    fi
    if [ $((BASH_REMATCH[2] - BASH_REMATCH[1] + 1)) -ne "$(file_size "$1")" ]; then
        reason="the board did not receive $(file_size "$1") bytes: copy the file to the server again (--tftp)"
        return 1
    fi
}

loader_verify() {
    console_run "cksum -b $2 -l $(hex "$(file_size "$1")")" || return 1
    if ! [[ $received =~ "cksum = "([0-9]+) ]] ||
        [ "${BASH_REMATCH[1]}" != "$(file_cksum "$1")" ]; then
        reason='its checksum on the board is wrong'
        return 1
    fi
}

loader_verify_nand() {
    # After an error the memory may hold an older copy of the file.
    console_run "fis load -b $check_address $2" &&
        ! [[ $received =~ [Ee]rror ]] && loader_verify "$1" $check_address && return 0
    reason="the content of the NAND differs from $1"
    return 1
}

# RedBoot's address of the NAND, where its own image starts.
redboot_flash_base() {
    $dry_run && { flash_base=0; return 0; }
    console_run 'fis list' || return 1
    if ! [[ $received =~ RedBoot\ +(0x[0-9A-Fa-f]+) ]]; then
        reason='fis list shows no RedBoot image: create its directory with fis init'
        return 1
    fi
    flash_base=$((BASH_REMATCH[1]))
}

# loader_write NAME PARTITION OFFSET SIZE; the user has been asked already.
loader_write() {
    local line
    redboot_flash_base || return 1
    line="fis create -b $load_address -l $(hex "$4") -s $(hex "$(file_size "$1")")"
    line+=" -f $(hex $((flash_base + $3))) -r $load_address -e $load_address $2"
    echo "  > $line"
    $dry_run && return 0
    console_type "$line" || return 1
    until console_wait 120 "$prompt_pattern|$autoboot_pattern|\(y/n\)\? ?$" &&
        [[ $received =~ $prompt_pattern ]]; do
        if ! [[ $received =~ \(y/n\)\?\ ?$ ]]; then
            reason='fis create did not finish within 120 s'
            [[ ! $received =~ $autoboot_pattern ]] ||
                reason='the board was reset during fis create'
            return 1
        fi
        received=
        console_put $'y\r'
    done
    if [[ $received =~ ([^$'\n']*([Ee]rror|[Ii]nvalid|can\'t)[^$'\n']*) ]]; then
        reason="RedBoot reports: ${BASH_REMATCH[1]}"
        return 1
    fi
}

loader_run() {
    start_kernel "exec -b $load_address -l $(hex "$(file_size "$kernel")") -r $initramfs_address -s $(hex "$(file_size "$initramfs")") -c \"$run_arguments\""
}

loader_start_from_nand() {
    cat <<END
Done. To start limber now:
  fis load kernel
  exec -b $load_address -l $(hex "$(file_size "$kernel")") -c "$nand_arguments"
To do so at every power-up, give these two lines to fconfig as the boot script.
END
}
