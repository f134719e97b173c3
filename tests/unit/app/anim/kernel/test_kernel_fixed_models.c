/*
 * Compares fixed point with float for all models of the project, and for
 * Khronos' sample models if their folder exists.
 */
#include "app/anim/clip.h"
#include "app/anim/kernel/kernel.h"
#include "app/anim/kernel/layout/fixed_morph.h"
#include "app/anim/kernel/layout/fixed_skin.h"
#include "app/anim/kernel/run/fixed_morph_run.h"
#include "app/anim/kernel/run/fixed_palette.h"
#include "app/anim/kernel/run/fixed_skin_run.h"
#include "app/anim/pose.h"
#include "app/model/model_deltas.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/samples.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	TIMES = 7
};

/* The largest errors of a primitive. */
struct worst {
	double position; /* relative to the posed vertices' radius */
	double normal_rad;
};

struct scene {
	const struct model *model;
	struct arena arena;
	struct pose pose;
	mat4 *world;
	mat4 *palette;
};

static void *allocate(struct arena *arena, int count, size_t size)
{
	void *block = arena_alloc(arena, (size_t)count, size);

	assert_non_null(block);
	return block;
}

static double distance(const float a[3], const float b[3])
{
	double sum = 0;

	for (int k = 0; k < 3; k++) {
		sum += ((double)a[k] - b[k]) * ((double)a[k] - b[k]);
	}
	return sqrt(sum);
}

/* The radius of a sphere around all vertices, with the centre of their box. */
static double radius(const float (*v)[3], int count)
{
	float low[3] = {1e30f, 1e30f, 1e30f};
	float high[3] = {-1e30f, -1e30f, -1e30f};
	float middle[3];
	double most = 0;

	for (int i = 0; i < count * 3; i++) {
		float value = v[i / 3][i % 3];

		low[i % 3] = value < low[i % 3] ? value : low[i % 3];
		high[i % 3] = value > high[i % 3] ? value : high[i % 3];
	}
	for (int k = 0; k < 3; k++) {
		middle[k] = 0.5f * (low[k] + high[k]);
	}
	for (int i = 0; i < count; i++) {
		most = fmax(most, distance(v[i], middle));
	}
	return most;
}

static void to_float(const struct fixed_vector *v,
	const struct fixed_placement *placement, float out[3])
{
	out[0] = (float)v->x * placement->scale + placement->offset[0];
	out[1] = (float)v->y * placement->scale + placement->offset[1];
	out[2] = (float)v->z * placement->scale + placement->offset[2];
}

static double angle_rad(const float unit[3], const struct fixed_vector *v)
{
	double length = sqrt((double)v->x * v->x + (double)v->y * v->y +
		(double)v->z * v->z);
	double chord;

	if (length == 0) {
		return 0;
	}
	chord = distance(unit,
		(float[3]){(float)(v->x / length), (float)(v->y / length),
			(float)(v->z / length)});
	return 2 * asin(fmin(1, chord / 2));
}

/* The float kernel's terms for the given weights. */
static void set_terms(const struct model_primitive *primitive,
	const float *weight, int count, struct arena *arena,
	struct morph_term *term)
{
	for (int t = 0; t < count; t++) {
		const struct model_target *target = &primitive->target[t];

		term[t] = (struct morph_term){.weight = weight[t]};
		assert_int_equal(model_deltas_floats(&target->position, arena,
					 &term[t].position),
			0);
		assert_int_equal(model_deltas_floats(&target->normal, arena,
					 &term[t].normal),
			0);
	}
}

/* A skinned primitive, with its targets if it has any. */
struct skinned {
	struct fixed_skin skin;
	struct skin_stream stream;
	int target_count;
	float *weight;
};

static void skin_float(const struct scene *scene, const struct skinned *it,
	int cap, float (*position)[3], float (*normal)[3])
{
	const struct model_primitive *primitive = it->skin.primitive;
	struct morph_term term[64];
	const struct morph_input input = {
		.position = (const float(*)[3])primitive->position,
		.normal = (const float(*)[3])primitive->normal,
		.term = term,
		.term_count = it->target_count,
		.position_scale = 1,
	};
	const struct skin_output output = {position, normal, NULL};
	struct arena arena = arena_empty();

	if (it->target_count == 0) {
		kernel_float.skin(&it->stream, (const mat4 *)scene->palette,
			cap, position, normal);
		return;
	}
	assert_true(it->target_count <= 64);
	set_terms(primitive, it->weight, it->target_count, &arena, term);
	kernel_float.skin_morphed(&it->stream, &input,
		(const mat4 *)scene->palette, cap, &output);
	arena_release(&arena);
}

