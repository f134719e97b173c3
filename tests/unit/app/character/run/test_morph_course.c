/* How a morph goes from one key frame to the next, and how a layer plays. */
#include "app/character/character_open.h"
#include "app/character/run/layers.h"
#include "app/scene/instance/bounds.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double rate_hz = 50.0;

/* The Bezier curve by its definition, in double precision. */
static double bezier(double a, double b, double s)
{
	return 3 * (1 - s) * (1 - s) * s * a + 3 * (1 - s) * s * s * b +
		s * s * s;
}

static void test_a_bezier_curve_has_its_y_at_each_x(void **state)
{
	static const float point[][4] = {{0.4f, 0, 0.2f, 1}, {0, 0, 1, 1},
		{0.1f, 0.9f, 0.9f, 0.1f}, {1, 0.3f, 0, 0.7f},
		{0.25f, -0.5f, 0.6f, 1.5f}};

	(void)state;
	for (size_t i = 0; i < sizeof(point) / sizeof(point[0]); i++) {
		struct character_curve curve = {.kind = CHARACTER_CURVE_BEZIER};
		const float *p = point[i];

		memcpy(curve.table, p, sizeof(point[i]));
		for (int step = 0; step <= 20; step++) {
			double s = step / 20.0;

			assert_near(character_morph_curve(&curve,
					    (float)bezier(p[0], p[2], s)),
				bezier(p[1], p[3], s), 2e-3);
		}
		assert_near(character_morph_curve(&curve, 0), 0, 1e-5);
		assert_near(character_morph_curve(&curve, 1), 1, 1e-5);
	}
}

/* A curve whose x is s itself is exact but for rounding and the halving. */
static void test_a_bezier_curve_is_exact_to_a_millionth(void **state)
{
	struct character_curve curve = {.kind = CHARACTER_CURVE_BEZIER,
		.table = {1.0f / 3.0f, 0.1f, 2.0f / 3.0f, 0.8f}};

	(void)state;
	for (int step = 0; step <= 50; step++) {
		double s = step / 50.0;

		assert_near(character_morph_curve(&curve, (float)s),
			bezier(0.1, 0.8, s), 3e-6);
	}
}

/* Where x and y are s, what is left of the halving is seen. */
static void test_a_straight_bezier_curve_is_exact_to_less_than_a_millionth(
	void **state)
{
	struct character_curve curve = {.kind = CHARACTER_CURVE_BEZIER,
		.table = {1.0f / 3.0f, 1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f}};

	(void)state;
	for (int step = 0; step <= 997; step++) {
		float u = (float)step / 997.0f;

		assert_near(character_morph_curve(&curve, u), u, 7e-7);
	}
}

static void test_a_table_has_its_values_at_even_distances(void **state)
{
	struct character_curve curve = {.kind = CHARACTER_CURVE_TABLE,
		.table_count = 4,
		.table = {0, 0.6f, 0.3f, 1}};
	static const float wanted[] = {0, 0.3f, 0.6f, 0.45f, 0.3f, 0.65f, 1};

	(void)state;
	for (int i = 0; i <= 6; i++) {
		assert_near(character_morph_curve(&curve, (float)i / 6.0f),
			wanted[i], 1e-6);
	}
	curve.table_count = 2;
	curve.table[1] = 1;
	assert_near(character_morph_curve(&curve, 0.25f), 0.25, 1e-6);
	curve.kind = CHARACTER_CURVE_SINE;
	assert_near(character_morph_curve(&curve, 0.75f), 0.75, 0);
}

static void begin(struct acting *acting, const char *model, const char *text)
{
	acting_begin(acting, model);
	acting_expect(acting, text);
	acting_run_to(acting, 0.1, rate_hz);
}

static float weight_of(const struct acting *acting, int target)
{
	int node = model_find_node(acting->model, "Face");

	return acting->instance->pose
		.weight[acting->model->node[node].weight_offset + target];
}

/* Weights of all eight targets, at half the morph's weight. */
static void test_each_target_of_a_morph_is_shown_by_its_weight(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/face.glb",
		"[state a]\nclip = rest\n[morph m]\ntime = 2\nweight = 0.5\n"
		"key = none\nkey = all, 0 0.1, 1 0.2, 2 0.3, 3 0.4, 4 0.5, "
		"5 0.6, 6 0.7, 7 0.8\n[buttons]\nUP = morph m all\n"
		"DOWN = pace m 2\nLEFT = morph m none\n");
	acting_tap(&acting, BUTTON_UP, 1.0, rate_hz);
	for (int i = 0; i < 8; i++) {
		assert_near(weight_of(&acting, i), 0.25 * 0.1 * (i + 1), 1e-4);
	}
	acting_run_to(&acting, 3.0, rate_hz);
	assert_int_equal(acting.character->morph[0].before, 0);
	assert_int_equal(acting.character->morph[0].destiny, 1);
	assert_near(weight_of(&acting, 7), 0.4, 1e-6);
	/* Twice as fast, it takes a second. */
	acting_tap(&acting, BUTTON_DOWN, 0.1, rate_hz);
	acting_tap(&acting, BUTTON_LEFT, 0.25, rate_hz);
	assert_int_equal(acting.character->morph[0].before, 1);
	assert_int_equal(acting.character->morph[0].destiny, 0);
	assert_near(weight_of(&acting, 7), 0.4 * 0.74, 1e-4);
	assert_near(character_morph_omega(&acting.character->morph[0],
			    acting.character->now_s),
		0.26, 1e-4);
	acting_end(&acting);
}

