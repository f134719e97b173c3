# make coverage: the lines of app and platform that the tests on this machine
# reach, as a table by folder and as pages in build/coverage/html.

CC_coverage := gcc
# Without optimization GCC cannot tell what is initialized. With -g the tests would
# take 42 GB.
CFLAGS_coverage := -O0 --coverage -fprofile-update=atomic \
	-Wno-maybe-uninitialized
# The span template takes GCC minutes and gigabytes without optimization.
build/coverage/obj/platform/gl/soft/span/%: CFLAGS_coverage += -O1
# A confined program may write its counters, too.
build/coverage/obj/platform/process/confine_files.o: \
	CFLAGS_coverage += -DCOUNTERS='"$(CURDIR)/build/coverage/obj/counters"'
SETS_coverage := host font coverage
PACKAGES_coverage := $(PACKAGES_host)
OPENED_coverage := $(OPENED_host)
LIBS_coverage := -lgif -lm -ldl --coverage
RUN_coverage :=
GL_DRIVERS_coverage := $(GL_DRIVERS_host)
DISPLAY_DRIVERS_coverage := $(DISPLAY_DRIVERS_host)
BUTTON_DRIVERS_coverage := $(BUTTON_DRIVERS_host)
CAMERA_DRIVERS_coverage := $(CAMERA_DRIVERS_host)
KERNELS_coverage := $(KERNELS_host)
JOINT_SOURCES_coverage := $(JOINT_SOURCES_host)
GPIOD_API_coverage := $(GPIOD_API_host)
SOFT_ROWS_coverage := portable
TESTS_coverage := $(TESTS)
$(eval $(call target_rules,coverage))
$(eval $(call fake_gles_rules,coverage))
$(foreach generation,1 2,$(eval $(call gpiod_test,coverage,$(generation))))

.PRECIOUS: build/coverage/obj/%.o

COVERAGE := build/coverage
coverage_suites = $(call unit_suites,coverage) \
	$(call script_suites,cli,coverage/,LIMBER=build/coverage/limber) \
	$(call golden_suite,coverage,soft) \
	$(call conformance_suite,coverage) $(call xfile_suite,coverage) \
	$(call suite,faults/coverage,$(FAULTS_RUN) build/coverage/limber --most 1)

.PHONY: coverage coverage-build
coverage-build: build/coverage/limber build/host/compare_png \
		build/host/conformance $(FAULTS) \
		$(TESTS:%=build/coverage/unit/%)

# A suite that fails here is one that make check names; the figure counts anyway.
coverage: | build
	$(Q)toolchain/install.sh coverage
	$(Q)date +%s >build/coverage-began
	+$(Q)$(make_all) coverage-build
	$(file >build/coverage-suites,$(coverage_suites))
	$(Q)sed -i 's/^ *//; /^$$/d' build/coverage-suites
	$(Q)find $(COVERAGE)/obj -name '*.gcda' -delete
	-$(Q)BEGAN=$$(cat build/coverage-began) $(CHECK_ENVIRONMENT) \
		tests/support/tally/tally.sh build/coverage-suites \
		$(CHECK)/coverage $(processors)
	$(Q)python3 -B toolchain/coverage.py $(COVERAGE)
