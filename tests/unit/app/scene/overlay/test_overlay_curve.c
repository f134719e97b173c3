#include "app/scene/overlay/overlay_curve.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <math.h>

enum {
	KEYS_MAX = 5,
	TARGETS_MAX = 6
};

/* A curve's points are evenly spaced from the first moment to the last. */
static double moment(int point)
{
	return point / (double)(OVERLAY_CURVE_POINTS - 1);
}

static float squared(const void *user, float omega)
{
	return *(const float *)user * omega * omega;
}

static void test_a_morphs_curves_are_slope_signal_and_sum(void **state)
{
	static const float factor = 0.75f;
	static const float waves[] = {0.0f, 0.25f, -1.5f};

	(void)state;
	for (int i = 0; i < 3; i++) {
		for (int shaped = 0; shaped < 2; shaped++) {
			const struct overlay_way way = {
				waves[i], shaped ? squared : NULL, &factor};
			struct overlay_curve curve =
				overlay_curve_of_morph(&way, 0.625f);

			assert_int_equal(curve.count, waves[i] == 0.0f ? 1 : 3);
			assert_near(curve.at, 0.625, 0.0);
			for (int p = 0; p < OVERLAY_CURVE_POINTS; p++) {
				double t = moment(p);
				double slope = shaped ? 0.75 * t * t : t;
				double signal = (double)waves[i] *
					sin(3.14159265358979 * t);

				assert_near(curve.value[0][p], slope + signal,
					1e-5);
				if (curve.count == 3) {
					assert_near(curve.value[1][p], signal,
						1e-5);
					assert_near(
						curve.value[2][p], slope, 1e-5);
				}
			}
		}
	}
}

struct weights {
	float time_s[KEYS_MAX];
	float value[KEYS_MAX * TARGETS_MAX];
	struct model_channel channel;
	struct model_clip clip;
};

static void make_weights(struct weights *weights, uint32_t *seed)
{
	struct model_channel *channel = &weights->channel;
	float time_s = 0.0f;

	*channel = (struct model_channel){.path = MODEL_WEIGHTS,
		.interpolation = MODEL_LINEAR,
		.width = random_between(seed, 1, TARGETS_MAX),
		.key_count = random_between(seed, 2, KEYS_MAX),
		.time_s = weights->time_s,
		.value = weights->value};
	for (int key = 0; key < channel->key_count; key++) {
		weights->time_s[key] = time_s;
		time_s += (float)random_between(seed, 1, 40) / 16.0f;
	}
	for (int i = 0; i < KEYS_MAX * TARGETS_MAX; i++) {
		weights->value[i] = (float)random_within(seed, 64) / 64.0f;
	}
	weights->clip = (struct model_clip){.name = "any",
		.duration_s = weights->time_s[channel->key_count - 1],
		.channel_count = 1,
		.channel = channel};
}

/* The straight line between the keys around a time. */
static double weight_at(const struct weights *weights, int target, double time_s)
{
	const struct model_channel *channel = &weights->channel;
	int key = 0;
	double from, to, part;

	while (key + 2 < channel->key_count &&
		time_s > (double)weights->time_s[key + 1]) {
		key++;
	}
	from = (double)weights->value[key * channel->width + target];
	to = (double)weights->value[(key + 1) * channel->width + target];
	part = (time_s - (double)weights->time_s[key]) /
		((double)weights->time_s[key + 1] - (double)weights->time_s[key]);
	return from + (to - from) * part;
}

static void test_a_channels_curves_are_its_weights_over_the_clip(void **state)
{
	uint32_t seed = 1;

	(void)state;
	for (int turn = 0; turn < 100; turn++) {
		struct weights weights;
		struct overlay_curve curve;
		float room[TARGETS_MAX];
		int first, shown;
		double duration_s, now_s;

		make_weights(&weights, &seed);
		duration_s = (double)weights.clip.duration_s;
		now_s = duration_s * random_between(&seed, -2, 10) / 8.0;
		first = random_between(&seed, 0, weights.channel.width - 1);
		shown = weights.channel.width - first;
		shown = shown < OVERLAY_CURVES_MAX ? shown : OVERLAY_CURVES_MAX;
		curve = overlay_curve_of_channel(&weights.clip,
			&weights.channel, first, (float)now_s, CLIP_AUTO, room);
		assert_int_equal(curve.count, shown);
		assert_near(curve.at, fmin(fmax(now_s / duration_s, 0.0), 1.0),
			1e-6);
		for (int c = 0; c < shown; c++) {
			for (int p = 0; p < OVERLAY_CURVE_POINTS; p++) {
				assert_near(curve.value[c][p],
					weight_at(&weights, first + c,
						duration_s * moment(p)),
					1e-4);
			}
		}
	}
}

/* The curves are those that the figure follows. */
static void test_curves_obey_the_interpolation(void **state)
{
	uint32_t seed = 1;
	struct weights weights;
	struct overlay_curve curve;
	float room[TARGETS_MAX];

	(void)state;
	make_weights(&weights, &seed);
	curve = overlay_curve_of_channel(
		&weights.clip, &weights.channel, 0, 0.0f, CLIP_STEP, room);
	for (int p = 0; p < OVERLAY_CURVE_POINTS; p++) {
		bool of_a_key = false;

		for (int k = 0; k < weights.channel.key_count; k++) {
			of_a_key = of_a_key ||
				curve.value[0][p] ==
					weights.value[k * weights.channel.width];
		}
		assert_true(of_a_key);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_morphs_curves_are_slope_signal_and_sum),
		cmocka_unit_test(
			test_a_channels_curves_are_its_weights_over_the_clip),
		cmocka_unit_test(test_curves_obey_the_interpolation),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
