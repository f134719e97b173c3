#!/bin/sh
# build.sh SOURCE.tar.xz DIR: builds the board's kernel from Debian's source in
# DIR/source and DIR/obj, and copies it to DIR/zImage and DIR/modules. Does
# nothing when its input has not changed.
set -eu

tarball=$1
directory=$2
here=$(cd "$(dirname "$0")" && pwd)
: "${JOBS:=$(nproc)}"

hash=$(cat "$tarball" "$here/build.sh" "$here/limber.config" \
    "$here/limber-imx31-pdk.c" "$here/linux.patch" | sha256sum)
if [ -f "$directory/made-from" ] && [ "$(cat "$directory/made-from")" = "$hash" ]; then
    exit 0
fi
mkdir -p "$directory"
directory=$(cd "$directory" && pwd)
case $directory in
*[[:space:]:]*)
    echo "limber: the kernel cannot be built in $directory: Linux does not build in a folder whose path has a space or a colon; move limber to another folder" >&2
    exit 1
    ;;
esac
source=$directory/source
log=$directory/build.log
: >"$log"
rm -f "$directory/made-from"

# Makes the build reproducible.
export ARCH=arm CROSS_COMPILE=arm-linux-gnueabi- LC_ALL=C
export KBUILD_BUILD_TIMESTAMP='2026-01-01 00:00:00 UTC'
export KBUILD_BUILD_USER=limber KBUILD_BUILD_HOST=limber KBUILD_BUILD_VERSION=1

kernel_make() {
    make -C "$source" O="$directory/obj" --no-print-directory -j"$JOBS" \
        "$@" >>"$log" 2>&1 || {
        tail -n 30 "$log" >&2
        echo "limber: the kernel cannot be built: see $log" >&2
        exit 1
    }
}

# Leaves out most of the source that is for other machines.
unpack() {
    rm -rf "$source" "$source.new"
    mkdir "$source.new"
    tar -xJf "$tarball" -C "$source.new" --strip-components=1 \
        --exclude='*/arch/[b-z]*.[chSs]' --exclude='*/arch/[b-z]*.dts*' \
        --exclude='*/arch/arm64/*.[chSs]' --exclude='*/arch/arm64/*.dts*' \
        --exclude='*/arch/alpha/*.[chSs]' --exclude='*/arch/arc/*.[chSs]' \
        --exclude='*/Documentation/*.rst' --exclude='*/Documentation/*.yaml' \
        --exclude='*/Documentation/*.txt' --exclude='*/Documentation/*.svg' \
        --exclude='*/sound/*.[ch]' --exclude='*/drivers/net/*.[ch]' \
        --exclude='*/drivers/gpu/drm/amd/*.[ch]' \
        --exclude='*/drivers/gpu/drm/nouveau/*.[ch]' \
        --exclude='*/drivers/gpu/drm/i915/*.[ch]' \
        --exclude='*/drivers/gpu/drm/radeon/*.[ch]' \
        --exclude='*/drivers/staging/*.[ch]' \
        --exclude='*/drivers/infiniband/*.[ch]' \
        --exclude='*/drivers/scsi/*.[ch]' \
        --exclude='*/drivers/media/dvb-frontends/*.[ch]' \
        --exclude='*/tools/testing'
    mv "$source.new" "$source"
    cat >>"$source/arch/arm/mach-imx/Kconfig" <<'END'

config LIMBER_IMX31_PDK
	bool "Picture of the i.MX31 PDK on a device-tree kernel"
	depends on SOC_IMX31
END
    echo 'obj-$(CONFIG_LIMBER_IMX31_PDK) += limber-imx31-pdk.o' \
        >>"$source/arch/arm/mach-imx/Makefile"
    patch -d "$source" -s -p1 <"$here/linux.patch" >>"$log" 2>&1 || {
        echo "limber: linux.patch does not fit $tarball: see $log" >&2
        exit 1
    }
    # A test loads the module simpledrm after it has unbound the simple
    # framebuffer. Both drivers have the same name, so Kconfig allows only one
    # of them; this allows both and renames one.
    sed -i '/^config FB_SIMPLE$/,/^config /{/depends on !DRM_SIMPLEDRM/d}' \
        "$source/drivers/video/fbdev/Kconfig"
    sed -i 's/\.name = "simple-framebuffer", .*/.name = "simpledrm",/' \
        "$source/drivers/gpu/drm/tiny/simpledrm.c"
}

# Prints the lines of limber.config that the configuration did not accept.
check_config() {
    grep -E '^(# )?CONFIG_' "$here/limber.config" |
        while read -r line; do
            case $line in
            '# CONFIG_'*' is not set')
                name=${line#\# }
                ! grep -q "^${name%% *}=" "$directory/obj/.config" || echo "$line"
                ;;
            *) grep -qxF "$line" "$directory/obj/.config" || echo "$line" ;;
            esac
        done
}

source_hash=$(cat "$tarball" "$here/build.sh" "$here/linux.patch" | sha256sum)
if [ ! -f "$source/made-from" ] || [ "$(cat "$source/made-from")" != "$source_hash" ]; then
    rm -rf "$directory/obj"
    unpack
    echo "$source_hash" >"$source/made-from"
fi
cmp -s "$here/limber-imx31-pdk.c" "$source/arch/arm/mach-imx/limber-imx31-pdk.c" ||
    cp "$here/limber-imx31-pdk.c" "$source/arch/arm/mach-imx"
mkdir -p "$directory/obj"
kernel_make tinyconfig
"$source/scripts/kconfig/merge_config.sh" -m -O "$directory/obj" \
    "$directory/obj/.config" "$here/limber.config" >>"$log" 2>&1
kernel_make olddefconfig
refused=$(check_config)
if [ -n "$refused" ]; then
    echo "limber: the kernel's configuration does not accept these lines:" >&2
    echo "$refused" >&2
    exit 1
fi
kernel_make zImage modules
rm -rf "$directory/modules"
kernel_make INSTALL_MOD_PATH="$directory/modules" INSTALL_MOD_STRIP=1 modules_install
cp "$directory/obj/arch/arm/boot/zImage" "$directory/zImage"
echo "$hash" >"$directory/made-from"
