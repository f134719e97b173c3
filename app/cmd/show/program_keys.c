#include "app/cmd/show/program_keys.h"

static void press_f9(struct program_keys *keys, const struct button_event *event)
{
	keys->f9_held = true;
	keys->f9_used = false;
	keys->f9_since_ms = event->time_ms;
}

/*
 * Passes a press and the release of F9 to the demo, unless the program used F9.
 */
static int release_f9(struct program_keys *keys,
	const struct button_event *event,
	struct button_event passed[PROGRAM_KEYS_PASSED_MAX])
{
	bool is_demos = keys->f9_held && !keys->f9_used;

	keys->f9_held = false;
	if (!is_demos) {
		return 0;
	}
	passed[0] = passed[1] = *event;
	passed[0].down = true;
	return 2;
}

/* Returns the action of a button that is pressed while F9 is held. */
static enum program_action chord_of(enum button button)
{
	switch (button) {
	case BUTTON_F8:
		return PROGRAM_KEEP_PICTURE;
	case BUTTON_F6:
		return PROGRAM_NEXT_OVERLAY;
	case BUTTON_DOWN:
		return PROGRAM_NEXT_JOINT;
	case BUTTON_UP:
		return PROGRAM_PREVIOUS_JOINT;
	default:
		return PROGRAM_NOTHING;
	}
}

enum program_action program_keys_press(struct program_keys *keys,
	const struct button_event *event,
	struct button_event passed[PROGRAM_KEYS_PASSED_MAX], int *count)
{
	*count = 0;
	if (event->button == BUTTON_F10 && keys->has_camera) {
		return event->down ? PROGRAM_NEXT_CAMERA_USE : PROGRAM_NOTHING;
	}
	if (event->button == BUTTON_F9) {
		if (event->down) {
			press_f9(keys, event);
		} else {
			*count = release_f9(keys, event, passed);
		}
		return PROGRAM_NOTHING;
	}
	if (event->down && keys->f9_held &&
		chord_of(event->button) != PROGRAM_NOTHING) {
		keys->f9_used = keys->used[event->button] = true;
		return chord_of(event->button);
	}
	if (!event->down && keys->used[event->button]) {
		keys->used[event->button] = false;
		return PROGRAM_NOTHING;
	}
	passed[0] = *event;
	*count = 1;
	return PROGRAM_NOTHING;
}

enum program_action program_keys_update(
	struct program_keys *keys, int64_t now_ms)
{
	if (!keys->f9_held || keys->f9_used ||
		now_ms - keys->f9_since_ms < PROGRAM_KEYS_HOLD_MS) {
		return PROGRAM_NOTHING;
	}
	keys->f9_used = true;
	return PROGRAM_TOGGLE_GRAPH;
}

static void print_actions(
	FILE *out, const struct demo_driver *driver, bool has_camera)
{
	for (const struct demo_action *action = driver->action; action->summary;
		action++) {
		if (!has_camera || action->button != BUTTON_F10) {
			fprintf(out, "  %-6s %s\n", button_name(action->button),
				action->summary);
		}
	}
}

void program_keys_print(FILE *out, const struct demo_driver *driver,
	const struct demo *demo, bool has_camera)
{
	fprintf(out, "%s: %s\n", driver->name, driver->summary);
	if (driver->print_buttons) {
		driver->print_buttons(demo, out);
	} else {
		print_actions(out, driver, has_camera);
	}
	if (has_camera) {
		fputs("  F10    change what the camera's pictures are for\n",
			out);
	}
	fputs("  F9     held: show or hide the frame times (H in a window)\n"
	      "  F9+F6  show skeleton, weights, wireframe... (F7 in a window)\n"
	      "  F9+UP, F9+DOWN  choose their joint (Page Up and Page Down)\n"
	      "  F9+F8  keep the picture in a file (P in a window)\n"
	      "  Ctrl-C quit (Esc in a window)\n",
		out);
	fflush(out);
}
