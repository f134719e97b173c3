/*
 * What buttons ask of the program rather than of a demo.
 *
 * All buttons are the demo's, so F9 has two lives. Let go soon, it is the
 * demo's F9, pressed and let go at that moment. Held for HOLD_MS it asks for
 * the graph of frame times, and with F8 meanwhile for a picture; the demo then
 * hears of neither.
 */
#ifndef APP_CMD_SHOW_PROGRAM_KEYS_H
#define APP_CMD_SHOW_PROGRAM_KEYS_H

#include "platform/buttons/buttons.h"

enum {
	PROGRAM_KEYS_HOLD_MS = 700,
	PROGRAM_KEYS_PASSED = 2
};

enum program_wish {
	WISH_NOTHING,
	WISH_GRAPH,
	WISH_PICTURE
};

/* All zero: nothing is held. */
struct program_keys {
	bool held;     /* F9 */
	bool used;     /* it has been more than the demo's F9 */
	bool swallows; /* F8 is down and not the demo's */
	int64_t held_since_ms;
};

/*
 * Takes an event; what the demo is to hear goes into passed, its number into
 * *count.
 */
enum program_wish program_keys_take(struct program_keys *keys,
	const struct button_event *event,
	struct button_event passed[PROGRAM_KEYS_PASSED], int *count);

/* Once a frame: whether F9 has been held for long enough by now. */
enum program_wish program_keys_wait(struct program_keys *keys, int64_t now_ms);

#endif
