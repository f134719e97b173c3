# The targets host and asan: this machine, without and with the sanitizers.

WARNINGS := -Wall -Wextra -Wshadow -Wstrict-prototypes -Wmissing-prototypes \
	-Wpointer-arith -Wvla -Wwrite-strings -Werror
COMMON_CFLAGS := -std=c11 -D_POSIX_C_SOURCE=200809L -DCGLM_ALL_UNALIGNED \
	-ffp-contract=off -fno-math-errno $(WARNINGS)

CC_host ?= gcc
CFLAGS_host ?= -O2 -g
SETS_host := host font
PACKAGES_host := jansson libpng libjpeg sdl2 zlib libgpiod libdrm inih
LIBS_host := -lgif -lm -ldl
RUN_host :=

# The sanitizers check memory accesses, leaks and undefined behaviour.
CC_asan := gcc
CFLAGS_asan := -O1 -g -fno-omit-frame-pointer \
	-fsanitize=address,undefined,float-cast-overflow \
	-fno-sanitize-recover=all
SETS_asan := host font
PACKAGES_asan := $(PACKAGES_host)
LIBS_asan := $(LIBS_host) -fsanitize=address,undefined
RUN_asan :=
GL_DRIVERS_asan := $(GL_DRIVERS_host)
DISPLAY_DRIVERS_asan := $(DISPLAY_DRIVERS_host)
BUTTON_DRIVERS_asan := $(BUTTON_DRIVERS_host)
CAMERA_DRIVERS_asan := $(CAMERA_DRIVERS_host)
