# make check builds everything, runs every suite and counts the tests.
# tests/README.md says what the suites are.

# Sample models and reference poses that are not part of the project.
SAMPLES ?= ../shared
CHECK := build/check

# The fuzz targets are built by clang, which has libFuzzer.
CC_fuzz := clang-14
CFLAGS_fuzz := -O1 -gline-tables-only -fno-omit-frame-pointer \
	-fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow \
	-fno-sanitize-recover=all
# What reads files and devices shifts no bit out; fixed point and hashes do.
$(foreach folder,app/model app/character platform/camera platform/display,\
	build/fuzz/obj/$(folder)/%): CFLAGS_fuzz += -fsanitize=unsigned-shift-base
# Clang takes twice as long for optimized code in which all comparisons are counted.
# Without optimization, only what draws and converts pixels would run far slower.
build/fuzz/obj/app/%: CFLAGS_fuzz += -O0
# As in the sanitizers' build (host.mk).
build/fuzz/obj/platform/gl/soft/span/spans_%.o \
	build/fuzz/obj/platform/gl/soft/stages/spans_%.o: CFLAGS_fuzz += -DSOFT_SHARED_TEXT
SETS_fuzz := host font fuzz
PACKAGES_fuzz := jansson libpng libjpeg zlib libgpiod libdrm inih
LIBS_fuzz := -lgif -lm -ldl
$(eval $(call target_rules,fuzz))

# Targets that load models change glTF as JSON.
build/fuzz/fuzz_gltf build/fuzz/fuzz_command: \
	build/fuzz/obj/tests/fuzz/gltf_mutator.o
build/fuzz/fuzz_gl: build/fuzz/obj/tests/fuzz/fuzz_gl_calls.o
build/fuzz/fuzz_device: $(patsubst %,build/fuzz/obj/tests/fuzz/%_calls.o,\
	fuzz_device fuzz_device_kms fuzz_device_gpio)

build/fuzz/fuzz_%: build/fuzz/obj/tests/fuzz/fuzz_%.o build/fuzz/liblimber.a
	$(call say,LINK,$@)
	$(Q)$(CC_fuzz) $(CFLAGS_fuzz) -fsanitize=fuzzer -o $@ \
		$(filter %.o,$^) $(filter %.a,$^) @build/fuzz/libs $(LIBS_fuzz)

# Building a test installs the packages that tests need.
build/test-packages.stamp: toolchain/packages/test.txt | build
	$(Q)toolchain/install.sh test
	$(Q)touch $@
$(foreach target,$(TARGETS),$(patsubst %.c,build/$(target)/obj/%.o,\
	$(TEST_SOURCES) $(SUPPORT_SOURCES))): | build/test-packages.stamp

