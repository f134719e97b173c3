/*
 * Decodes the events that an input device delivers.
 *
 * The kernel writes struct input_event with its own long: two longs of time,
 * then type, code and value. That makes 24 bytes where a long has 64 bits, else
 * 16. A C library with a 64-bit time_t may declare the struct differently.
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
	/* The kernel's time stamp (event_time.h); negative if the device sent
	 * numbers that are no time. */
	int64_t stamp_ns;
	uint16_t type, code;
	int32_t value;
};

/* Decodes one event of EVDEV_SIZE_32 or EVDEV_SIZE_64 bytes. */
struct evdev_event evdev_decode(const unsigned char *bytes, size_t size);

#endif
