/* What limber info measures: the units of meshes, and bytes by technique. */
#include "app/cmd/info/info_report.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cglm/cglm.h>

enum {
	NODES = 3,
	MESHES = 3,
	VERTICES = 12
};

/* Nodes of sizes 2, 3 and 4, which show copies of a grid. */
struct scene {
	struct model *model;
	struct model_node node[NODES];
	struct model_mesh mesh[MESHES];
};

static void begin(struct scene *scene, const int mesh_of[NODES])
{
	scene->model = small_model_grid(3, 2, 1.0f, true);
	for (int i = 0; i < NODES; i++) {
		scene->node[i] = *scene->model->node;
		scene->node[i].mesh = mesh_of[i];
		scene->node[i].rest.scale[0] = scene->node[i].rest.scale[1] =
			scene->node[i].rest.scale[2] = 2.0f + (float)i;
	}
	for (int i = 0; i < MESHES; i++) {
		scene->mesh[i] = *scene->model->mesh;
	}
	scene->model->node = scene->node;
	scene->model->node_count = NODES;
	scene->model->mesh = scene->mesh;
	scene->model->mesh_count = MESHES;
}

static struct info_report measured(const struct scene *scene)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct info_report report;

	assert_int_equal(info_measure(scene->model, &log, &report), 0);
	assert_ptr_equal(report.model, scene->model);
	return report;
}

static void expect_units(const int mesh_of[NODES], const float wanted[MESHES])
{
	struct scene scene;
	struct info_report report;

	begin(&scene, mesh_of);
	report = measured(&scene);
	assert_all_near(report.unit_m, wanted, MESHES, 1e-6);
	info_release(&report);
	assert_null(report.unit_m);
	model_destroy(scene.model);
}

static void test_a_mesh_has_the_unit_of_its_first_node(void **state)
{
	(void)state;
	expect_units((const int[]){0, 1, 2}, (const float[]){2, 3, 4});
	expect_units((const int[]){2, 1, 0}, (const float[]){4, 3, 2});
	expect_units((const int[]){1, 1, 0}, (const float[]){4, 2, 1});
	expect_units((const int[]){2, 2, 2}, (const float[]){1, 1, 2});
	expect_units((const int[]){-1, -1, -1}, (const float[]){1, 1, 1});
	expect_units((const int[]){0, -1, 0}, (const float[]){2, 1, 1});
}

/* A node has a transform and a matrix; nothing is morphed or skinned. */
static void test_nodes_alone_need_transforms(void **state)
{
	struct scene scene;
	struct info_report report;

	(void)state;
	begin(&scene, (const int[]){0, 1, 2});
	report = measured(&scene);
	assert_int_equal(report.hierarchical_bytes,
		NODES * (sizeof(struct transform) + 64));
	assert_int_equal(report.morphing_bytes, 0);
	assert_int_equal(report.skeletal_bytes, 0);
	assert_int_equal(report.joint_count, 0);
	info_release(&report);
	model_destroy(scene.model);
}

/* Positions and normals of the vertices, and what each influence takes. */
static void test_skins_need_palettes_and_skinned_vertices(void **state)
{
	static const int joints[2] = {0, 1};
	static uint16_t joint[VERTICES];
	static float weight[VERTICES];
	mat4 bind[2] = {GLM_MAT4_IDENTITY_INIT, GLM_MAT4_IDENTITY_INIT};
	struct model_skin skin[2];
	struct scene scene;
	struct info_report report;
	size_t bytes[2];

	(void)state;
	for (int v = 0; v < VERTICES; v++) {
		weight[v] = 1.0f;
	}
	for (int i = 0; i < 2; i++) {
		skin[i] = (struct model_skin){.name = "",
			.joint_count = i + 1,
			.joint = (int *)(uintptr_t)joints,
			.inverse_bind = bind};
	}
	begin(&scene, (const int[]){0, 1, 2});
	scene.mesh[0].primitive->influences = 1;
	scene.mesh[0].primitive->joint = joint;
	scene.mesh[0].primitive->weight = weight;
	scene.model->skin = skin;
	scene.model->skin_count = 2;
	for (int count = 1; count <= 2; count++) {
		scene.node[count].skin = count - 1;
		report = measured(&scene);
		assert_int_equal(report.joint_count, 3);
		bytes[count - 1] = report.skeletal_bytes;
		info_release(&report);
	}
	/* The second mesh takes as much as the first, without the palettes. */
	assert_int_equal(2 * bytes[0] - bytes[1], 3 * 64);
	assert_true(bytes[1] - bytes[0] > VERTICES * 2 * 12);
	assert_int_equal(report.morphing_bytes, 0);
	model_destroy(scene.model);
}

/* Returns how far from its line's start the word ends. */
static int end_of(const char *text, const char *word)
{
	const char *at = strstr(text, word), *line = at;

	assert_non_null(at);
	while (line > text && line[-1] != '\n') {
		line--;
	}
	return (int)(at - line) + (int)strlen(word);
}

static void test_columns_of_clips_hold_a_clip_of_a_day(void **state)
{
	struct model_clip clip[] = {{.name = "second", .duration_s = 1},
		{.name = "day", .duration_s = 86400}};
	struct scene scene;
	struct info_report report;
	char *text;
	size_t size;
	FILE *out = open_memstream(&text, &size);

	(void)state;
	assert_non_null(out);
	begin(&scene, (const int[]){0, 1, 2});
	scene.model->clip = clip;
	scene.model->clip_count = 2;
	report = measured(&scene);
	info_print_text(&report, out);
	assert_int_equal(fclose(out), 0);
	assert_int_equal(end_of(text, "seconds"), end_of(text, " 1.00"));
	assert_int_equal(end_of(text, "seconds"), end_of(text, "86400.00"));
	assert_int_equal(end_of(text, "30 Hz"), end_of(text, " 30.0"));
	assert_int_equal(end_of(text, "30 Hz"), end_of(text, "2592000.0"));
	assert_int_equal(end_of(text, "ticks"), end_of(text, " 4800"));
	assert_int_equal(end_of(text, "ticks"), end_of(text, "414720000"));
	assert_int_equal(end_of(text, "second\n"), end_of(text, "day\n") + 3);
	free(text);
	info_release(&report);
	scene.model->clip_count = 0;
	model_destroy(scene.model);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_mesh_has_the_unit_of_its_first_node),
		cmocka_unit_test(test_nodes_alone_need_transforms),
		cmocka_unit_test(test_skins_need_palettes_and_skinned_vertices),
		cmocka_unit_test(test_columns_of_clips_hold_a_clip_of_a_day),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
