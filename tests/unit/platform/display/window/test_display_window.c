#include "platform/display/display.h"
#include "tests/support/log_capture.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#if __has_include(<SDL.h>)
#include <SDL.h>

extern const struct display_driver display_driver_window;

/* A window of SDL's dummy driver, which needs no screen. */
struct scene {
	const struct display_driver *driver;
	struct display *display;
	struct log_capture capture;
	struct log log;
	struct button_queue queue;
	struct display_events events;
};

static void scene_open(struct scene *scene)
{
	struct display_options options = {
		.width = 64,
		.height = 48,
		.title = "test",
		.log = &scene->log,
	};

	setenv("SDL_VIDEODRIVER", "dummy", 1);
	scene->driver = &display_driver_window;
	scene->log = log_capture_begin(&scene->capture);
	button_queue_init(&scene->queue, 0);
	assert_int_equal(scene->driver->create(&options, &scene->display), 0);
	/* The events of opening a window. */
	scene->driver->poll(scene->display, 0, &scene->queue, &scene->events);
	assert_false(scene->events.close);
}

static void scene_close(struct scene *scene)
{
	assert_int_equal(scene->capture.count, 0);
	scene->driver->destroy(scene->display);
}

static void poll(struct scene *scene, int now_ms)
{
	scene->driver->poll(
		scene->display, now_ms, &scene->queue, &scene->events);
}

static void push_key(SDL_Keycode key, bool down, bool repeat)
{
	SDL_Event event = {.key = {
				   .type = down ? SDL_KEYDOWN : SDL_KEYUP,
				   .state = down ? SDL_PRESSED : SDL_RELEASED,
				   .repeat = repeat,
				   .keysym = {.sym = key},
			   }};

	assert_int_equal(SDL_PushEvent(&event), 1);
}

static void push_window_event(Uint8 what)
{
	SDL_Event event = {.window = {.type = SDL_WINDOWEVENT, .event = what}};

	assert_int_equal(SDL_PushEvent(&event), 1);
}

static void expect(
	struct scene *scene, int time_ms, enum button button, bool down)
{
	struct button_event event;

	assert_true(button_queue_pop(&scene->queue, &event));
	assert_int_equal(event.time_ms, time_ms);
	assert_int_equal(event.button, button);
	assert_int_equal(event.down, down);
}

static void expect_nothing(struct scene *scene)
{
	struct button_event event;

	assert_false(button_queue_pop(&scene->queue, &event));
}

static void draw(struct scene *scene, int width, int height)
{
	struct pixels pixels;

	assert_int_equal(scene->driver->begin_frame(scene->display, &pixels), 0);
	assert_int_equal(pixels.width, width);
	assert_int_equal(pixels.height, height);
	assert_int_equal(pixels.format, PIXELS_RGBA8888);
	memset(pixels.data, 200, (size_t)(pixels.stride_bytes * pixels.height));
	assert_int_equal(scene->driver->end_frame(scene->display), 0);
}

static void test_frames_are_shown(void **state)
{
	struct scene scene;

	(void)state;
	scene_open(&scene);
	for (int i = 0; i < 3; i++) {
		draw(&scene, 64, 48);
	}
	scene_close(&scene);
}

static const struct {
	SDL_Keycode key;
	enum button button;
} pairs[] = {
	{SDLK_UP, BUTTON_UP},
	{SDLK_DOWN, BUTTON_DOWN},
	{SDLK_LEFT, BUTTON_LEFT},
	{SDLK_RIGHT, BUTTON_RIGHT},
	{SDLK_RETURN, BUTTON_ENTER},
	{SDLK_KP_ENTER, BUTTON_ENTER},
	{SDLK_F6, BUTTON_F6},
	{SDLK_F8, BUTTON_F8},
	{SDLK_F9, BUTTON_F9},
	{SDLK_F10, BUTTON_F10},
};

enum {
	PAIRS = sizeof(pairs) / sizeof(pairs[0])
};