/* The rest pose's box, bent as the morph says. */
static struct bounds bent(struct acting *acting)
{
	character_bend(acting->character);
	instance_update(acting->instance);
	return bounds_of_instance(acting->instance);
}

#define SINE                                                               \
	"[state a]\nclip = rest\n[morph m]\ntime = 1\nkey = a\nkey = b\n"  \
	"curve = sine 0.1\ndirection = 0 0 1\n[buttons]\nUP = morph m b\n" \
	"DOWN = pause\n"

/* It is highest in the middle, and 0 at the ends. */
static void test_a_sine_moves_the_vertices_while_a_morph_runs(void **state)
{
	struct acting acting;
	struct bounds rest, now;

	(void)state;
	begin(&acting, "assets/face.glb", SINE);
	assert_true(acting.character->morph[0].bend.part_count > 0);
	rest = bent(&acting);
	acting_tap(&acting, BUTTON_UP, 0.5, rate_hz);
	now = bent(&acting);
	assert_true(now.high[2] > rest.high[2] + 0.05f);
	assert_true(now.high[2] < rest.high[2] + 0.101f);
	assert_near(now.high[1], rest.high[1], 1e-4);
	acting_run_to(&acting, 1.5, rate_hz);
	now = bent(&acting);
	assert_near(now.high[2], rest.high[2], 1e-5);
	acting_end(&acting);
}

/* If its vertices cannot be bent, the whole node moves, turned and scaled. */
static void test_a_sine_moves_a_node_that_cannot_be_bent(void **state)
{
	struct acting acting;
	struct transform *local;
	int node;

	(void)state;
	begin(&acting, "assets/face.glb", SINE);
	acting.character->morph[0].bend.part_count = 0;
	node = model_find_node(acting.model, "Face");
	acting_tap(&acting, BUTTON_UP, 0.5, rate_hz);
	local = &acting.instance->pose.local[node];
	local->scale[0] = local->scale[1] = local->scale[2] = 2.0f;
	memset(local->translation, 0, sizeof(local->translation));
	memcpy(local->rotation, ((float[4]){0, 0.70710678f, 0, 0.70710678f}),
		sizeof(local->rotation));
	acting.instance->pose.animated[node] = false;
	acting.character->step_s = 0;
	acting.character->now_s += 1.0 / rate_hz;
	character_morph_run(acting.character, &acting.character->morph[0]);
	assert_all_near(local->translation, ((float[]){0.2f, 0, 0}), 3, 1e-3);
	assert_true(acting.instance->pose.animated[node]);
	acting_end(&acting);
}

static void test_a_head_turns_above_its_neck(void **state)
{
	struct acting acting;
	struct bounds rest, now;

	(void)state;
	begin(&acting, "assets/face.glb",
		"[state a]\nclip = rest\n[parameter turn]\nrange = -90 90\n"
		"start = 0\n[morph m]\nneck = 0 0.01\nturn = turn\n"
		"[buttons]\nUP = set turn 90\n");
	rest = bent(&acting);
	acting_tap(&acting, BUTTON_UP, 0.1, rate_hz);
	now = bent(&acting);
	/* What looked along +Z looks along +X. */
	assert_near(now.high[0], rest.high[2], 0.01);
	assert_near(now.high[1], rest.high[1], 1e-4);
	acting_end(&acting);
}

/* The vertices that a morph has bent: the bytes of its only part. */
static size_t bytes_of(const struct bend *bend, const void **bytes)
{
	const struct bend_part *part = &bend->part[0];
	size_t count = (size_t)part->drawable->primitive->vertex_count;

	assert_int_equal(bend->part_count, 1);
	*bytes = part->position ? (const void *)part->position
				: (const void *)part->fixed_position;
	return count *
		(part->position ? sizeof(*part->position)
				: sizeof(*part->fixed_position));
}

