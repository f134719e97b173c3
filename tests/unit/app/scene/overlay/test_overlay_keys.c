/* Key frames as onion skins, and the row of a morphed model's shapes. */
#include "platform/base/compiler.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/test.h"
#include "tests/unit/app/scene/overlay/overlay_bench.h"

#include <string.h>

enum {
	CALLS_MAX = 64
};

/* What GL was told, and what the ghost's pose was in each picture of a row. */
static struct {
	const struct instance *ghost;
	int viewports, viewport[CALLS_MAX][4];
	double weight[CALLS_MAX][CALLS_MAX];
	int scissor[4];
	bool scissoring;
	int colors;
	double color[CALLS_MAX][4];
	void (*draw)(
		GLenum mode, GLsizei count, GLenum type, const void *indices);
} told;

static void keep_viewport(GLint x, GLint y, GLsizei width, GLsizei height)
{
	const int at[4] = {x, y, width, height};

	assert_in_range(told.viewports, 0, CALLS_MAX - 1);
	memcpy(told.viewport[told.viewports++], at, sizeof(at));
}

static void keep_scissor(GLint x, GLint y, GLsizei width, GLsizei height)
{
	const int at[4] = {x, y, width, height};

	memcpy(told.scissor, at, sizeof(at));
}

static void enable(GLenum capability)
{
	told.scissoring = told.scissoring || capability == GL_SCISSOR_TEST;
}

static void disable(GLenum capability)
{
	told.scissoring = told.scissoring && capability != GL_SCISSOR_TEST;
}

/* Each colour that differs from the one before. */
static void keep_color(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha)
{
	const double color[4] = {red / 65536.0, green / 65536.0, blue / 65536.0,
		alpha / 65536.0};

	if (told.colors == 0 ||
		memcmp(told.color[told.colors - 1], color, sizeof(color)) != 0) {
		assert_in_range(told.colors, 0, CALLS_MAX - 1);
		memcpy(told.color[told.colors++], color, sizeof(color));
	}
}

static void note_pose(
	GLenum mode, GLsizei count, GLenum type, const void *indices)
{
	const struct pose *pose = &told.ghost->pose;

	for (int i = 0; told.viewports > 0 && i < pose->weight_count; i++) {
		told.weight[told.viewports - 1][i] = (double)pose->weight[i];
	}
	told.draw(mode, count, type, indices);
}

static void record(struct overlay_bench *bench)
{
	bench->gl = gl_recorder_begin();
	memset(&told, 0, sizeof(told));
	told.ghost = bench->overlay->ghost.instance;
	told.draw = bench->gl.DrawElements;
	bench->gl.DrawElements = note_pose;
	bench->gl.Viewport = keep_viewport;
	bench->gl.Scissor = keep_scissor;
	bench->gl.Enable = enable;
	bench->gl.Disable = disable;
	bench->gl.Color4x = keep_color;
	bench->overlay->gl = &bench->gl;
}

/* Two on each side, cool before and warm after; the farther ones are clearer. */
static void test_onion_skins_are_tinted_by_their_side(void **state)
{
	static const double expected[4][4] = {{0.30, 0.62, 1.0, 0.36},
		{0.30, 0.62, 1.0, 0.216}, {1.0, 0.66, 0.22, 0.36},
		{1.0, 0.66, 0.22, 0.216}};
	struct overlay_motion motion = overlay_motion_none();
	struct overlay_bench bench;

	(void)state;
	overlay_bench_begin(&bench, "walker", 1u << OVERLAY_KEYS);
	motion.clip = 0;
	for (int i = 0; i < 5; i++) {
		int found = 0;

		motion.time_s = 0.25f * (float)i *
			bench.figure.instance->model->clip[0].duration_s;
		record(&bench);
		overlay_draw_keys(
			bench.overlay, &motion, &bench.figure, 480, 640);
		for (int c = 0; c < told.colors; c++) {
			double worst = 0.0;

			for (int k = 0; found < 4 && k < 4; k++) {
				double off =
					told.color[c][k] - expected[found][k];

				worst += off * off;
			}
			found += found < 4 && worst < 1e-3;
		}
		assert_int_equal(found, 4);
		assert_int_equal(gl_recorder_result()->depth, 0);
	}
	/* Without a clip there are no keys. */
	motion.clip = -1;
	record(&bench);
	overlay_draw_keys(bench.overlay, &motion, &bench.figure, 480, 640);
	assert_int_equal(gl_recorder_result()->draw_count, 0);
	overlay_bench_end(&bench);
}

