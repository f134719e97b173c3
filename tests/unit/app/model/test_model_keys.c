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
	float delta[TARGETS][VERTICES][3];
	struct model_clip clip;
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
		.clip = {.duration_s = 3.0f, .channel_count = 1},
		.channel = {.path = MODEL_WEIGHTS,
			.interpolation = MODEL_LINEAR,
			.width = TARGETS,
			.key_count = KEYS},
		.time_s = {0.0f, 1.0f, 2.0f, 3.0f},
		.weight = {{0}, {1.0f, 0, 0}, {0, 0, 1.0f}, {0, 1.0f, 0}},
	};
	b->model.node = &b->node;
	b->model.mesh = &b->mesh;
	b->model.clip = &b->clip;
	b->mesh.primitive = &b->primitive;
	b->primitive.target = b->target;
	b->clip.channel = &b->channel;
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
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
