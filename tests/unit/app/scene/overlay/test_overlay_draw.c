/* How graphs of curves, the wireframe and bones reach the hud and GL. */
#include "app/anim/math/vec.h"
#include "app/scene/overlay/overlay_curve.h"
#include "platform/base/compiler.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/gl/gl_state.h"
#include "tests/support/test.h"
#include "tests/unit/app/scene/overlay/overlay_bench.h"

#include <math.h>
#include <string.h>

static struct hud hud;

/* Shows a curve in a group; the quads of the graph are from 0 on. */
static struct hud_group show_curve(const struct overlay_curve *curve)
{
	struct gl gl = gl_recorder_begin();
	struct log log = log_to_stderr(LOG_WARNING);
	struct hud_group group;

	assert_int_equal(hud_init(&hud, &gl, &log), 0);
	hud_begin(&hud, 480, 640);
	group = hud_group_begin(&hud, HUD_TOP_LEFT, NULL);
	hud.quad_count = 0;
	overlay_curve_show(curve, &group);
	hud_finish(&hud, &gl);
	return group;
}

/* Left, top, right and bottom of a quad. */
static void corners_of(int quad, int out[4])
{
	const struct hud_vertex *a = &hud.vertex[4 * quad], *b = a + 3;

	assert_in_range(quad, 0, hud.quad_count - 1);
	out[0] = a->x < b->x ? a->x : b->x;
	out[1] = a->y < b->y ? a->y : b->y;
	out[2] = a->x < b->x ? b->x : a->x;
	out[3] = a->y < b->y ? b->y : a->y;
}

/* The row of a value between those that are at the top and at the bottom. */
static int row_of(
	const int field[4], int dot, float high, float low, float value)
{
	int height = field[3] - field[1] - dot;

	return field[1] + dot / 2 +
		(int)((high - value) / (high - low) * (float)(height - 1) + 0.5f);
}

/* Columns side by side, each from one point's row to the next one's. */
static void expect_steps(int first_quad, const int field[4], int dot,
	const float *value, float high, float low)
{
	int right = field[0], at[4];

	for (int i = 0; i + 1 < OVERLAY_CURVE_POINTS; i++) {
		int from = row_of(field, dot, high, low, value[i]);
		int to = row_of(field, dot, high, low, value[i + 1]);

		corners_of(first_quad + i, at);
		assert_int_equal(at[0], right);
		assert_int_equal(at[1], (from < to ? from : to) - 1);
		assert_int_equal(at[3], (from < to ? to : from) + 1);
		right = at[2];
		assert_in_range(right - at[0],
			(field[2] - field[0]) / (OVERLAY_CURVE_POINTS - 1),
			(field[2] - field[0]) / (OVERLAY_CURVE_POINTS - 1) + 1);
	}
	assert_int_equal(right, field[2]);
}

static void fill(struct overlay_curve *curve, float at)
{
	*curve = (struct overlay_curve){.count = 2, .at = at};
	for (int i = 0; i < OVERLAY_CURVE_POINTS; i++) {
		float part = (float)i / (OVERLAY_CURVE_POINTS - 1);

		curve->value[0][i] = 2.0f * part;
		curve->value[1][i] = -part * part;
	}
}

static void test_a_graph_spans_its_group_and_its_values(void **state)
{
	struct overlay_curve curve;
	struct hud_group group;
	int field[4], em, dot;

	(void)state;
	fill(&curve, 0.25f);
	group = show_curve(&curve);
	em = hud_em(&hud);
	dot = em / 2 < 4 ? 4 : em / 2;
	corners_of(0, field);
	assert_int_equal(field[0], group.left);
	assert_int_equal(field[2] - field[0], group.width);
	assert_int_equal(field[3] - field[1], em * OVERLAY_CURVE_EMS);
	/* The first curve is drawn last, over the others. */
	expect_steps(2, field, dot, curve.value[1], 2.0f, -1.0f);
	expect_steps(2 + OVERLAY_CURVE_POINTS - 1, field, dot, curve.value[0],
		2.0f, -1.0f);
}

