# What limber is made of. Which drivers a target has is a list here, not an
# #ifdef in their code; the registries are generated from these lists.

APP_SOURCES := $(filter-out app/main.c,$(sort $(wildcard app/*/*.c \
	app/anim/kernel/*.c)))
BASE_SOURCES := $(sort $(wildcard platform/base/*.c))
SEAM_SOURCES := platform/gl/registry.c platform/display/registry.c \
	platform/buttons/registry.c
SHARED_SOURCES := $(APP_SOURCES) $(BASE_SOURCES) $(SEAM_SOURCES) \
	$(sort $(wildcard platform/gl/common/*.c platform/display/common/*.c \
	platform/buttons/common/*.c))

# Drivers, best first. A driver NAME is platform/SEAM/NAME.c and exports
# SEAM_driver_NAME.
GL_DRIVERS_host :=
DISPLAY_DRIVERS_host :=
BUTTON_DRIVERS_host :=

GL_DRIVERS_arm :=
DISPLAY_DRIVERS_arm :=
BUTTON_DRIVERS_arm :=

driver_sources = $(patsubst %,platform/gl/%.c,$(GL_DRIVERS_$(1))) \
	$(patsubst %,platform/display/%.c,$(DISPLAY_DRIVERS_$(1))) \
	$(patsubst %,platform/buttons/%.c,$(BUTTON_DRIVERS_$(1)))

TEST_SOURCES := $(sort $(wildcard tests/unit/test_*.c))
SUPPORT_SOURCES := $(sort $(wildcard tests/support/*.c))
