# How RedBoot is told. Its RAM begins at 0; it asks before it erases.
# shellcheck shell=bash disable=SC2034,SC2154 # flash.sh's variables

load_address=0x100000
initramfs_address=0x2000000
check_address=0x4000000

loader_network() {
    [ -z "$address$server" ] || attempt network tell \
        "ip_address${address:+ -l $address}${server:+ -h $server}"
}

loader_load() {
    tell "load -r -b $2 $1" || return 1
    $dry_run && return 0
    if ! [[ $heard =~ "Raw file loaded "(0x[0-9a-f]+)-(0x[0-9a-f]+) ]]; then
        reason="the transfer failed: $(grep -m 1 -iE "can't|error|timed out" <<<"$heard" || echo 'no reason given')"
        return 1
    fi
    if [ $((BASH_REMATCH[2] - BASH_REMATCH[1] + 1)) -ne "$(file_size "$1")" ]; then
        reason="not $(file_size "$1") bytes came: is the server's copy old? (--tftp copies it)"
        return 1
    fi
}

loader_verify() {
    tell "cksum -b $2 -l $(hex "$(file_size "$1")")" || return 1
    if ! [[ $heard =~ "cksum = "([0-9]+) ]] ||
        [ "${BASH_REMATCH[1]}" != "$(file_cksum "$1")" ]; then
        reason='its sum on the board is wrong'
        return 1
    fi
}

loader_verify_nand() {
    tell "fis load -b $check_address $2" &&
        loader_verify "$1" $check_address && return 0
    reason="what the NAND holds is not $1"
    return 1
}

# Where RedBoot sees the NAND: its own image is at the start of it.
redboot_flash_base() {
    $dry_run && { flash_base=0; return 0; }
    tell 'fis list' || return 1
    if ! [[ $heard =~ RedBoot\ +(0x[0-9A-Fa-f]+) ]]; then
        reason='fis list shows no RedBoot image: is there a directory (fis init)?'
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
    until console_wait 120 "$prompt_pattern|\(y/n\)\? ?$" &&
        [[ $heard =~ $prompt_pattern ]]; do
        if ! [[ $heard =~ \(y/n\)\?\ ?$ ]]; then
            reason='no answer to fis create within 120 s'
            return 1
        fi
        heard=
        console_put $'y\r'
    done
    if [[ $heard =~ ([^$'\n']*([Ee]rror|[Ii]nvalid|can\'t)[^$'\n']*) ]]; then
        reason="RedBoot says: ${BASH_REMATCH[1]}"
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
