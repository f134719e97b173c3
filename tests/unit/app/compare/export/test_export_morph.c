/* The mesh and the scene of exported key frames. */
#include "app/compare/candidate/candidate_morph.h"
#include "app/compare/export/export.h"
#include "app/compare/export/export_bake.h"
#include "app/compare/measure/reference.h"
#include "platform/base/interrupt.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/model/written_glb.h"
#include "tests/support/test.h"

#include <errno.h>
#include <signal.h>
#include <string.h>

enum {
	CLIPS_MAX = 12,
	KEYS = 2
};

struct bench {
	struct log_capture capture;
	struct log log;
	struct model *model;
	float time_s[CLIPS_MAX][KEYS];
	struct comparison_clip clip[CLIPS_MAX];
	struct comparison_cell cell[CLIPS_MAX];
	struct comparison comparison;
	struct comparison_row row;
};

/* Each clip has two keys: at half of its time, and at its end. */
static void begin(struct bench *bench, const char *name)
{
	memset(bench, 0, sizeof(*bench));
	bench->log = log_capture_begin(&bench->capture);
	bench->model = model_fixture(name, NULL);
	assert_in_range(bench->model->clip_count, 1, CLIPS_MAX);
	for (int c = 0; c < bench->model->clip_count; c++) {
		bench->time_s[c][1] = bench->model->clip[c].duration_s;
		bench->time_s[c][0] = 0.5f * bench->time_s[c][1];
		bench->clip[c].clip = c;
		bench->cell[c].keys = (struct fit_keys){KEYS, bench->time_s[c]};
	}
	bench->comparison = (struct comparison){.model = bench->model,
		.box = {{-8, -8, -8}, {8, 8, 24}},
		.clip_count = bench->model->clip_count,
		.clip = bench->clip};
	bench->row = (struct comparison_row){.kind = COMPARISON_MORPH,
		.cell = bench->cell,
		.total = {.key_count = KEYS * bench->model->clip_count}};
}

static void end(struct bench *bench)
{
	model_destroy(bench->model);
}

static struct written_glb export(struct bench *bench)
{
	struct glb glb;

	glb_begin_memory(&glb);
	assert_int_equal(
		export_morph(&glb, &bench->comparison, &bench->row, &bench->log),
		0);
	return written_glb_take(&glb);
}

static const json_t *at(const json_t *array, size_t index)
{
	return json_array_get(array, index);
}

/* Where the elements of an accessor begin, which is not sparse. */
static const void *elements(const struct written_glb *written,
	const json_t *attributes, const char *name)
{
	json_t *number = json_object_get(attributes, name);
	const json_t *accessor = at(json_object_get(written->root, "accessors"),
		(size_t)json_integer_value(number));
	const json_t *view = at(json_object_get(written->root, "bufferViews"),
		(size_t)json_integer_value(
			json_object_get(accessor, "bufferView")));

	assert_non_null(number);
	assert_null(json_object_get(accessor, "sparse"));
	return written->binary +
		json_integer_value(json_object_get(view, "byteOffset"));
}

static void expect_base(const struct reference *rest,
	const struct fixed_placement *placement,
	const struct reference_part *part, const struct written_glb *written,
	const json_t *attributes)
{
	const int16_t(*position)[4] = elements(written, attributes, "POSITION");
	const int8_t(*normal)[4] =
		part->normals ? elements(written, attributes, "NORMAL") : NULL;

	for (int i = 0; i < part->vertex_count; i++) {
		int v = part->first_vertex + i;

		for (int axis = 0; axis < 3; axis++) {
			assert_near(
				(double)(placement->scale * position[i][axis] +
					placement->offset[axis]),
				rest->position[v][axis], 1e-3);
			if (normal) {
				assert_int_equal(normal[i][axis],
					rest->normal[v][axis] < 0 ? -73 : 73);
			}
		}
	}
	assert_int_equal(json_object_size(attributes) > 1, part->normals);
}

/*
 * Its positions are those of rest, and its normals the diagonals nearest to
 * those of rest, from which a signed byte reaches any other normal.
 */
static void test_the_mesh_of_key_frames_is_the_pose_of_rest(void **state)
{
	static const char *const names[] = {
		"gltf/clip/door.gltf", "gltf/skin/and_morph.gltf"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		struct fixed_placement placement;
		struct written_glb written;
		struct reference *rest;
		const json_t *primitives;
		struct bench bench;

		begin(&bench, names[i]);
		placement = candidate_morph_placement(&bench.comparison.box);
		assert_int_equal(
			reference_create(bench.model, 0, &bench.log, &rest), 0);
		reference_rest(rest);
		written = export(&bench);
		primitives = json_object_get(
			at(json_object_get(written.root, "meshes"), 0),
			"primitives");
		assert_int_equal(json_array_size(primitives), rest->part_count);
		for (int p = 0; p < rest->part_count; p++) {
			expect_base(rest, &placement, &rest->part[p], &written,
				json_object_get(at(primitives, (size_t)p),
					"attributes"));
		}
		written_glb_release(&written);
		reference_destroy(rest);
		end(&bench);
	}
}

/* Readers need not show a scene that the file does not name. */
static void test_a_scene_of_one_node_shows_the_key_frames(void **state)
{
	struct written_glb written;
	struct bench bench;
	const json_t *mesh;

	(void)state;
	begin(&bench, "gltf/clip/door.gltf");
	bench.comparison.box =
		(struct bounds){{-16383, 0, 0}, {16383, 2, 2 * 16383}};
	written = export(&bench);
	assert_true(json_is_integer(json_object_get(written.root, "scene")));
	assert_int_equal(
		json_integer_value(json_object_get(written.root, "scene")), 0);
	written_glb_expect(&written, "scenes", "[{'nodes':[0]}]");
	written_glb_expect(&written, "nodes",
		"[{'mesh':0,'scale':[1.0,1.0,1.0],'translation':[0.0,1.0,16383.0]}]");
	mesh = at(json_object_get(written.root, "meshes"), 0);
	assert_true(json_is_true(
		json_object_get(json_object_get(mesh, "extras"), "keyFrames")));
	assert_int_equal(
		json_array_size(json_object_get(written.root, "animations")),
		bench.model->clip_count);
	written_glb_release(&written);
	end(&bench);
}

/* While the model is prepared and, without a mesh, between its key frames. */
static void test_an_export_gives_up_and_says_nothing(void **state)
{
	(void)state;
	for (int meshes = 0; meshes < 2; meshes++) {
		struct bench bench;
		struct glb glb;
		int error;

		begin(&bench, "gltf/clip/door.gltf");
		for (int i = 0; !meshes && i < bench.model->node_count; i++) {
			bench.model->node[i].mesh = -1;
		}
		glb_begin_memory(&glb);
		interrupt_set(SIGTERM);
		error = export_morph(
			&glb, &bench.comparison, &bench.row, &bench.log);
		interrupt_set(0);
		assert_int_equal(error, -EINTR);
		assert_string_equal(bench.capture.sentence[0], "");
		assert_int_equal(bench.capture.count, 0);
		glb_discard(&glb);
		end(&bench);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_mesh_of_key_frames_is_the_pose_of_rest),
		cmocka_unit_test(test_a_scene_of_one_node_shows_the_key_frames),
		cmocka_unit_test(test_an_export_gives_up_and_says_nothing),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