/* By its parameter's degrees; a wave runs while a sine is chosen and runs. */
static void test_a_morph_bends_by_its_turn_and_its_sine(void **state)
{
	static const struct {
		int curve;
		bool turns, runs;
		float omega;
	} rows[] = {{0, true, true, 0.25f}, {0, false, true, 0.25f},
		{1, true, true, 0}, {0, true, false, 0}, {1, false, true, 0}};
	const float turn_rad = 30 * (SCALAR_PI / 180);

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct acting acting;
		struct character_morph *morph;
		const void *bytes;
		uint8_t *before;
		size_t size;

		begin(&acting, "assets/face.glb",
			"[state a]\nclip = rest\n"
			"[parameter turn]\nrange = -90 90\nstart = 30\n"
			"[morph m]\ntime = 1\nkey = a\nkey = b\n"
			"curve = sine 0.1\ncurve = linear\n"
			"direction = 0 0 1\nneck = 0 0.01\nturn = turn\n");
		acting_run_to(&acting, 0.1, rate_hz);
		instance_update(acting.instance);
		morph = acting.character->morph;
		if (rows[i].runs) {
			character_morph_go(morph, 1, 8);
		}
		morph->chosen = rows[i].curve;
		morph->turn_deg = rows[i].turns ? morph->turn_deg : NULL;
		character_morph_bend(morph, 8.25);
		size = bytes_of(&morph->bend, &bytes);
		before = malloc(size);
		assert_non_null(before);
		memcpy(before, bytes, size);
		bend_update(&morph->bend, rows[i].turns ? turn_rad : 0,
			rows[i].omega);
		assert_memory_equal(before, bytes, size);
		free(before);
		acting_end(&acting);
	}
}

static double smooth(double u)
{
	u = fmin(1.0, fmax(0.0, u));
	return u * u * (3 - 2 * u);
}

/* A layer that plays once fades within its clip, which takes 2.4 s. */
static void test_a_layer_fades_at_both_ends_of_its_clip(void **state)
{
	static const char *const rates[] = {"", "rate = -1\n"};
	const struct character_layer *layer;

	(void)state;
	for (int i = 0; i < 2; i++) {
		char text[256] = "[state a]\nclip = rest\n"
				 "[buttons]\nUP = play w\n[layer w]\n"
				 "clip = wave\nplay = once\nfade = 0.5\n"
				 "weight = 0.8\n";
		struct acting acting;
		double begun_s, largest = 0.0;

		strcat(text, rates[i]);
		begin(&acting, "assets/walker.glb", text);
		layer = acting.character->layer;
		assert_near(layer->is.now, 0, 0);
		acting_press(&acting, BUTTON_UP);
		begun_s = acting.now_s;
		while (acting.now_s < begun_s + 2.3) {
			double left_s, played_s;

			acting_run_to(
				&acting, acting.now_s + 1.0 / rate_hz, rate_hz);
			played_s = i == 0 ? layer->entry.time_s
					  : 2.4 - layer->entry.time_s;
			left_s = 2.4 - played_s;
			assert_near(played_s, acting.now_s - begun_s, 0.021);
			assert_near(layer->is.now,
				0.8 * smooth(played_s / 0.5) *
					smooth(left_s / 0.5),
				1e-3);
			largest = fmax(largest, layer->is.now);
		}
		assert_near(largest, 0.8, 1e-6);
		acting_run_to(&acting, begun_s + 2.6, rate_hz);
		assert_near(layer->is.now, 0, 0);
		assert_false(layer->playing);
		acting_end(&acting);
	}
}

/* Without a fade it is there at once. */
static void test_a_layer_without_a_fade_has_its_weight_at_once(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = rest\n[buttons]\nUP = play w\n[layer w]\n"
		"clip = wave\nplay = once\nfade = 0\nweight = 0.8\n");
	acting_tap(&acting, BUTTON_UP, 0.04, rate_hz);
	assert_near(acting.character->layer[0].is.now, 0.8, 1e-6);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_bezier_curve_has_its_y_at_each_x),
		cmocka_unit_test(test_a_bezier_curve_is_exact_to_a_millionth),
		cmocka_unit_test(
			test_a_straight_bezier_curve_is_exact_to_less_than_a_millionth),
		cmocka_unit_test(test_a_table_has_its_values_at_even_distances),
		cmocka_unit_test(
			test_each_target_of_a_morph_is_shown_by_its_weight),
		cmocka_unit_test(
			test_a_sine_moves_the_vertices_while_a_morph_runs),
		cmocka_unit_test(test_a_sine_moves_a_node_that_cannot_be_bent),
		cmocka_unit_test(test_a_head_turns_above_its_neck),
		cmocka_unit_test(test_a_morph_bends_by_its_turn_and_its_sine),
		cmocka_unit_test(test_a_layer_fades_at_both_ends_of_its_clip),
		cmocka_unit_test(
			test_a_layer_without_a_fade_has_its_weight_at_once),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
