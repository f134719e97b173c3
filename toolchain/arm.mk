# The board: ARM1136JF-S, against a Debian 13 armel sysroot. The 64-bit time
# defines match that release's ABI.

SYSROOT := build/sysroot
ARM_PREFIX := arm-linux-gnueabi-

CC_arm := $(ARM_PREFIX)gcc --sysroot=$(SYSROOT)
CFLAGS_arm ?= -O2 -g
CFLAGS_arm += -mcpu=arm1136jf-s -mfpu=vfpv2 -mfloat-abi=softfp -marm \
	-D_TIME_BITS=64 -D_FILE_OFFSET_BITS=64 \
	-I$(SYSROOT)/usr/include/libdrm
SETS_arm := arm font
# Small libraries go in; libc stays out, and GL is opened at run time. They
# want the sysroot's C library, which is newer than the cross compiler's own.
# libjpeg stays out too: it carries NEON code, which it uses where it finds
# NEON, but which would hide from the check below what limber itself needs.
PACKAGES_arm :=
LIBS_arm := -L$(SYSROOT)/usr/lib/arm-linux-gnueabi \
	-l:libjansson.a -l:libpng16.a -l:libz.a -l:libgif.a \
	-l:libgpiod.a -l:libdrm.a -l:libinih.a \
	-l:libjpeg.so -lm -ldl
RUN_arm := qemu-arm -cpu arm1136 -L $(SYSROOT)
build/sysroot.stamp: toolchain/sysroot.sh toolchain/packages/sysroot.txt \
		toolchain/packages/arm.txt | build
	$(Q)toolchain/install.sh arm
	$(call say,SYSROOT,$(SYSROOT))
	$(Q)toolchain/sysroot.sh $(SYSROOT)
	$(Q)touch $@

build/arm/packages.stamp: build/sysroot.stamp

# The board's core has neither ARMv7 nor NEON: refuse a binary that wants them.
build/arm/limber: CHECK_BINARY = toolchain/check-arm.sh $(ARM_PREFIX)readelf $@
