/* How far points and weights have to move for a clip to be played once. */
#include "app/character/sketch/sketch_once.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	POINTS = 8, /* a node and a mesh of one vertex each */
	FIRST = 0,  /* those that move unless a test says otherwise */
	LAST = POINTS - 1,
	KEYS = 9, /* at every eighth of the clip */
	WEIGHTS = 2
};

struct film {
	struct model_node node[POINTS];
	struct model_mesh mesh[POINTS];
	struct model_primitive primitive[POINTS];
	float position[1][3], weight[1][4];
	uint16_t joint[1][4];
	float rest_weights[WEIGHTS];
	int joints[2];
	mat4 inverse_bind[2];
	struct model_skin skin;
	struct model_channel channel[POINTS + 1];
	float time_s[KEYS], value[POINTS][KEYS][3], weights[KEYS][WEIGHTS];
	struct model_clip clip;
	struct model model;
};

/* The sides of the points' box are 10, 4 and 2 along three axes, and scaled. */
static const float places[POINTS][3] = {{10, 4, 2}, {0, 0, 0}, {9, 0, 0},
	{0, 4, 0}, {0, 0, 2}, {2, 1, 1}, {5, 1, 1}, {7, 3, 1}};

static void add_clip(struct film *film)
{
	for (int k = 0; k < KEYS; k++) {
		film->time_s[k] = (float)k / (KEYS - 1);
	}
	for (int i = 0; i <= POINTS; i++) {
		film->channel[i] = (struct model_channel){.node = i,
			.path = MODEL_TRANSLATION,
			.interpolation = MODEL_LINEAR,
			.width = 3,
			.key_count = KEYS,
			.time_s = film->time_s,
			.value = film->value[i % POINTS][0]};
	}
	film->channel[POINTS].node = 0;
	film->channel[POINTS].path = MODEL_WEIGHTS;
	film->channel[POINTS].width = WEIGHTS;
	film->channel[POINTS].value = film->weights[0];
	film->clip = (struct model_clip){.name = "clip",
		.duration_s = 1,
		.channel_count = POINTS,
		.channel = film->channel};
}

/* Begins with points that stay, of a box whose longest side is along an axis. */
static void begin(struct film *film, int axis, float scale)
{
	static const float away[3] = {32, 64, 128};

	memset(film, 0, sizeof(*film));
	for (int i = 0; i < POINTS; i++) {
		film->primitive[i] = (struct model_primitive){
			.vertex_count = 1, .position = film->position};
		film->mesh[i] = (struct model_mesh){
			.primitive_count = 1, .primitive = &film->primitive[i]};
		film->node[i] = (struct model_node){.parent = -1,
			.in_scene = true,
			.rest = {{0}, {0, 0, 0, 1}, {1, 1, 1}},
			.mesh = i,
			.skin = -1,
			.camera = -1};
		for (int k = 0; k < 3 * KEYS; k++) {
			int to = (k % 3 + axis) % 3;

			film->value[i][k / 3][to] =
				scale * (places[i][k % 3] + away[to]);
		}
		memcpy(film->node[i].rest.translation, film->value[i][0],
			sizeof(film->value[i][0]));
	}
	add_clip(film);
	film->model = (struct model){.node = film->node,
		.node_count = POINTS,
		.mesh = film->mesh,
		.mesh_count = POINTS,
		.rest_weights = film->rest_weights,
		.weight_count = WEIGHTS,
		.clip = &film->clip,
		.clip_count = 1};
}

/* Moves a point evenly to an end that is so far along an axis. */
static void move(struct film *film, int point, int axis, float way)
{
	for (int k = 0; k < KEYS; k++) {
		film->value[point][k][axis] += way * (float)k / (KEYS - 1);
	}
}

/* The first and the last point move as far, so that their middle stays. */
static void open(struct film *film, int axis, float way)
{
	move(film, FIRST, axis, way);
	move(film, LAST, axis, -way);
}

