#include "app/cmd/bench/bench_mesh.h"

#include "app/anim/clip.h"
#include "app/model/model_deltas.h"
#include "platform/base/scalar.h"

#include <cglm/cglm.h>

#include <errno.h>

enum {
	JOINTS = 24,
};

/* One step of a linear congruential generator. */
static uint32_t draw(uint32_t *state)
{
	*state = *state * 1664525u + 1013904223u;
	return *state >> 16;
}

/* Draws a number from -1 to 1. */
static float draw_float(uint32_t *state)
{
	return (float)draw(state) * (2.0f / 65535.0f) - 1.0f;
}

static void draw_unit(uint32_t *state, float out[3])
{
	float length2;

	do {
		length2 = 0.0f;
		for (int k = 0; k < 3; k++) {
			out[k] = draw_float(state);
			length2 += out[k] * out[k];
		}
	} while (length2 < 0.01f || length2 > 1.0f);
	for (int k = 0; k < 3; k++) {
		out[k] /= scalar_sqrt(length2);
	}
}

static void draw_vectors(uint32_t *state, int count, float size, float (*out)[3])
{
	for (int i = 0; i < count; i++) {
		draw_unit(state, out[i]);
		for (int k = 0; k < 3; k++) {
			out[i][k] *= size;
		}
	}
}

/* Draws distinct joints, from one of joint_sets sets; 0: any joints. */
static void draw_joints(
	uint32_t *state, int influences, int joint_sets, uint16_t *joint)
{
	uint32_t set_state = draw(state);

	if (joint_sets > 0) {
		set_state %= (uint32_t)joint_sets;
	}
	for (int i = 0; i < influences; i++) {
		joint[i] = (uint16_t)(draw(&set_state) % JOINTS);
		for (int k = 0; k < i; k++) {
			if (joint[k] == joint[i]) {
				joint[i] = (uint16_t)((joint[i] + 1) % JOINTS);
				k = -1;
			}
		}
	}
}

static void draw_influences(uint32_t *state, struct model_primitive *primitive,
	int influences, int joint_sets)
{
	for (int v = 0; v < primitive->vertex_count; v++) {
		uint16_t *joint = primitive->joint + v * primitive->influences;
		float *weight = primitive->weight + v * primitive->influences;
		float sum = 0.0f;

		draw_joints(state, influences, joint_sets, joint);
		for (int i = 0; i < influences; i++) {
			weight[i] = 1.25f + draw_float(state);
			sum += weight[i];
		}
		for (int i = 0; i < influences; i++) {
			weight[i] /= sum;
		}
	}
}

static void draw_palette(uint32_t *state, mat4 *palette)
{
	for (int j = 0; j < JOINTS; j++) {
		float axis[3];
		float angle_rad = 3.0f * draw_float(state);

		draw_unit(state, axis);
		glm_rotate_make(palette[j], angle_rad, axis);
		for (int k = 0; k < 3; k++) {
			palette[j][3][k] = 0.5f * draw_float(state);
		}
	}
}

static float (*vectors(struct arena *arena, int count))[3]
{
	return arena_alloc(arena, (size_t)count, sizeof(float[3]));
}

static int allocate(struct bench_mesh *mesh, int count)
{
	struct model_primitive *primitive = &mesh->primitive;
	struct arena *arena = &mesh->arena;
	size_t influences = (size_t)count * (size_t)primitive->influences;

	primitive->position = vectors(arena, count);
	primitive->normal = vectors(arena, count);
	primitive->tangent = arena_alloc(arena, (size_t)count, sizeof(float[4]));
	primitive->joint = ARENA_ARRAY(arena, uint16_t, influences);
	primitive->weight = ARENA_ARRAY(arena, float, influences);
	mesh->palette = ARENA_ARRAY(arena, mat4, JOINTS);
	return primitive->position && primitive->normal && primitive->tangent &&
			primitive->joint && primitive->weight && mesh->palette
		? 0
		: -ENOMEM;
}

/* Draws the second key frame and the targets. */
static int add_keys(struct bench_mesh *mesh, uint32_t *state)
{
	int count = mesh->primitive.vertex_count;

	mesh->destiny = vectors(&mesh->arena, count);
	mesh->destiny_normal = vectors(&mesh->arena, count);
	if (!mesh->destiny || !mesh->destiny_normal) {
		return -ENOMEM;
	}
	draw_vectors(state, count, 0.9f, mesh->destiny);
	draw_vectors(state, count, 1.0f, mesh->destiny_normal);
	for (int t = 0; t < 2; t++) {
		float(*normal)[3] = vectors(&mesh->arena, count);

		mesh->delta[t] = vectors(&mesh->arena, count);
		if (!mesh->delta[t] || !normal) {
			return -ENOMEM;
		}
		draw_vectors(state, count, 0.2f, mesh->delta[t]);
		draw_vectors(state, count, 0.2f, normal);
		mesh->target[t].position = model_deltas_view(
			(const float(*)[3])mesh->delta[t], count);
		mesh->target[t].normal =
			model_deltas_view((const float(*)[3])normal, count);
	}
	return 0;
}