static void compare_at(const struct scene *scene, struct skinned *it, int cap,
	struct worst *worst)
{
	struct fixed_skin *skin = &it->skin;
	struct arena arena = arena_empty();
	int count = skin->vertex_count;
	float(*position)[3] = allocate(&arena, count, sizeof(*position));
	float(*normal)[3] = allocate(&arena, count, sizeof(*normal));
	struct fixed_vector *out = allocate(&arena, count, sizeof(*out));
	struct fixed_vector *out_normal = allocate(&arena, count, sizeof(*out));
	struct fixed_matrix *matrix =
		allocate(&arena, skin->joint_count, sizeof(*matrix));
	struct fixed_placement placement;
	double size;

	skin_float(scene, it, cap, position,
		skin->base[FIXED_NORMAL] ? normal : NULL);
	fixed_skin_set_cap(skin, cap);
	if (it->target_count > 0) {
		assert_int_equal(fixed_skin_set_weights(
					 &it->skin, &fixed_loops_c, it->weight),
			0);
	}
	assert_int_equal(fixed_palette_make(skin, (const mat4 *)scene->palette,
				 matrix, &placement),
		0);
	fixed_loops_c.skin(skin->group, skin->group_count,
		skin->base[FIXED_POSITION], matrix, out);
	if (skin->base[FIXED_NORMAL]) {
		fixed_loops_c.skin(skin->group, skin->group_count,
			skin->base[FIXED_NORMAL], matrix, out_normal);
	}
	size = radius((const float(*)[3])position, count);
	for (int i = 0; i < count; i++) {
		float got[3];

		to_float(&out[i], &placement, got);
		worst->position = fmax(worst->position,
			distance(got, position[skin->order[i]]) / size);
		if (skin->base[FIXED_NORMAL]) {
			worst->normal_rad = fmax(worst->normal_rad,
				angle_rad(normal[skin->order[i]],
					&out_normal[i]));
		}
	}
	arena_release(&arena);
}

static void set_up_skinned(struct skinned *it, const struct scene *scene,
	const struct model_node *node, const struct model_primitive *primitive,
	struct arena *arena)
{
	it->target_count = scene->model->mesh[node->mesh].target_count;
	it->weight = allocate(arena, it->target_count, sizeof(*it->weight));
	assert_int_equal(skin_stream_init(&it->stream, primitive, 1, arena), 0);
	assert_int_equal(fixed_skin_init(&it->skin, primitive,
				 primitive->normal ? FIXED_NORMALS : 0, arena),
		0);
	if (it->target_count > 0) {
		assert_int_equal(fixed_skin_add_targets(
					 &it->skin, it->target_count, arena),
			0);
	}
}

static void pose_at(struct scene *scene, const struct model_node *node,
	const struct model_clip *clip, int time, struct clip_cursor *cursor)
{
	const struct model *model = scene->model;

	pose_rest(&scene->pose, model);
	if (clip) {
		clip_sample(clip, clip->duration_s * (float)time / (TIMES - 1),
			cursor, &scene->pose);
	}
	pose_world(&scene->pose, model, NULL, scene->world);
	pose_palette(&model->skin[node->skin], (const mat4 *)scene->world,
		scene->palette);
}

static void compare_skinned(struct scene *scene, const struct model_node *node,
	const struct model_primitive *primitive, struct worst *worst)
{
	const struct model *model = scene->model;
	struct arena arena = arena_empty();
	struct clip_cursor cursor;
	struct skinned it;

	set_up_skinned(&it, scene, node, primitive, &arena);
	assert_int_equal(clip_cursor_init(&cursor, model, &arena), 0);
	for (int i = 0; i < 1 + model->clip_count * TIMES; i++) {
		pose_at(scene, node, i ? &model->clip[(i - 1) / TIMES] : NULL,
			(i - 1) % TIMES, &cursor);
		memcpy(it.weight, scene->pose.weight + node->weight_offset,
			(size_t)it.target_count * sizeof(*it.weight));
		if (it.target_count > 0) {
			it.weight[i % it.target_count] = 1;
		}
		compare_at(scene, &it, i % 5, worst);
	}
	arena_release(&arena);
}

static void compare_morphed_at(const struct model_primitive *primitive,
	int target_count, const float *weight, struct fixed_morph *morph,
	struct worst *worst)
{
	struct arena arena = arena_empty();
	int count = primitive->vertex_count;
	float(*position)[3] = allocate(&arena, count, sizeof(*position));
	float(*normal)[3] = allocate(&arena, count, sizeof(*normal));
	struct fixed_vector *out = allocate(&arena, count, sizeof(*out));
	struct morph_term *term = allocate(&arena, target_count, sizeof(*term));
	double size;