static bool plays_once(const struct film *film)
{
	const struct character_sketch_play play = {
		.rate = 1, .repeat = CLIP_LOOP};
	struct sketch_once once;

	assert_int_equal(sketch_find_once(&film->model, &play, &once), 0);
	assert_int_equal(once.any, once.clip[0]);
	return once.clip[0];
}

/* A twentieth of the longest side is too short a way. */
static void test_a_point_ends_far_from_where_it_began(void **state)
{
	static const float scales[] = {1, -1.0f / 64};
	struct film film;

	(void)state;
	for (int i = 0; i < 9 * (int)ARRAY_COUNT(scales); i++) {
		float scale = scales[i / 9];

		begin(&film, i % 3, scale);
		assert_false(plays_once(&film));
		open(&film, i / 3 % 3, 0.5f * scale);
		assert_false(plays_once(&film));
		begin(&film, i % 3, scale);
		open(&film, i / 3 % 3, 0.5625f * scale);
		assert_true(plays_once(&film));
	}
}

/* The others go an eighth of its way back from the middle. */
static void test_any_single_point_tells(void **state)
{
	struct film film;

	(void)state;
	for (int i = 0; i < POINTS; i++) {
		begin(&film, 0, 1);
		move(&film, i, 1, 0.5625f);
		assert_false(plays_once(&film));
		begin(&film, 0, 1);
		move(&film, i, 1, 0.625f);
		assert_true(plays_once(&film));
	}
}

static void test_a_shorter_clip_is_a_pose(void **state)
{
	struct film film;

	(void)state;
	begin(&film, 0, 1);
	open(&film, 0, 2);
	film.clip.duration_s = 0.1f;
	for (int k = 0; k < KEYS; k++) {
		film.time_s[k] *= 0.1f;
	}
	assert_true(plays_once(&film));
	film.clip.duration_s = 0.09f;
	assert_false(plays_once(&film));
}

/* By more than its longest side, along the ground alone. */
static void test_what_goes_away_does_not_end_in_another_shape(void **state)
{
	static const struct {
		float drift[3];
		bool once;
	} rows[] = {{{0, 0, 0}, true}, {{10, 0, 0}, true}, {{0, 0, 10}, true},
		{{0, 80, 0}, true}, {{-10.5f, 0, 0}, false},
		{{0, 0, -10.5f}, false}, {{10.5f, 0, 0}, false},
		{{0, 0, 10.5f}, false}, {{7.5f, 0, 7.5f}, false},
		{{6.5f, 0, -6.5f}, true}};
	struct film film;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		begin(&film, 0, 1);
		open(&film, 1, 1);
		for (int k = 0; k < 3 * POINTS; k++) {
			move(&film, k / 3, k % 3, rows[i].drift[k % 3]);
		}
		assert_int_equal(plays_once(&film), rows[i].once);
	}
}

/* Any pose between may be farther from the start, but by a third at most. */
static void test_the_last_pose_is_about_the_farthest(void **state)
{
	struct film film;

	(void)state;
	for (int k = 1; k < KEYS - 1; k++) {
		for (int far = 0; far < 2; far++) {
			float most = far ? 4.25f : 4;

			begin(&film, 0, 1);
			open(&film, 1, 3);
			film.value[FIRST][k][1] = film.value[FIRST][0][1] + most;
			film.value[LAST][k][1] = film.value[LAST][0][1] - most;
			assert_int_equal(plays_once(&film), !far);
		}
	}
}

/* Moves two points 0.7 from each other by so much, each towards the other. */
static void exchange(
	struct film *film, int one, int other, bool same_mesh, float way)
{
	begin(film, 0, 1.0f / 64);
	if (same_mesh) {
		film->node[other].mesh = film->node[one].mesh;
	}
	for (int k = 0; k < 3 * KEYS; k++) {
		film->value[one][k / 3][k % 3] = 0;
		film->value[other][k / 3][k % 3] = k % 3 == 1 ? 0.7f : 0;
	}
	move(film, one, 1, way);
	move(film, other, 1, -way);
}

