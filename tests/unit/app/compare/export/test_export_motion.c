/* Exported key frames and rigid parts move as the model does. */
#include "app/compare/candidate/candidate_morph.h"
#include "app/compare/candidate/candidate_rigid.h"
#include "app/compare/export/export.h"
#include "app/compare/measure/reference.h"
#include "platform/base/scalar.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

#include <cglm/cglm.h>

enum {
	CLIPS_MAX = 12,
	KEYS = 3 /* of each clip */
};

struct bench {
	struct log log;
	struct model *model, *loaded;
	struct comparison_clip clip[CLIPS_MAX];
	float time_s[CLIPS_MAX][KEYS];
	int key_count;
	struct comparison_cell cell[CLIPS_MAX];
	struct comparison comparison;
};

/*
 * Compares all clips from number first on, one after the other. Their keys are
 * their begin, this share of them, and their end.
 */
static void begin(struct bench *bench, const char *path, int first, float share)
{
	struct model *model;

	*bench = (struct bench){.log = log_to_stderr(LOG_ERROR)};
	assert_int_equal(model_load(path, &bench->log, &model), 0);
	bench->model = model;
	bench->comparison = (struct comparison){.model = model,
		.box = {{-8, -8, -8}, {8, 8, 24}},
		.clip_count = model->clip_count - first,
		.clip = bench->clip};
	assert_in_range(bench->comparison.clip_count, 1, CLIPS_MAX);
	for (int c = 0; c < bench->comparison.clip_count; c++) {
		float duration_s = model->clip[first + c].duration_s;

		bench->clip[c].clip = first + c;
		bench->time_s[c][1] = share * duration_s;
		bench->time_s[c][2] = duration_s;
		bench->cell[c].keys = (struct fit_keys){
			share < 1.0f ? KEYS : KEYS - 1, bench->time_s[c]};
		bench->key_count += bench->cell[c].keys.count;
	}
}

static void load(struct bench *bench, enum comparison_kind kind)
{
	const struct comparison_row row = {.kind = kind,
		.cell = bench->cell,
		.total = {.key_count = bench->key_count}};

	assert_int_equal(export_load(&bench->comparison, &row, &bench->log,
				 &bench->loaded),
		0);
	assert_int_equal(
		bench->loaded->clip_count, bench->comparison.clip_count);
}

static void end(struct bench *bench)
{
	model_destroy(bench->loaded);
	model_destroy(bench->model);
}

static struct reference *reference_of(
	const struct bench *bench, const struct model *model, int clip)
{
	struct reference *reference;

	assert_int_equal(
		reference_create(model, clip, &bench->log, &reference), 0);
	return reference;
}

static const struct model_primitive *primitive_of(
	const struct reference *reference, int part)
{
	return reference->instance->drawable[reference->part[part].drawable]
		.primitive;
}

/* A level of detail or a part shows what the model's own part shows. */
static void expect_looks(const struct model_primitive *primitive,
	const struct model_primitive *own, int vertex, int own_vertex)
{
	assert_int_equal(primitive->material, own->material);
	assert_int_equal(primitive->texcoord == NULL, own->texcoord == NULL);
	assert_int_equal(primitive->color == NULL, own->color == NULL);
	if (own->texcoord) {
		assert_all_near(primitive->texcoord[vertex],
			own->texcoord[own_vertex], 2, 0.0);
	}
	if (own->color) {
		assert_memory_equal(
			primitive->color[vertex], own->color[own_vertex], 4);
	}
}

/* Positions have 15 bits of the box, and normals 54 steps. */
static void expect_key(const struct reference *morph,
	const struct reference *own, bool mirrored)
{
	assert_int_equal(morph->part_count, own->part_count);
	assert_int_equal(morph->vertex_count, own->vertex_count);
	assert_all_near(morph->position, own->position, 3 * own->vertex_count,
		32.0 / 32767.0);
	assert_all_near(
		morph->normal, own->normal, 3 * own->vertex_count, 1.5 / 54.0);
	for (int p = 0; p < own->part_count; p++) {
		const struct model_primitive *shown = primitive_of(morph, p);
		const struct model_primitive *from = primitive_of(own, p);

		assert_int_equal(shown->index_count, from->index_count);
		for (int i = 0; i < from->index_count; i++) {
			int other = i % 3 == 1 ? i + 1 : i - (i % 3 == 2);

			assert_int_equal(shown->index[i],
				from->index[mirrored ? other : i]);
		}
		for (int v = 0; v < from->vertex_count; v++) {
			expect_looks(shown, from, v, v);
		}
	}
}

static void expect_morph(const char *path, int first, float share, bool mirrored)
{
	struct bench bench;

	begin(&bench, path, first, share);
	load(&bench, COMPARISON_MORPH);
	for (int c = 0; c < bench.comparison.clip_count; c++) {
		struct reference *own =
			reference_of(&bench, bench.model, first + c);
		struct reference *morph = reference_of(&bench, bench.loaded, c);

		assert_string_equal(morph->clip->name, own->clip->name);
		for (int k = 0; k < KEYS; k++) {
			reference_pose(own, bench.time_s[c][k], true);
			reference_pose(morph, bench.time_s[c][k], true);
			expect_key(morph, own, mirrored);
		}
		reference_destroy(own);
		reference_destroy(morph);
	}
	end(&bench);
}

