/* Recognising morph targets that are key frames. */
#include "app/model/model_deltas.h"
#include "app/model/model_keys.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	TARGETS = 3,
	VERTICES = 4,
	KEYS = 4
};

struct bench {
	struct model model;
	struct model_node node;
	struct model_mesh mesh;
	struct model_primitive primitive;
	struct model_target target[TARGETS];
	float delta[TARGETS][VERTICES][3], turn[TARGETS][VERTICES][3];
	struct model_clip clip[2];
	struct model_channel channel;
	float time_s[KEYS], weight[KEYS][TARGETS];
};

/* A clip that shows the mesh, then target 0, 2 and 1, with all vertices moved. */
static void set_up(struct bench *b)
{
	*b = (struct bench){
		.model = {.node_count = 1, .mesh_count = 1, .clip_count = 1},
		.mesh = {.primitive_count = 1, .target_count = TARGETS},
		.primitive = {.vertex_count = VERTICES},
		.clip = {{.duration_s = 3.0f, .channel_count = 1}},
		.channel = {.path = MODEL_WEIGHTS,
			.interpolation = MODEL_LINEAR,
			.width = TARGETS,
			.key_count = KEYS},
		.time_s = {0.0f, 1.0f, 2.0f, 3.0f},
		.weight = {{0}, {1.0f, 0, 0}, {0, 0, 1.0f}, {0, 1.0f, 0}},
	};
	b->model.node = &b->node;
	b->model.mesh = &b->mesh;
	b->model.clip = b->clip;
	b->mesh.primitive = &b->primitive;
	b->primitive.target = b->target;
	b->clip[0].channel = &b->channel;
	b->channel.time_s = b->time_s;
	b->channel.value = &b->weight[0][0];
	for (int t = 0; t < TARGETS; t++) {
		b->target[t].position = model_deltas_view(
			(const float(*)[3])b->delta[t], VERTICES);
		for (int v = 0; v < VERTICES; v++) {
			b->delta[t][v][1] = 0.5f;
		}
	}
}

static void test_targets_shown_one_by_one_are_key_frames(void **state)
{
	struct bench b;

	(void)state;
	set_up(&b);
	assert_true(model_has_key_frames(&b.model, 0));
	b.channel.interpolation = MODEL_STEP;
	assert_true(model_has_key_frames(&b.model, 0));
	b.weight[1][0] = 1.0f - 1e-6f;
	assert_true(model_has_key_frames(&b.model, 0));
}

/* As exporters write an eased change that they sampled at each frame. */
static void test_sampled_changes_between_two_targets_are_key_frames(void **state)
{
	static const float changes[KEYS][TARGETS] = {{0.3f, 0.0f, 0.0f},
		{1.0f, 0.0f, 0.0f}, {0.84f, 0.16f, 0.0f}, {0.16f, 0.84f, 0.0f}};
	struct bench b;

	(void)state;
	set_up(&b);
	memcpy(b.weight, changes, sizeof(changes));
	assert_true(model_has_key_frames(&b.model, 0));
	b.weight[0][2] = 0.7f; /* from two targets to a third one */
	b.weight[1][0] = 0.0f;
	b.weight[1][1] = 1.0f;
	assert_false(model_has_key_frames(&b.model, 0));
	b.channel.interpolation = MODEL_STEP; /* nothing is between two keys */
	assert_true(model_has_key_frames(&b.model, 0));
	b.weight[3][1] = 0.8f; /* 0.04 of the mesh, besides two targets */
	assert_false(model_has_key_frames(&b.model, 0));
}

/* A hundred thousandth more or less, and no further, is taken as rounding. */
static void test_rounding_of_weights_is_tolerated(void **state)
{
	static const float within = 1e-5f, beyond = 2e-5f;
	struct bench b;

	(void)state;
	set_up(&b);
	b.channel.interpolation = MODEL_STEP;
	memcpy(b.weight[1], (float[]){0.5f, 1.0f - within - 0.5f, 0},
		sizeof(b.weight[1])); /* none of the mesh */
	assert_true(model_has_key_frames(&b.model, 0));
	b.weight[1][1] = 1.0f - beyond - 0.5f;
	assert_false(model_has_key_frames(&b.model, 0));
	b.weight[1][1] = 1.0f + within - 0.5f;
	assert_true(model_has_key_frames(&b.model, 0));
	b.weight[1][1] = 1.0f + beyond - 0.5f;
	assert_false(model_has_key_frames(&b.model, 0));
	b.weight[1][1] = 0.5f;
	b.weight[1][2] = within; /* no third target */
	assert_true(model_has_key_frames(&b.model, 0));
	b.weight[1][1] = 0.5f - beyond;
	b.weight[1][2] = beyond;
	assert_false(model_has_key_frames(&b.model, 0));
	b.weight[1][1] = 0.5f;
	b.weight[1][2] = -within;
	assert_true(model_has_key_frames(&b.model, 0));
	b.weight[1][2] = -beyond;
	assert_false(model_has_key_frames(&b.model, 0));
}

