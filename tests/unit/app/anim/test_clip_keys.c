/* Packed keys, the signs of rotations, and the ends of a channel's keys. */
#include "app/anim/clip.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	KEYS = 5
};

static const float TIMES[KEYS] = {0.5f, 1, 1.75f, 2, 3.5f};

/* About MODEL_PACKED_UNIT long, and w is the largest. */
static const int16_t PACKED[KEYS][4] = {{3000, -9000, 12000, 28977},
	{5000, -6000, 15000, 28060}, {9000, -3000, 17000, 26366},
	{13000, 2000, 12000, 27503}, {9000, 4000, 5000, 30840}};

static struct model_channel make(const float *value)
{
	return (struct model_channel){.path = MODEL_ROTATION,
		.interpolation = MODEL_LINEAR,
		.width = 4,
		.key_count = KEYS,
		.time_s = TIMES,
		.value = value};
}

static void unpack(float value[KEYS][4])
{
	for (int k = 0; k < KEYS; k++) {
		double sum = 0;

		for (int i = 0; i < 4; i++) {
			sum += (double)PACKED[k][i] * PACKED[k][i];
		}
		for (int i = 0; i < 4; i++) {
			value[k][i] = (float)(PACKED[k][i] / sqrt(sum));
		}
	}
}

static void test_packed_keys_are_sampled_as_others(void **state)
{
	float value[KEYS][4];
	struct model_channel other = make(value[0]), packed = make(NULL);

	(void)state;
	packed.packed = PACKED;
	unpack(value);
	for (int as = CLIP_AUTO; as <= CLIP_CUBIC; as++) {
		for (float t = 0; t < 4; t += 0.0625f) {
			float out[5] = {0, 0, 0, 0, 77};
			float want[5] = {0, 0, 0, 0, 77};
			int key[2] = {0, 0};

			clip_sample_channel(&packed, t,
				(enum clip_interpolation)as, &key[0], out);
			clip_sample_channel(&other, t,
				(enum clip_interpolation)as, &key[1], want);
			assert_all_near(out, want, 5, 5e-5);
		}
	}
}

/* Keys q and -q are one rotation. Keys as close as these make no detours. */
static void check_signs(float keys[KEYS][4], unsigned signs)
{
	float value[KEYS][4];
	struct model_channel flipped = make(value[0]), plain = make(keys[0]);

	for (int k = 0; k < KEYS; k++) {
		for (int i = 0; i < 4; i++) {
			value[k][i] = signs >> k & 1 ? -keys[k][i] : keys[k][i];
		}
	}
	for (float t = 0; t < 4; t += 0.0625f) {
		float out[3][4];
		double cosine[2] = {0, 0};
		int key = 0;

		clip_sample_channel(&flipped, t, CLIP_CUBIC, &key, out[0]);
		clip_sample_channel(&plain, t, CLIP_CUBIC, &key, out[1]);
		clip_sample_channel(&plain, t, CLIP_LINEAR, &key, out[2]);
		for (int i = 0; i < 4; i++) {
			cosine[0] += (double)out[0][i] * out[1][i];
			cosine[1] += (double)out[0][i] * out[2][i];
		}
		assert_near(fabs(cosine[0]), 1, 1e-4);
		assert_near(fabs(cosine[1]), 1, 0.01);
	}
}

/* Whichever of a quaternion's numbers is the largest, or negative. */
static void test_cubic_rotations_have_any_signs_of_keys(void **state)
{
	float value[KEYS][4], turned[KEYS][4];

	(void)state;
	unpack(value);
	for (int turn = 0; turn < 20; turn++) {
		for (int i = 0; i < 4 * KEYS; i++) {
			int k = i / 4, to = (i + turn) % 4;
			float sign = turn / 4 == to + 1 ? -1 : 1;

			turned[k][to] = sign * value[k][i % 4];
		}
		for (unsigned signs = 0; signs < 1u << KEYS; signs++) {
			check_signs(turned, signs);
		}
	}
}

static void test_a_channel_writes_no_more_than_its_width(void **state)
{
	static const float value[3 * 3 * 8] = {1, 2, 3, 4, 5, 6, 7, 8, 9};

	(void)state;
	for (int kind = MODEL_STEP; kind <= MODEL_CUBICSPLINE; kind++) {
		for (int width = 1; width < 8; width++) {
			float out[9];
			int key = 0;
			struct model_channel channel = make(value);

			channel.path = MODEL_WEIGHTS;
			channel.interpolation = (enum model_interpolation)kind;
			channel.width = width;
			channel.key_count = 3;
			for (float t = 0; t < 2; t += 0.125f) {
				out[width] = 77;
				clip_sample_channel(
					&channel, t, CLIP_AUTO, &key, out);
				assert_true(out[width] == 77);
			}
		}
	}
}

/* At, just before and just after each key, from each key that may be cached. */
static void test_a_key_is_found_from_any_other(void **state)
{
	enum {
		MOST = 9
	};
	float value[MOST];

	(void)state;
	for (int k = 0; k < MOST; k++) {
		value[k] = (float)(100 + k);
	}
	for (int count = 1; count <= MOST; count++) {
		/* Times beyond the last are below all others. */
		float time_s[MOST + 4] = {0};
		struct model_channel channel = {.path = MODEL_WEIGHTS,
			.interpolation = MODEL_STEP,
			.width = 1,
			.key_count = count,
			.time_s = time_s,
			.value = value};

		for (int k = 0; k < count; k++) {
			time_s[k] = 1 + (float)(k * k) / 4;
		}
		for (int i = 0; i < 3 * count * (count + 4); i++) {
			int at = i / 3 % count, side = i % 3 - 1;
			int cached = i / 3 / count - 2, key = cached;
			int want = side < 0 && at > 0 ? at - 1 : at;
			float out;

			clip_sample_channel(&channel,
				time_s[at] + 0.01f * (float)side, CLIP_AUTO,
				&key, &out);
			assert_true(out == value[want]);
			assert_int_equal(key, want);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_packed_keys_are_sampled_as_others),
		cmocka_unit_test(test_cubic_rotations_have_any_signs_of_keys),
		cmocka_unit_test(test_a_channel_writes_no_more_than_its_width),
		cmocka_unit_test(test_a_key_is_found_from_any_other),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
