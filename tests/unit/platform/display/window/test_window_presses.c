/* Keys of a window that are pressed more than once within one frame. */
#include "platform/display/display.h"
#include "tests/support/button_events.h"
#include "tests/support/test.h"

#include <stdlib.h>

#if __has_include(<SDL.h>)
#include <SDL.h>

extern const struct display_driver display_driver_window;

static void push_key(SDL_Keycode key, bool down)
{
	SDL_Event event = {.key = {
				   .type = down ? SDL_KEYDOWN : SDL_KEYUP,
				   .state = down ? SDL_PRESSED : SDL_RELEASED,
				   .keysym = {.sym = key},
			   }};

	assert_int_equal(SDL_PushEvent(&event), 1);
}

static void press(SDL_Keycode key, int times)
{
	for (int i = 0; i < times; i++) {
		push_key(key, true);
		push_key(key, false);
	}
}

static void test_all_presses_of_a_frame_count(void **state)
{
	struct log log = log_to_nowhere();
	const struct display_options options = {
		.width = 64, .height = 48, .log = &log};
	struct display_events events;
	struct button_queue queue;
	struct display *display;

	(void)state;
	setenv("SDL_VIDEODRIVER", "dummy", 1);
	assert_int_equal(display_driver_window.create(&options, &display), 0);
	button_queue_init(&queue, BUTTON_DEBOUNCE_MS);
	display_driver_window.poll(display, 0, &queue, &events);
	press(SDLK_h, 2);
	press(SDLK_F7, 3);
	press(SDLK_PAGEDOWN, 4);
	press(SDLK_PAGEUP, 1);
	press(SDLK_F6, 2);
	display_driver_window.poll(display, 40, &queue, &events);
	assert_int_equal(events.graph, 2);
	assert_int_equal(events.overlay, 3);
	assert_int_equal(events.joint, 3);
	for (int i = 0; i < 4; i++) {
		button_expect(&queue, 40, BUTTON_F6, i % 2 == 0);
	}
	button_expect_nothing(&queue);
	/* A contact bounces, too, if a window was polled before it. */
	button_push(&queue, 60, BUTTON_F6, true);
	button_push(&queue, 61, BUTTON_F6, false);
	button_expect(&queue, 60, BUTTON_F6, true);
	button_expect_nothing(&queue);
	display_driver_window.destroy(display);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_all_presses_of_a_frame_count),
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
