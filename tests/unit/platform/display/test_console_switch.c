/* Switching to another console and back, as Ctrl-Alt-F2 and chvt do. */
#include "platform/display/console.h"
#include "platform/display/kms/kms_calls.h"
#include "tests/support/fake/fake_card.h"
#include "tests/support/fake/fbdev_scene.h"
#include "tests/support/test.h"

#include <errno.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <signal.h>
#include <string.h>

extern const struct display_driver display_driver_kms;

/* As the kernel asks whether it may leave the console, and tells of the return. */
static void ask(void)
{
	assert_int_equal(fake_fb.console_switching.mode, VT_PROCESS);
	raise(fake_fb.console_switching.relsig);
}

static void tell(void)
{
	raise(fake_fb.console_switching.acqsig);
}

static bool is_away(const struct display_driver *driver, struct display *display)
{
	struct display_events events;
	struct button_queue queue;

	button_queue_init(&queue, 0);
	driver->poll(display, 0, &queue, &events);
	assert_false(events.close);
	return events.away;
}

static void expect_answers(int count, int last)
{
	assert_int_equal(fake_fb.console_answers, count);
	assert_int_equal(fake_fb.console_answer, last);
}

static void open_framebuffer(struct fbdev_scene *scene, int pages)
{
	*scene = (struct fbdev_scene){0};
	fbdev_scene_begin_565(pages);
	fake_fb.has_console = true;
	assert_int_equal(fbdev_scene_open(scene), 0);
}

/* Shows a picture, then gives the screen to another console. */
static void leave_framebuffer(struct fbdev_scene *scene)
{
	open_framebuffer(scene, 2);
	fbdev_scene_draw(scene);
	ask();
	assert_true(is_away(scene->driver, scene->display));
}

/* Another program draws on the whole framebuffer. */
static void scribble(void)
{
	memset(fake_fb.memory, 0x55, fake_fb.fix.smem_len);
}

static void expect_filled(const struct fbdev_scene *scene, uint32_t pixel)
{
	(void)scene;
	for (uint32_t y = 0; y < fake_fb.var.yres; y++) {
		for (uint32_t x = 0; x < fake_fb.var.xres; x++) {
			assert_int_equal(fake_fb_seen((int)x, (int)y), pixel);
		}
	}
}

static void test_a_framebuffer_is_given_and_taken_again(void **state)
{
	(void)state;
	for (int pages = 1; pages <= 2; pages++) {
		struct fbdev_scene scene = {0};
		struct fb_var_screeninfo before;

		fbdev_scene_begin_565(pages);
		fake_fb.has_wait = true;
		fake_fb.has_console = true;
		before = fake_fb.var;
		assert_int_equal(fbdev_scene_open(&scene), 0);
		fbdev_scene_draw(&scene);
		assert_false(is_away(scene.driver, scene.display));
		ask();
		/* The frame is completed before. */
		fbdev_scene_draw(&scene);
		expect_answers(0, 0);
		assert_true(is_away(scene.driver, scene.display));
		expect_answers(1, 1);
		assert_int_equal(fake_fb.var.yoffset, before.yoffset);
		assert_int_equal(fake_fb.var.yres_virtual, before.yres_virtual);
		scribble();
		assert_true(is_away(scene.driver, scene.display));
		expect_filled(&scene, 0x5555);

		tell();
		assert_false(is_away(scene.driver, scene.display));
		expect_answers(2, VT_ACKACQ);
		expect_filled(&scene, 0);
		fbdev_scene_draw(&scene);
		assert_int_not_equal(fake_fb_seen(3, 3), 0x5555);
		assert_false(is_away(scene.driver, scene.display));
		fbdev_scene_close(&scene);
		assert_int_equal(fake_fb.console_switching.mode, VT_AUTO);
		assert_int_equal(fake_fb.console_mode, KD_TEXT);
	}
}