static void test_keys_carry_the_keypads_names(void **state)
{
	struct scene scene;

	(void)state;
	scene_open(&scene);
	for (size_t i = 0; i < PAIRS; i++) {
		push_key(pairs[i].key, true, false);
		poll(&scene, 100);
		expect(&scene, 100, pairs[i].button, true);
		push_key(pairs[i].key, false, false);
		poll(&scene, 120);
		expect(&scene, 120, pairs[i].button, false);
	}
	push_key(SDLK_a, true, false);
	poll(&scene, 130);
	expect_nothing(&scene);
	assert_false(scene.events.close);
	scene_close(&scene);
}

static void test_key_repeat_is_ignored(void **state)
{
	struct scene scene;

	(void)state;
	scene_open(&scene);
	push_key(SDLK_UP, true, false);
	push_key(SDLK_UP, true, true);
	push_key(SDLK_UP, true, true);
	push_key(SDLK_q, true, true);
	poll(&scene, 7);
	expect(&scene, 7, BUTTON_UP, true);
	expect_nothing(&scene);
	assert_false(scene.events.close);
	scene_close(&scene);
}

static void test_losing_the_focus_releases_the_buttons(void **state)
{
	struct scene scene;

	(void)state;
	scene_open(&scene);
	/* The window must not release a button of another source. */
	button_queue_push(
		&scene.queue, (struct button_event){1, BUTTON_F6, true, 0});
	expect(&scene, 1, BUTTON_F6, true);
	push_key(SDLK_LEFT, true, false);
	push_window_event(SDL_WINDOWEVENT_FOCUS_LOST);
	poll(&scene, 5);
	expect(&scene, 5, BUTTON_LEFT, true);
	expect(&scene, 5, BUTTON_LEFT, false);
	expect_nothing(&scene);
	scene_close(&scene);
}

static void test_a_resized_window_hands_out_the_new_size(void **state)
{
	struct scene scene;
	SDL_Window *window;

	(void)state;
	scene_open(&scene);
	draw(&scene, 64, 48);
	window = SDL_GetWindowFromID(1);
	for (Uint32 id = 2; !window && id < 100; id++) {
		window = SDL_GetWindowFromID(id);
	}
	assert_non_null(window);
	assert_true(SDL_GetWindowFlags(window) & SDL_WINDOW_RESIZABLE);
	assert_string_equal(SDL_GetWindowTitle(window), "test");
	SDL_SetWindowSize(window, 80, 30);
	poll(&scene, 1);
	assert_true(scene.events.resized);
	draw(&scene, 80, 30);
	poll(&scene, 2);
	assert_false(scene.events.resized);
	draw(&scene, 80, 30);
	/* A larger one than pictures can be is filled in part. */
	SDL_SetWindowSize(window, PIXELS_SIZE_MAX + 9, 3);
	draw(&scene, PIXELS_SIZE_MAX, 3);
	draw(&scene, PIXELS_SIZE_MAX, 3);
	scene_close(&scene);
}

static void test_h_and_p_ask_for_graph_and_picture_once(void **state)
{
	struct scene scene;

	(void)state;
	scene_open(&scene);
	push_key(SDLK_h, true, false);
	push_key(SDLK_h, true, true);
	poll(&scene, 1);
	assert_int_equal(scene.events.graph, 1);
	assert_false(scene.events.picture);
	push_key(SDLK_h, false, false);
	poll(&scene, 2);
	assert_int_equal(scene.events.graph, 0);
	push_key(SDLK_p, true, false);
	poll(&scene, 3);
	assert_true(scene.events.picture);
	assert_int_equal(scene.events.graph, 0);
	poll(&scene, 4);
	assert_false(scene.events.picture);
	scene_close(&scene);
}

