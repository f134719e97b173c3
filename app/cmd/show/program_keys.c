#include "app/cmd/show/program_keys.h"

static void hold(struct program_keys *keys, const struct button_event *event)
{
	keys->held = true;
	keys->used = false;
	keys->held_since_ms = event->time_ms;
}

/* A whole press for the demo, unless it meant something else. */
static int let_go(struct program_keys *keys, const struct button_event *event,
	struct button_event passed[PROGRAM_KEYS_PASSED])
{
	bool whole = keys->held && !keys->used;

	keys->held = false;
	if (!whole) {
		return 0;
	}
	passed[0] = passed[1] = *event;
	passed[0].down = true;
	return 2;
}

enum program_wish program_keys_take(struct program_keys *keys,
	const struct button_event *event,
	struct button_event passed[PROGRAM_KEYS_PASSED], int *count)
{
	*count = 0;
	if (event->button == BUTTON_F9) {
		if (event->down) {
			hold(keys, event);
		} else {
			*count = let_go(keys, event, passed);
		}
		return WISH_NOTHING;
	}
	if (event->button == BUTTON_F8 && event->down && keys->held) {
		keys->used = keys->swallows = true;
		return WISH_PICTURE;
	}
	if (event->button == BUTTON_F8 && !event->down && keys->swallows) {
		keys->swallows = false;
		return WISH_NOTHING;
	}
	passed[0] = *event;
	*count = 1;
	return WISH_NOTHING;
}

enum program_wish program_keys_wait(struct program_keys *keys, int64_t now_ms)
{
	if (!keys->held || keys->used ||
		now_ms - keys->held_since_ms < PROGRAM_KEYS_HOLD_MS) {
		return WISH_NOTHING;
	}
	keys->used = true;
	return WISH_GRAPH;
}