/* What the other program has set is not changed when limber ends meanwhile. */
static void test_a_screen_that_is_away_is_left_alone_at_the_end(void **state)
{
	struct fbdev_scene scene;
	int puts;

	(void)state;
	leave_framebuffer(&scene);
	puts = fake_fb.put_count;
	scene.driver->destroy(scene.display);
	assert_int_equal(fake_fb.put_count, puts);
	assert_int_equal(fake_fb.open_count, 0);
	assert_int_equal(fake_fb.console_switching.mode, VT_AUTO);
	assert_int_equal(fake_fb.console_mode, KD_TEXT);
}

static void test_a_mode_that_cannot_be_set_back_is_an_error(void **state)
{
	struct fbdev_scene scene;
	struct pixels pixels;

	(void)state;
	leave_framebuffer(&scene);
	fake_fb.rounds_width = true;
	tell();
	assert_false(is_away(scene.driver, scene.display));
	assert_int_equal(
		scene.driver->begin_frame(scene.display, &pixels), -ENOTSUP);
	assert_true(log_capture_has(
		&scene.capture, LOG_ERROR, "another program has changed"));
	scene.driver->destroy(scene.display);
}

struct card_scene {
	struct log_capture capture;
	struct log log;
	struct display *display;
};

static void open_card(struct card_scene *scene)
{
	const struct display_options options = {.log = &scene->log};

	scene->log = log_capture_begin(&scene->capture);
	fake_card_begin();
	fake_fb_begin(8, 8, 8, 8, 16, fbdev_scene_layout_565);
	fake_fb.has_console = true;
	assert_int_equal(
		kms_create_on(&fake_card_calls, &options, &scene->display), 0);
}

static void draw_card(struct display *display)
{
	struct pixels pixels;

	assert_int_equal(display_driver_kms.begin_frame(display, &pixels), 0);
	assert_int_equal(display_driver_kms.end_frame(display), 0);
}

/* Without rights the guard answers (test_console_guard); here nobody can. */
static void test_a_console_that_may_not_be_left_goes_on(void **state)
{
	struct fbdev_scene scene;
	struct card_scene card;

	(void)state;
	open_framebuffer(&scene, 2);
	fake_fb.fail_request = VT_RELDISP;
	fake_fb.fail_error = EIO;
	ask();
	assert_false(is_away(scene.driver, scene.display));
	assert_true(log_capture_has(
		&scene.capture, LOG_WARNING, "Input/output error: start it"));
	fbdev_scene_draw(&scene);
	assert_int_not_equal(fake_fb_seen(3, 3), 0);
	fbdev_scene_close(&scene);

	open_card(&card);
	fake_fb.fail_request = VT_RELDISP;
	fake_fb.fail_error = EIO;
	ask();
	assert_false(is_away(&display_driver_kms, card.display));
	draw_card(card.display);
	display_driver_kms.destroy(card.display);
}

/* Ends while a switch waits: the user gets the other console. */
static void test_a_switch_takes_place_at_the_end(void **state)
{
	struct fbdev_scene scene;

	(void)state;
	open_framebuffer(&scene, 1);
	ask();
	fbdev_scene_draw(&scene);
	fbdev_scene_close(&scene);
	expect_answers(1, 1);
	assert_int_equal(fake_fb.console_switching.mode, VT_AUTO);
}

/* The kernel notices at the next switch only that a program was killed. */
static void test_a_console_of_a_killed_limber_is_not_in_use(void **state)
{
	struct fbdev_scene scene;
	struct vt_mode ours;

	(void)state;
	open_framebuffer(&scene, 1);
	ours = fake_fb.console_switching;
	fbdev_scene_close(&scene);
	fake_fb.console_mode = KD_GRAPHICS;
	fake_fb.console_switching = ours;
	assert_false(console_is_in_use(&fake_fb_calls));
	fake_fb.console_switching.relsig = SIGUSR1;
	assert_true(console_is_in_use(&fake_fb_calls));
}

