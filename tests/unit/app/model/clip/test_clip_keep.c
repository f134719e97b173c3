/* Which channels a clip keeps as one key, as shorts, or with shared times. */
#include "app/model/model_loader.h"
#include "tests/support/test.h"

#include <string.h>

static const float time_s[3] = {0, 1, 2};

/* A little of the largest value of a path is noise, whichever path it is. */
static void test_each_path_has_its_own_noise(void **state)
{
	static const float large[8] = {0, 0, 0, 0, 0, 1000, 0, 0};
	static const float noisy[8] = {1, 1, 1, 1, 1, 1, 1, 1.001f};

	(void)state;
	for (int path = MODEL_TRANSLATION; path <= MODEL_WEIGHTS; path++) {
		for (int other = 0; other < 2; other++) {
			struct model_channel channel[2] = {
				{.value = noisy}, {.value = large}};
			struct model_clip clip = {
				.channel_count = 2, .channel = channel};
			struct model model = {.clip_count = 1, .clip = &clip};

			for (int c = 0; c < 2; c++) {
				channel[c].path = (enum model_path)path;
				channel[c].interpolation = MODEL_LINEAR;
				channel[c].width = 4;
				channel[c].key_count = 2;
				channel[c].time_s = time_s;
			}
			if (other) {
				channel[1].path = path == MODEL_WEIGHTS
					? MODEL_SCALE
					: MODEL_WEIGHTS;
			}
			model_prepare_clips(&model);
			assert_int_equal(channel[0].constant, !other);
			assert_false(channel[1].constant);
		}
	}
}

/* Keeps a channel of shorts, which are also given as floats. */
static void keep(struct model_channel *channel, const int16_t (*packed)[4],
	int count, struct arena *arena)
{
	static float value[3][4];
	struct arena keys = arena_empty();
	struct model_clip clip = {.channel_count = 1, .channel = channel};

	for (int k = 0; k < count; k++) {
		for (int i = 0; i < 4; i++) {
			value[k][i] = (float)packed[k][i] / MODEL_PACKED_UNIT;
		}
	}
	*channel = (struct model_channel){.path = MODEL_ROTATION,
		.interpolation = MODEL_LINEAR,
		.width = 4,
		.key_count = count,
		.time_s = time_s,
		.value = value[0],
		.packed = packed};
	assert_int_equal(model_keep_clip(&clip, &keys, arena), 0);
}

/* Each number decides alone about the sign of the next key, and all turn. */
static void test_keys_of_shorts_take_the_shorter_arc(void **state)
{
	struct arena arena = arena_empty();

	(void)state;
	for (int i = 0; i < 4; i++) {
		int16_t key[3][4] = {{0}}, wanted[3][4];
		struct model_channel channel;

		for (int k = 0; k < 3; k++) {
			key[k][i] = (int16_t)(k == 1 ? -26214 : 26214);
			key[k][(i + 1 + k) % 4] = -19660;
		}
		/* (0.8, -0.6, 0, 0), (-0.8, 0, -0.6, 0), (0.8, 0, 0, -0.6) */
		memcpy(wanted, key, sizeof(wanted));
		for (int n = 0; n < 4; n++) {
			wanted[1][n] = (int16_t)-wanted[1][n];
		}
		keep(&channel, (const int16_t(*)[4])key, 3, &arena);
		assert_int_equal(channel.key_count, 3);
		assert_null(channel.value);
		assert_non_null(channel.packed);
		assert_memory_equal(channel.packed, wanted, sizeof(wanted));
	}
	arena_release(&arena);
}

/* Each number counts for the length that shorts must have. */
static void test_shorts_of_another_length_become_floats(void **state)
{
	struct arena arena = arena_empty();

	(void)state;
	for (int i = 0; i < 4; i++) {
		for (int length = 32764; length <= 32767; length++) {
			int16_t key[2][4] = {{0}};
			struct model_channel channel;
			float out[4];

			key[0][(i + 1) % 4] = 32767;
			key[1][i] = (int16_t)length;
			keep(&channel, (const int16_t(*)[4])key, 2, &arena);
			/* The square may be 8e-5 away, which is 1.3 steps. */
			assert_int_equal(
				channel.packed != NULL, length >= 32766);
			model_channel_key(&channel, 1, out);
			assert_near(out[i],
				channel.packed ? 1.0 : length / 32767.0, 1e-7);
			assert_near(out[(i + 1) % 4], 0, 0);
			model_channel_key(&channel, 0, out);
			assert_near(out[(i + 1) % 4], 1, 0);
		}
	}
	arena_release(&arena);
}

/* Each number of a key counts for its length, to a millionth. */
static void test_all_numbers_of_a_rotation_make_its_length(void **state)
{
	(void)state;
	for (int i = 0; i < 16; i++) {
		for (int more = -1; more <= 1; more++) {
			float length = 1.0f + 1e-5f * (float)more;
			float key[2][4] = {{0, 0, 0, 1}};
			struct model_channel channel = {.path = MODEL_ROTATION,
				.interpolation = MODEL_LINEAR,
				.width = 4,
				.key_count = 2,
				.time_s = time_s,
				.value = key[0]};
			struct model_clip clip = {
				.channel_count = 1, .channel = &channel};
			struct model model = {.clip_count = 1, .clip = &clip};

			key[1][i / 4] = 0.6f * length;
			key[1][i % 4] = (i / 4 == i % 4 ? 1.0f : 0.8f) * length;
			model_prepare_clips(&model);
			assert_int_equal(channel.unit, more == 0);
		}
	}
}

static void test_a_key_of_floats_is_read_at_its_place(void **state)
{
	static const float value[9] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
	const struct model_channel channel = {
		.width = 3, .key_count = 3, .value = value};

	(void)state;
	for (int k = 0; k < 3; k++) {
		float out[4] = {0, 0, 0, -1};

		model_channel_key(&channel, k, out);
		assert_all_near(out, value + 3 * k, 3, 0);
		assert_near(out[3], -1, 0);
	}
}

enum {
	FARTHEST = 256,
	CHANNELS = FARTHEST + 2
};

/* Only the channels of a distance share their times, as there may be many. */
static void test_times_are_shared_with_256_channels_before(void **state)
{
	static float time[CHANNELS][2];
	static const float value[2] = {0, 1};
	static struct model_channel channel[CHANNELS];

	(void)state;
	for (int last = FARTHEST - 1; last <= FARTHEST + 1; last++) {
		struct model_clip clip = {
			.channel_count = last + 1, .channel = channel};
		struct model model = {.clip_count = 1, .clip = &clip};

		for (int c = 0; c <= last; c++) {
			time[c][0] = 0;
			time[c][1] = 1.0f + (float)(c == last ? 0 : c);
			channel[c] = (struct model_channel){.path = MODEL_SCALE,
				.interpolation = MODEL_LINEAR,
				.width = 1,
				.key_count = 2,
				.time_s = time[c],
				.value = value};
		}
		model_prepare_clips(&model);
		assert_ptr_equal(
			channel[last].time_s, time[last > FARTHEST ? last : 0]);
		assert_ptr_equal(channel[last - 1].time_s, time[last - 1]);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_path_has_its_own_noise),
		cmocka_unit_test(test_keys_of_shorts_take_the_shorter_arc),
		cmocka_unit_test(test_shorts_of_another_length_become_floats),
		cmocka_unit_test(test_all_numbers_of_a_rotation_make_its_length),
		cmocka_unit_test(test_a_key_of_floats_is_read_at_its_place),
		cmocka_unit_test(test_times_are_shared_with_256_channels_before),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
