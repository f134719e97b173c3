/* The soft driver's vertices: transformed in assembly as in C. */
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
	VERTICES = 64
};

static struct draw *make_draw(void)
{
	struct draw *draw = aligned_alloc(_Alignof(struct draw), sizeof(*draw));

	assert_non_null(draw);
	memset(draw, 0, sizeof(*draw));
	soft_init_scratch(draw);
	draw->view.center_x_q8 = 240 * 256 + 8;
	draw->view.center_y_q8 = 320 * 256 + 8;
	draw->view.width_q10 = 480 * 1024;
	draw->view.height_q10 = -640 * 1024;
	return draw;
}

/* Both ways to the positions: soft_transform_c() reads the array's state. */
static void set_positions(struct draw *draw, struct soft *soft, GLenum type,
	const void *pointer, int stride_bytes)
{
	soft->arrays.vertex = (struct array){.size = 3,
		.type = type,
		.stride_bytes = stride_bytes,
		.pointer = pointer};
	draw->soft = soft;
	draw->view.positions = pointer;
	draw->view.stride_bytes = stride_bytes;
	draw->position_q = 14; /* of shorts */
}

/* Coordinates below 2^28 for positions below 2^30, or 2^15 * 2^16. */
static void make_view(
	struct view *view, enum position_kind kind, bool affine, uint32_t *seed)
{
	int32_t entry = kind == POSITION_SHORTS ? 1 << 26 : 1 << 28;
	int32_t move = (1 << 28) - 3 * (1 << 26);

	view->kind = kind;
	for (int i = 0; i < 3; i++) {
		view->row_x[i] = random_within(seed, entry);
		view->row_y[i] = random_within(seed, entry);
		view->row_z[i] = random_within(seed, entry);
		view->row_w[i] = affine ? 0 : random_within(seed, entry);
	}
	view->moved_x = random_within(seed, move);
	view->moved_y = random_within(seed, move);
	view->moved_z = random_within(seed, move);
	view->moved_w = move + random_within(seed, affine ? 0 : move);
}

/* The planes of the clip volume that the vertex is outside of, by 64 bits. */
static int expected_outcode(const struct vertex *vertex)
{
	int64_t w = vertex->clip[3];
	int out = w <= 0 ? OUT_NEAR : 0;

	for (int i = 0; i < 3; i++) {
		static const int below[] = {OUT_LEFT, OUT_BOTTOM, OUT_NEAR};
		static const int above[] = {OUT_RIGHT, OUT_TOP, OUT_FAR};

		out |= vertex->clip[i] < -w ? below[i] : 0;
		out |= vertex->clip[i] > w ? above[i] : 0;
	}
	return out;
}

static void check_vertex(const struct draw *draw, uint32_t index)
{
	struct vertex vertex = {.shaded = true}, other = {.shaded = true};

	soft_transform(draw, index, &vertex);
	soft_transform_c(draw, index, &other);
	assert_memory_equal(vertex.clip, other.clip, sizeof(vertex.clip));
	assert_int_equal(vertex.outcode, other.outcode);
	assert_int_equal(vertex.outcode, expected_outcode(&vertex));
	assert_int_equal(vertex.index, index);
	assert_int_equal(other.index, index);
	assert_false(vertex.shaded);
	assert_false(other.shaded);
	if (vertex.outcode == 0) {
		assert_int_equal(vertex.x, other.x);
		assert_int_equal(vertex.y, other.y);
		assert_int_equal(vertex.z, other.z);
		assert_int_equal(vertex.w_zeros, other.w_zeros);
		assert_int_equal(vertex.inverse_w_q30, other.inverse_w_q30);
	}
}

/* Where exact arithmetic puts what is inside. */
static void check_place(const struct draw *draw, uint32_t index)
{
	const struct view *view = &draw->view;
	struct vertex v = {.shaded = true};
	double w, x, y;

	soft_transform(draw, index, &v);
	if (v.outcode != 0 || v.clip[3] < 1 << 20) {
		return;
	}
	w = v.clip[3];
	x = (view->center_x_q8 + v.clip[0] / w * view->width_q10 / 8) / 16;
	y = (view->center_y_q8 + v.clip[1] / w * view->height_q10 / 8) / 16;
	assert_true(fabs(v.x + 0.5 - x) < 0.51);
	assert_true(fabs(v.y + 0.5 - y) < 0.51);
	assert_true(fabs(v.z - (131070 + v.clip[2] / w * 131066)) < 2);
}

static void check_vertices(struct draw *draw, uint32_t count)
{
	for (uint32_t i = 0; i < count; i++) {
		check_vertex(draw, i);
		check_place(draw, i);
	}
}

