/* To which stages and frames the time of a run belongs. */
#include "app/cmd/show/frame_watch.h"
#include "platform/process/clock.h"
#include "tests/support/test.h"

#include <time.h>

static void wait_ms(int ms)
{
	const struct timespec time = {.tv_nsec = ms * 1000000L};

	assert_int_equal(nanosleep(&time, NULL), 0);
}

/* Plays a frame of 4, 2 and 1 ms, after a pause of 8 ms. */
static void play_frame(struct frame_watch *watch)
{
	wait_ms(8);
	frame_watch_begin(watch);
	wait_ms(4);
	frame_watch_stage(watch, HUD_ANIMATE);
	wait_ms(2);
	frame_watch_stage(watch, HUD_DRAW);
	wait_ms(1);
	frame_watch_stage(watch, HUD_PRESENT);
	frame_watch_end(watch);
}

static void test_each_stage_has_the_time_since_the_one_before(void **state)
{
	struct frame_watch watch = {0};
	int64_t begun_ns = clock_monotonic_ns();
	float all_ms, sum_ms = 0.0f;

	(void)state;
	play_frame(&watch);
	all_ms = (float)(clock_monotonic_ns() - begun_ns) * 1e-6f;
	for (int i = 0; i < HUD_STAGES; i++) {
		assert_true(watch.stage_ms[i] >= (float)(4 >> i));
		sum_ms += watch.stage_ms[i];
	}
	/* The pause before the frame belongs to no stage. */
	assert_true(sum_ms <= all_ms - 8.0f);
	wait_ms(1);
	frame_watch_begin(&watch);
	assert_true(watch.stage_ms[HUD_ANIMATE] == 0.0f);
	frame_watch_stage(&watch, HUD_DRAW);
	all_ms = watch.stage_ms[HUD_DRAW];
	wait_ms(3);
	frame_watch_stage(&watch, HUD_DRAW);
	assert_true(watch.stage_ms[HUD_DRAW] >= all_ms + 3.0f);
}

static void test_a_frame_lasts_since_the_end_of_the_one_before(void **state)
{
	struct frame_watch watch = {0};
	int64_t first_ns;

	(void)state;
	play_frame(&watch);
	first_ns = watch.ended_ns;
	assert_true(first_ns > 0);
	/* Before the second one's end it is not known how long a frame lasts. */
	assert_int_equal(watch.graph.count, 0);
	play_frame(&watch);
	assert_int_equal(watch.graph.count, 1);
	assert_true(
		watch.graph.ms[0][HUD_ANIMATE] == watch.stage_ms[HUD_ANIMATE]);
	assert_near(watch.graph.sum.interval_ms + watch.graph.shown.interval_ms,
		(double)(watch.ended_ns - first_ns) * 1e-6, 1e-3);
	assert_true(watch.ended_ns - first_ns >= 15 * INT64_C(1000000));
}

/* Reading the memory takes time, and it changes slowly. */
static void test_memory_is_read_every_33_frames(void **state)
{
	const struct demo_facts facts = {.technique = "Skeletal"};
	struct frame_watch watch = {.shown = true};
	static const struct hud_place beside = {HUD_BOTTOM_LEFT, 0};
	static struct hud hud;

	(void)state;
	hud.font = &font_default;
	for (int frame = 0; frame < 100; frame++) {
		watch.memory_bytes = 1;
		hud_begin(&hud, 480, 640);
		frame_watch_show(&watch, &facts, "soft", NULL, &beside, &hud);
		assert_int_equal(watch.memory_bytes > 1, frame % 33 == 0);
		assert_true(hud.quad_count > 0);
	}
	watch.shown = false;
	watch.memory_wait = 0;
	watch.memory_bytes = 1;
	hud_begin(&hud, 480, 640);
	frame_watch_show(&watch, &facts, "soft", NULL, &beside, &hud);
	assert_int_equal(watch.memory_bytes, 1);
	assert_int_equal(hud.quad_count, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_each_stage_has_the_time_since_the_one_before),
		cmocka_unit_test(
			test_a_frame_lasts_since_the_end_of_the_one_before),
		cmocka_unit_test(test_memory_is_read_every_33_frames),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
