/* Where the model itself is shown: with all it has, and with less. */
#include "app/compare/candidate/candidate.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	VERTICES_MAX = 256,
	JOINTS_MAX = 16
};

typedef float vectors[VERTICES_MAX][3];

static struct reference *reference_of(const struct model *model)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct reference *reference;

	assert_int_equal(reference_create(model, 0, &log, &reference), 0);
	assert_in_range(reference->vertex_count, 1, VERTICES_MAX);
	return reference;
}

static struct candidate candidate_of(
	struct reference *reference, int max_influences, bool targets)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct candidate candidate;

	assert_int_equal(
		candidate_original(&candidate, reference, kernel_find("float"),
			max_influences, targets, 60.0, &log),
		0);
	assert_int_equal(candidate.vertex_count, reference->vertex_count);
	return candidate;
}

/* A clip that moves each joint of a skin in a direction of its own. */
struct moves {
	struct model_clip clip;
	struct model_channel channel[JOINTS_MAX];
	float time_s[2], place[JOINTS_MAX][2][3];
};

static void begin_moves(struct moves *moves, struct model *model)
{
	const struct model_skin *skin = &model->skin[0];

	assert_in_range(skin->joint_count, 2, JOINTS_MAX);
	assert_int_equal(model->clip_count, 0);
	*moves = (struct moves){.time_s = {0, 1}};
	for (int j = 0; j < skin->joint_count; j++) {
		const float *rest = model->node[skin->joint[j]].rest.translation;

		for (int axis = 0; axis < 3; axis++) {
			moves->place[j][0][axis] = rest[axis];
			moves->place[j][1][axis] =
				rest[axis] + (float)(j % (axis + 2));
		}
		moves->channel[j] =
			(struct model_channel){.node = skin->joint[j],
				.path = MODEL_TRANSLATION,
				.interpolation = MODEL_LINEAR,
				.width = 3,
				.key_count = 2,
				.time_s = moves->time_s,
				.value = moves->place[j][0]};
	}
	moves->clip = (struct model_clip){.name = "moves",
		.duration_s = 1.0f,
		.channel_count = skin->joint_count,
		.channel = moves->channel};
	model->clip = &moves->clip;
	model->clip_count = 1;
}

static void end_moves(struct model *model)
{
	model->clip = NULL;
	model->clip_count = 0;
}

/* Whether both show the same after a share of the clip. */
static bool is_same(struct candidate *candidate, struct reference *reference,
	float share, bool normals)
{
	float time_s = share * reference->clip->duration_s;
	vectors position, normal = {{0}};
	bool same = true;

	candidate->positions_only = !normals;
	candidate_pose(candidate, time_s);
	candidate->take(candidate, position, normals ? normal : NULL);
	reference_pose(reference, time_s, normals);
	for (int i = 0; i < 3 * reference->vertex_count; i++) {
		float apart = position[i / 3][i % 3] -
			reference->position[i / 3][i % 3];
		float turned = normals
			? normal[i / 3][i % 3] - reference->normal[i / 3][i % 3]
			: 0.0f;

		same = same && apart * apart < 1e-10f && turned * turned < 1e-6f;
	}
	return same;
}

/* Also after poses for which no normals were wanted. */
static void test_the_whole_model_is_where_the_reference_has_it(void **state)
{
	static const char *const names[] = {
		"gltf/skin/and_morph.gltf", "gltf/clip/door.gltf"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		struct model *model = model_fixture(names[i], NULL);
		struct reference *reference = reference_of(model);
		struct candidate candidate = candidate_of(reference, 0, true);

		for (int k = 0; k < 9; k++) {
			assert_true(is_same(&candidate, reference,
				0.125f * (float)k, k % 3 != 1));
		}
		candidate_destroy(&candidate);
		reference_destroy(reference);
		model_destroy(model);
	}
}

/* The model keeps its targets, as others still show them. */
static void test_a_skin_without_targets_moves_without_them(void **state)
{
	struct model *model = model_fixture("gltf/skin/and_morph.gltf", NULL);
	struct reference *whole = reference_of(model), *bare;
	struct candidate without = candidate_of(whole, 0, false);
	int differ = 0, count = model->mesh[0].target_count;

	(void)state;
	assert_true(count > 0);
	for (int k = 0; k <= 8; k++) {
		differ += !is_same(&without, whole, 0.125f * (float)k, true);
	}
	assert_true(differ > 0);
	for (int m = 0; m < model->mesh_count; m++) {
		model->mesh[m].target_count = 0;
	}
	bare = reference_of(model);
	for (int k = 0; k <= 8; k++) {
		assert_true(is_same(&without, bare, 0.125f * (float)k, true));
	}
	candidate_destroy(&without);
	model->mesh[0].target_count = count;
	reference_destroy(bare);
	reference_destroy(whole);
	model_destroy(model);
}

/* Leaves each vertex the joint of its largest weight alone. */
static void cap_at_1(const struct model_primitive *primitive)
{
	for (int v = 0; v < primitive->vertex_count; v++) {
		float *weight = primitive->weight +
			(size_t)v * (size_t)primitive->influences;
		int most = 0;

		for (int i = 1; i < primitive->influences; i++) {
			most = weight[i] > weight[most] ? i : most;
		}
		for (int i = 0; i < primitive->influences; i++) {
			weight[i] = i == most ? 1.0f : 0.0f;
		}
	}
}

static void test_a_capped_skin_follows_the_largest_weights(void **state)
{
	struct model *model =
		model_fixture("gltf/skin/eight_influences.gltf", NULL);
	struct model_primitive *primitive = model->mesh->primitive;
	size_t bytes = (size_t)primitive->vertex_count *
		(size_t)primitive->influences * sizeof(float);
	float before[VERTICES_MAX * 8];
	struct reference *whole, *capped;
	struct candidate candidate;
	struct moves moves;
	int differ = 0;

	(void)state;
	begin_moves(&moves, model);
	whole = reference_of(model);
	assert_int_equal(primitive->influences, 8);
	memcpy(before, primitive->weight, bytes);
	candidate = candidate_of(whole, 1, true);
	assert_memory_equal(before, primitive->weight, bytes);
	for (int k = 0; k <= 8; k++) {
		differ += !is_same(&candidate, whole, 0.125f * (float)k, true);
	}
	assert_true(differ > 0);
	cap_at_1(primitive);
	capped = reference_of(model);
	for (int k = 0; k <= 8; k++) {
		assert_true(
			is_same(&candidate, capped, 0.125f * (float)k, true));
	}
	candidate_destroy(&candidate);
	reference_destroy(capped);
	reference_destroy(whole);
	end_moves(model);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_the_whole_model_is_where_the_reference_has_it),
		cmocka_unit_test(test_a_skin_without_targets_moves_without_them),
		cmocka_unit_test(test_a_capped_skin_follows_the_largest_weights),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