static void test_mixed_targets_are_no_key_frames(void **state)
{
	struct bench b;

	(void)state;
	set_up(&b);
	b.weight[2][0] = 0.5f;
	assert_false(model_has_key_frames(&b.model, 0));
	set_up(&b);
	b.weight[2][0] = 1.0f;
	assert_false(model_has_key_frames(&b.model, 0));
	set_up(&b);
	b.weight[3][1] = -1.0f;
	assert_false(model_has_key_frames(&b.model, 0));
	set_up(&b);
	b.channel.interpolation = MODEL_CUBICSPLINE;
	assert_false(model_has_key_frames(&b.model, 0));
}

static void test_targets_without_a_clip_are_no_key_frames(void **state)
{
	struct bench b;

	(void)state;
	set_up(&b);
	b.model.clip_count = 0;
	assert_false(model_has_key_frames(&b.model, 0));
	set_up(&b);
	b.channel.path = MODEL_ROTATION;
	assert_false(model_has_key_frames(&b.model, 0));
	set_up(&b);
	b.node.mesh = -1;
	assert_false(model_has_key_frames(&b.model, 0));
}

static void test_targets_that_move_little_stay_weighted_unless_marked(
	void **state)
{
	struct bench b;

	(void)state;
	set_up(&b);
	for (int t = 0; t < TARGETS; t++) {
		for (int v = 1; v < VERTICES; v++) {
			b.delta[t][v][1] = 0.0f;
		}
	}
	assert_false(model_has_key_frames(&b.model, 0));
	b.mesh.key_frames = true;
	assert_true(model_has_key_frames(&b.model, 0));
	b.weight[2][0] = 0.5f;
	assert_false(model_has_key_frames(&b.model, 0));
}

/* Lets all targets move the positions and the normals of these vertices, as bits. */
static void move_vertices(struct bench *b, unsigned positions, unsigned normals)
{
	for (int t = 0; t < TARGETS; t++) {
		b->target[t].normal = model_deltas_view(
			(const float(*)[3])b->turn[t], VERTICES);
		for (int v = 0; v < VERTICES; v++) {
			b->delta[t][v][1] = positions >> v & 1 ? 0.5f : 0.0f;
			b->turn[t][v][2] = normals >> v & 1 ? -0.5f : 0.0f;
		}
	}
}

/* A vertex whose normal alone turns counts like one that moves, and once. */
static void test_targets_that_move_half_of_the_vertices_are_key_frames(
	void **state)
{
	static const struct {
		unsigned positions, normals;
		bool half;
	} cases[] = {
		{0x3, 0x0, true},
		{0xC, 0x0, true},
		{0x0, 0x3, true},
		{0x0, 0xC, true},
		{0x3, 0x3, true},
		{0xF, 0x0, true},
		{0x0, 0xF, true},
		{0x1, 0x8, true},
		{0x8, 0x1, true},
		{0x1, 0x1, false},
		{0x8, 0x8, false},
		{0x1, 0x0, false},
		{0x0, 0x8, false},
		{0x0, 0x0, false},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct bench b;

		set_up(&b);
		move_vertices(&b, cases[i].positions, cases[i].normals);
		if (model_has_key_frames(&b.model, 0) != cases[i].half) {
			fail_msg("case %zu", i);
		}
	}
}

/* Six of twelve, whichever target moves none of them. */
static void test_vertices_count_over_all_targets(void **state)
{
	(void)state;
	for (int least = 0; least < TARGETS; least++) {
		int half = (least + 1) % TARGETS;
		struct bench b;

		set_up(&b);
		memset(b.delta[least], 0, sizeof(b.delta[least]));
		memset(b.delta[half], 0, sizeof(b.delta[half]) / 2);
		assert_true(model_has_key_frames(&b.model, 0));
		b.delta[half][3][1] = 0.0f;
		assert_false(model_has_key_frames(&b.model, 0));
	}
}

