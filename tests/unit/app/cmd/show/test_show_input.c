/* What events of a display and of buttons do to a run. */
#include "app/cmd/show/show_state.h"
#include "app/demo/actor.h"
#include "tests/support/demo_shown.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

static struct display_events next; /* of the made-up display */

static void poll_display(struct display *display, int64_t now_ms,
	struct button_queue *queue, struct display_events *events)
{
	(void)display;
	(void)now_ms;
	(void)queue;
	*events = next;
	next = (struct display_events){0};
}

static const struct display_driver display = {.poll = poll_display};

struct scene {
	struct shown shown;
	struct show_plan plan;
	struct options options;
	struct show show;
};

/* All tests share the demo, as loading it takes longest. */
static int load(void **state)
{
	static const int size[2] = {240, 320};
	static struct scene scene;

	shown_begin(&scene.shown, "arm", size, false);
	*state = &scene;
	return 0;
}

static int unload(void **state)
{
	shown_end(&((struct scene *)*state)->shown);
	return 0;
}

static int begin(void **state)
{
	struct scene *scene = *state;

	next = (struct display_events){0};
	scene->options = options_default();
	scene->plan = (struct show_plan){.demo = scene->shown.driver};
	scene->show = (struct show){
		.plan = &scene->plan,
		.options = &scene->options,
		.log = &scene->shown.log,
		.demo = scene->shown.demo,
		.screen.driver = &display,
		.clock = clock_fixed(25.0, 0.0),
	};
	assert_int_equal(show_input_open(&scene->show), 0);
	return 0;
}

static unsigned kinds(const struct show *show)
{
	const struct overlay *overlay =
		((const struct demo_base *)show->demo)->overlay;

	return overlay ? overlay->kinds : 0;
}

/* The next test begins without overlays, as a run does. */
static int end(void **state)
{
	struct scene *scene = *state;

	while (kinds(&scene->show) != 0) {
		demo_show_next_overlay(scene->plan.demo, scene->show.demo);
	}
	return show_input_close(&scene->show, 0);
}

static void see(struct show *show, struct display_events events)
{
	next = events;
	show_input_poll_display(show, 0);
}

/* Presses or releases a button, as a source does. */
static void press(struct show *show, int64_t ms, enum button button, bool down)
{
	const struct button_event event = {ms, button, down, 0};

	memset(show->buttons.queue.debounce_ms, 0,
		sizeof(show->buttons.queue.debounce_ms));
	button_queue_push(&show->buttons.queue, event);
}

static void test_a_display_that_sees_nothing_changes_nothing(void **state)
{
	struct show *show = &((struct scene *)*state)->show;

	see(show, (struct display_events){.resized = true});
	assert_false(show->closed);
	assert_false(show->watch.shown);
	assert_false(show->keeps_picture);
	assert_int_equal(kinds(show), 0);
	show->screen.driver = &(const struct display_driver){.name = "mute"};
	show_input_poll_display(show, 0);
	assert_false(show->closed);
}

static void test_a_closed_window_stays_closed(void **state)
{
	struct show *show = &((struct scene *)*state)->show;

	see(show, (struct display_events){.close = true});
	assert_true(show->closed);
	see(show, (struct display_events){0});
	assert_true(show->closed);
}

static void test_a_window_has_keys_for_the_graph_and_the_picture(void **state)
{
	struct show *show = &((struct scene *)*state)->show;

	see(show, (struct display_events){.graph = 1});
	assert_true(show->watch.shown);
	assert_false(show->keeps_picture);
	see(show, (struct display_events){.picture = true});
	assert_true(show->watch.shown);
	assert_true(show->keeps_picture);
	see(show, (struct display_events){.graph = 1});
	assert_false(show->watch.shown);
	see(show, (struct display_events){.graph = 2});
	assert_false(show->watch.shown);
	see(show, (struct display_events){.graph = 3});
	assert_true(show->watch.shown);
}

static int chosen(const struct show *show)
{
	return ((const struct demo_base *)show->demo)->overlay->chosen;
}

static void test_a_window_has_keys_for_overlays_and_joints(void **state)
{
	struct show *show = &((struct scene *)*state)->show;
	int first, second;

	see(show, (struct display_events){.overlay = 1});
	assert_int_equal(kinds(show), 1u << OVERLAY_SKELETON);
	see(show, (struct display_events){.overlay = 1});
	assert_int_equal(kinds(show), 1u << OVERLAY_WEIGHTS);
	first = chosen(show);
	see(show, (struct display_events){.joint = 1});
	assert_int_not_equal(chosen(show), first);
	see(show, (struct display_events){.joint = -1});
	assert_int_equal(chosen(show), first);
	see(show, (struct display_events){.joint = 1});
	see(show, (struct display_events){.joint = 1});
	second = chosen(show);
	see(show, (struct display_events){.joint = -2});
	assert_int_equal(chosen(show), first);
	see(show, (struct display_events){.joint = 2});
	assert_int_equal(chosen(show), second);
	assert_int_not_equal(second, first);
}

/* A frame of a slow board may last longer than two presses. */
static void test_a_key_pressed_twice_in_a_frame_counts_twice(void **state)
{
	struct show *show = &((struct scene *)*state)->show;

	see(show, (struct display_events){.overlay = 2});
	assert_int_equal(kinds(show), 1u << OVERLAY_WEIGHTS);
}

