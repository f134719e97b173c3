/* The skeleton, axes and links of a figure, and the labels beside it. */
#include "app/scene/overlay/overlay_bones.h"

#include "app/anim/math/vec.h"
#include "app/scene/overlay/overlay.h"
#include "app/scene/stage/light.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	SPINDLE = 24 /* vertices of eight triangles */
};

/* Nodes at x = 0, 1, 3, 3.2; the second is no bone, the third is chosen. */
struct figure {
	struct bones bones;
	struct instance instance;
	struct overlay_bones drawn;
	struct overlay_sketch sketch;
};

static const uint8_t is_bone[4] = {1, 0, 1, 1};

static struct figure *begin(GLenum mode)
{
	static struct figure figure;
	struct bones *bones = &figure.bones;

	memset(&figure, 0, sizeof(figure));
	bones_begin(bones);
	bones_add(bones, -1, 0, 0, 0);
	bones_add(bones, 0, 1, 0, 0);
	bones_add(bones, 1, 2, 0, 0);
	bones_add(bones, 2, 0.2f, 0, 0);
	bones_pose(bones);
	figure.instance.model = &bones->model;
	figure.instance.world = bones->world;
	figure.instance.unit_scale = 1.0f;
	figure.drawn = (struct overlay_bones){
		&figure.instance, is_bone, .chosen = 2, .extent = 10.0f};
	figure.sketch.mode = mode;
	return &figure;
}

static void end(struct figure *figure)
{
	bones_end(&figure->bones);
}

static void expect_at(
	const struct overlay_vertex *vertex, float x, float y, float z)
{
	assert_all_near(vertex->position, ((float[]){x, y, z}), 3, 1e-5);
}

static void test_links_run_to_the_nearest_bone_above(void **state)
{
	struct figure *figure = begin(GL_LINES);
	const struct overlay_vertex *vertex = figure->sketch.vertex;

	(void)state;
	overlay_bones_links(&figure->drawn, &figure->sketch);
	assert_int_equal(figure->sketch.count, 4);
	expect_at(&vertex[0], 0, 0, 0);
	expect_at(&vertex[1], 3, 0, 0);
	expect_at(&vertex[2], 3, 0, 0);
	expect_at(&vertex[3], 3.2f, 0, 0);
	for (int i = 0; i < 4; i++) {
		assert_memory_equal(
			vertex[i].color, ((uint8_t[]){255, 255, 255, 200}), 4);
	}
	end(figure);
}

/* The part of a colour that the brightest face has. */
static float brightest(const struct overlay_vertex *vertex, int channel)
{
	int most = 0;

	for (int i = 0; i < SPINDLE; i++) {
		int value = vertex[i].color[channel];

		most = value > most ? value : most;
	}
	return (float)most;
}

/* A spindle along x, from tip to tip, this thick at x = middle. */
static void expect_spindle(const struct overlay_vertex *vertex, float from,
	float to, float middle, float radius, const uint8_t color[3])
{
	float light = brightest(vertex, 0) / (float)color[0];

	assert_true(light > 0.7f && light <= 1.0f);
	for (int i = 0; i < SPINDLE; i++) {
		const float *p = vertex[i].position;
		float aside = sqrtf(p[1] * p[1] + p[2] * p[2]);
		bool is_tip = aside < 1e-6f;

		if (is_tip) {
			assert_near(p[0], i / 3 % 2 ? to : from, 1e-5);
		} else {
			assert_near(p[0], middle, 1e-5);
			assert_near(aside, radius, 1e-5);
		}
		assert_int_equal(is_tip, i % 3 == 0);
		assert_int_equal(vertex[i].color[3], 255);
	}
	for (int k = 1; k < 3; k++) {
		assert_near(brightest(vertex, k), light * (float)color[k], 2.0);
	}
}

/* Each face by 32% of the cosine of its angle with the light around 68%. */
static void expect_shaded(
	const struct overlay_vertex *vertex, const uint8_t color[3])
{
	float light[3];

	light_direction(light);
	for (int v = 0; v < SPINDLE; v++) {
		const struct overlay_vertex *face = vertex + v / 3 * 3;
		float ab[3], ac[3], normal[3], share;

		vec_subtract(face[1].position, face[0].position, ab);
		vec_subtract(face[2].position, face[0].position, ac);
		vec_cross(ab, ac, normal);
		share = 0.68f +
			0.32f * vec_dot(normal, light) / vec_length(normal);
		for (int k = 0; k < 3; k++) {
			assert_near(vertex[v].color[k] + 0.5,
				(double)(share * color[k]), 0.502);
		}
		assert_int_equal(vertex[v].color[3], 255);
	}
}