/* The base, and each target alone at full weight. */
static void test_a_row_shows_the_base_and_each_target(void **state)
{
	const struct overlay_motion motion = overlay_motion_none();
	struct overlay_bench bench;
	struct overlay_row row;
	int targets, last;

	(void)state;
	overlay_bench_begin(&bench, "face", 1u << OVERLAY_KEYS);
	targets = bench.overlay->target_count;
	row = overlay_row_of(bench.overlay, 480, 640);
	assert_int_equal(row.count, targets + 1 < 12 ? targets + 1 : 12);
	assert_in_range(row.width * row.count, 1, 480);
	assert_int_equal(row.height, 640 * row.width / 480);
	for (int among = 0; among < 2; among++) {
		bench.figure.among_others = among;
		record(&bench);
		overlay_draw_keys(
			bench.overlay, &motion, &bench.figure, 480, 640);
		last = told.viewports - 1;
		assert_int_equal(last, row.count);
		for (int i = 0; i < row.count; i++) {
			const int at[4] = {
				i * row.width, 0, row.width, row.height};

			assert_memory_equal(told.viewport[i], at, sizeof(at));
			for (int t = 0; t < targets; t++) {
				assert_near(told.weight[i][t], t == i - 1, 0.0);
			}
		}
		assert_int_equal(told.viewport[last][0], 0);
		assert_int_equal(told.viewport[last][1], 0);
		assert_int_equal(told.viewport[last][2], 480);
		assert_int_equal(told.viewport[last][3], 640);
		assert_int_equal(told.scissor[0], 0);
		assert_int_equal(told.scissor[1], 0);
		assert_int_equal(told.scissor[2], row.width * row.count);
		assert_int_equal(told.scissor[3], row.height);
		assert_false(told.scissoring);
	}
	/* A picture of no pixels is none. */
	record(&bench);
	overlay_draw_keys(bench.overlay, &motion, &bench.figure, 4, 640);
	overlay_draw_keys(bench.overlay, &motion, &bench.figure, 480, 2);
	assert_int_equal(gl_recorder_result()->draw_count, 0);
	overlay_bench_end(&bench);
}

/* From the last target the next one is the first. */
static void test_a_target_is_chosen_by_its_number_and_named(void **state)
{
	struct overlay_bench bench;
	const struct model_mesh *mesh = NULL;
	char number[HUD_NAME_BYTES];

	(void)state;
	overlay_bench_begin(&bench, "face", 0);
	for (int m = 0; m < bench.figure.instance->model->mesh_count; m++) {
		const struct model_mesh *at =
			&bench.figure.instance->model->mesh[m];

		mesh = !mesh && at->target_count > 0 ? at : mesh;
	}
	assert_non_null(mesh);
	assert_int_equal(bench.overlay->target_count, mesh->target_count);
	for (int i = 0; i < 2 * mesh->target_count; i++) {
		int target = i % mesh->target_count;

		assert_int_equal(bench.overlay->chosen, target);
		assert_string_equal(overlay_chosen_name(bench.overlay, number),
			mesh->target_name[target]);
		overlay_choose(bench.overlay, 1);
	}
	overlay_choose(bench.overlay, -1);
	assert_int_equal(bench.overlay->chosen, mesh->target_count - 1);
	overlay_bench_end(&bench);
}

/* Along the lines of sight, so that it stays where it is in the picture. */
static void test_a_place_may_be_nearer_to_the_eye(void **state)
{
	struct overlay_bench bench;
	float extent, distance;
	mat4 view;

	(void)state;
	overlay_bench_begin(&bench, "walker", 0);
	camera_view(bench.overlay->camera, view);
	distance = bench.overlay->camera->distance;
	extent = bench.overlay->subject.extent;
	glm_translate(bench.figure.place, (vec3){0.25f, -0.5f, 1.0f});
	for (int i = -1; i < 2; i++) {
		float nearer = 0.1f * (float)i;
		float scale = i ? 1.0f - nearer * extent / distance : 1.0f;
		mat4 expected;

		record(&bench);
		overlay_push_place(bench.overlay, &bench.figure, nearer);
		bench.gl.DrawArrays(GL_TRIANGLES, 0, 0);
		bench.gl.PopMatrix();
		assert_int_equal(gl_recorder_result()->depth, 0);
		glm_mat4_copy(bench.figure.place, expected);
		if (i) {
			glm_mat4_mul(view, bench.figure.place, expected);
		}
		for (int k = 0; k < 12; k++) {
			int at = k / 3 * 4 + k % 3;

			assert_near(gl_recorder_result()->draw[0].matrix[at],
				scale * expected[k / 3][k % 3], 1e-3);
		}
	}
	overlay_bench_end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_onion_skins_are_tinted_by_their_side),
		cmocka_unit_test(test_a_row_shows_the_base_and_each_target),
		cmocka_unit_test(test_a_target_is_chosen_by_its_number_and_named),
		cmocka_unit_test(test_a_place_may_be_nearer_to_the_eye),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
