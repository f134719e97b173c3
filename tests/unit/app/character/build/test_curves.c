/* What the lines of morphs and their curves say, as the morph keeps it. */
#include "app/character/character_data.h"
#include "platform/base/compiler.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>

struct wave {
	float amplitude, axis[3], delay, direction[3];
};

static void expect_waves(const char *text, const struct wave *waves, int count)
{
	struct acting acting;
	const struct character_morph *morph;

	acting_begin(&acting, "assets/face.glb");
	acting_expect(&acting, text);
	morph = &acting.character->morph[0];
	assert_int_equal(morph->curve_count, count);
	for (int i = 0; i < count; i++) {
		const struct morph_wave *wave = &morph->curve[i].wave;

		assert_near(wave->amplitude, waves[i].amplitude, 0);
		assert_all_near(wave->axis, waves[i].axis, 3, 1e-6);
		assert_near(wave->delay, waves[i].delay, 0);
		assert_all_near(wave->direction, waves[i].direction, 3, 1e-6);
	}
	acting_end(&acting);
}

/* Upwards at once, or along the axis that the line says. */
static void test_a_wave_runs_along_its_axis(void **state)
{
	static const struct wave waves[] = {{0.25f, {0, 1, 0}, 0, {1, 0, 0}},
		{0.5f, {0, 0, -1}, 0.75f, {1, 0, 0}},
		{0, {0.6f, 0, 0.8f}, 100, {1, 0, 0}}};

	(void)state;
	expect_waves("[morph a]\ncurve = sine 0.25\ndirection = 2 0 0\n"
		     "curve = sine 0.5 0 0 -3 0.75\ncurve = sine 0 3 0 4 100\n",
		waves, 3);
}

/* A later curve has the first one's, unless a line behind it says another. */
static void test_a_direction_is_that_of_the_curve_above(void **state)
{
	static const struct wave waves[] = {{0.1f, {0, 1, 0}, 0, {1, 0, 0}},
		{0.2f, {0, 1, 0}, 0, {0, -1, 0}},
		{0.3f, {0, 1, 0}, 0, {1, 0, 0}}};

	(void)state;
	expect_waves("[morph a]\ncurve = sine 0.1\ndirection = 5 0 0\n"
		     "curve = sine 0.2\ndirection = 0 -1 0\ncurve = sine 0.3\n",
		waves, 3);
	expect_waves(
		"[morph a]\ndirection = 5 0 0\ncurve = sine 0.1\n", waves, 1);
}

/* 30 frames a second, but at least one, unless the section gives a number. */
static void test_a_morph_takes_a_time_and_frames(void **state)
{
	static const struct {
		const char *text;
		double duration_s;
		int frames;
	} rows[] = {{"[morph a]\n", 0.6, 18}, {"[morph a]\ntime = 0\n", 0, 1},
		{"[morph a]\ntime = 0.01\n", 0.01, 1},
		{"[morph a]\ntime = 2\n", 2, 60},
		{"[morph a]\ntime = 0.55\n", 0.55, 17},
		{"[morph a]\ntime = 2\nframes = 7\n", 2, 7}};
	static const float front[3] = {0, 0, 1};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/face.glb");
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		const struct character_morph *morph;

		acting_expect(&acting, rows[i].text);
		morph = acting.character->morph;
		assert_near(morph->duration_s, rows[i].duration_s, 1e-6);
		assert_int_equal(morph->frame_count, rows[i].frames);
		assert_int_equal(morph->curve_count, 1);
		assert_string_equal(morph->curve[0].name, "linear");
		assert_all_near(morph->curve[0].wave.direction, front, 3, 0);
	}
	acting_end(&acting);
}

/* A switch that is on has its weight at once, without a fade. */
static void test_an_expression_starts_at_its_weight(void **state)
{
	static const struct {
		const char *lines;
		double level, now;
	} rows[] = {{"weight = 0.25\non = yes\n", 1, 0.25},
		{"weight = 0.25\non = no\n", 0, 0},
		{"weight = 0\non = yes\n", 1, 0}};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/face.glb");
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		const struct character_switch *is;
		char text[128];

		snprintf(text, sizeof(text),
			"[expression a]\ntargets = smile 1\n%s", rows[i].lines);
		acting_expect(&acting, text);
		is = acting.character->switches[0];
		assert_near(is->level, rows[i].level, 0);
		assert_near(is->now, rows[i].now, 0);
	}
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_wave_runs_along_its_axis),
		cmocka_unit_test(test_a_morph_takes_a_time_and_frames),
		cmocka_unit_test(test_an_expression_starts_at_its_weight),
		cmocka_unit_test(test_a_direction_is_that_of_the_curve_above),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