static void test_vertices_count_over_all_primitives(void **state)
{
	(void)state;
	for (int i = 0; i < 4; i++) {
		unsigned first = i < 2 ? 0x1 : i < 3 ? 0x7 : 0x3;
		unsigned second = i % 2 ? 0x1 : 0x7;
		struct model_primitive both[2];
		struct bench b, other;

		set_up(&b);
		set_up(&other);
		move_vertices(&b, first, 0);
		move_vertices(&other, second, 0);
		both[0] = b.primitive;
		both[1] = other.primitive;
		b.mesh.primitive = both;
		b.mesh.primitive_count = 2;
		assert_int_equal(model_has_key_frames(&b.model, 0), i % 2 == 0);
	}
}

/* Of two targets on, since one is a shape that a weight scales. */
static void test_one_target_is_no_key_frame(void **state)
{
	struct bench b;

	(void)state;
	set_up(&b);
	memcpy(b.weight, (float[]){0, 0, 1, 0, 0, 1, 0, 0}, 8 * sizeof(float));
	b.mesh.target_count = b.channel.width = 2;
	assert_true(model_has_key_frames(&b.model, 0));
	b.mesh.target_count = b.channel.width = 1;
	assert_false(model_has_key_frames(&b.model, 0));
}

/* From half of one target to half of two: the mesh is a third shape then. */
static void test_the_order_of_targets_does_not_matter(void **state)
{
	(void)state;
	for (int pair = 0; pair < TARGETS * TARGETS; pair++) {
		int one = pair / TARGETS, two = pair % TARGETS;
		struct bench b;

		if (one == two) {
			continue;
		}
		set_up(&b);
		memset(b.weight, 0, sizeof(b.weight));
		b.weight[0][one] = b.weight[1][one] = b.weight[1][two] = 0.5f;
		assert_false(model_has_key_frames(&b.model, 0));
		b.weight[0][two] = 0.5f;
		b.weight[1][two] = 1.0f;
		b.weight[1][one] = 0.0f;
		b.channel.key_count = 2;
		assert_true(model_has_key_frames(&b.model, 0));
	}
}

/* What moves another node, or something else of this one, says nothing. */
static void test_every_clip_of_the_node_decides(void **state)
{
	struct bench b;
	struct model_channel channels[3];
	float mixed[1][TARGETS] = {{0.5f, 0.25f, 0.25f}};

	(void)state;
	set_up(&b);
	channels[0] = channels[1] = channels[2] = b.channel;
	channels[1].value = mixed[0];
	channels[1].key_count = 1;
	b.clip[1] = (struct model_clip){
		.channel_count = 1, .channel = &channels[1]};
	b.model.clip_count = 2;
	assert_false(model_has_key_frames(&b.model, 0));
	channels[1].node = 1;
	assert_true(model_has_key_frames(&b.model, 0));
	channels[1].node = 0;
	channels[1].path = MODEL_SCALE;
	assert_true(model_has_key_frames(&b.model, 0));
	b.clip[0].channel = channels;
	b.clip[0].channel_count = 2;
	b.clip[1].channel_count = 0;
	assert_true(model_has_key_frames(&b.model, 0));
	channels[1].path = MODEL_WEIGHTS;
	assert_false(model_has_key_frames(&b.model, 0));
	channels[2] = channels[0];
	channels[0] = channels[1];
	channels[0].node = 1;
	channels[1] = channels[2];
	assert_true(model_has_key_frames(&b.model, 0));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_targets_shown_one_by_one_are_key_frames),
		cmocka_unit_test(
			test_sampled_changes_between_two_targets_are_key_frames),
		cmocka_unit_test(test_rounding_of_weights_is_tolerated),
		cmocka_unit_test(test_mixed_targets_are_no_key_frames),
		cmocka_unit_test(test_targets_without_a_clip_are_no_key_frames),
		cmocka_unit_test(
			test_targets_that_move_little_stay_weighted_unless_marked),
		cmocka_unit_test(
			test_targets_that_move_half_of_the_vertices_are_key_frames),
		cmocka_unit_test(test_vertices_count_over_all_targets),
		cmocka_unit_test(test_vertices_count_over_all_primitives),
		cmocka_unit_test(test_one_target_is_no_key_frame),
		cmocka_unit_test(test_the_order_of_targets_does_not_matter),
		cmocka_unit_test(test_every_clip_of_the_node_decides),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