/* As near as 0.3 of the way to where a point of the same mesh was. */
static void test_a_wheel_that_looks_the_same_has_not_moved(void **state)
{
	static const struct {
		float way;
		bool once;
	} rows[] = {{0.7f, false}, {1, false}, {1.01f, true}, {0.55f, false},
		{0.53f, true}};
	static const int pairs[][2] = {
		{FIRST, LAST}, {FIRST + 1, FIRST}, {LAST, 3}};
	struct film film;

	(void)state;
	for (int i = 0; i < 3 * (int)ARRAY_COUNT(rows); i++) {
		const int *pair = pairs[i % 3];

		exchange(&film, pair[0], pair[1], true, rows[i / 3].way);
		assert_int_equal(plays_once(&film), rows[i / 3].once);
		exchange(&film, pair[0], pair[1], false, rows[i / 3].way);
		assert_true(plays_once(&film));
	}
}

/* What moves by half of the longest way need not look the same. */
static void test_a_wheel_may_have_parts_that_move_less(void **state)
{
	static const struct {
		float way;
		bool once;
	} rows[] = {{0.25f, false}, {0.5f, false}, {0.5625f, true},
		{-0.5625f, true}};
	struct film film;

	(void)state;
	for (int i = 0; i < 2 * (int)ARRAY_COUNT(rows); i++) {
		int one = i % 2 ? FIRST : 2, other = i % 2 ? 5 : LAST;

		exchange(&film, 3, 4, true, 1);
		move(&film, one, 0, rows[i / 2].way);
		move(&film, other, 0, -rows[i / 2].way);
		assert_int_equal(plays_once(&film), rows[i / 2].once);
	}
}

/*
 * Shows a vertex that stays, and one of two joints. One of the joints has it 1
 * beside itself.
 */
static void add_skin(struct film *film, int beside)
{
	static const float weight[2] = {0.75f, 0.25f};

	for (int i = 0; i < POINTS; i++) {
		film->node[i].mesh = i == 4 || i == 5 ? i : -1;
	}
	film->node[5].skin = 0;
	for (int i = 0; i < 2; i++) {
		for (int k = 0; k < 4; k++) {
			film->inverse_bind[i][k][k] = 1;
		}
		film->joints[i] = 1 + i;
		film->joint[0][i] = (uint16_t)i;
		film->weight[0][i] = weight[i];
	}
	film->inverse_bind[beside][3][0] = 1;
	film->skin = (struct model_skin){.joint_count = 2,
		.joint = film->joints,
		.inverse_bind = film->inverse_bind};
	film->model.skin = &film->skin;
	film->model.skin_count = 1;
	film->primitive[5].influences = 4;
	film->primitive[5].joint = film->joint[0];
	film->primitive[5].weight = film->weight[0];
}

/*
 * The joints are 9 apart, so that the side is 2.25 and the weight of the one that
 * has the vertex beside it. Each vertex goes half the way from their middle.
 */
static void test_vertices_of_skins_move_with_both_joints(void **state)
{
	static const struct {
		float way;
		bool once;
	} rows[2][2] = {{{0.39f, false}, {0.41f, true}},
		{{0.98f, false}, {1.02f, true}}};
	struct film film;

	(void)state;
	for (int joint = 0; joint < 2; joint++) {
		for (int far = 0; far < 2; far++) {
			begin(&film, 0, 1);
			add_skin(&film, joint);
			move(&film, 1 + joint, 1, rows[joint][far].way);
			assert_int_equal(
				plays_once(&film), rows[joint][far].once);
		}
	}
}

static void morph(struct film *film, int which, float from, float to)
{
	film->clip.channel_count = POINTS + 1;
	film->mesh[0].target_count = WEIGHTS;
	for (int k = 0; k < KEYS; k++) {
		film->weights[k][which] =
			from + (to - from) * (float)k / (KEYS - 1);
	}
}

