# The rules of a target, instantiated for host, asan, arm and fuzz (check.mk).

TARGETS := host asan arm

build:
	$(Q)mkdir -p $@

# Writes a registry's list of drivers, unless the file has that content already.
define driver_list
	$(Q)for name in $(2); do echo "$(1)_DRIVER($$name)"; done >$@.new
	$(Q)cmp -s $@.new $@ && rm $@.new || mv $@.new $@
endef

# $(call flags_of,OPTION,PACKAGES): the command that prints a compiler's flags.
flags_of = $(if $(strip $(2)),pkg-config $(1) $(2))

# The file that sets a target's packages, where that is not host.mk.
packages_of_arm := arm
packages_of_fuzz := check
packages_of_coverage := coverage

define target_rules
OBJECTS_$(1) := $$(addprefix build/$(1)/obj/,$$(addsuffix .o,$$(basename \
	$$(SHARED_SOURCES) $$(call driver_sources,$(1)) \
	$$(KERNEL_SOURCES_$(1)) $$(JOINT_SOURCES_$(1)))))
LISTS_$(1) := build/$(1)/gen/gl_drivers.h build/$(1)/gen/display_drivers.h \
	build/$(1)/gen/button_drivers.h build/$(1)/gen/camera_drivers.h \
	build/$(1)/gen/kernel_drivers.h

build/$(1)/gen/gl_drivers.h: toolchain/sources.mk | build/$(1)/packages.stamp
	@mkdir -p $$(@D)
	$$(call driver_list,GL,$$(GL_DRIVERS_$(1)))
build/$(1)/gen/display_drivers.h: toolchain/sources.mk | build/$(1)/packages.stamp
	@mkdir -p $$(@D)
	$$(call driver_list,DISPLAY,$$(DISPLAY_DRIVERS_$(1)))
build/$(1)/gen/button_drivers.h: toolchain/sources.mk | build/$(1)/packages.stamp
	@mkdir -p $$(@D)
	$$(call driver_list,BUTTON,$$(BUTTON_DRIVERS_$(1)))
build/$(1)/gen/camera_drivers.h: toolchain/sources.mk | build/$(1)/packages.stamp
	@mkdir -p $$(@D)
	$$(call driver_list,CAMERA,$$(CAMERA_DRIVERS_$(1)))
build/$(1)/gen/kernel_drivers.h: toolchain/sources.mk | build/$(1)/packages.stamp
	@mkdir -p $$(@D)
	$$(call driver_list,KERNEL,$$(KERNELS_$(1)))

# Installs the target's packages, then asks pkg-config for the libraries' flags.
build/$(1)/packages.stamp: $$(patsubst %,toolchain/packages/%.txt,$$(SETS_$(1))) \
		toolchain/$(or $(packages_of_$(1)),host).mk toolchain/build.mk
	$$(Q)mkdir -p $$(@D)
	$$(Q)toolchain/install.sh $$(SETS_$(1))
	$$(Q)$$(call flags_of,--cflags,$$(PACKAGES_$(1)) $$(OPENED_$(1))) \
		>build/$(1)/cflags
	$$(Q)$$(call flags_of,--libs,$$(PACKAGES_$(1))) >build/$(1)/libs
	$$(Q)$$(call flags_of,--libs,$$(OPENED_$(1))) >build/$(1)/opened
	$$(Q)touch $$@

build/$(1)/obj/%.o: %.c | build/$(1)/packages.stamp $$(LISTS_$(1))
	@mkdir -p $$(@D)
	$$(call say,CC,$$@)
	$$(Q)$$(CC_$(1)) $$(COMMON_CFLAGS) $$(CFLAGS_$(1)) \
		-I. -Ibuild/$(1)/gen @build/$(1)/cflags -MMD -MP -c -o $$@ $$<

build/$(1)/obj/%.o: %.S | build/$(1)/packages.stamp
	@mkdir -p $$(@D)
	$$(call say,AS,$$@)
	$$(Q)$$(CC_$(1)) $$(CFLAGS_$(1)) -I. -Ibuild/$(1)/gen -MMD -MP \
		-c -o $$@ $$<

build/$(1)/liblimber.a: $$(OBJECTS_$(1))
	$$(call say,AR,$$@)
	$$(Q)rm -f $$@ && $$(if $$(filter arm,$(1)),$$(ARM_PREFIX))ar rcs $$@ $$^

build/$(1)/liblimber.so: $$(OBJECTS_$(1))
	$$(call say,LINK,$$@)
	$$(Q)$$(CC_$(1)) $$(CFLAGS_$(1)) -shared -o $$@ $$^ \
		@build/$(1)/libs $$(LIBS_$(1))

build/$(1)/limber: build/$(1)/obj/app/main.o build/$(1)/liblimber.a
	$$(call say,LINK,$$@)
	$$(Q)$$(CC_$(1)) $$(CFLAGS_$(1)) -o $$@ $$^ @build/$(1)/libs $$(LIBS_$(1))
	$$(Q)$$(CHECK_BINARY)

$$(foreach test,$$(TEST_SOURCES),$$(eval build/$(1)/unit/$$(basename \
	$$(notdir $$(test))): build/$(1)/obj/$$(test:.c=.o)))
# Objects precede the library, so that a test can replace one of its objects.
build/$(1)/unit/test_%: \
		$$(patsubst %.c,build/$(1)/obj/%.o,$$(SUPPORT_SOURCES)) \
		build/$(1)/$(or $(TEST_LIBRARY_$(1)),liblimber.a)
	@mkdir -p $$(@D)
	$$(call say,LINK,$$@)
	$$(Q)$$(CC_$(1)) $$(CFLAGS_$(1)) $$(TEST_LDFLAGS_$(1)) -o $$@ \
		$$(filter %.o,$$^) $$(filter %.a %.so,$$^) @build/$(1)/libs \
		$$(LIBS_$(1)) -lcmocka -Wl,--as-needed @build/$(1)/opened

-include $$(shell find build/$(1)/obj -name '*.d' 2>/dev/null)
endef

# The font of the labels is baked once, on this machine, for all targets.
FONT ?= /usr/share/fonts/opentype/inter/Inter-Medium.otf
FONT_SIZES := 12 16 24

build/gen/font.stamp: toolchain/packages/font.txt
	@mkdir -p $(@D)
	$(Q)toolchain/install.sh font
	$(Q)touch $@
build/gen/bake_font: toolchain/font/bake.c app/scene/hud/font.h | build/gen/font.stamp
	$(call say,CC,$@)
	$(Q)$(CC_host) $(COMMON_CFLAGS) -O1 -I. -o $@ $< \
		$$(pkg-config --cflags --libs freetype2)
$(FONT_SOURCE): build/gen/bake_font toolchain/build.mk
	$(call say,BAKE,$@)
	$(Q)$< $(FONT) $(FONT_SIZES) >$@

# The player that limber export writes, as a string.
$(PLAYER_SOURCE): app/embed/player.inc toolchain/build.mk
	@mkdir -p $(@D)
	$(call say,TEXT,$@)
	$(Q){ echo 'extern const char embed_player_text[];'; \
		echo 'const char embed_player_text[] ='; \
		sed 's/[\\"]/\\&/g; s/.*/"&\\n"/' $<; echo ';'; } >$@

# Make deletes none of the objects, although they are intermediate files.
.PRECIOUS: $(foreach target,$(TARGETS),build/$(target)/obj/%.o)
$(foreach target,$(TARGETS),$(eval $(call target_rules,$(target))))
