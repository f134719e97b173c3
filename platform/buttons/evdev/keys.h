/*
 * Which key of a keyboard or keypad is which button.
 */
#ifndef PLATFORM_BUTTONS_EVDEV_KEYS_H
#define PLATFORM_BUTTONS_EVDEV_KEYS_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/buttons/buttons.h"

enum {
	EVDEV_KEYS = 768, /* as many as the kernel has codes for */
	EVDEV_KEY_BYTES = EVDEV_KEYS / 8
};

struct evdev_keys {
	uint8_t button[EVDEV_KEYS]; /* enum button; BUTTON_COUNT: none */
};

/*
 * The arrows, Enter, F6 and F8 to F10, and what keypads have in their place:
 * 8 2 4 6 and Enter of the number pad, OK and select, the direction pad.
 */
struct evdev_keys evdev_keys_default(void);

/*
 * Reads "BUTTON=KEY", KEY a name such as KEY_W or a number from evtest: from
 * now on that key is that button. 0, or -EINVAL after a sentence.
 */
int evdev_keys_read(
	struct evdev_keys *keys, const char *text, const struct log *log);

/* The button of a key, or BUTTON_COUNT; any code may be asked. */
enum button evdev_keys_find(const struct evdev_keys *keys, unsigned int code);

/* Whether a bit is set; codes from EVDEV_KEYS on are not. */
bool evdev_key_bit(const uint8_t bits[EVDEV_KEY_BYTES], unsigned int code);

#endif