static void test_the_colours_of_bones_joints_and_axes(void **state)
{
	static const uint8_t plain[3] = {244, 236, 212};
	static const uint8_t chosen[3] = {250, 170, 60};
	static const uint8_t joint[3] = {92, 172, 255};
	static const uint8_t axes[3][3] = {
		{236, 66, 60}, {84, 200, 84}, {74, 128, 255}};
	struct figure *figure = begin(GL_TRIANGLES);
	const struct overlay_vertex *vertex = figure->sketch.vertex;

	(void)state;
	overlay_bones_skeleton(&figure->drawn, &figure->sketch);
	expect_shaded(vertex, joint);
	expect_shaded(vertex + SPINDLE, plain);
	expect_shaded(vertex + 2 * SPINDLE, chosen);
	expect_shaded(vertex + 3 * SPINDLE, chosen);
	expect_shaded(vertex + 4 * SPINDLE, joint);
	figure->sketch.count = 0;
	overlay_bones_axes(&figure->drawn, &figure->sketch);
	for (int i = 0; i < 9; i++) {
		expect_shaded(vertex + i * SPINDLE, axes[i % 3]);
	}
	end(figure);
}

static void test_bones_are_as_thick_as_they_are_long_up_to_a_limit(void **state)
{
	static const uint8_t plain[3] = {244, 236, 212};
	static const uint8_t chosen[3] = {250, 170, 60};
	static const uint8_t joint[3] = {92, 172, 255};
	struct figure *figure = begin(GL_TRIANGLES);
	const struct overlay_vertex *vertex = figure->sketch.vertex;

	(void)state;
	overlay_bones_skeleton(&figure->drawn, &figure->sketch);
	/* An octahedron a bone, and two spindles before theirs. */
	assert_int_equal(figure->sketch.count, 5 * SPINDLE);
	assert_near(vertex[0].position[1], -0.09, 1e-5);
	assert_near(vertex[3].position[1], 0.09, 1e-5);
	assert_near(brightest(vertex, 2) / brightest(vertex, 0),
		(float)joint[2] / (float)joint[0], 0.05);
	/* 13% of its length, but at most 1.7% of the figure. */
	expect_spindle(vertex + SPINDLE, 0, 3, 3 * 0.16f, 0.17f, plain);
	assert_near(brightest(vertex + 2 * SPINDLE, 0) /
			brightest(vertex + 2 * SPINDLE, 2),
		(float)chosen[0] / (float)chosen[2], 0.2);
	expect_spindle(vertex + 3 * SPINDLE, 3, 3.2f, 3 + 0.2f * 0.16f,
		0.2f * 0.13f, chosen);
	assert_near(vertex[4 * SPINDLE].position[0], 3.2, 1e-5);
	end(figure);
}

static void test_axes_have_one_length_and_three_colours(void **state)
{
	static const uint8_t color[3][3] = {
		{236, 66, 60}, {84, 200, 84}, {74, 128, 255}};
	struct figure *figure = begin(GL_TRIANGLES);
	const struct overlay_vertex *vertex = figure->sketch.vertex;

	(void)state;
	/* The last node's x axis is three times as long, and y has none. */
	figure->bones.world[3][0][0] = 3.0f;
	figure->bones.world[3][1][1] = 0.0f;
	overlay_bones_axes(&figure->drawn, &figure->sketch);
	assert_int_equal(figure->sketch.count, (3 + 3 + 2) * SPINDLE);
	expect_spindle(vertex, 0, 0.65f, 0.75f * 0.65f, 0.06f, color[0]);
	for (int axis = 0; axis < 3; axis++) {
		const struct overlay_vertex *arrow = vertex + axis * SPINDLE;

		assert_near(arrow[0].position[axis], 0.0, 1e-5);
		assert_near(arrow[3].position[axis], 0.65, 1e-5);
		for (int k = 0; k < 3; k++) {
			assert_near(brightest(arrow, k) / brightest(arrow, axis),
				(float)color[axis][k] / (float)color[axis][axis],
				0.05);
		}
	}
	vertex += 6 * SPINDLE;
	assert_near(vertex[3].position[0], 3.2 + 0.65, 1e-5);
	assert_near(vertex[SPINDLE + 3].position[2], 0.65, 1e-5);
	end(figure);
}

/* The quads that have been added, and one that a test places. */
static struct hud *hud_with(int height)
{
	static struct hud hud;

