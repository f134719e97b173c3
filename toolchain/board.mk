# The i.MX31 PDK's image, its emulation, and the tests of both.

BOARD := board/imx31-pdk
IMAGE := build/$(BOARD)
KERNEL_SOURCE ?= /usr/src/linux-source-6.1.tar.xz

build/board/packages.stamp: toolchain/packages/board.txt
	$(Q)mkdir -p $(@D)
	$(Q)toolchain/install.sh board
	$(Q)touch $@

# Phony, because the scripts themselves find out what has changed.
.PHONY: kernel image emulate emulator bench-board soak power-cuts
kernel: build/board/packages.stamp build/arm/packages.stamp
	$(call say,KERNEL,build/linux/zImage)
	$(Q)$(BOARD)/kernel/build.sh $(KERNEL_SOURCE) build/linux

image: kernel build/arm/limber build/host/limber
	$(call say,IMAGE,$(IMAGE))
	$(Q)$(BOARD)/image.sh build/linux build/sysroot build/arm/limber \
		build/host/limber $(IMAGE)

# QEMU with the machine imx31-pdk; where it cannot be built, the emulation uses
# the installed one. EMULATOR=kzm does not need it.
emulator: build/board/packages.stamp build/qemu/packages.stamp
ifneq ($(EMULATOR),kzm)
	$(call say,QEMU,build/qemu/qemu-system-arm)
	$(Q)$(BOARD)/qemu/build.sh build/qemu
endif

build/qemu/packages.stamp: toolchain/packages/qemu.txt
	$(Q)mkdir -p $(@D)
	$(Q)toolchain/install.sh qemu
	$(Q)touch $@

emulate: image emulator
	$(Q)$(BOARD)/emulate run

build/virtual-pdk/packages.stamp: toolchain/packages/virtual.txt
	$(Q)mkdir -p $(@D)
	$(Q)toolchain/install.sh virtual
	$(Q)touch $@

# PORT=NUMBER serves the page on another port than 8031.
.PHONY: virtual-pdk screenshots screenshots-virtual-pdk
virtual-pdk: image emulator build/virtual-pdk/packages.stamp
	$(Q)exec $(BOARD)/virtual/serve $(if $(PORT),--port $(PORT))

# The library with which the page's test drives a browser, outside the sources.
build/virtual-pdk-test/stamp: $(addprefix tests/virtual-pdk/,package.json \
		package-lock.json .npmrc) toolchain/packages/browser.txt
	@mkdir -p $(@D)
	$(Q)toolchain/install.sh browser virtual
	$(call say,NPM,$(@D))
	$(Q)cp $(filter tests/%,$^) $(@D)
	$(Q)cd $(@D) && npm ci --loglevel=error --no-audit --no-fund >npm.log
	$(Q)touch $@

virtual_pdk_node := NODE_PATH=build/virtual-pdk-test/node_modules node
virtual_pdk_suite = $(call suite,virtual-pdk,$(virtual_pdk_node) \
	tests/virtual-pdk/test.js) \
	$(call suite,virtual-pdk-board,/usr/bin/python3 -B tests/virtual-pdk/test_board.py)

# demo.mk draws the other pictures of make screenshots.
screenshots: screenshots-virtual-pdk
screenshots-virtual-pdk: image emulator build/virtual-pdk-test/stamp
	$(call say,PICTURE,$(BOARD)/virtual/page.png)
	$(Q)$(virtual_pdk_node) tests/virtual-pdk/picture.js \
		$(BOARD)/virtual/page.png

bench-board: image emulator build/arm/bench/demo_frames build/arm1136/insn_count.so
	$(Q)PATIENCE_S=3000 python3 -B tests/board/bench.py build/bench-board.json
	@echo "The same for programs: build/bench-board.json"

# The program that the tests run on the board, beside limber.
build/board/guest: tests/board/guest.c build/arm/packages.stamp build/sysroot.stamp
	@mkdir -p $(@D)
	$(call say,CC,$@)
	$(Q)$(CC_arm) $(WARNINGS) -std=c11 -D_DEFAULT_SOURCE -O2 \
		$(filter-out -g -O2,$(CFLAGS_arm)) -o $@ $<

# Debian's kernel for the Raspberry Pi Zero, its device tree and two drivers
# for keyboards, for the test of that board.
PI := build/raspberry-pi
$(PI)/stamp: toolchain/sysroot.sh toolchain/packages/raspberry-pi.txt \
		toolchain/packages/arm.txt
	@mkdir -p $(@D)
	$(Q)toolchain/install.sh arm
	$(call say,KERNEL,$(PI))
	$(Q)PACKAGES=toolchain/packages/raspberry-pi.txt RECORD= \
		toolchain/sysroot.sh $(PI)/packages
	$(Q)cp $(PI)/packages/boot/vmlinuz-* $(PI)/vmlinuz
	$(Q)cp $(PI)/packages/usr/lib/linux-image-*/bcm2835-rpi-zero.dtb $(PI)
	$(Q)for name in evdev uinput; do \
		find $(PI)/packages -name $$name.ko.xz -exec xz -dc {} + \
		>$(PI)/$$name.ko || exit 1; done
	$(Q)rm -rf $(PI)/packages
	$(Q)touch $@

# SOAK_S is the length in seconds of the board's time; SOAK_SEED=N gives other
# buttons.
soak: image emulator build/board/guest
	$(Q)SOAK_S=$(or $(SOAK_S),1800) PATIENCE_S=1000000 \
		python3 -B tests/board/test_soak.py

# More moments of a power cut during flash.sh write than make check has time for.
power-cuts: image emulator
	$(Q)CUTS=$(or $(CUTS),50) PATIENCE_S=10000 \
		python3 -B tests/board/test_power_cut.py

board_suites = $(foreach test,$(sort $(wildcard tests/board/test_*.py)),\
	$(call suite,board/$(patsubst test_%.py,%,$(notdir $(test))),\
	python3 -B $(test))) \
	$(call suite,other-boards/raspberry-pi,\
	python3 -B tests/other-boards/raspberry_pi.py)
