#!/bin/sh
# image.sh LINUX SYSROOT LIMBER HOST-LIMBER DIR: builds the board's image in DIR.
#
# LINUX is the folder that kernel/build.sh made, HOST-LIMBER the program for this
# machine. The same input gives the same bytes, in any folder and at any time.
set -eu
export LC_ALL=C

linux=$1
sysroot=$2
limber=$3
host_limber=$4
out=$5
here=$(dirname "$0")
top=$here/../..

# The flash chip and the BSP's layout (README.md).
page=2048
block=131072
# The NAND driver corrects errors in units of 512 bytes, which UBI therefore uses
# as its sub-page size, and places its second header accordingly.
part=512
logical=$((block - page))
rootfs_blocks=160
kernel_bytes=5242880
total_bytes=$((12 * 1024 * 1024))

rm -rf "$out"
mkdir -p "$out"
work=$out.work
rm -rf "$work"
mkdir -p "$work"
trap 'rm -rf "$work"' EXIT

# archive LIST FILE.lz4: makes an initramfs with fixed times, without being root.
# It uses LZ4 because unpacking gzip would delay the first picture by 0.5 s.
archive() {
    "$linux/obj/usr/gen_init_cpio" -t 0 "$1" | lz4 -l -12 --favor-decSpeed >"$2"
}

arm-linux-gnueabi-cpp -nostdinc -undef -x assembler-with-cpp \
    -I "$linux/source/arch/arm/boot/dts" -I "$linux/source/include" \
    "$here/imx31-pdk-limber.dts" |
    dtc -q -I dts -O dtb -o "$out/imx31-pdk-limber.dtb" -
cp "$linux/zImage" "$out/zImage"
# The boot loaders know no device trees; the kernel finds one appended to itself.
cat "$linux/zImage" "$out/imx31-pdk-limber.dtb" >"$out/zImage-dtb"

"$here/rootfs/make.py" "$sysroot" "$limber" "$host_limber" "$top/assets" "$work"
archive "$work/list" "$out/initramfs.cpio.lz4"

# Modules that replace hardware, for emulation and tests only.
find "$linux/modules" ! -type l -exec touch -d @0 {} +
(cd "$linux/modules" && find . -type d ! -name . -printf 'dir /%P 0755 0 0\n' \
    -o -type f -printf "file /%P $PWD/%P 0644 0 0\\n") | sort -k 2 >"$work/modules"
archive "$work/modules" "$out/test-drivers.cpio.lz4"

# -f 128: the index has few, large nodes, because mounting reads them one by one.
mkfs.ubifs -m "$page" -e "$logical" -c "$rootfs_blocks" -x lzo -f 128 -U \
    -D "$here/rootfs/devices.txt" -r "$work/root" -o "$work/rootfs.ubifs" \
    >"$work/log" || {
    cat "$work/log" >&2
    exit 1
}
"$here/settle_ubifs.py" "$work/rootfs.ubifs"
cat >"$work/ubi.ini" <<END
[rootfs]
mode=ubi
image=$work/rootfs.ubifs
vol_id=0
vol_type=dynamic
vol_size=$(stat -c %s "$work/rootfs.ubifs")
vol_name=rootfs
vol_flags=autoresize
END
ubinize -Q 1 -m "$page" -s "$part" -p "$block" -o "$out/rootfs.ubi" \
    "$work/ubi.ini" >>"$work/log"

"$here/package.sh" "$work/root" "$sysroot" "$out"

(cd "$out" && sha256sum -- * >SHA256SUMS)
size() {
    stat -c %s "$out/$1"
}
for file in zImage zImage-dtb imx31-pdk-limber.dtb initramfs.cpio.lz4 \
    rootfs.ubi; do
    printf '  %9d  %s\n' "$(size $file)" "$out/$file"
done
together=$(($(size zImage-dtb) + $(size initramfs.cpio.lz4)))
if [ "$together" -gt "$total_bytes" ] ||
    [ "$(size zImage-dtb)" -gt "$kernel_bytes" ]; then
    echo "limber: kernel and root file system are too large: they take $together of $total_bytes bytes, and the kernel's partition has $kernel_bytes" >&2
    exit 1
fi
