# The timing model of the board's core: a plugin for qemu-arm, and the small
# programs that test it (tests/arm1136/README.md).

MODEL_SOURCES := $(sort $(wildcard tests/arm1136/core/*.c)) \
	$(addprefix tests/arm1136/,plugin.c program.c report.c symbols.c)
MODEL_OBJECTS := $(MODEL_SOURCES:%.c=build/arm1136/obj/%.o)
MODEL := build/arm1136/model.so

# The model is optimized as a whole: its files call each other for every
# instruction.
MODEL_CFLAGS := -O3 -g -flto -fPIC -fvisibility=hidden

build/arm1136/obj/%.o: %.c | build/host/packages.stamp
	@mkdir -p $(@D)
	$(call say,CC,$@)
	$(Q)$(CC_host) $(COMMON_CFLAGS) $(MODEL_CFLAGS) -I. -MMD -MP -c -o $@ $<

$(MODEL): $(MODEL_OBJECTS)
	$(call say,LINK,$@)
	$(Q)$(CC_host) $(MODEL_CFLAGS) -shared -o $@ $^

-include $(MODEL_OBJECTS:.o=.d)

# The test programs use no C library, so they need no sysroot.
MICRO_CFLAGS := -mcpu=arm1136jf-s -mfpu=vfpv2 -mfloat-abi=softfp -marm
MICRO := $(patsubst tests/arm1136/micro/%.S,build/arm1136/micro/%,\
	$(sort $(wildcard tests/arm1136/micro/*.S)))

build/arm1136/micro/%: tests/arm1136/micro/%.S tests/arm1136/micro/cases.h \
		tests/arm1136/marker.h | build/arm/packages.stamp
	@mkdir -p $(@D)
	$(call say,AS,$@)
	$(Q)$(ARM_PREFIX)gcc $(MICRO_CFLAGS) -I. -nostdlib -static -o $@ $<

build/arm1136/unknown build/arm1136/regions: build/arm1136/%: \
		tests/arm1136/%.S tests/arm1136/marker.h | build/arm/packages.stamp
	@mkdir -p $(@D)
	$(call say,AS,$@)
	$(Q)$(ARM_PREFIX)gcc $(MICRO_CFLAGS) -I. -nostdlib -static -o $@ $<

# AN4044's skinning loop, optimized as the board's loops are.
build/arm1136/an4044: tests/arm1136/an4044_run.c app/anim/kernel/an4044.c \
		app/anim/kernel/an4044.h tests/arm1136/marker.h \
		| build/arm/packages.stamp
	@mkdir -p $(@D)
	$(call say,CC,$@)
	$(Q)$(ARM_PREFIX)gcc $(COMMON_CFLAGS) -O3 $(MICRO_CFLAGS) -I. \
		-nostdlib -static -o $@ $(filter %.c,$^)

model_programs := $(MODEL) $(MICRO) build/arm1136/an4044 build/arm1136/unknown \
	build/arm1136/regions build/arm1136/insn_count.so
model_suites = $(foreach program,$(MICRO),$(call suite,arm1136/$(notdir \
	$(program)),tests/arm1136/micro.sh $(MODEL) $(program) \
	tests/arm1136/micro/$(notdir $(program)).S)) \
	$(call suite,arm1136/plugin,tests/arm1136/plugin.sh $(MODEL) \
	build/arm1136/an4044 build/arm1136/unknown build/arm1136/regions) \
	$(call suite,arm1136/growth,tests/arm1136/growth.py build/arm1136/insn_count.so \
	$(RUN_arm) build/arm/limber) \
	$(call suite,arm1136/checker,tests/arm1136/checker.sh $(MODEL) \
	build/arm1136/micro)
