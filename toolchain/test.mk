# make test: the quick part of make check, for the loop of editing and trying.
# It builds for this machine alone and runs the unit tests and the tests of the
# command line. T="NAME..." picks tests by name; a name may contain *.

T ?=
CLI_SCRIPTS := $(sort $(wildcard tests/cli/*.sh))
test_names := $(patsubst tests/%.sh,%,$(CLI_SCRIPTS)) $(TESTS)

# The test test_clip answers to "clip", too, and cli/usage to "usage".
called = $(filter $(1) test_$(1) cli/$(1),$(test_names))
test_patterns := $(subst *,%,$(T))
test_picked := $(if $(test_patterns),$(sort $(foreach pattern,\
	$(test_patterns),$(call called,$(pattern)))),$(test_names))
test_unknown := $(strip $(subst %,*,$(foreach pattern,$(test_patterns),\
	$(if $(call called,$(pattern)),,$(pattern)))))

define TEST_SUITES
$(foreach script,$(filter cli/%,$(test_picked)),$(call \
	suite,$(script),LIMBER=build/host/limber tests/$(script).sh))
$(foreach test,$(filter test_%,$(test_picked)),$(call \
	suite,$(test),build/host/unit/$(test)))
endef

.PHONY: test test-build
test-build: build/host/limber build/test-packages.stamp \
		$(patsubst %,build/host/unit/%,$(filter test_%,$(test_picked))) \
		$(if $(filter cli/egl,$(test_picked)),build/host/unit/fake_gles.so)

# Without T, a suite that passed is run again only after its program, the
# script or one of the files that tests read has changed (support/tally/suite.sh).
test: | build
	$(Q)$(if $(test_unknown),tests/support/tally/close_names.sh \
		"$(test_unknown)" $(test_names))
	$(Q)date +%s >build/test-began
	+$(Q)$(make_all) test-build || { echo; \
		echo 'The build failed, so no test ran.'; \
		echo '0 passed, 1 failed'; exit 1; }
	$(file >build/test-suites,$(TEST_SUITES))
	$(Q)sed -i 's/^ *//; /^$$/d' build/test-suites
	$(Q)BEGAN=$$(cat build/test-began) \
		REMEMBER=$(if $(T),,$$({ id -u; find tests assets $(SAMPLES) \
		-name '*.pyc' -prune -o -path tests/unit -prune -o -type f \
		-printf '%p %s %T@\n' 2>&1 | sort; } | sha256sum | cut -c 1-64)) \
		$(CHECK_ENVIRONMENT) tests/support/tally/tally.sh \
		build/test-suites build/test$(if $(T),-one) $(processors)
