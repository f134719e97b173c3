#include "app/cmd/show/show_state.h"

#include "platform/process/stop.h"

#include <inttypes.h>

int show_input_open(struct show *show)
{
	const struct options_input *input = &show->options->input;
	int error = buttons_open(&show->buttons, input->buttons, show->log);

	if (!error && input->script) {
		error = buttons_add(
			&show->buttons, "script", input->script, show->log);
	}
	if (!error && input->record_buttons) {
		error = output_file_create(
			input->record_buttons, show->log, &show->record);
	}
	if (error) {
		buttons_close(&show->buttons);
	}
	return error;
}

int show_input_add_keyboards(struct show *show)
{
	const struct options_input *input = &show->options->input;

	if (input->buttons || input->script ||
		!show->screen.driver->needs_keyboard) {
		return 0;
	}
	return buttons_add(&show->buttons, "evdev", NULL, show->log);
}

int show_input_close(struct show *show, int run_error)
{
	buttons_close(&show->buttons);
	if (!show->record) {
		return 0;
	}
	if (run_error) {
		output_file_discard(show->record);
		return 0;
	}
	return output_file_commit(show->record);
}

/*
 * Writes the event as a line of a script. The line is in the file on return,
 * since a board may be switched off at any time.
 */
static void record(struct show *show, const struct button_event *event)
{
	if (!show->record) {
		return;
	}
	/* Times never decrease in a script. */
	if (event->time_ms > show->record_ms) {
		show->record_ms = event->time_ms;
	}
	fprintf(output_file_stream(show->record), "%" PRId64 " %s %s\n",
		show->record_ms, button_name(event->button),
		event->down ? "down" : "up");
	/* show_input_close() reports errors of writing. */
	(void)output_file_publish(show->record);
}

static void act(struct show *show, enum program_action action)
{
	switch (action) {
	case PROGRAM_TOGGLE_GRAPH:
		show->watch.shown = !show->watch.shown;
		break;
	case PROGRAM_KEEP_PICTURE:
		show->keeps_picture = true;
		break;
	case PROGRAM_NEXT_CAMERA_USE:
		demo_next_camera_use(show->demo);
		break;
	case PROGRAM_NEXT_OVERLAY:
		demo_show_next_overlay(show->plan->demo, show->demo);
		break;
	case PROGRAM_NEXT_JOINT:
		demo_choose_joint(show->demo, 1);
		break;
	case PROGRAM_PREVIOUS_JOINT:
		demo_choose_joint(show->demo, -1);
		break;
	default:
		break;
	}
}

static void act_times(struct show *show, enum program_action action, int times)
{
	for (int i = 0; i < times; i++) {
		act(show, action);
	}
}

/* Runs the button's action, as remapped by [actions] of limber.conf. */
static void press(struct show *show, struct button_event event)
{
	struct button_event passed[PROGRAM_KEYS_PASSED_MAX];
	int count;

	event.button = show->options->input.action[event.button];
	if (event.button == BUTTON_COUNT) {
		return;
	}
	act(show, program_keys_press(&show->keys, &event, passed, &count));
	for (int i = 0; i < count; i++) {
		demo_press(show->plan->demo, show->demo, &passed[i]);
	}
}

/* The release of a press that did not count does not count, either. */
static bool counts(struct show *show, const struct button_event *event)
{
	bool pressed = show->pressed[event->button];

	show->pressed[event->button] = event->down;
	return event->down || pressed;
}

void show_input_ignore_buttons(struct show *show, int64_t now_ms)
{
	struct button_event event;

	buttons_poll(&show->buttons, now_ms);
	while (button_queue_pop(&show->buttons.queue, &event)) {
		if (!event.down && counts(show, &event)) {
			record(show, &event);
			press(show, event);
		}
	}
}

void show_input_poll_buttons(struct show *show, int64_t now_ms)
{
	struct button_event event;

	buttons_poll(&show->buttons, now_ms);
	while (button_queue_pop(&show->buttons.queue, &event)) {
		if (!counts(show, &event)) {
			continue;
		}
		record(show, &event);
		press(show, event);
		if (!show->clock.fixed) {
			frame_stats_press(&show->stats,
				show->clock.origin_ns + event.time_ms * 1000000);
		}
	}
	act(show, program_keys_update(&show->keys, now_ms));
}

void show_input_poll_display(struct show *show, int64_t now_ms)
{
	const struct show_screen *screen = &show->screen;
	struct display_events events = {0};

	if (screen->driver->poll) {
		screen->driver->poll(
			screen->display, now_ms, &show->buttons.queue, &events);
	}
	show->closed = show->closed || events.close || stop_requested();
	show->away = events.away;
	if (events.picture) {
		act(show, PROGRAM_KEEP_PICTURE);
	}
	act_times(show, PROGRAM_TOGGLE_GRAPH, events.graph);
	act_times(show, PROGRAM_NEXT_OVERLAY, events.overlay);
	act_times(show, PROGRAM_NEXT_JOINT, events.joint);
	act_times(show, PROGRAM_PREVIOUS_JOINT, -events.joint);
}