	set_terms(primitive, weight, target_count, &arena, term);
	kernel_float.morph_targets(count, (const float(*)[3])primitive->position,
		term, target_count, false, position);
	assert_int_equal(fixed_morph_set_weights(morph, weight), 0);
	fixed_morph_run(morph, &fixed_loops_c, FIXED_POSITION, out);
	size = radius((const float(*)[3])position, count);
	for (int i = 0; i < count; i++) {
		float got[3];

		to_float(&out[i], &morph->placement, got);
		worst->position = fmax(
			worst->position, distance(got, position[i]) / size);
	}
	if (primitive->normal) {
		kernel_float.morph_targets(count,
			(const float(*)[3])primitive->normal, term,
			target_count, true, normal);
		kernel_float.normalize(count, normal);
		fixed_morph_run(morph, &fixed_loops_c, FIXED_NORMAL, out);
		for (int i = 0; i < count; i++) {
			worst->normal_rad = fmax(worst->normal_rad,
				angle_rad(normal[i], &out[i]));
		}
	}
	arena_release(&arena);
}

/* At times of all clips, and with each target at weight 1. */
static void compare_morphed(struct scene *scene, const struct model_node *node,
	const struct model_primitive *primitive, struct worst *worst)
{
	const struct model *model = scene->model;
	int targets = model->mesh[node->mesh].target_count;
	struct arena arena = arena_empty();
	float *weight = allocate(&arena, targets, sizeof(*weight));
	struct clip_cursor cursor;
	struct fixed_morph morph;

	assert_int_equal(clip_cursor_init(&cursor, model, &arena), 0);
	assert_int_equal(fixed_morph_init(&morph, primitive, targets,
				 primitive->normal ? FIXED_NORMALS : 0, &arena),
		0);
	for (int t = 0; t < targets; t++) {
		memset(weight, 0, (size_t)targets * sizeof(*weight));
		weight[t] = 1;
		compare_morphed_at(primitive, targets, weight, &morph, worst);
		weight[0] = 1;
		weight[targets - 1] = 1;
		compare_morphed_at(primitive, targets, weight, &morph, worst);
	}
	for (int i = 0; i < model->clip_count * TIMES; i++) {
		const struct model_clip *clip = &model->clip[i / TIMES];

		pose_rest(&scene->pose, model);
		clip_sample(clip,
			clip->duration_s * (float)(i % TIMES) / (TIMES - 1),
			&cursor, &scene->pose);
		compare_morphed_at(primitive, targets,
			scene->pose.weight + node->weight_offset, &morph, worst);
	}
	arena_release(&arena);
}

static void expect_close(const char *path, const char *name, int primitive,
	const struct worst *worst)
{
	print_message("# %s %s %d: %.2g of the radius, %.2g degrees\n", path,
		name, primitive, worst->position,
		worst->normal_rad * 180 / acos(-1));
	assert_near(worst->position, 0, 2e-4);
	assert_near(worst->normal_rad * 180 / acos(-1), 0, 1);
}

static void compare_model(const char *path)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct scene scene = {.arena = arena_empty()};
	struct model *model;
	int joints = 1;

	if (model_load(path, &log, &model) != 0) {
		return;
	}
	scene.model = model;
	for (int i = 0; i < model->skin_count; i++) {
		joints = model->skin[i].joint_count > joints
			? model->skin[i].joint_count
			: joints;
	}
	assert_int_equal(pose_init(&scene.pose, model, &scene.arena), 0);
	scene.world = allocate(&scene.arena, model->node_count, sizeof(mat4));
	scene.palette = allocate(&scene.arena, joints, sizeof(mat4));
	for (int n = 0; n < model->node_count; n++) {
		const struct model_node *node = &model->node[n];

		if (node->mesh < 0) {
			continue;
		}
		for (int p = 0; p < model->mesh[node->mesh].primitive_count;
			p++) {
			const struct model_primitive *primitive =
				&model->mesh[node->mesh].primitive[p];
			struct worst worst = {0};

			if (node->skin >= 0 && primitive->influences) {
				compare_skinned(&scene, node, primitive, &worst);
			}
			if (node->skin < 0 &&
				model->mesh[node->mesh].target_count > 0) {
				compare_morphed(&scene, node, primitive, &worst);
			}
			expect_close(path, node->name, p, &worst);
		}
	}
	arena_release(&scene.arena);
	model_destroy(model);
}

static void test_the_projects_models_are_as_in_float(void **state)
{
	(void)state;
	assert_true(samples_each_model("assets", compare_model) > 0);
}

static void test_sample_models_are_as_in_float(void **state)
{
	(void)state;
	samples_require("");
	assert_true(
		samples_each_model(samples_path("").text, compare_model) > 0);
	samples_each_model(samples_path("x").text, compare_model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_projects_models_are_as_in_float),
		cmocka_unit_test(test_sample_models_are_as_in_float),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
