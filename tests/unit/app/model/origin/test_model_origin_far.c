/* When a model counts as far from the origin, and where it moves to. */
#include "app/model/origin/model_origin.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	NODES = 3
};

/* Roots, of which node 0 shows mesh 0. */
struct fixture {
	struct model_node node[NODES];
	float position[NODES][2][3];
	struct model_primitive primitive[NODES];
	struct model_mesh mesh[NODES];
	struct model model;
	struct arena arena;
};

/* A mesh of two corners, which span the box, at a place of node 0. */
static void begin_box(struct fixture *f, const float span[3], int axis, float at)
{
	memset(f, 0, sizeof(*f));
	for (int n = 0; n < NODES; n++) {
		f->node[n] = (struct model_node){.name = "",
			.parent = -1,
			.in_scene = true,
			.mesh = -1,
			.skin = -1,
			.camera = -1,
			.rest = {{0}, {0, 0, 0, 1}, {1, 1, 1}}};
		f->primitive[n] = (struct model_primitive){
			.vertex_count = 2, .position = f->position[n]};
		f->mesh[n] = (struct model_mesh){
			.primitive_count = 1, .primitive = &f->primitive[n]};
	}
	f->model = (struct model){.node_count = NODES,
		.node = f->node,
		.mesh_count = NODES,
		.mesh = f->mesh};
	f->arena = arena_empty();
	f->node[0].mesh = 0;
	f->node[0].rest.translation[axis] = at;
	for (int i = 0; i < 3; i++) {
		f->position[0][0][i] = -span[i];
		f->position[0][1][i] = span[i];
	}
}

static void end(struct fixture *f)
{
	arena_release(&f->arena);
	arena_release(&f->model.arena);
}

/* Finds with clips that begin at these places. Returns whether it moved. */
static bool move_from(struct fixture *f, const float (*start)[3])
{
	static const bool turned[NODES];
	double(*shift)[3];

	assert_int_equal(
		model_origin_find(&f->model, turned, start, &f->arena, &shift),
		0);
	return shift != NULL;
}

static bool move(struct fixture *f)
{
	float start[NODES][3];

	for (int n = 0; n < NODES; n++) {
		memcpy(start[n], f->node[n].rest.translation, sizeof(start[n]));
	}
	return move_from(f, (const float(*)[3])start);
}

/* On any axis, by the longest side. A side of 4 is half of what is spanned. */
static void test_the_longest_side_is_the_size(void **state)
{
	(void)state;
	for (int n = 0; n < 9; n++) {
		for (int way = -1; way <= 1; way += 2) {
			float span[3] = {0.5f, 0.5f, 0.5f};
			struct fixture f;

			span[n % 3] = 2;
			begin_box(&f, span, n / 3, (float)way * 128 * 4);
			assert_false(move(&f));
			end(&f);
			begin_box(&f, span, n / 3, (float)way * 128.5f * 4);
			assert_true(move(&f));
			assert_near(f.model.origin[n / 3], way * 129.0 * 4, 0);
			end(&f);
		}
	}
}

/* Of the power of two that is as large as the size, or the next larger one. */
static void test_the_origin_is_a_multiple_of_a_power_of_two(void **state)
{
	static const struct {
		float half, at;
		double origin;
	} cases[] = {
		{2, 4001, 4000},
		{2, 4003, 4004},
		{1.5f, 4001, 4000},
		{2.25f, 4003, 4000},
		{2.25f, 4005, 4008},
		{0.25f, 1000.25f, 1000.5},
		{0.25f, 1000.2f, 1000},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		const float half = cases[i].half;
		struct fixture f;

		begin_box(&f, (const float[]){half, half, half}, 0, cases[i].at);
		assert_true(move(&f));
		assert_near(f.model.origin[0], cases[i].origin, 0);
		end(&f);
	}
}

/* What is not shown, or has no vertices, is nowhere. */
static void test_only_what_is_shown_has_a_place(void **state)
{
	static const float unit[3] = {0.5f, 0.5f, 0.5f};
	struct fixture f;

	(void)state;
	begin_box(&f, unit, 1, 1000);
	f.node[1].mesh = 1; /* at the origin, without a size */
	f.node[1].hidden = true;
	f.node[2].mesh = 2;
	f.mesh[2].primitive_count = 0;
	assert_true(move(&f));
	assert_near(f.model.origin[1], 1000, 0);
	end(&f);
	begin_box(&f, unit, 1, 1000);
	f.node[1].mesh = 1; /* so that the model spans 1000 m */
	assert_false(move(&f));
	end(&f);
}

/* Up to 128 sizes from the rest pose, on each axis; of roots alone. */
static void test_a_clip_may_begin_near_the_rest_pose(void **state)
{
	static const float unit[3] = {0.5f, 0.5f, 0.5f};

	(void)state;
	for (int n = 0; n < 12; n++) {
		int axis = n % 3;
		float start[NODES][3] = {{0}}, far = n < 6 ? 128 : 128.5f;
		struct fixture f;

		begin_box(&f, unit, 0, 1e6f);
		memcpy(start[0], f.node[0].rest.translation, sizeof(start[0]));
		start[0][axis] += n % 2 ? far : -far;
		start[1][axis] = 5000;
		f.node[1].parent = 0;
		assert_int_equal(move_from(&f, (const float(*)[3])start), n < 6);
		end(&f);
	}
}

