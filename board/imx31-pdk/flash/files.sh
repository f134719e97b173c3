# The images, their checksums and their partitions.
# shellcheck shell=bash disable=SC2034,SC2154 # flash.sh's variables

kernel=zImage-dtb
initramfs=initramfs.cpio.lz4
rootfs=rootfs.ubi

# The BSP's partitions of the NAND: offset and size in bytes.
partition_range() {
    case $1 in
    kernel) echo $((0x100000)) $((0x500000)) ;;
    rootfs) echo $((0x600000)) $((0x1400000)) ;;
    esac
}

nand_page=2048

hex() {
    printf '0x%x' "$1"
}

file_size() {
    stat -c %s "$images/$1"
}

# The size rounded up to whole pages of the NAND.
paged_size() {
    local size
    size=$(file_size "$1")
    echo $(((size + nand_page - 1) / nand_page * nand_page))
}

# The CRC-32 that U-Boot prints, which gzip appends to its output.
file_crc32() {
    local byte
    read -ra byte <<<"$(gzip -1c "$images/$1" | tail -c 8 | head -c 4 | od -An -tx1)"
    echo "${byte[3]}${byte[2]}${byte[1]}${byte[0]}"
}

# The checksum that RedBoot prints, that of POSIX cksum.
file_cksum() {
    cksum <"$images/$1" | cut -d' ' -f1
}

# Checks that the files exist, match SHA256SUMS and fit into their partitions.
files_check() {
    local name part offset size
    local wanted=("$kernel" "$initramfs")
    [ "$action" = run ] || wanted=("$kernel" "$rootfs")
    for name in "${wanted[@]}" SHA256SUMS; do
        [ -s "$images/$name" ] ||
            fail "$images/$name: this file is missing: run make image, or name the folder with --images"
    done
    for name in "${wanted[@]}"; do
        (cd "$images" && grep -q " [ *]*$name\$" SHA256SUMS &&
            grep " [ *]*$name\$" SHA256SUMS | sha256sum --check --status) ||
            fail "$images/$name: its checksum differs from SHA256SUMS: run make image again"
    done
    [ "$action" = write ] || return 0
    for part in kernel rootfs; do
        read -r offset size <<<"$(partition_range "$part")"
        [ "$(paged_size "${!part}")" -le "$size" ] ||
            fail "$images/${!part}: it is larger than its partition of $size bytes"
    done
}

files_publish() {
    local name
    [ -n "$tftp" ] || return 0
    [ -d "$tftp" ] || fail "--tftp $tftp: no such folder"
    for name in "$kernel" "$initramfs" "$rootfs"; do
        [ -f "$images/$name" ] || continue
        cmp -s "$images/$name" "$tftp/$name" ||
            cp "$images/$name" "$tftp/$name" ||
            fail "--tftp $tftp: $name cannot be copied there"
    done
}

run_arguments='console=ttymxc0,115200 panic=5'
nand_arguments='console=ttymxc0,115200 panic=5 ubi.mtd=rootfs root=ubi0:rootfs rootfstype=ubifs ro'
