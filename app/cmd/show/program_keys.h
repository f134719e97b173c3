/*
 * Buttons that do the same in every demo, beside the demo's own actions.
 *
 *	F9, held for PROGRAM_KEYS_HOLD_MS   shows or hides the frame times
 *	F6, pressed while F9 is held        shows the next overlay
 *	DOWN, UP, pressed while F9 is held  choose the joint that overlays show
 *	F8, pressed while F9 is held        keeps the picture in a file
 *	F10, where a camera is open         changes what its pictures are for
 *
 * The demo gets all other presses. Since F9 may be held for the program, the
 * demo gets the press of F9 together with its release, if F9 was not held for
 * long. A window has keys of its own for all but the last (struct
 * display_events).
 */
#ifndef APP_CMD_SHOW_PROGRAM_KEYS_H
#define APP_CMD_SHOW_PROGRAM_KEYS_H

#include "app/demo/demo.h"

#include <stdio.h>

enum {
	PROGRAM_KEYS_HOLD_MS = 700,
	PROGRAM_KEYS_PASSED_MAX = 2
};

/* What a key asks the program to do. */
enum program_action {
	PROGRAM_NOTHING,
	PROGRAM_TOGGLE_GRAPH,
	PROGRAM_KEEP_PICTURE,
	PROGRAM_NEXT_CAMERA_USE,
	PROGRAM_NEXT_OVERLAY,
	PROGRAM_NEXT_JOINT,
	PROGRAM_PREVIOUS_JOINT,
};

/* All zero: no key is down, there is no camera. */
struct program_keys {
	bool has_camera; /* F10 belongs to the program */
	bool f9_held;
	bool f9_used; /* for the program: the demo does not get it */
	/* Pressed for the program while F9 was held, and not released yet. */
	bool used[BUTTON_COUNT];
	int64_t f9_since_ms; /* when F9 was pressed */
};

/*
 * Takes one event and returns what the program must do. Writes the events that
 * the demo gets to passed, and their number to *count.
 */
enum program_action program_keys_press(struct program_keys *keys,
	const struct button_event *event,
	struct button_event passed[PROGRAM_KEYS_PASSED_MAX], int *count);

/* Call this once a frame: returns an action if F9 has been held for long. */
enum program_action program_keys_update(
	struct program_keys *keys, int64_t now_ms);

/* Prints what each button does in this demo. */
void program_keys_print(FILE *out, const struct demo_driver *driver,
	const struct demo *demo, bool has_camera);

#endif