static void test_page_keys_choose_the_next_and_the_last_joint(void **state)
{
	struct scene scene;

	(void)state;
	scene_open(&scene);
	push_key(SDLK_PAGEDOWN, true, false);
	poll(&scene, 1);
	assert_int_equal(scene.events.joint, 1);
	assert_int_equal(scene.events.overlay, 0);
	push_key(SDLK_PAGEDOWN, true, true);
	push_key(SDLK_PAGEDOWN, false, false);
	poll(&scene, 2);
	assert_int_equal(scene.events.joint, 0);
	push_key(SDLK_PAGEUP, true, false);
	push_key(SDLK_F7, true, false);
	poll(&scene, 3);
	assert_int_equal(scene.events.joint, -1);
	assert_int_equal(scene.events.overlay, 1);
	push_key(SDLK_F7, false, false);
	push_key(SDLK_PAGEUP, false, false);
	poll(&scene, 4);
	assert_int_equal(scene.events.joint, 0);
	assert_int_equal(scene.events.overlay, 0);
	scene_close(&scene);
}

static void test_escape_q_and_the_close_button_close(void **state)
{
	struct scene scene;
	SDL_Event quit = {.type = SDL_QUIT};

	(void)state;
	scene_open(&scene);
	push_key(SDLK_ESCAPE, true, false);
	poll(&scene, 1);
	assert_true(scene.events.close);
	poll(&scene, 2);
	assert_false(scene.events.close);
	push_key(SDLK_q, true, false);
	poll(&scene, 3);
	assert_true(scene.events.close);
	push_key(SDLK_q, false, false);
	poll(&scene, 4);
	assert_false(scene.events.close);
	push_window_event(SDL_WINDOWEVENT_CLOSE);
	poll(&scene, 5);
	assert_true(scene.events.close);
	assert_int_equal(SDL_PushEvent(&quit), 1);
	poll(&scene, 6);
	assert_true(scene.events.close);
	scene_close(&scene);
}

static void test_an_interrupt_closes(void **state)
{
	struct scene scene;

	(void)state;
	/* SDL does not catch a signal that a shell's "&" has set to ignored. */
	signal(SIGINT, SIG_DFL);
	scene_open(&scene);
	raise(SIGINT);
	poll(&scene, 1);
	assert_true(scene.events.close);
	scene_close(&scene);
}

/* What a window does with events, said a second time and more simply. */
struct reference {
	bool here[PAIRS];         /* keys that are pressed in the window */
	bool there[BUTTON_COUNT]; /* pressed by another source */
	bool down[BUTTON_COUNT];  /* as the queue has passed on */
	struct button_event event[64];
	int count;
	struct display_events seen;
};

static void reference_press(struct reference *reference, int button, int now_ms)
{
	bool down = reference->there[button];

	for (int i = 0; i < PAIRS; i++) {
		down = down ||
			((int)pairs[i].button == button && reference->here[i]);
	}
	if (reference->down[button] != down) {
		reference->down[button] = down;
		reference->event[reference->count++] = (struct button_event){
			now_ms, (enum button)button, down, 0};
	}
}

/* A key, or the loss of the focus, chosen at random. */
static void push_any(uint32_t *seed, struct reference *reference, int now_ms)
{
	static const SDL_Keycode others[] = {SDLK_ESCAPE, SDLK_q, SDLK_h,
		SDLK_p, SDLK_F7, SDLK_PAGEUP, SDLK_PAGEDOWN, SDLK_a};
	int which = random_between(seed, 0, PAIRS + 8);
	bool down = random_one_in(seed, 2);
	bool repeat = down && random_one_in(seed, 4);
	SDL_Keycode other = which < PAIRS + 8 ? others[which % 8] : 0;

	if (which < PAIRS) {
		push_key(pairs[which].key, down, repeat);
		if (!repeat) {
			reference->here[which] = down;
			reference_press(
				reference, (int)pairs[which].button, now_ms);
		}
	} else if (other) {
		push_key(other, down, repeat);
		if (down && !repeat) {
			struct display_events *seen = &reference->seen;

			seen->close |= other == SDLK_ESCAPE || other == SDLK_q;
			seen->graph += other == SDLK_h;
			seen->picture |= other == SDLK_p;
			seen->overlay += other == SDLK_F7;
			seen->joint += (other == SDLK_PAGEDOWN) -
				(other == SDLK_PAGEUP);
		}
	} else {
		push_window_event(SDL_WINDOWEVENT_FOCUS_LOST);
		for (int i = 0; i < PAIRS; i++) {
			reference->here[i] = false;
			reference_press(reference, (int)pairs[i].button, now_ms);
		}
	}
}

