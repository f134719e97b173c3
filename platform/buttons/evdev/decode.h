/*
 * The bytes of an input device.
 *
 * The kernel writes struct input_event with its own long: two longs of time,
 * then type, code and value, 24 bytes where a long has 64 bits, else 16,
 * whatever the C library's time_t is.
 */
#ifndef PLATFORM_BUTTONS_EVDEV_DECODE_H
#define PLATFORM_BUTTONS_EVDEV_DECODE_H

#include <stddef.h>
#include <stdint.h>

enum {
	EVDEV_SIZE_32 = 16,
	EVDEV_SIZE_64 = 24,
	EVDEV_SIZE = sizeof(long) == 8 ? EVDEV_SIZE_64 : EVDEV_SIZE_32
};

struct evdev_event {
	int64_t stamp_ns;
	uint16_t type, code;
	int32_t value;
};

/* Reads one event of EVDEV_SIZE_32 or EVDEV_SIZE_64 bytes. */
struct evdev_event evdev_decode(const unsigned char *bytes, size_t size);

#endif