static void check_shorts(bool affine)
{
	struct draw *draw = make_draw();
	struct soft soft;
	int16_t position[VERTICES][4];
	uint32_t seed = 7;

	set_positions(
		draw, &soft, GL_SHORT, &position[0][1], sizeof(position[0]));
	for (int round = 0; round < 300; round++) {
		make_view(&draw->view, POSITION_SHORTS, affine, &seed);
		for (int i = 0; i < 4 * VERTICES; i++) {
			int16_t any = (int16_t)random_within(&seed, 32767);

			position[i / 4][i % 4] = i < 12 ? INT16_MIN
				: i < 24                ? INT16_MAX
				: i < 128               ? any >> 2
							: any;
		}
		check_vertices(draw, VERTICES - 1);
	}
	free(draw);
}

static void test_shorts_are_transformed_as_in_c(void **state)
{
	(void)state;
	check_shorts(false);
}

static void test_flat_projections_are_transformed_as_in_c(void **state)
{
	(void)state;
	check_shorts(true);
}

static void test_floats_are_transformed_as_in_c(void **state)
{
	struct draw *draw = make_draw();
	struct soft soft;
	float position[VERTICES][5];
	uint32_t seed = 11;

	(void)state;
	set_positions(draw, &soft, GL_FLOAT, position, sizeof(position[0]));
	draw->view.scale = 1 << 24;
	for (int round = 0; round < 300; round++) {
		make_view(&draw->view, POSITION_FLOATS, round % 4 == 0, &seed);
		for (int i = 0; i < 5 * VERTICES; i++) {
			int32_t any = random_within(&seed, (1 << 30) - 1);

			position[i / 5][i % 5] = i < 10 ? 0.0f
				: i < 20                ? -63.999996f
				: i < 99 ? (float)(any >> 3) / (1 << 24)
					 : (float)(any >> 7) / (1 << 17);
		}
		check_vertices(draw, VERTICES);
	}
	free(draw);
}

/* All of the volume's planes, and w of 0 and below. */
static void test_outcodes_name_the_planes(void **state)
{
	struct draw *draw = make_draw();
	struct soft soft;
	int16_t position[1][3] = {{0, 0, 0}};
	static const int32_t some[] = {
		-(1 << 27), -1001, -1000, -1, 0, 1, 1000, 1001, 1 << 27};
	struct view *view = &draw->view;

	(void)state;
	view->kind = POSITION_SHORTS;
	set_positions(draw, &soft, GL_SHORT, position, sizeof(position[0]));
	for (int i = 0; i < 9 * 9 * 9 * 9; i++) {
		view->moved_x = some[i % 9];
		view->moved_y = some[i / 9 % 9];
		view->moved_z = some[i / 81 % 9];
		view->moved_w = some[i / 729];
		check_vertex(draw, 0);
	}
	free(draw);
}

static void test_the_largest_float_is_found(void **state)
{
	float position[VERTICES][4];
	const uint8_t *at = (const uint8_t *)position;
	uint32_t seed = 1;

	(void)state;
	for (int round = 0; round < 2000; round++) {
		uint32_t count = (uint32_t)round % VERTICES;
		int stride = round % 3 ? 16 : 12;
		uint32_t found, expected = 0;

		for (int i = 0; i < 4 * VERTICES; i++) {
			position[i / 4][i % 4] =
				(float)random_within(&seed, 1 << (i % 24));
		}
		found = soft_largest_float(at, stride, count, 3);
		for (uint32_t i = 0; i < 3 * count; i++) {
			uint32_t bits;

			memcpy(&bits, at + i / 3 * (size_t)stride + 4 * (i % 3),
				4);
			expected = bits << 1 > expected ? bits << 1 : expected;
		}
		assert_int_equal(found, expected);
		assert_int_equal(soft_largest_aligned_float(at, stride, count),
			expected);
		if (count > 0) {
			size_t last = (size_t)stride * (count - 1) + 8;
			uint32_t bits = 0xC5000000u | (uint32_t)round;

			/* 2048 and more */
			memcpy((uint8_t *)position + last, &bits, 4);
			assert_true(soft_largest_aligned_float(
					    at, stride, count) >= bits << 1);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_shorts_are_transformed_as_in_c),
		cmocka_unit_test(test_flat_projections_are_transformed_as_in_c),
		cmocka_unit_test(test_floats_are_transformed_as_in_c),
		cmocka_unit_test(test_outcodes_name_the_planes),
		cmocka_unit_test(test_the_largest_float_is_found),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