/* A program may inherit both, and the kernel would wait for ever. */
static void test_ignored_and_blocked_signals_do_not_matter(void **state)
{
	struct fbdev_scene scene;
	sigset_t all, former;

	(void)state;
	for (int i = SIGRTMIN; i <= SIGRTMAX; i++) {
		signal(i, SIG_IGN);
	}
	sigfillset(&all);
	sigprocmask(SIG_BLOCK, &all, &former);
	open_framebuffer(&scene, 1);
	ask();
	assert_true(is_away(scene.driver, scene.display));
	scene.driver->destroy(scene.display);
	sigprocmask(SIG_SETMASK, &former, NULL);
	for (int i = SIGRTMIN; i <= SIGRTMAX; i++) {
		assert_true(signal(i, SIG_DFL) == SIG_IGN);
	}
}

static void test_a_card_is_given_and_taken_again(void **state)
{
	struct card_scene card;
	uint32_t shown;

	(void)state;
	open_card(&card);
	draw_card(card.display);
	ask();
	draw_card(card.display);
	assert_true(is_away(&display_driver_kms, card.display));
	expect_answers(1, 1);
	assert_true(fake_card.not_master);
	shown = fake_card.shown_fb;
	fake_card.shown_fb = 99;

	/* X is quick to ask for the console, and slow to give up the card. */
	fake_card.held = true;
	tell();
	assert_true(is_away(&display_driver_kms, card.display));
	expect_answers(1, 1);
	fake_card.held = false;
	assert_false(is_away(&display_driver_kms, card.display));
	expect_answers(2, VT_ACKACQ);
	assert_int_equal(fake_card.shown_fb, shown);
	draw_card(card.display);
	assert_int_equal(
		card.capture.count, log_capture_count(&card.capture, LOG_NOTE));
	display_driver_kms.destroy(card.display);
	assert_int_equal(fake_card.open_count, 0);
}

/* Old kernels let only root drop it. The console would be invisible. */
static void test_a_card_that_cannot_be_given_is_kept(void **state)
{
	struct card_scene card;

	(void)state;
	open_card(&card);
	fake_card.fail = CALL_DROP;
	fake_card.fail_error = EACCES;
	ask();
	assert_false(is_away(&display_driver_kms, card.display));
	expect_answers(1, 0);
	draw_card(card.display);
	fake_card.fail = CALL_NONE;
	ask();
	assert_true(is_away(&display_driver_kms, card.display));
	display_driver_kms.destroy(card.display);
	assert_int_equal(fake_card.open_count, 0);
}

static void test_a_card_without_its_mode_is_an_error(void **state)
{
	struct card_scene card;
	struct pixels pixels;

	(void)state;
	open_card(&card);
	ask();
	assert_true(is_away(&display_driver_kms, card.display));
	fake_card.fail = CALL_SET;
	fake_card.fail_error = ENOSPC;
	tell();
	assert_false(is_away(&display_driver_kms, card.display));
	assert_true(display_driver_kms.begin_frame(card.display, &pixels) < 0);
	assert_true(log_capture_has(
		&card.capture, LOG_ERROR, "show pictures again"));
	display_driver_kms.destroy(card.display);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_framebuffer_is_given_and_taken_again),
		cmocka_unit_test(
			test_a_screen_that_is_away_is_left_alone_at_the_end),
		cmocka_unit_test(test_a_mode_that_cannot_be_set_back_is_an_error),
		cmocka_unit_test(test_a_console_that_may_not_be_left_goes_on),
		cmocka_unit_test(test_a_switch_takes_place_at_the_end),
		cmocka_unit_test(test_a_console_of_a_killed_limber_is_not_in_use),
		cmocka_unit_test(test_ignored_and_blocked_signals_do_not_matter),
		cmocka_unit_test(test_a_card_is_given_and_taken_again),
		cmocka_unit_test(test_a_card_that_cannot_be_given_is_kept),
		cmocka_unit_test(test_a_card_without_its_mode_is_an_error),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