/* The same by buttons while F9 is held, at any time of the run. */
static void test_buttons_with_f9_act_as_the_windows_keys(void **state)
{
	struct show *show = &((struct scene *)*state)->show;
	int first;

	press(show, 10, BUTTON_F9, true);
	press(show, 20, BUTTON_F6, true);
	press(show, 30, BUTTON_F6, false);
	press(show, 40, BUTTON_F6, true);
	press(show, 50, BUTTON_F8, true);
	show_input_poll_buttons(show, 60);
	assert_int_equal(kinds(show), 1u << OVERLAY_WEIGHTS);
	assert_true(show->keeps_picture);
	first = chosen(show);
	press(show, 70, BUTTON_DOWN, true);
	show_input_poll_buttons(show, 80);
	assert_int_not_equal(chosen(show), first);
	press(show, 90, BUTTON_UP, true);
	show_input_poll_buttons(show, 100);
	assert_int_equal(chosen(show), first);
	assert_false(show->watch.shown);
}

/* What is typed on another console. A press from before ends meanwhile. */
static void test_presses_do_not_count_while_the_user_is_away(void **state)
{
	struct show *show = &((struct scene *)*state)->show;

	press(show, 10, BUTTON_F9, true);
	show_input_poll_buttons(show, 20);
	see(show, (struct display_events){.away = true});
	assert_true(show->away);
	press(show, 30, BUTTON_F6, true);
	press(show, 40, BUTTON_F8, true);
	press(show, 50, BUTTON_F8, false);
	press(show, 60, BUTTON_F9, false);
	show_input_ignore_buttons(show, 70);
	assert_int_equal(kinds(show), 0);
	assert_false(show->keeps_picture);
	assert_false(show->keys.f9_held);
	see(show, (struct display_events){.away = false});
	assert_false(show->away);
	press(show, 80, BUTTON_F9, true);
	press(show, 90, BUTTON_F6, false);
	press(show, 100, BUTTON_F6, true);
	show_input_poll_buttons(show, 110);
	assert_int_equal(kinds(show), 1u << OVERLAY_SKELETON);
}

static int polls; /* of a display that is away, and closed at the fifth */

static void poll_away(struct display *closing, int64_t now_ms,
	struct button_queue *queue, struct display_events *events)
{
	(void)closing;
	(void)now_ms;
	(void)queue;
	*events = (struct display_events){.away = true, .close = ++polls == 5};
}

/* This display could not draw. Signals and the close button still count. */
static void test_nothing_is_drawn_while_the_user_is_away(void **state)
{
	static const struct display_driver away = {.poll = poll_away};
	struct show *show = &((struct scene *)*state)->show;

	polls = 0;
	show->screen.driver = &away;
	show->watchdog = watchdog_none();
	assert_int_equal(show_loop_run(show), 0);
	assert_int_equal(polls, 5);
	assert_true(show->closed);
}

static void test_f9_held_alone_shows_the_graph(void **state)
{
	struct show *show = &((struct scene *)*state)->show;

	press(show, 10, BUTTON_F9, true);
	show_input_poll_buttons(show, 10 + PROGRAM_KEYS_HOLD_MS - 1);
	assert_false(show->watch.shown);
	show_input_poll_buttons(show, 10 + PROGRAM_KEYS_HOLD_MS);
	assert_true(show->watch.shown);
}

/* Two sources may give their events out of order; a script must not. */
static void test_recorded_times_never_decrease(void **state)
{
	struct scene *scene = *state;
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "record.txt");
	char *text;

	scene->options.input.record_buttons = path.text;
	assert_int_equal(show_input_open(&scene->show), 0);
	press(&scene->show, 40, BUTTON_UP, true);
	press(&scene->show, 30, BUTTON_F6, true);
	press(&scene->show, 50, BUTTON_UP, false);
	show_input_poll_buttons(&scene->show, 60);
	/* The lines are in the file before it is complete. */
	text = file_read(path.text, NULL);
	assert_string_equal(text, "40 UP down\n40 F6 down\n50 UP up\n");
	free(text);
	temp_dir_remove(&folder);
}

static void test_a_screen_without_keys_takes_those_of_keyboards(void **state)
{
	static const struct display_driver screen = {.needs_keyboard = true};
	struct scene *scene = *state;
	struct show *show = &scene->show;

	assert_int_equal(show_input_add_keyboards(show), 0);
	assert_int_equal(show->buttons.source_count, 0);
	show->screen.driver = &screen;
	scene->options.input.buttons = "gpiod:UP=chip/3";
	assert_int_equal(show_input_add_keyboards(show), 0);
	assert_int_equal(show->buttons.source_count, 0);
	scene->options.input.buttons = NULL;
	scene->options.input.script = "script.txt";
	assert_int_equal(show_input_add_keyboards(show), 0);
	assert_int_equal(show->buttons.source_count, 0);
	scene->options.input.script = NULL;
	assert_int_equal(show_input_add_keyboards(show), 0);
	assert_int_equal(show->buttons.source_count, 1);
	assert_string_equal(show->buttons.source[0].driver->name, "evdev");
}

int main(void)
{
#define CASE(name) cmocka_unit_test_setup_teardown(name, begin, end)
	static const struct CMUnitTest tests[] = {
		CASE(test_a_display_that_sees_nothing_changes_nothing),
		CASE(test_a_closed_window_stays_closed),
		CASE(test_a_window_has_keys_for_the_graph_and_the_picture),
		CASE(test_a_window_has_keys_for_overlays_and_joints),
		CASE(test_a_key_pressed_twice_in_a_frame_counts_twice),
		CASE(test_buttons_with_f9_act_as_the_windows_keys),
		CASE(test_presses_do_not_count_while_the_user_is_away),
		CASE(test_nothing_is_drawn_while_the_user_is_away),
		CASE(test_f9_held_alone_shows_the_graph),
		CASE(test_recorded_times_never_decrease),
		CASE(test_a_screen_without_keys_takes_those_of_keyboards),
	};
#undef CASE

	return cmocka_run_group_tests(tests, load, unload);
}