	memset(&hud, 0, sizeof(hud));
	hud.font = &font_default;
	hud_begin(&hud, 480, height);
	return &hud;
}

static void expect_frame(const struct hud *hud, int first, int x, int y, int w,
	int h, int line, struct hud_color color)
{
	const int box[4][4] = {{x, y, x + w, y + line},
		{x, y + h - line, x + w, y + h},
		{x, y + line, x + line, y + h - line},
		{x + w - line, y + line, x + w, y + h - line}};

	for (int i = 0; i < 4; i++) {
		const struct hud_vertex *v = &hud->vertex[(first + i) * 4];

		assert_int_equal(v[0].x, box[i][0]);
		assert_int_equal(v[0].y, box[i][1]);
		assert_int_equal(v[3].x, box[i][2]);
		assert_int_equal(v[3].y, box[i][3]);
		assert_memory_equal(&v->color, &color, sizeof(color));
	}
}

/* Five pictures of a base and four targets are a fifth of the width each. */
static void test_source_and_destiny_are_framed_in_the_row(void **state)
{
	static const int heights[2] = {640, 200};
	struct overlay overlay = {.kinds = 1U << OVERLAY_KEYS,
		.chooses_target = true,
		.target_count = 4};
	const struct hud_place place = {HUD_TOP_LEFT, 640};
	struct overlay_motion motion = overlay_motion_none();

	(void)state;
	for (int i = 0; i < 2; i++) {
		int height = heights[i], high = height / 5;
		struct hud *hud = hud_with(height);
		int line = i ? 2 : hud_em(hud) / 6;

		motion.morphing = true;
		motion.from = -1;
		motion.to = 2;
		overlay_reserve_row(&overlay, hud);
		overlay_label(&overlay, &motion, &place, hud);
		expect_frame(hud, 0, 0, height - high, 96, high, line,
			hud_color_blue);
		expect_frame(hud, 4, 3 * 96, height - high, 96, high, line,
			hud_color_amber);
		assert_int_equal(hud->stacked_px[HUD_BOTTOM_LEFT], high);
		assert_int_equal(hud->stacked_px[HUD_BOTTOM_RIGHT], high);
		assert_true(hud->stacked_px[HUD_TOP_LEFT] > 0);
	}
}

static void test_a_row_has_at_most_twelve_pictures(void **state)
{
	struct overlay overlay = {.target_count = 11};
	struct overlay_row row = overlay_row_of(&overlay, 480, 640);

	(void)state;
	assert_int_equal(row.count, 12);
	assert_int_equal(row.width, 40);
	assert_int_equal(row.height, 53);
	overlay.target_count = 12;
	assert_int_equal(overlay_row_of(&overlay, 480, 640).count, 12);
	overlay.target_count = 1;
	row = overlay_row_of(&overlay, 480, 640);
	assert_int_equal(row.count, 2);
	assert_int_equal(row.width, 96);
	assert_int_equal(row.height, 128);
}

/* Neither where nothing morphs nor for a target that has no picture. */
static void test_what_is_not_in_the_row_is_not_framed(void **state)
{
	struct overlay overlay = {.kinds = 1U << OVERLAY_KEYS,
		.chooses_target = true,
		.target_count = 20};
	const struct hud_place place = {HUD_TOP_LEFT, 640};
	struct overlay_motion motion = overlay_motion_none();
	struct hud *hud = hud_with(640);
	int quads[3];

	(void)state;
	for (int i = 0; i < 3; i++) {
		hud_begin(hud, 480, 640);
		motion.morphing = true;
		motion.from = i < 2 ? 11 : 10; /* the 13th picture, the 12th */
		motion.to = i < 1 ? 19 : 0;
		overlay_label(&overlay, &motion, &place, hud);
		quads[i] = hud->quad_count;
	}
	assert_int_equal(quads[1] - quads[0], 4);
	assert_int_equal(quads[2] - quads[1], 4);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_links_run_to_the_nearest_bone_above),
		cmocka_unit_test(
			test_bones_are_as_thick_as_they_are_long_up_to_a_limit),
		cmocka_unit_test(test_axes_have_one_length_and_three_colours),
		cmocka_unit_test(test_source_and_destiny_are_framed_in_the_row),
		cmocka_unit_test(test_a_row_has_at_most_twelve_pictures),
		cmocka_unit_test(test_what_is_not_in_the_row_is_not_framed),
		cmocka_unit_test(test_the_colours_of_bones_joints_and_axes),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
