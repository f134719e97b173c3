#include "tests/support/model/bones.h"

#include "app/anim/math/transform.h"
#include "app/anim/math/vec.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

void bones_begin(struct bones *bones)
{
	memset(bones, 0, sizeof(*bones));
	bones->model.node = bones->node;
	bones->model.mesh = bones->mesh;
	bones->model.mesh_count = 1;
	bones->model.rest_weights = bones->rest_weights;
}

void bones_end(struct bones *bones)
{
	arena_release(&bones->model.arena);
}

int bones_add(struct bones *bones, int parent, float x, float y, float z)
{
	int index = bones->model.node_count++;
	struct model_node *node;

	assert_true(index < BONES_MAX);
	node = &bones->node[index];
	*node = (struct model_node){.name = "",
		.file_index = index,
		.parent = parent,
		.in_scene = true,
		.rest = transform_identity(),
		.mesh = -1,
		.skin = -1,
		.camera = -1};
	node->rest.translation[0] = x;
	node->rest.translation[1] = y;
	node->rest.translation[2] = z;
	return index;
}

void bones_pose(struct bones *bones)
{
	assert_int_equal(
		pose_init(&bones->pose, &bones->model, &bones->model.arena), 0);
	bones_update(bones);
}

void bones_update(struct bones *bones)
{
	pose_world(&bones->pose, &bones->model, NULL, bones->world);
}

void bones_place(const struct bones *bones, int node, float out[3])
{
	memcpy(out, bones->world[node][3], 3 * sizeof(*out));
}

double bones_distance(const struct bones *bones, int node, const float point[3])
{
	const float *at = bones->world[node][3];
	double x = (double)at[0] - point[0];
	double y = (double)at[1] - point[1];
	double z = (double)at[2] - point[2];

	return sqrt(x * x + y * y + z * z);
}

static void assert_finite(const float *value, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		if (!isfinite(value[i])) {
			fail_msg("number %zu is %f", i, (double)value[i]);
		}
	}
}

double bones_length(const struct bones *bones, int a, int b)
{
	float at[3];

	bones_place(bones, b, at);
	return bones_distance(bones, a, at);
}

void bones_point(const struct bones *bones, int node, const float direction[3],
	float distance, float out[3])
{
	bones_place(bones, node, out);
	vec_add_scaled(out, direction, distance, out);
}

void bones_assert_finite(const struct bones *bones)
{
	for (int i = 0; i < bones->model.node_count; i++) {
		assert_finite((const float *)&bones->pose.local[i],
			sizeof(struct transform) / sizeof(float));
		assert_finite(bones->world[i][0], 16);
	}
}