/* The smallest rectangle around the quads first to end - 1. */
static void around(int first, int end, int out[4])
{
	corners_of(first, out);
	for (int i = first + 1; i < end; i++) {
		int at[4];

		corners_of(i, at);
		out[0] = at[0] < out[0] ? at[0] : out[0];
		out[1] = at[1] < out[1] ? at[1] : out[1];
		out[2] = at[2] > out[2] ? at[2] : out[2];
		out[3] = at[3] > out[3] ? at[3] : out[3];
	}
}

/* A line, and a dot on each curve, which is of the curve's colour but the first. */
static void test_the_present_moment_is_marked_on_each_curve(void **state)
{
	static const float moments[] = {
		0.0f, 0.26f, 0.5f, 0.99f, 1.0f, 7.0f, -1.0f};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(moments); i++) {
		float at = fminf(fmaxf(moments[i], 0.0f), 1.0f);
		struct overlay_curve curve;
		int field[4], line[4], dot, first, each;

		fill(&curve, moments[i]);
		(void)show_curve(&curve);
		dot = hud_em(&hud) / 2 < 4 ? 4 : hud_em(&hud) / 2;
		corners_of(0, field);
		corners_of(1, line);
		assert_int_equal(line[0],
			field[0] + (int)(at * (float)(field[2] - field[0] - 1)));
		assert_int_equal(line[2] - line[0], 1);
		assert_int_equal(line[1], field[1]);
		assert_int_equal(line[3], field[3]);
		first = 2 + 2 * (OVERLAY_CURVE_POINTS - 1);
		each = (hud.quad_count - first) / 2;
		for (int c = 0; c < 2; c++) {
			float value = c == 0 ? 2.0f * at : -at * at;
			int box[4];

			around(first + c * each, first + (c + 1) * each, box);
			assert_int_equal(box[0], line[0] - dot / 2);
			assert_int_equal(box[2] - box[0], dot);
			assert_int_equal(box[3] - box[1], dot);
			assert_in_range(box[1] -
					row_of(field, dot, 2.0f, -1.0f, value) +
					dot / 2 + 1,
				0, 2);
		}
		assert_memory_equal(&hud.vertex[4 * first].color,
			&hud_color_text, sizeof(hud_color_text));
		assert_memory_equal(&hud.vertex[4 * (first + each)].color,
			&hud_color_green, sizeof(hud_color_green));
	}
}

/* Its only row is the upper one, because a graph begins at 0. */
static void test_a_constant_has_a_graph(void **state)
{
	struct overlay_curve curve = {.count = 1, .at = 0.5f};
	int field[4], at[4];

	(void)state;
	(void)show_curve(&curve);
	corners_of(0, field);
	corners_of(2, at);
	assert_int_equal(at[3] - at[1], 2);
	assert_in_range(at[1], field[1], field[3] - 1);
}

/* What GL was told that gl_state does not follow. */
static struct {
	double line_width, widest;
	GLenum depth_function;
	int clears;
} told;

static void keep_width(GLfixed width)
{
	told.line_width = width / 65536.0;
	told.widest = fmax(told.widest, told.line_width);
}

static void keep_depth(GLenum function)
{
	told.depth_function = function;
}

static void keep_clear(GLbitfield mask)
{
	assert_int_equal(mask, GL_DEPTH_BUFFER_BIT);
	assert_true(gl_state_has(NULL, GL_STATE_DEPTH_WRITES));
	told.clears++;
}

static void record(struct overlay_bench *bench, bool enabled)
{
	bench->gl = gl_state_begin(enabled);
	memset(&told, 0, sizeof(told));
	bench->gl.LineWidthx = keep_width;
	bench->gl.DepthFunc = keep_depth;
	bench->gl.Clear = keep_clear;
	bench->overlay->gl = &bench->gl;
}