int bench_mesh_make(struct bench_mesh *mesh, int vertex_count, int influences,
	int joint_sets)
{
	struct model_primitive *primitive = &mesh->primitive;
	uint32_t state = 4044;
	int error;

	*mesh = (struct bench_mesh){
		.arena = arena_empty(),
		.primitive.vertex_count = vertex_count,
		/* As in glTF files, whose sets have four. */
		.primitive.influences = (influences + 3) / 4 * 4,
		.joint_count = JOINTS,
	};
	error = allocate(mesh, vertex_count);
	if (error) {
		goto fail;
	}
	draw_vectors(&state, vertex_count, 0.9f, primitive->position);
	draw_vectors(&state, vertex_count, 1.0f, primitive->normal);
	for (int v = 0; v < vertex_count; v++) {
		draw_unit(&state, primitive->tangent[v]);
		primitive->tangent[v][3] = 1.0f;
	}
	draw_influences(&state, primitive, influences, joint_sets);
	draw_palette(&state, mesh->palette);
	error = add_keys(mesh, &state);
	if (!error) {
		return 0;
	}
fail:
	bench_mesh_release(mesh);
	return error;
}

/* Finds the skinned primitive with the most vertices, and its skin. */
static const struct model_primitive *largest_skinned(
	const struct model *model, int *skin)
{
	const struct model_primitive *largest = NULL;

	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];
		const struct model_mesh *mesh;

		if (node->mesh < 0 || node->skin < 0) {
			continue;
		}
		mesh = &model->mesh[node->mesh];
		for (int p = 0; p < mesh->primitive_count; p++) {
			const struct model_primitive *one = &mesh->primitive[p];

			if (one->influences > 0 &&
				(!largest ||
					one->vertex_count >
						largest->vertex_count)) {
				largest = one;
				*skin = node->skin;
			}
		}
	}
	return largest;
}

static int pose_model(
	struct bench_mesh *mesh, const struct model *model, int skin)
{
	struct arena *arena = &mesh->arena;
	struct clip_cursor cursor;
	struct pose pose;
	mat4 *world = ARENA_ARRAY(arena, mat4, (size_t)model->node_count);

	mesh->joint_count = model->skin[skin].joint_count;
	mesh->palette = ARENA_ARRAY(arena, mat4, (size_t)mesh->joint_count);
	if (!world || !mesh->palette || pose_init(&pose, model, arena) != 0 ||
		clip_cursor_init(&cursor, model, arena) != 0) {
		return -ENOMEM;
	}
	if (model->clip_count > 0) {
		const struct model_clip *clip = &model->clip[0];

		clip_sample(clip, clip->duration_s * 0.5f, &cursor, &pose);
	}
	pose_world(&pose, model, NULL, world);
	pose_palette(&model->skin[skin], (const mat4 *)world, mesh->palette);
	return 0;
}

/* Adds random normals if there are none: the loops take the same time. */
static int add_normals(struct bench_mesh *mesh, uint32_t *state)
{
	struct model_primitive *primitive = &mesh->primitive;

	if (primitive->normal) {
		return 0;
	}
	primitive->normal = vectors(&mesh->arena, primitive->vertex_count);
	if (!primitive->normal) {
		return -ENOMEM;
	}
	draw_vectors(state, primitive->vertex_count, 1.0f, primitive->normal);
	return 0;
}

int bench_mesh_of_model(struct bench_mesh *mesh, const struct model *model)
{
	const struct model_primitive *primitive;
	uint32_t state = 4044;
	int skin = -1;
	int error;

	*mesh = (struct bench_mesh){
		.arena = arena_within(model->budget), .is_model = true};
	primitive = largest_skinned(model, &skin);
	if (!primitive) {
		return -ENOENT;
	}
	mesh->primitive = *primitive;
	error = pose_model(mesh, model, skin);
	if (!error) {
		error = add_keys(mesh, &state);
	}
	if (!error) {
		error = add_normals(mesh, &state);
	}
	if (error) {
		bench_mesh_release(mesh);
	}
	return error;
}

void bench_mesh_release(struct bench_mesh *mesh)
{
	arena_release(&mesh->arena);
}
