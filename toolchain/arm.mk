# The target arm: the board's ARM1136JF-S, against a Debian 13 armel sysroot. The
# defines for 64-bit time match that release's ABI.

SYSROOT := build/sysroot
ARM_PREFIX := arm-linux-gnueabi-

CC_arm := $(ARM_PREFIX)gcc --sysroot=$(SYSROOT)
CFLAGS_arm ?= -O2 -g
CFLAGS_arm += -mcpu=arm1136jf-s -mfpu=vfpv2 -mfloat-abi=softfp -marm \
	$(HARDENING) -D_TIME_BITS=64 -D_FILE_OFFSET_BITS=64 \
	-I$(SYSROOT)/usr/include/libdrm
SETS_arm := arm font
# Small libraries are linked in. libc is not: they need the sysroot's, which is
# newer than the cross compiler's own. GL is opened at run time. libjpeg is not
# linked in either: it contains NEON code, used only where NEON is found, which
# would make the check below fail.
PACKAGES_arm :=
LIBS_arm := -L$(SYSROOT)/usr/lib/arm-linux-gnueabi \
	-l:libjansson.a -l:libpng16.a -l:libz.a -l:libgif.a \
	-l:libgpiod.a -l:libdrm.a -l:libinih.a \
	-l:libjpeg.so -lm -ldl $(HARDENING_LIBS)
TEST_LDFLAGS_arm = -Wl,--strip-debug $(CHECKED_LOCKS) $(call gold,$(ARM_PREFIX)ld.gold)
RUN_arm := qemu-arm -cpu arm1136 -L $(SYSROOT)
build/sysroot.stamp: toolchain/sysroot.sh toolchain/packages/sysroot.txt \
		toolchain/packages/sysroot.sha256 \
		toolchain/packages/arm.txt | build
	$(Q)toolchain/install.sh arm
	$(call say,SYSROOT,$(SYSROOT))
	$(Q)toolchain/sysroot.sh $(SYSROOT)
	$(Q)touch $@

build/arm/packages.stamp: build/sysroot.stamp

# Accepts the packages of the sysroot as those that limber is made with.
.PHONY: sysroot-record
sysroot-record: build/sysroot.stamp
	cp $(SYSROOT)/packages.sha256 toolchain/packages/sysroot.sha256

# The board's core has neither ARMv7 nor NEON; a binary that needs them fails.
build/arm/limber: CHECK_BINARY = toolchain/check-arm.sh $(ARM_PREFIX)readelf $@

# Offsets of structures for the soft driver's assembly, from the compiler's.
build/arm/gen/platform/gl/soft/arm/offsets.h: platform/gl/soft/arm/offsets.inc | \
		build/arm/packages.stamp
	@mkdir -p $(@D)
	$(call say,OFFSETS,$@)
	$(Q)$(CC_arm) $(COMMON_CFLAGS) $(CFLAGS_arm) -g0 -I. -MMD -MP -MT $@ \
		-MF $@.d -S -x c -o $@.s $<
	$(Q)sed -n 's/^->\([A-Z0-9_]*\) #*\(-*[0-9]*\)$$/#define \1 \2/p' \
		$@.s >$@
-include build/arm/gen/platform/gl/soft/arm/offsets.h.d
$(patsubst %.S,build/arm/obj/%.o,$(wildcard platform/gl/soft/arm/*.S)): \
	build/arm/gen/platform/gl/soft/arm/offsets.h
