# The gpiod driver is tested with both generations of libgpiod, on every target,
# each with its own header and a made-up library (tests/gpiod). The header of 1.x
# is this machine's, that of 2.x the sysroot's.

GPIOD_HEADER_1 = $(shell pkg-config --variable=includedir libgpiod)/gpiod.h
GPIOD_HEADER_2 := $(SYSROOT)/usr/include/gpiod.h

build/gen/gpiod_v1/gpiod.h: | build/host/packages.stamp
build/gen/gpiod_v2/gpiod.h: | build/sysroot.stamp
build/gen/gpiod_v%/gpiod.h:
	@mkdir -p $(@D)
	$(Q)cp $(GPIOD_HEADER_$*) $@

# $(call gpiod_test,TARGET,GENERATION)
define gpiod_test
GPIOD_OBJECTS_$(1)_$(2) := $(patsubst %.c,build/$(1)/obj/gpiod_v$(2)/%.o,\
	platform/buttons/gpiod/v$(2)/gpio_v$(2).c \
	$(addprefix tests/gpiod/,bench.c cases.c lost_cases.c output_cases.c fake.c fake_v$(2).c))

build/$(1)/obj/gpiod_v$(2)/%.o: %.c build/gen/gpiod_v$(2)/gpiod.h \
		| build/$(1)/packages.stamp build/test-packages.stamp
	@mkdir -p $$(@D)
	$$(call say,CC,$$@)
	$$(Q)$$(CC_$(1)) $$(COMMON_CFLAGS) $$(CFLAGS_$(1)) -I. \
		-Ibuild/gen/gpiod_v$(2) @build/$(1)/cflags -MMD -MP -c -o $$@ $$<

$(addprefix build/$(1)/unit/test_gpiod_,v$(2) lost_v$(2) output_v$(2)): \
		$$(GPIOD_OBJECTS_$(1)_$(2))
endef
$(foreach target,$(TARGETS),$(foreach generation,1 2,\
	$(eval $(call gpiod_test,$(target),$(generation)))))