static void test_all_keys_of_splines_move(void **state)
{
	const double shift[3] = {10, 20, -30};
	float value[18];
	struct model_channel channel = {
		.interpolation = MODEL_CUBICSPLINE, .key_count = 2, .width = 3};

	(void)state;
	for (int i = 0; i < 18; i++) {
		value[i] = 1;
	}
	model_origin_shift_keys(shift, &channel, value);
	for (int i = 0; i < 18; i++) {
		bool middle = i % 9 / 3 == 1;

		assert_near(value[i], middle ? 1 - shift[i % 3] : 1, 0);
	}
}

static void test_a_zero_keeps_its_sign_in_the_file(void **state)
{
	const struct model model = {.origin = {0, 8, 0}};
	double out[3];

	(void)state;
	model_origin_to_file(&model, (const float[]){-0.0f, -0.0f, 1}, out);
	assert_true(signbit(out[0]));
	assert_near(out[1], 8, 0);
	assert_near(out[2], 1, 0);
}

static const float times[] = {0, 1};

/* A clip that moves, turns or scales nodes, with two keys each. */
static struct model_channel channel_of(
	int node, enum model_path path, const float *value)
{
	return (struct model_channel){.node = node,
		.path = path,
		.interpolation = MODEL_LINEAR,
		.width = 3,
		.key_count = 2,
		.time_s = times,
		.value = value};
}

static bool move_with(struct fixture *f, struct model_clip *clips, int count)
{
	f->model.clip = clips;
	f->model.clip_count = count;
	assert_int_equal(model_origin_move(&f->model, &f->arena), 0);
	return f->model.origin[0] != 0;
}

static const float unit_box[3] = {0.5f, 0.5f, 0.5f};

static void test_translations_of_all_clips_move(void **state)
{
	static const float there[] = {1000, 1, 2, 1001, 3, 4};
	static const float here[] = {7, 8, 9, 10, 11, 12};
	struct model_channel channels[2][3];
	struct model_clip clips[2];
	struct fixture f;

	(void)state;
	begin_box(&f, unit_box, 0, 1000);
	f.node[1].parent = 0;
	for (int c = 0; c < 2; c++) {
		channels[c][0] = channel_of(0, MODEL_SCALE, here);
		channels[c][1] = channel_of(0, MODEL_TRANSLATION, there);
		channels[c][2] = channel_of(1, MODEL_TRANSLATION, here);
		clips[c] = (struct model_clip){
			.channel_count = 3, .channel = channels[c]};
	}
	assert_true(move_with(&f, clips, 2));
	for (int c = 0; c < 2; c++) {
		assert_ptr_equal(channels[c][0].value, here);
		assert_all_near(channels[c][1].value,
			((float[]){0, 1, 2, 1, 3, 4}), 6, 0);
		assert_all_near(channels[c][2].value, here, 6, 0);
	}
	assert_near(there[0], 1000, 0);
	end(&f);
}

/* The first clip that moves a root says where the model begins. */
static void test_the_first_translation_of_a_root_decides(void **state)
{
	static const float there[] = {1000, 0, 0, 0, 0, 0};
	static const float here[] = {0, 0, 0, 1000, 0, 0};
	static const struct {
		int node[3];
		const float *first;
		bool moves;
	} cases[] = {
		{{0, 0, 0}, there, true},
		{{0, 0, 0}, here, false},
		{{1, 0, 0}, here, true}, /* then node 0 begins there */
		{{1, 1, 1}, here, true}, /* node 1 is below node 0 */
		{{2, 2, 2}, here, true}, /* where its rest is */
		{{2, 2, 0}, there, false},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct model_channel channels[3];
		struct model_clip clips[3];
		struct fixture f;

		begin_box(&f, unit_box, 0, 1000);
		f.node[1].parent = 0;
		for (int c = 0; c < 3; c++) {
			channels[c] =
				channel_of(cases[i].node[c], MODEL_TRANSLATION,
					c == 0           ? cases[i].first
						: c == 1 ? there
							 : here);
			clips[c] = (struct model_clip){
				.channel_count = 1, .channel = &channels[c]};
		}
		if (move_with(&f, clips, 3) != cases[i].moves) {
			fail_msg("case %zu", i);
		}
		end(&f);
	}
}

/* Turning or scaling a node needs its own origin; moving it does not. */
static void test_vertices_stay_in_nodes_that_clips_turn(void **state)
{
	static const float one[] = {0, 0, 0, 1, 0, 0, 0, 1};
	static const enum model_path paths[] = {
		MODEL_TRANSLATION, MODEL_ROTATION, MODEL_SCALE, MODEL_WEIGHTS};

	(void)state;
	for (int i = 0; i < 8; i++) {
		struct model_channel channels[2] = {
			channel_of(1, MODEL_ROTATION, one),
			channel_of(i / 4, paths[i % 4], one)};
		struct model_clip clip = {
			.channel_count = 2, .channel = channels};
		struct fixture f;

		begin_box(&f, unit_box, 0, 0);
		f.position[0][0][0] += 1000;
		f.position[0][1][0] += 1000;
		assert_true(move_with(&f, &clip, 1));
		assert_near(f.position[0][0][0],
			i == 0 || i >= 4 ? -0.5 : 999.5, 0);
		end(&f);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_longest_side_is_the_size),
		cmocka_unit_test(test_the_origin_is_a_multiple_of_a_power_of_two),
		cmocka_unit_test(test_only_what_is_shown_has_a_place),
		cmocka_unit_test(test_a_clip_may_begin_near_the_rest_pose),
		cmocka_unit_test(test_translations_of_all_clips_move),
		cmocka_unit_test(test_the_first_translation_of_a_root_decides),
		cmocka_unit_test(test_vertices_stay_in_nodes_that_clips_turn),
		cmocka_unit_test(test_all_keys_of_splines_move),
		cmocka_unit_test(test_a_zero_keeps_its_sign_in_the_file),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