static const GLenum sketch_on[] = {GL_BLEND, GL_VERTEX_ARRAY, GL_COLOR_ARRAY, 0};
static const GLenum plain_off[] = {GL_LIGHTING, GL_TEXTURE_2D, GL_ALPHA_TEST,
	GL_CULL_FACE, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, 0};

static void test_a_wireframe_is_blended_over_its_surface(void **state)
{
	static const GLenum edges_off[] = {
		GL_LIGHTING, GL_TEXTURE_2D, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, 0};
	struct overlay_bench bench;

	(void)state;
	overlay_bench_begin(&bench, "walker", 1u << OVERLAY_WIREFRAME);
	for (int i = 0; i < 4; i++) {
		const struct gl_state_draw *draw;
		int height = i < 2 ? 500 : 1300;

		record(&bench, i % 2);
		overlay_draw_surface(bench.overlay, &bench.figure, height);
		draw = gl_state_last();
		gl_state_expect_off(draw, edges_off);
		assert_int_equal(draw->mode, GL_LINES);
		assert_true(gl_state_has(draw, GL_BLEND));
		assert_false(gl_state_has(draw, GL_STATE_DEPTH_WRITES));
		assert_near(draw->color[3], 0.5, 1e-4);
		assert_near(told.widest, i < 2 ? 1.0 : 2.0, 0.0);
		assert_near(told.line_width, 1.0, 0.0);
		assert_int_equal(told.depth_function, GL_LESS);
		assert_true(gl_state_has(NULL, GL_STATE_DEPTH_WRITES));
		assert_false(gl_state_has(NULL, GL_BLEND));
		assert_int_equal(gl_recorder_result()->depth, 0);
	}
	bench.overlay->kinds = 0;
	record(&bench, false);
	overlay_draw_surface(bench.overlay, &bench.figure, 640);
	assert_int_equal(gl_recorder_result()->draw_count, 0);
	overlay_bench_end(&bench);
}

/* All vertices of a kind of primitive. */
static long drawn(GLenum mode, int draws)
{
	long count = 0;

	for (int i = 0; i < draws; i++) {
		const struct gl_state_draw *draw = gl_state_drawn(i);

		gl_state_expect_on(draw, sketch_on);
		gl_state_expect_off(draw, plain_off);
		count += draw->mode == mode ? draw->count : 0;
	}
	return count;
}

static void test_bones_and_pivots_are_drawn_for_each_joint(void **state)
{
	struct overlay_bench bench;
	const struct model *model;
	long bones = 0, links = 0;

	(void)state;
	overlay_bench_begin(&bench, "walker", 1u << OVERLAY_SKELETON);
	model = bench.figure.instance->model;
	for (int i = 0; i < model->node_count; i++) {
		int parent = model->node[i].parent;

		while (parent >= 0 && !bench.overlay->is_bone[parent]) {
			parent = model->node[parent].parent;
		}
		bones += bench.overlay->is_bone[i];
		links += bench.overlay->is_bone[i] && parent >= 0;
	}
	for (int before = 0; before < 2; before++) {
		record(&bench, before);
		overlay_draw_bones(bench.overlay, &bench.figure, 640);
		assert_int_equal(
			drawn(GL_TRIANGLES, gl_recorder_result()->draw_count),
			24 * (bones + links));
		assert_false(gl_state_has(NULL, GL_BLEND));
		bench.overlay->kinds = 1u << OVERLAY_PIVOTS;
		record(&bench, before);
		overlay_draw_bones(bench.overlay, &bench.figure, 1300);
		assert_int_equal(
			drawn(GL_LINES, gl_recorder_result()->draw_count),
			2 * links);
		assert_int_equal(
			drawn(GL_TRIANGLES, gl_recorder_result()->draw_count),
			24 * 3 * bones);
		assert_near(told.widest, 2.0, 0.0);
		assert_near(told.line_width, 1.0, 0.0);
		assert_int_equal(gl_recorder_result()->depth, 0);
		bench.overlay->kinds = 1u << OVERLAY_SKELETON;
	}
	/* Not for a figure whose matrices are not those of this frame. */
	bench.figure.unposed_nodes = true;
	record(&bench, false);
	overlay_draw_bones(bench.overlay, &bench.figure, 640);
	assert_int_equal(gl_recorder_result()->draw_count, 0);
	overlay_bench_end(&bench);
}