static void test_a_weight_changes_by_more_than_a_tenth(void **state)
{
	static const struct {
		float from, to;
		bool once;
	} rows[] = {{0, 0.1f, false}, {0, 0.125f, true}, {0.5f, 0.625f, true},
		{0.75f, 0.625f, true}, {0.75f, 0.6875f, false},
		{0.5f, 0.5625f, false}};
	struct film film;

	(void)state;
	for (int i = 0; i < WEIGHTS * (int)ARRAY_COUNT(rows); i++) {
		begin(&film, 0, 1);
		morph(&film, i % WEIGHTS, rows[i / WEIGHTS].from,
			rows[i / WEIGHTS].to);
		assert_int_equal(plays_once(&film), rows[i / WEIGHTS].once);
	}
}

/* Points or weights tell, and either may be farther in between. */
static void test_the_last_weight_is_about_the_largest(void **state)
{
	struct film film;

	(void)state;
	for (int k = 1; k < KEYS - 1; k++) {
		begin(&film, 0, 1);
		morph(&film, 1, 0, 0.375f);
		film.weights[k][1] = 0.5f;
		assert_true(plays_once(&film));
		film.weights[k][1] = 0.5625f;
		assert_false(plays_once(&film));
		open(&film, 0, 1);
		assert_true(plays_once(&film));
		film.value[FIRST][k][0] = film.value[FIRST][0][0] + 4;
		film.value[LAST][k][0] = film.value[LAST][0][0] - 4;
		assert_false(plays_once(&film));
		film.weights[k][1] = 0.5f;
		assert_true(plays_once(&film));
	}
}

/* Plays a clip of the first point alone, with two keys. */
static bool plays_keys_once(
	enum model_interpolation interpolation, const float *value)
{
	struct film film;

	begin(&film, 0, 1);
	film.time_s[1] = 1;
	film.channel[FIRST].interpolation = interpolation;
	film.channel[FIRST].key_count = 2;
	film.channel[FIRST].value = value;
	film.clip.channel_count = 1;
	return plays_once(&film);
}

/* Neither do the tangents, nor the numbers before and behind them. */
static void test_the_last_cubic_value_tells_where_a_point_ends(void **state)
{
	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		float keys[1 + 6][3] = {{0}};

		keys[0][axis] = keys[5][axis] = 16;
		assert_true(plays_keys_once(MODEL_CUBICSPLINE, keys[1]));
		keys[5][axis] = 0;
		assert_false(plays_keys_once(MODEL_CUBICSPLINE, keys[1]));
	}
}

static void test_the_last_value_tells_where_a_point_ends(void **state)
{
	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		float keys[3][3] = {{0}};

		keys[1][axis] = 16;
		assert_true(plays_keys_once(MODEL_LINEAR, keys[0]));
		keys[2][axis] = 16;
		assert_true(plays_keys_once(MODEL_LINEAR, keys[0]));
		keys[1][axis] = 0;
		assert_false(plays_keys_once(MODEL_LINEAR, keys[0]));
	}
}

static void test_a_model_without_vertices_plays_on(void **state)
{
	struct film film;

	(void)state;
	begin(&film, 0, 1);
	open(&film, 0, 2);
	for (int i = 0; i < POINTS; i++) {
		film.node[i].mesh = -1;
	}
	assert_false(plays_once(&film));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_point_ends_far_from_where_it_began),
		cmocka_unit_test(test_any_single_point_tells),
		cmocka_unit_test(test_a_shorter_clip_is_a_pose),
		cmocka_unit_test(
			test_what_goes_away_does_not_end_in_another_shape),
		cmocka_unit_test(test_the_last_pose_is_about_the_farthest),
		cmocka_unit_test(test_a_wheel_that_looks_the_same_has_not_moved),
		cmocka_unit_test(test_a_wheel_may_have_parts_that_move_less),
		cmocka_unit_test(test_vertices_of_skins_move_with_both_joints),
		cmocka_unit_test(test_a_weight_changes_by_more_than_a_tenth),
		cmocka_unit_test(test_the_last_weight_is_about_the_largest),
		cmocka_unit_test(
			test_the_last_cubic_value_tells_where_a_point_ends),
		cmocka_unit_test(test_the_last_value_tells_where_a_point_ends),
		cmocka_unit_test(test_a_model_without_vertices_plays_on),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
