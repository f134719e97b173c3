/* Which channels of an animation share times. */
#include "platform/base/compiler.h"
#include "tests/support/test.h"
#include "tests/unit/app/compare/optimize/build/keys_bench.h"

#include <math.h>
#include <string.h>

/* Times of their own take an accessor more than a few values take. */
static void test_channels_share_the_times_of_few_keys(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	memcpy(f.time_s[1], f.time_s[0], sizeof(f.time_s[1]));
	bend(&f, 0, 7, 20);
	bend(&f, 1, 9, 33);
	bend(&f, 2, 7, 20);
	choose(&f);
	for (int c = 0; c < 2; c++) {
		assert_int_equal(f.channel[c].group, 0);
		expect_kept(&f, c, (const int[]){0, 7, 9, 20, 33, KEYS - 1}, 6);
	}
	assert_int_equal(f.channel[2].group, 2);
	expect_kept(&f, 2, (const int[]){0, 7, 20, KEYS - 1}, 4);
	end(&f);
}

/* A channel of two keys shares no times that would give it 40. */
static void test_many_keys_are_not_shared(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	memcpy(f.time_s[1], f.time_s[0], sizeof(f.time_s[1]));
	bend(&f, 1, KEYS, KEYS);
	for (int k = 0; k < KEYS; k++) {
		f.value[0][k][2] = (float)(k % 2);
	}
	choose(&f);
	assert_int_equal(f.channel[1].group, 0);
	assert_int_equal(f.channel[0].kept_count, KEYS);
	expect_kept(&f, 1, (const int[]){0, KEYS - 1}, 2);
	end(&f);
}

/*
 * Times of its own take a channel 4 bytes a key and an accessor of about 110.
 * It shares those of others while the values of more keys take fewer.
 */
static void test_channels_share_times_while_that_takes_fewer_bytes(void **state)
{
	static const struct {
		enum model_path path;
		int width;
		int most; /* shared keys for which it gives up its two */
	} cases[] = {
		{MODEL_TRANSLATION, 3, 11}, /* 142 bytes or 12 a key */
		{MODEL_SCALE, 3, 11},
		{MODEL_ROTATION, 4, 16}, /* 134 bytes or 8 a key */
		{MODEL_WEIGHTS, 5, 7},   /* 158 bytes or 20 a key */
	};

	(void)state;
	for (int i = 0; i < 2 * (int)ARRAY_COUNT(cases); i++) {
		int width = cases[i / 2].width, most = cases[i / 2].most;
		float value[KEYS * 5] = {0};
		int bends = most - 2 + i % 2; /* besides the ends */
		struct fixture f;

		begin(&f);
		memcpy(f.time_s[1], f.time_s[0], sizeof(f.time_s[1]));
		for (int k = 0; k < KEYS; k++) {
			f.value[0][k][1] = (float)(k <= bends
					? k % 2
					: bends % 2 + 3 * (k - bends));
			value[k * width] = (float)k / 64.0f;
		}
		f.channel[1].track.path = cases[i / 2].path;
		f.channel[1].track.width = width;
		f.channel[1].track.value = value;
		if (cases[i / 2].path == MODEL_ROTATION) {
			f.channel[1].track.bound_px = 0.05f;
			for (int k = 0; k < KEYS; k++) {
				value[4 * k] = sinf(0.01f * (float)k);
				value[4 * k + 3] = cosf(0.01f * (float)k);
			}
		}
		memset(f.moved, true, sizeof(f.moved));
		choose(&f);
		assert_int_equal(f.channel[0].kept_count, bends + 2);
		assert_int_equal(f.channel[1].kept_count, i % 2 ? 2 : bends + 2);
		end(&f);
	}
}

/* Three keys with times of their own take 3 * 16 + 110 bytes. */
static void test_three_keys_give_way_to_13_but_not_to_14(void **state)
{
	(void)state;
	for (int shared = 12; shared <= 15; shared++) {
		struct fixture f;

		begin(&f);
		memcpy(f.time_s[1], f.time_s[0], sizeof(f.time_s[1]));
		/* It bends at each of the keys 1 to shared - 2. */
		for (int k = 0; k < KEYS; k++) {
			int bends = shared - 2;

			f.value[0][k][1] = (float)(k <= bends
					? k % 2
					: bends % 2 + 3 * (k - bends));
		}
		bend(&f, 1, 5, KEYS);
		choose(&f);
		assert_int_equal(f.channel[0].kept_count, shared);
		assert_int_equal(
			f.channel[1].kept_count, shared <= 13 ? shared : 3);
		end(&f);
	}
}

/* Whatever their hashes are: some of these share a bucket. */
static void test_times_that_differ_in_any_key_are_not_shared(void **state)
{
	(void)state;
	for (int k = 1; k < KEYS; k++) {
		struct fixture f;

		begin(&f);
		memcpy(f.time_s[1], f.time_s[0], sizeof(f.time_s[1]));
		f.time_s[1][k] += 0.125f;
		bend(&f, 0, 7, 20);
		bend(&f, 1, 9, 33);
		choose(&f);
		assert_int_equal(f.channel[0].group, 0);
		assert_int_equal(f.channel[1].group, 1);
		end(&f);
	}
}

/* Keys of steps, and of splines, do not suffice for lines. */
static void test_channels_of_other_keys_share_no_times(void **state)
{
	(void)state;
	for (int i = 0; i < 4; i++) {
		struct optimize_reach_node own = reach;
		float value[KEYS * 9] = {0};
		struct fixture f;

		begin(&f);
		memcpy(f.time_s[1], f.time_s[0], sizeof(f.time_s[1]));
		bend(&f, 0, 7, 20);
		bend(&f, 1, 9, 33);
		f.channel[1].track.reach = &own;
		switch (i) {
		case 0:
			f.channel[1].track.interpolation = MODEL_STEP;
			break;
		case 1:
			f.channel[1].track.interpolation = MODEL_CUBICSPLINE;
			f.channel[1].track.value = value;
			value[4] = 1.0f;
			break;
		case 2:
			f.time_s[1][KEYS - 1] += 0.25f;
			break;
		default:
			f.channel[1].track.reach = NULL;
			break;
		}
		choose(&f);
		expect_kept(&f, 0, (const int[]){0, 7, 20, KEYS - 1}, 4);
		assert_int_equal(f.channel[0].group, 0);
		assert_int_equal(f.channel[1].group, i % 2 ? -1 : 1);
		assert_int_equal(f.channel[1].kept_count, i == 2 ? 5 : KEYS);
		end(&f);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_channels_share_the_times_of_few_keys),
		cmocka_unit_test(test_many_keys_are_not_shared),
		cmocka_unit_test(
			test_channels_share_times_while_that_takes_fewer_bytes),
		cmocka_unit_test(test_three_keys_give_way_to_13_but_not_to_14),
		cmocka_unit_test(
			test_times_that_differ_in_any_key_are_not_shared),
		cmocka_unit_test(test_channels_of_other_keys_share_no_times),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