static void test_depths_are_cleared_where_bones_follow(void **state)
{
	struct overlay_bench bench;

	(void)state;
	overlay_bench_begin(&bench, "walker", 0);
	for (int kind = 0; kind < OVERLAY_KINDS; kind++) {
		bench.overlay->kinds = 1u << kind;
		record(&bench, false);
		overlay_clear_depth(bench.overlay);
		assert_int_equal(told.clears,
			kind == OVERLAY_SKELETON || kind == OVERLAY_PIVOTS);
	}
	overlay_bench_end(&bench);
}

/* The colours of all vertices, summed up. */
static uint64_t heat_of(const struct overlay *overlay)
{
	const struct instance *instance = overlay->subject.instance;
	uint64_t hash = 0;
	int at = 0;

	for (int d = 0; d < instance->drawable_count; d++) {
		const struct drawable *drawable = &instance->drawable[d];

		for (int b = 0; b < drawable->batch_count; b++, at++) {
			for (int i = 0; i < drawable->batch[b].vertex_count;
				i++) {
				hash = hash * 31 + overlay->heat.color[at][i][0];
			}
		}
	}
	return hash;
}

static uint64_t painted(struct overlay_bench *bench, enum overlay_kind kind,
	const struct overlay_motion *motion)
{
	bench->overlay->kinds = 1u << kind;
	overlay_begin(bench->overlay, motion, bench->overlay->camera);
	assert_true(bench->overlay->painting);
	overlay_end(bench->overlay);
	assert_false(bench->overlay->painting);
	return heat_of(bench->overlay);
}

/* Each is painted anew after the other. */
static void test_heat_follows_the_choice_and_the_first_mask(void **state)
{
	struct overlay_motion motion = overlay_motion_none();
	struct overlay_bench bench;
	float mask[64] = {0.0f};
	uint64_t first, next, masked;

	(void)state;
	overlay_bench_begin(&bench, "walker", 0);
	mask[model_find_node(bench.figure.instance->model, "forearm.L")] = 1.0f;
	motion.layer_count = 2;
	motion.layer[1].mask = mask;
	first = painted(&bench, OVERLAY_WEIGHTS, &motion);
	masked = painted(&bench, OVERLAY_LAYERS, &motion);
	assert_true(masked != first);
	assert_true(painted(&bench, OVERLAY_WEIGHTS, &motion) == first);
	overlay_choose(bench.overlay, 1);
	next = painted(&bench, OVERLAY_WEIGHTS, &motion);
	assert_true(next != first);
	overlay_choose(bench.overlay, -1);
	assert_true(painted(&bench, OVERLAY_WEIGHTS, &motion) == first);
	assert_true(painted(&bench, OVERLAY_LAYERS, &motion) == masked);
	/* Without a mask, and for other overlays, nothing is painted. */
	motion.layer_count = 1;
	overlay_begin(bench.overlay, &motion, bench.overlay->camera);
	assert_false(bench.overlay->painting);
	overlay_bench_end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_graph_spans_its_group_and_its_values),
		cmocka_unit_test(test_the_present_moment_is_marked_on_each_curve),
		cmocka_unit_test(test_a_constant_has_a_graph),
		cmocka_unit_test(test_a_wireframe_is_blended_over_its_surface),
		cmocka_unit_test(test_bones_and_pivots_are_drawn_for_each_joint),
		cmocka_unit_test(test_depths_are_cleared_where_bones_follow),
		cmocka_unit_test(test_heat_follows_the_choice_and_the_first_mask),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
