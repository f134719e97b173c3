# The sources of limber, and the drivers of each target. The registries are
# generated from these lists, so the code of drivers needs no #ifdef.

# The C files of folders and of the folders in them.
c_files = $(sort $(shell find $(1) -name '*.c'))

# Folders named after an architecture are chosen below, for each target.
APP_SOURCES := $(filter-out app/main.c app/anim/arm/% app/anim/portable/% \
	app/anim/kernel/arm/%,$(call c_files,app))
BASE_SOURCES := $(call c_files,platform/base platform/process)
# Files beside a registry are shared by its drivers.
SEAM_SOURCES := $(sort $(wildcard platform/gl/*.c platform/display/*.c \
	platform/buttons/*.c platform/camera/*.c platform/watchdog/*.c))
FONT_SOURCE := build/gen/font_data.c
PLAYER_SOURCE := build/gen/player_text.c
SHARED_SOURCES := $(APP_SOURCES) $(BASE_SOURCES) $(SEAM_SOURCES) $(FONT_SOURCE) \
	$(PLAYER_SOURCE)

# The loops over joints: C, or for ARM11 cores assembly (choose.c).
JOINT_SOURCES_host := app/anim/portable/joints.c app/anim/portable/turns.c
JOINT_SOURCES_asan := $(JOINT_SOURCES_host)
JOINT_SOURCES_fuzz := $(JOINT_SOURCES_host)
JOINT_SOURCES_arm := app/anim/arm/joints.S app/anim/arm/turns.S \
	$(addprefix app/anim/arm/,choose.c joints_c.c turns_c.c)

# Drivers, best first. A driver NAME is the folder platform/SEAM/NAME and
# exports SEAM_driver_NAME.
GL_DRIVERS_host := gles1 soft osmesa
DISPLAY_DRIVERS_host := window kms fbdev egl image null
BUTTON_DRIVERS_host := script gpiod evdev
CAMERA_DRIVERS_host := v4l2 pattern

GL_DRIVERS_arm := gles1 soft osmesa
DISPLAY_DRIVERS_arm := kms fbdev egl image null
BUTTON_DRIVERS_arm := script gpiod evdev
CAMERA_DRIVERS_arm := v4l2 pattern

# Vertex kernels, best first; NAME exports kernel_NAME. Assembly is for the board
# alone. On a PC, fixed point updates CesiumMan 1.3 times, the walker 1.35 times
# and the face 1.4 times as fast as float (median of 301 frames).
KERNELS_host := fixed float an4044
KERNELS_asan := $(KERNELS_host)
KERNELS_arm := armv6 fixed float an4044
KERNELS_fuzz := $(KERNELS_host)
KERNEL_SOURCES_arm := $(sort $(wildcard app/anim/kernel/arm/*.[cS]))

# The fuzz targets need only the drivers that they test.
GL_DRIVERS_fuzz := soft
DISPLAY_DRIVERS_fuzz := kms fbdev image null
CAMERA_DRIVERS_fuzz := v4l2 pattern
BUTTON_DRIVERS_fuzz := script gpiod evdev

# The gpiod driver has a part for each generation of libgpiod. This machine's
# generation is looked up (Debian 12 has 1.6); the sysroot has 2.x.
GPIOD_API_host := $(or $(firstword $(subst ., ,$(shell \
	pkg-config --modversion libgpiod 2>/dev/null))),1)
GPIOD_API_asan := $(GPIOD_API_host)
GPIOD_API_fuzz := $(GPIOD_API_host)
GPIOD_API_arm := 2

# How the soft driver walks rows: a folder of platform/gl/soft.
SOFT_ROWS_host := portable
SOFT_ROWS_arm := arm
SOFT_ROWS_asan := portable
SOFT_ROWS_fuzz := portable

# $(call seam_driver_sources,SEAM,NAMES): all but the folders of which a target
# takes one.
one_of_several := platform/gl/soft/arm/% platform/gl/soft/portable/% \
	platform/buttons/gpiod/v1/% platform/buttons/gpiod/v2/%
seam_driver_sources = $(filter-out $(one_of_several),$(foreach name,$(2),\
	$(call c_files,platform/$(1)/$(name))))
soft_row_sources = $(if $(filter soft,$(GL_DRIVERS_$(1))),$(sort $(wildcard \
	$(patsubst %,platform/gl/soft/$(SOFT_ROWS_$(1))/*.%,c S))))
driver_sources = $(call seam_driver_sources,gl,$(GL_DRIVERS_$(1))) \
	$(call soft_row_sources,$(1)) \
	$(call seam_driver_sources,display,$(DISPLAY_DRIVERS_$(1))) \
	$(call seam_driver_sources,buttons,$(BUTTON_DRIVERS_$(1))) \
	$(call seam_driver_sources,camera,$(CAMERA_DRIVERS_$(1))) \
	$(if $(filter gpiod,$(BUTTON_DRIVERS_$(1))),\
	platform/buttons/gpiod/v$(GPIOD_API_$(1))/gpio_v$(GPIOD_API_$(1)).c)

TEST_SOURCES := $(filter %.c,$(call c_files,tests/unit))
SUPPORT_SOURCES := $(call c_files,tests/support)
# What tests/support/locks.c checks.
CHECKED_LOCKS := -Wl,--wrap=pthread_mutex_unlock -Wl,--wrap=pthread_cond_wait \
	-Wl,--wrap=pthread_cond_timedwait
# Links tests in half of the time, where this linker is installed.
gold = $(if $(shell command -v $(1)),-fuse-ld=gold)
