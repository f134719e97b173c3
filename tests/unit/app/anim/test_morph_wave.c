/* The wave of a sinusoidal morph. */
#include "app/anim/morph_wave.h"
#include "tests/support/test.h"

#include <math.h>

static const struct morph_wave alike = {.amplitude = 0.1f};
static const struct morph_wave running = {.amplitude = 0.1f, .delay = 1.5f};

static void test_without_delay_it_is_the_documents_sine(void **state)
{
	(void)state;
	for (int i = 0; i <= 20; i++) {
		float omega = (float)i / 20.0f;

		for (int k = 0; k <= 4; k++) {
			assert_near(
				morph_wave_at(&alike, omega, (float)k / 4.0f),
				0.1 * sin(3.14159265 * (double)omega), 1e-5);
		}
	}
}

static void test_every_place_begins_and_ends_at_rest(void **state)
{
	(void)state;
	for (int k = 0; k <= 10; k++) {
		float place = (float)k / 10.0f, highest = 0.0f;

		assert_true(morph_wave_at(&running, 0.0f, place) == 0.0f);
		assert_true(morph_wave_at(&running, 1.0f, place) == 0.0f);
		for (int i = 0; i <= 200; i++) {
			highest = fmaxf(highest,
				morph_wave_at(
					&running, (float)i / 200.0f, place));
		}
		assert_near(highest, 0.1, 1e-3);
	}
}

/* The crest is at the first place early and at the last one late. */
static void test_the_crest_runs_along_the_axis(void **state)
{
	float before = -1.0f;

	(void)state;
	for (int i = 2; i <= 8; i++) {
		float omega = (float)i / 10.0f, crest = 0.0f, height = -1.0f;

		for (int k = 0; k <= 100; k++) {
			float own = morph_wave_at(
				&running, omega, (float)k / 100.0f);

			if (own > height) {
				height = own;
				crest = (float)k / 100.0f;
			}
		}
		assert_true(crest > before);
		before = crest;
	}
}

static void test_an_omega_of_its_own_is_0_to_1(void **state)
{
	(void)state;
	assert_near(morph_wave_omega(&running, 0, 1), 0, 0);
	assert_near(morph_wave_omega(&running, 0.4f, 0), 1, 1e-6);
	assert_near(morph_wave_omega(&running, 1, 0), 1, 0);
	assert_near(morph_wave_omega(&running, 0.8f, 1), 0.5, 1e-6);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_without_delay_it_is_the_documents_sine),
		cmocka_unit_test(test_every_place_begins_and_ends_at_rest),
		cmocka_unit_test(test_the_crest_runs_along_the_axis),
		cmocka_unit_test(test_an_omega_of_its_own_is_0_to_1),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
