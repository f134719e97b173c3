/*
 * The table from the keys of a keyboard or keypad to buttons.
 */
#ifndef PLATFORM_BUTTONS_EVDEV_KEYS_H
#define PLATFORM_BUTTONS_EVDEV_KEYS_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/buttons/buttons.h"

enum {
	EVDEV_KEYS = 768, /* the kernel's number of key codes, KEY_CNT */
	EVDEV_KEY_BYTES = EVDEV_KEYS / 8
};

struct evdev_keys {
	uint8_t button[EVDEV_KEYS]; /* enum button; BUTTON_COUNT for none */
};

/*
 * Returns the default table: the arrows, Enter, F6 and F8 to F10, and on
 * keypads 8, 2, 4, 6, Enter, OK, select and the direction pad.
 */
struct evdev_keys evdev_keys_default(void);

/*
 * Reads "BUTTON=KEY" and maps that key to that button. KEY is a name such as
 * KEY_W or a number that evtest shows. Returns 0, or -EINVAL after logging an
 * error.
 */
int evdev_keys_read(
	struct evdev_keys *keys, const char *text, const struct log *log);

/* The button of a key, or BUTTON_COUNT. Any code is allowed. */
enum button evdev_keys_find(const struct evdev_keys *keys, unsigned int code);

/* Whether the bit of a key is set. False for codes from EVDEV_KEYS on. */
bool evdev_key_bit(const uint8_t bits[EVDEV_KEY_BYTES], unsigned int code);

#endif
