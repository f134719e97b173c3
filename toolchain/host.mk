# The targets host and asan: this machine, without and with the sanitizers.

WARNINGS := -Wall -Wextra -Wshadow -Wstrict-prototypes -Wmissing-prototypes \
	-Wpointer-arith -Wvla -Wwrite-strings -Wconversion -Werror
COMMON_CFLAGS := -std=c11 -D_POSIX_C_SOURCE=200809L -DCGLM_ALL_UNALIGNED \
	-ffp-contract=off -fno-math-errno $(WARNINGS)

# What makes an error in memory harder to exploit, on host and ARM: addresses
# that change with every run, tables of the linker that are read-only, checks of
# the stack and of the C library's functions. No path of this machine gets into
# the program (tests/package/hardening.sh).
HARDENING := -fPIE -fstack-protector-strong -U_FORTIFY_SOURCE \
	-D_FORTIFY_SOURCE=2 -Wdate-time '-ffile-prefix-map=$(CURDIR)=.'
HARDENING_LIBS := -pie -Wl,-z,relro,-z,now,-z,noexecstack

CC_host ?= gcc
CFLAGS_host ?= -O2 -g
CFLAGS_host += $(HARDENING)
SETS_host := host font
PACKAGES_host := jansson libpng libjpeg zlib libgpiod libdrm inih
# Libraries that limber opens at run time: only tests that call them link them.
OPENED_host := sdl2
LIBS_host := -lgif -lm -ldl $(HARDENING_LIBS)
RUN_host :=
# Two hundred test programs with debug information of their own would take 3 GB.
# With make TEST_LDFLAGS_host= a debugger knows their lines.
TEST_LDFLAGS_host = -Wl,--strip-debug $(CHECKED_LOCKS) $(call gold,ld.gold)

# The sanitizers check memory accesses, leaks and undefined behaviour. Their reports
# need lines alone: to follow variables, too, takes GCC two thirds more time.
CC_asan := gcc
CFLAGS_asan := -O1 -g1 -fno-omit-frame-pointer -fPIC \
	-fsanitize=address,undefined,float-cast-overflow \
	-fno-sanitize-recover=all
SETS_asan := host font
PACKAGES_asan := $(PACKAGES_host)
OPENED_asan := $(OPENED_host)
LIBS_asan := -lgif -lm -ldl -fsanitize=address,undefined
RUN_asan :=
# The span loops are hundreds of functions from one template. Without the sanitizers
# they take GCC two thirds of the time with line numbers alone as debug information.
# With them the functions share the template's text: a tenth of the time.
build/host/obj/platform/gl/soft/span/spans_%.o \
	build/host/obj/platform/gl/soft/stages/spans_%.o: CFLAGS_host += -g1
build/arm/obj/platform/gl/soft/span/spans_%.o \
	build/arm/obj/platform/gl/soft/stages/spans_%.o: CFLAGS_arm += -g1
build/asan/obj/platform/gl/soft/span/spans_%.o \
	build/asan/obj/platform/gl/soft/stages/spans_%.o: CFLAGS_asan += -DSOFT_SHARED_TEXT
# A test is compiled for a run or two: full optimization and debug information of
# variables would take the compiler longer than they save. The sanitizers' own
# checks take most of the time of a test; -O0 halves what their compilation takes.
# It knows less of what is initialized, so that warning is left to the others.
build/host/obj/tests/unit/%.o: CFLAGS_host += -O1 -g1
build/arm/obj/tests/unit/%.o: CFLAGS_arm += -O1 -g1
build/asan/obj/tests/unit/%.o: CFLAGS_asan += -O0 -Wno-maybe-uninitialized
# The tests share one library: linked into each, it would take 13 GB.
TEST_LIBRARY_asan := liblimber.so
TEST_LDFLAGS_asan = -Wl,-rpath,'$$ORIGIN/..' $(call gold,ld.gold)
GL_DRIVERS_asan := $(GL_DRIVERS_host)
DISPLAY_DRIVERS_asan := $(DISPLAY_DRIVERS_host)
BUTTON_DRIVERS_asan := $(BUTTON_DRIVERS_host)
CAMERA_DRIVERS_asan := $(CAMERA_DRIVERS_host)