static void expect_seen(
	const struct display_events *seen, const struct display_events *wanted)
{
	assert_int_equal(seen->close, wanted->close);
	assert_int_equal(seen->graph, wanted->graph);
	assert_int_equal(seen->picture, wanted->picture);
	assert_int_equal(seen->overlay, wanted->overlay);
	assert_int_equal(seen->joint, wanted->joint);
	assert_int_equal(seen->resized, wanted->resized);
}

static void test_any_events_do_what_the_reference_does(void **state)
{
	struct reference reference = {.count = 0};
	struct scene scene;
	uint32_t seed = 7;

	(void)state;
	scene_open(&scene);
	for (int now_ms = 1; now_ms < 600; now_ms++) {
		int other = random_between(&seed, 0, BUTTON_COUNT - 1);

		reference.count = 0;
		reference.seen = (struct display_events){0};
		/* A source that is not the window. */
		if (random_one_in(&seed, 3)) {
			bool down = random_one_in(&seed, 2);

			reference.there[other] = down;
			reference_press(&reference, other, now_ms);
			scene.queue.source = 1;
			button_queue_push(&scene.queue,
				(struct button_event){
					now_ms, (enum button)other, down, 0});
			scene.queue.source = 0;
		}
		for (int i = random_between(&seed, 0, 5); i > 0; i--) {
			push_any(&seed, &reference, now_ms);
		}
		poll(&scene, now_ms);
		for (int i = 0; i < reference.count; i++) {
			expect(&scene, now_ms, reference.event[i].button,
				reference.event[i].down);
		}
		expect_nothing(&scene);
		expect_seen(&scene.events, &reference.seen);
	}
	scene_close(&scene);
}

static void test_windows_may_follow_each_other(void **state)
{
	(void)state;
	for (int i = 0; i < 3; i++) {
		struct scene scene;

		scene_open(&scene);
		draw(&scene, 64, 48);
		scene_close(&scene);
	}
}

static void test_a_missing_desktop_is_logged(void **state)
{
	const struct display_driver *driver = &display_driver_window;
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	const struct display_options options = {
		.width = 64, .height = 48, .log = &log};
	struct display *display = NULL;

	(void)state;
	setenv("SDL_VIDEODRIVER", "nothing-of-the-kind", 1);
	assert_true(driver->probe());
	assert_int_equal(driver->create(&options, &display), -ENODEV);
	assert_int_equal(capture.count, 1);
	assert_contains(capture.sentence[0], "--display window");
	assert_null(display);
	unsetenv("SDL_VIDEODRIVER");
	unsetenv("DISPLAY");
	unsetenv("WAYLAND_DISPLAY");
	assert_false(driver->probe());
	setenv("WAYLAND_DISPLAY", "wayland-0", 1);
	assert_true(driver->probe());
	unsetenv("WAYLAND_DISPLAY");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_frames_are_shown),
		cmocka_unit_test(test_keys_carry_the_keypads_names),
		cmocka_unit_test(test_key_repeat_is_ignored),
		cmocka_unit_test(test_losing_the_focus_releases_the_buttons),
		cmocka_unit_test(test_a_resized_window_hands_out_the_new_size),
		cmocka_unit_test(test_h_and_p_ask_for_graph_and_picture_once),
		cmocka_unit_test(
			test_page_keys_choose_the_next_and_the_last_joint),
		cmocka_unit_test(test_escape_q_and_the_close_button_close),
		cmocka_unit_test(test_an_interrupt_closes),
		cmocka_unit_test(test_any_events_do_what_the_reference_does),
		cmocka_unit_test(test_windows_may_follow_each_other),
		cmocka_unit_test(test_a_missing_desktop_is_logged),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

#else
#include "tests/unit/platform/display/window/no_window.h"

int main(void)
{
	return skip_the_window();
}

#endif
