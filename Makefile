# limber: 3D character animation for ARM11 boards. `make help` lists what this
# file can do. Everything it makes goes below build/.

MAKEFLAGS += --no-builtin-rules
.SUFFIXES:
.DELETE_ON_ERROR:
SHELL := /bin/sh

# Commands name this folder between apostrophes.
ifneq ($(findstring ',$(CURDIR)),)
$(error limber cannot be built in a folder whose path has an apostrophe: rename it)
endif

# V=1 shows the commands.
V ?= 0
Q := $(if $(filter 1,$(V)),,@)
say = $(if $(filter 1,$(V)),,@printf '  %-7s %s\n' $(1) $(2))

.PHONY: host arm demo check golden assets help clean
host: build/host/limber
arm: build/arm/limber

include toolchain/sources.mk
include toolchain/host.mk
include toolchain/arm.mk
include toolchain/build.mk
include toolchain/arm1136.mk
include toolchain/bench.mk
include toolchain/board.mk
include toolchain/check.mk
include toolchain/trust.mk
include toolchain/test.mk
include toolchain/gpiod.mk
include toolchain/coverage.mk
include toolchain/demo.mk
include toolchain/package.mk

help:
	@cat toolchain/help.txt

clean:
	rm -rf build
