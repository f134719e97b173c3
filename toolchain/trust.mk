# make trust measures how well limber stands faults and hostile input; make check
# runs the short form of each part (SECURITY.md).

FAULTS := build/faults/faults.so
FAULTS_RUN := python3 -B tests/faults/faults.py $(FAULTS)

$(FAULTS): $(sort $(wildcard tests/faults/*.[ch])) | build/host/packages.stamp \
		build/host/unit/fake_gles.so
	@mkdir -p $(@D)
	$(call say,CC,$@)
	$(Q)$(CC_host) -std=c11 $(WARNINGS) -O1 -g -fno-omit-frame-pointer -fPIC \
		-shared -o $@ $(filter %.c,$^)

# In these programs each allocation of an arena takes a block of its own, and so can
# fail. Objects precede the library that has the usual arena.
build/faults/%/arena.o: platform/base/arena.c platform/base/arena.h \
		platform/base/memory_budget.h | build/%/packages.stamp
	@mkdir -p $(@D)
	$(call say,CC,$@)
	$(Q)$(CC_$*) $(COMMON_CFLAGS) $(CFLAGS_$*) -DARENA_SINGLE -I. -c -o $@ $<
.PRECIOUS: build/faults/%/arena.o
build/faults/%/limber: build/%/obj/app/main.o build/faults/%/arena.o \
		build/%/liblimber.a
	$(call say,LINK,$@)
	$(Q)$(CC_$*) $(CFLAGS_$*) -o $@ $^ @build/$*/libs $(LIBS_$*)

# The long form lets a call from each site fail, in each command; MOST=50 tries so
# many of each kind and command, and EVERY=--every each call, which takes days.
MOST ?= 0
EVERY ?=
.PHONY: faults
faults: $(FAULTS) build/faults/asan/limber
	$(Q)$(FAULTS_RUN) build/faults/asan/limber $(EVERY) --most $(MOST) \
		--table build/faults/table

# make fuzz SECONDS=N JOBS=2 runs each target for N seconds, and keeps the inputs
# that reached new code in build/fuzz/corpus, where the next run begins.
SECONDS ?= 60
JOBS ?= 1
fuzz_run = CORPUS=build/fuzz/corpus/$(1) SEED=0 RUNS=-1 FUZZ_SECONDS=$(SECONDS) \
	tests/fuzz/run.sh build/fuzz/$(1)
.PHONY: fuzz
fuzz: $(FUZZERS:%=build/fuzz/%)
	$(Q)printf '%s\n' $(FUZZERS) | xargs -P $(JOBS) -I '{}' \
		sh -c '$(call fuzz_run,{})'

# This build notes which functions each suite calls (tests/mutants/reach.py).
CC_reached := gcc
CFLAGS_reached := -O1 -g1 -fPIE -fno-inline -finstrument-functions \
	-Wno-maybe-uninitialized
SETS_reached := host font
PACKAGES_reached := $(PACKAGES_host)
OPENED_reached := $(OPENED_host)
LIBS_reached := $(LIBS_host)
GL_DRIVERS_reached := $(GL_DRIVERS_host)
DISPLAY_DRIVERS_reached := $(DISPLAY_DRIVERS_host)
BUTTON_DRIVERS_reached := $(BUTTON_DRIVERS_host)
CAMERA_DRIVERS_reached := $(CAMERA_DRIVERS_host)
KERNELS_reached := $(KERNELS_host)
JOINT_SOURCES_reached := $(JOINT_SOURCES_host)
GPIOD_API_reached := $(GPIOD_API_host)
# The span template takes GCC minutes when nothing is inlined.
build/reached/obj/platform/gl/soft/span/%: CFLAGS_reached := -O1 -fPIE
SOFT_ROWS_reached := $(SOFT_ROWS_host)
$(eval $(call target_rules,reached))

# make mutants N=100 SEED=s puts one small fault after another into a copy of the
# sources, and names those that no suite of this machine finds.
N ?= 100
SEED ?= $(shell date +%s)
.PHONY: mutants
mutants: build/host/limber build/test-packages.stamp
	$(Q)$(CHECK_ENVIRONMENT) SAMPLES=$(abspath $(SAMPLES)) \
		python3 -B tests/mutants/mutants.py --number $(N) --seed $(SEED) \
		$(FOLDER:%=--folder %) $(SUITES:%=--suites '%') \
		$(SUITE_S:%=--seconds %)

# make months DAYS=30 plays for a month whose hours last a second each.
DAYS ?= 30
MONTHS := build/months/host.so build/months/arm.so
build/months/%.so: tests/months/months.c | build/%/packages.stamp
	@mkdir -p $(@D)
	$(call say,CC,$@)
	$(Q)$(CC_$*) -std=c11 -D_GNU_SOURCE $(WARNINGS) $(CFLAGS_$*) -fPIC \
		-shared -o $@ $<
months_host = tests/months/months.py build/months/host.so build/host/limber
months_arm = PRELOAD="-E LD_PRELOAD=build/months/arm.so" \
	tests/months/months.py build/months/arm.so $(RUN_arm) build/arm/limber
.PHONY: months
months: $(MONTHS) build/host/limber build/arm/limber
	$(Q)DAYS=$(DAYS) $(months_host)
	$(Q)DAYS=$(DAYS) $(months_arm)

# Builds host, ARM, the packages and the image from two folders, and compares
# their bytes.
REPRODUCED ?= host arm deb image
.PHONY: reproduce trust
reproduce: build/sysroot.stamp
	$(Q)toolchain/reproduce.sh build/reproduce $(REPRODUCED)

# The table of SECURITY.md.
trust: $(FAULTS) build/faults/asan/limber build/host/limber build/arm/limber \
		build/months/host.so build/test-packages.stamp build/sysroot.stamp \
		$(FUZZERS:%=build/fuzz/%)
	$(Q)$(CHECK_ENVIRONMENT) SAMPLES=$(abspath $(SAMPLES)) MOST=$(MOST) \
		SECONDS=$(SECONDS) DAYS=$(DAYS) N=$(N) SEED=$(SEED) \
		REPRODUCED='$(REPRODUCED)' toolchain/trust.sh \
		$(FUZZERS:%=build/fuzz/%)

check-build: $(FAULTS) build/faults/asan/limber build/faults/host/limber $(MONTHS)
trust_suites = $(call suite,mutants/checker,tests/mutants/checker.sh) \
	$(call suite,months/host,DAYS=2 $(months_host)) \
	$(call suite,months/arm,DAYS=1 $(months_arm)) \
	$(call suite,faults/asan,$(FAULTS_RUN) build/faults/asan/limber \
	--once --own --frames 1 --most 25 --later 2 --jobs 1) \
	$(call suite,faults/host,$(FAULTS_RUN) build/faults/host/limber \
	--once --frames 2 --later 3 --jobs 1)