# Stand-ins for a vendor's GL, one of them with EGL 1.0, beside the tests.
FAKE_GLES := $(sort $(wildcard tests/fake_gles/*.c))
define fake_gles_rules
build/$(1)/unit/fake_gles.so: $$(FAKE_GLES)
build/$(1)/unit/fake_gles_old.so: $$(FAKE_GLES)
build/$(1)/unit/fake_gles_old.so: FAKE_GLES_DEFINES := -DFAKE_GLES_OLD
build/$(1)/unit/fake_gles.so build/$(1)/unit/fake_gles_old.so: \
		| build/$(1)/packages.stamp build/test-packages.stamp
	@mkdir -p $$(@D)
	$$(call say,LINK,$$@)
	$$(Q)$$(CC_$(1)) $$(COMMON_CFLAGS) $$(CFLAGS_$(1)) -I. -fPIC -shared \
		$$(FAKE_GLES_DEFINES) -o $$@ $$(FAKE_GLES)
build/$(1)/unit/test_display_egl build/$(1)/unit/test_survey_displays \
build/$(1)/unit/test_gl_drivers: \
		| build/$(1)/unit/fake_gles.so \
		build/$(1)/unit/fake_gles_old.so
endef
$(foreach target,$(TARGETS),$(eval $(call fake_gles_rules,$(target))))

# Programs that run limber and compare its output with references.
objects = $(patsubst %.c,build/host/obj/%.o,$(1))
build/host/conformance: $(call objects,$(wildcard tests/conformance/*.c))
build/host/compare_png: $(call objects,tests/golden/compare_png.c)
build/host/conformance build/host/compare_png: \
		$(call objects,$(SUPPORT_SOURCES)) build/host/liblimber.a
	$(call say,LINK,$@)
	$(Q)$(CC_host) $(CFLAGS_host) -o $@ $^ @build/host/libs $(LIBS_host) \
		-lcmocka

# The Khronos glTF validator, outside the sources.
build/validator/stamp: $(addprefix tests/validator/,package.json \
		package-lock.json .npmrc)
	@mkdir -p $(@D)
	$(call say,NPM,$(@D))
	$(Q)cp $^ $(@D)
	$(Q)cd $(@D) && npm ci --loglevel=error --no-audit --no-fund >npm.log
	$(Q)touch $@

define newline


endef
TESTS := $(basename $(notdir $(TEST_SOURCES)))
FUZZERS := $(patsubst tests/fuzz/%.c,%,$(filter-out %_calls.c,$(sort \
	$(wildcard tests/fuzz/fuzz_*.c))))

# A suite is a line with a name and a command (tests/support/tally/tally.sh).
suite = $(1) $(2)$(newline)
TESTS_host := $(TESTS)
# These judge what others run with the sanitizers, over thousands of pictures and poses.
TESTS_asan := $(filter-out test_framing test_framing_motion test_candidate_error \
	test_character_gait test_demo_crowd test_lod_models,$(TESTS))
# These, too, take minutes in qemu-arm. What they test is the same C in floats on every
# machine, as golden-exact, golden-films and golden-texts show on ARM: views and labels
# to the pixel, characters to the byte, and the figures of limber compare.
TESTS_arm := $(filter-out test_character_mistakes test_character_sketch \
	test_character_walker test_cloth test_crowd_costs test_demo_duel test_levels \
	test_levels_file test_optimize test_overlay test_overlay_place test_spring \
	test_tuner test_tuner_panel test_viewer_reload,$(TESTS_asan))
unit_suites = $(foreach test,$(or $(TESTS_$(1)),$(error TESTS_$(1) is not set)),$(call \
	suite,$(1)/$(test),$(RUN_$(1)) build/$(1)/unit/$(test)))
# Tests of what reads files, run by valgrind, which finds values that are used and
# were never written. The sanitizers do not.
MEMCHECK_TESTS := $(filter test_model_% test_xfile% test_levels_file test_split \
	test_config% test_preset_file test_option% test_%_spec \
	test_character_statements test_button%,$(TESTS))
memcheck_suites = $(foreach test,$(MEMCHECK_TESTS),$(call \
	suite,memcheck/$(test),valgrind --quiet --error-exitcode=9 \
	build/host/unit/$(test)))
# What two threads use without a lock shows in few runs, but to this tool in each.
helgrind_suites = $(foreach test,test_background test_jobs,$(call \
	suite,helgrind/$(test),valgrind --tool=helgrind --quiet \
	--error-exitcode=9 build/host/unit/$(test)))
conformance_suite = $(call suite,$(1)/conformance,build/host/conformance \
	$(SAMPLES) $(CHECK)/$(1) $(RUN_$(1)) build/$(1)/limber)
script_suites = $(foreach script,$(filter-out $(4),$(sort $(wildcard \
	tests/$(1)/*.sh))),$(call \
	suite,$(2)$(1)/$(basename $(notdir $(script))),$(3) $(script)))
exact_suite = $(call suite,$(1)/golden-exact,tests/golden/golden.sh exact \
	$(CHECK)/$(1)/golden-exact $(RUN_$(1)) build/$(1)/limber)
# On ARM some texts name other kernels or sizes of pointers, and some take minutes.
TEXTS_ARM := (?!film|.*walker|bench|wrong|help|buttons|(info|doctor)-m|.*coarse|compare-[efl])
texts_suite = $(call suite,$(1)/golden-$(2),TEXTS='$(3)' \
	tests/golden/texts.py check $(CHECK)/$(1)/golden-$(2) $(RUN_$(1)) \
	build/$(1)/limber)
xfile_suite = $(call suite,$(1)/conformance-x,tests/conformance/xfile.sh \
	$(SAMPLES) $(RUN_$(1)) build/$(1)/limber)
golden_suite = $(call suite,$(1)/golden-$(2),PICTURES='$(3)' tests/golden/golden.sh check $(2) \
	$(CHECK)/$(1)/golden-$(2) $(RUN_$(1)) build/$(1)/limber)
# Mesa takes seconds for each picture in qemu-arm, where it is softpipe. These use all
# of GL that the others do; golden-exact draws all of them on ARM.
empty :=
PICTURES_SOFTPIPE := $(subst $(empty) ,|,arm-1 walker-cape camera-screen show-wireframe \
	show-curve ground)

# Short suites come last, so that both processors are busy until the end.
define CHECK_SUITES
$(call suite,build,cat build/check-build.tap)
$(foreach fuzzer,$(FUZZERS),$(call \
	suite,fuzz/$(fuzzer),tests/fuzz/run.sh build/fuzz/$(fuzzer)))
$(call golden_suite,arm,softpipe,$(PICTURES_SOFTPIPE))
$(call golden_suite,host,osmesa)
$(call golden_suite,host,gles1)
$(call golden_suite,host,soft)
$(call exact_suite,host)
$(call exact_suite,arm)
$(call suite,arm/later-core,PICTURES='walker-1|arm-1' tests/golden/golden.sh check exact \
	$(CHECK)/arm/later-core $(RUN_arm:arm1136=cortex-a7) build/arm/limber)
$(call texts_suite,host,films,film-)
$(call texts_suite,host,texts,(?!film-))
$(call texts_suite,arm,films,film-(.*-(all|tour)|curves|effects|parts|states))
$(call texts_suite,arm,texts,$(TEXTS_ARM))
$(call xfile_suite,host)
$(call xfile_suite,asan)
$(call xfile_suite,arm)
$(call suite,conformance-fixed,tests/conformance/fixed.sh $(SAMPLES) \
	build/host/limber $(RUN_arm) build/arm/limber)
$(call conformance_suite,host)
$(call conformance_suite,asan)
$(call conformance_suite,arm)
$(call script_suites,cli,host/,LIMBER=build/host/limber)
$(call script_suites,cli,asan/,LIMBER=build/asan/limber)
$(call script_suites,cli,arm/,GL_DRIVERS=osmesa LIMBER="$(RUN_arm) build/arm/limber",\
	tests/cli/config.sh tests/cli/optimize.sh)
$(call suite,assets,NODE_PATH=build/validator/node_modules \
	node tests/validator/validate.js $(sort $(wildcard assets/*.glb)))
$(call script_suites,toolchain)
$(call script_suites,structure)
$(call script_suites,flash)
$(call script_suites,package)
$(call suite,conformance/checker,tests/conformance/checker.sh)
$(call suite,golden/checker,tests/golden/checker.sh)
$(call suite,fuzz/checker,tests/fuzz/checker.sh)
$(call suite,validator/exports,NODE_PATH=build/validator/node_modules \
	tests/validator/exports.sh build/host/limber assets/walker.glb@run \
	assets/face.glb@cycle tests/cli/slider.gltf \
	$(SAMPLES)/models/CesiumMan.glb)
$(call suite,validator/optimized,NODE_PATH=build/validator/node_modules \
	tests/validator/optimized.sh build/host/limber assets/walker.glb \
	assets/face.glb assets/arm.glb tests/cli/slider.gltf \
	tests/fixtures/gltf/mesh/levels.gltf \
	tests/fixtures/gltf/skin/and_morph.gltf $(SAMPLES)/models/CesiumMan.glb)
$(call suite,validator/checker,NODE_PATH=build/validator/node_modules \
	tests/validator/checker.sh)
$(call suite,tally,tests/support/tally/tally_test.sh)
$(model_suites)
$(bench_suites)
$(trust_suites)
$(board_suites)
$(virtual_pdk_suite)
$(call unit_suites,arm)
$(call unit_suites,asan)
$(memcheck_suites) $(helgrind_suites)
$(call unit_suites,host)
endef

# Tests run without a desktop and without this machine's options, in one locale;
# leaks of GL and desktop libraries do not count.
CHECK_ENVIRONMENT := env -u DISPLAY -u WAYLAND_DISPLAY LC_ALL=C.UTF-8 \
	LIMBER_CONFIG=none SAMPLES=$(SAMPLES) \
	CMOCKA_MESSAGE_OUTPUT=TAP UBSAN_OPTIONS=print_stacktrace=1 \
	LSAN_OPTIONS=print_suppressions=0:suppressions=tests/support/lsan.supp

.PHONY: check-build golden-build
check-build: image emulator bundle $(PI)/stamp build/host/limber build/asan/limber build/arm/limber \
		$(foreach target,$(TARGETS),$(patsubst \
		%,build/$(target)/unit/%,$(TESTS_$(target)))) \
		$(FUZZERS:%=build/fuzz/%) build/host/conformance \
		build/host/compare_png build/validator/stamp $(model_programs) $(BENCH_ARM) $(BENCH_MODELS) \
		build/board/guest build/virtual-pdk-test/stamp
golden-build: build/host/limber build/host/compare_png \
		build/host/unit/test_demo_runs build/host/unit/test_character_mistakes

# There are as many jobs as processors, unless make got -j.
processors := $(shell nproc)
# Some suites wait half of their time, for a board or a browser.
suites_at_once := $(shell echo $$((2 + $(processors))))
make_all := $(MAKE) --no-print-directory $(if $(findstring jobserver,$(MAKEFLAGS)),,-j$(processors))

check: | build
	$(Q)date +%s >build/check-began
	$(Q)toolchain/install.sh host font arm test fuzz check board \
		qemu package virtual browser
	+$(Q)result=ok; $(make_all) -k check-build || result='not ok'; \
		printf '1..1\n%s 1 - build\n' "$$result" >build/check-build.tap
	$(file >build/check-suites,$(CHECK_SUITES))
	$(Q)sed -i 's/^ *//; /^$$/d' build/check-suites
	$(Q)BEGAN=$$(cat build/check-began) $(CHECK_ENVIRONMENT) \
		tests/support/tally/tally.sh build/check-suites $(CHECK) $(suites_at_once)

golden: golden-build
	$(Q)$(CHECK_ENVIRONMENT) tests/golden/golden.sh make build/host/limber
	$(Q)$(CHECK_ENVIRONMENT) tests/golden/texts.py make build/host/limber
	$(Q)for test in test_demo_runs test_character_mistakes; do \
		$(CHECK_ENVIRONMENT) GOLDEN_WRITE=1 build/host/unit/$$test \
		>/dev/null || exit 1; done