static void test_key_frames_are_poses_of_the_model(void **state)
{
	(void)state;
	expect_morph("tests/fixtures/gltf/clip/door.gltf", 0, 0.375f, false);
	expect_morph("tests/fixtures/gltf/clip/door.gltf", 7, 0.375f, false);
	expect_morph(
		"tests/fixtures/gltf/clip/frame_one.gltf", 0, 0.375f, false);
	expect_morph(
		"tests/fixtures/gltf/skin/and_morph.gltf", 0, 0.375f, false);
	expect_morph("assets/face.glb", 1, 0.375f, false);
}

/*
 * One clip is mirrored all the time, and one from a third of its time on. If
 * half of the key frames are mirrored, the triangles stay as they are.
 */
static void test_key_frames_have_the_winding_of_most_of_them(void **state)
{
	static const char path[] = "tests/fixtures/gltf/clip/mirror.gltf";

	(void)state;
	expect_morph(path, 0, 0.25f, true);
	expect_morph(path, 1, 0.375f, true);
	expect_morph(path, 1, 0.25f, false);
	expect_morph(path, 1, 1.0f, false);
}

/* The exported parts in the order of the file: by their nodes. */
static int next_part(const struct rigid_bake *rigid, int *node, int *part)
{
	for (; *node < rigid->reference->model->node_count; ++*node, *part = 0) {
		while (*part < rigid->part_count) {
			int at = (*part)++;

			if (rigid->part[at].node == *node) {
				return at;
			}
		}
	}
	return -1;
}

static void expect_part(const struct rigid_bake *rigid,
	const struct rigid_part *part, const struct reference *shown, int p)
{
	const struct model_primitive *primitive = primitive_of(shown, p);
	const struct reference_part *own = &rigid->reference->part[part->part];

	assert_int_equal(primitive->vertex_count, part->vertex_count);
	assert_int_equal(primitive->index_count, part->index_count);
	assert_memory_equal(primitive->index, rigid->index + part->first_index,
		(size_t)part->index_count * sizeof(*rigid->index));
	assert_int_equal(shown->part[p].normals, own->normals);
	for (int v = 0; v < part->vertex_count; v++) {
		expect_looks(primitive,
			primitive_of(rigid->reference, part->part), v,
			rigid->source[part->first_vertex + v] -
				own->first_vertex);
	}
}

static void expect_poses(const struct rigid_bake *rigid,
	const struct candidate *candidate, const struct reference *shown)
{
	size_t bytes = (size_t)candidate->vertex_count * sizeof(float[3]);
	float(*position)[3] = malloc(bytes), (*normal)[3] = malloc(bytes);
	int node = 0, part = 0;

	assert_non_null(position);
	assert_non_null(normal);
	candidate->take(candidate, position, normal);
	for (int p = 0; p < shown->part_count; p++) {
		int at = next_part(rigid, &node, &part);
		int from, to = shown->part[p].first_vertex;

		assert_true(at >= 0);
		from = rigid->part[at].first_vertex;
		expect_part(rigid, &rigid->part[at], shown, p);
		assert_all_near(shown->position + to, position + from,
			3 * rigid->part[at].vertex_count, 1e-5);
		for (int v = 0; v < rigid->part[at].vertex_count; v++) {
			assert_all_near(shown->normal[to + v], normal[from + v],
				rigid->reference->part[rigid->part[at].part].normals
					? 3
					: 0,
				1e-4);
		}
	}
	assert_int_equal(next_part(rigid, &node, &part), -1);
	free(position);
	free(normal);
}

static void expect_rigid(const char *path, int first)
{
	struct bench bench;

	begin(&bench, path, first, 0.375f);
	load(&bench, COMPARISON_RIGID);
	for (int c = 0; c < bench.comparison.clip_count; c++) {
		struct reference *own =
			reference_of(&bench, bench.model, first + c);
		struct reference *shown = reference_of(&bench, bench.loaded, c);
		struct candidate candidate;

		assert_int_equal(
			candidate_rigid(&candidate, own, &bench.log), 0);
		assert_string_equal(shown->clip->name, own->clip->name);
		for (int k = 0; k < KEYS; k++) {
			candidate_pose(&candidate, bench.time_s[c][k]);
			reference_pose(shown, bench.time_s[c][k], true);
			expect_poses(candidate_rigid_bake(&candidate),
				&candidate, shown);
		}
		candidate_destroy(&candidate);
		reference_destroy(own);
		reference_destroy(shown);
	}
	end(&bench);
}

static void test_rigid_parts_move_as_was_measured(void **state)
{
	(void)state;
	expect_rigid("tests/fixtures/gltf/clip/door.gltf", 0);
	expect_rigid("tests/fixtures/gltf/clip/frame_one.gltf", 0);
	expect_rigid("tests/fixtures/gltf/skin/and_morph.gltf", 0);
	expect_rigid("assets/walker.glb", 4);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_key_frames_are_poses_of_the_model),
		cmocka_unit_test(
			test_key_frames_have_the_winding_of_most_of_them),
		cmocka_unit_test(test_rigid_parts_move_as_was_measured),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
