/* AN4044's loops on a few numbers that were computed by hand. */
#include "app/anim/kernel/an4044.h"
#include "app/anim/kernel/kernel.h"
#include "tests/support/model/scattered.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	VERTICES = 150, /* two blocks and a part of one */
	WIDTH = 3,
	JOINTS = 300
};

/* Two vertices: one of joints 1 and 0, one of joint 2. */
static const struct an4044_joint_mat joint[3] = {
	{{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}},
	{{2, 0, 1, -1, 0, 3, 0, 2, 1, 1, 1, 1}},
	{{0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 10}},
};
static const struct joint_weight influence[3] = {
	{0.5f, sizeof(joint[0]), 2 * sizeof(influence[0])},
	{0.5f, 0, sizeof(influence[0])},
	{1, 2 * sizeof(joint[0]), sizeof(influence[0])},
};
static const float base[3][4] = {
	{1, 2, 3, 0.5f}, {2, 0, -1, 0.5f}, {4, 5, 6, 1}};
static const float normal[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
static const float tangent[3][4] = {{0, 1, 0, 0}, {0, 0, 2, 0}, {0, 1, 0, 0}};

static void assert_vector(
	const struct an4044_vec4 *got, float x, float y, float z)
{
	assert_near(got->x, x, 0);
	assert_near(got->y, y, 0);
	assert_near(got->z, z, 0);
}

static void assert_positions(const struct an4044_vertex *vertex)
{
	assert_vector(&vertex[0].position, 5.5f, 14, 19.5f);
	assert_vector(&vertex[1].position, 6, 4, 15);
	assert_vector(&vertex[2].position, 0, 0, 0);
}

static void test_each_attribute_is_a_sum_of_influences(void **state)
{
	static const struct an4044_vec4 none;

	(void)state;
	for (int attributes = 1; attributes <= 3; attributes++) {
		struct an4044_vertex vertex[3];

		memset(vertex, 0, sizeof(vertex));
		if (attributes == 1) {
			an4044_transform(vertex, 2, joint, base, influence);
		} else if (attributes == 2) {
			an4044_transform_normals(
				vertex, 2, joint, base, normal, influence);
		} else {
			an4044_transform_tangents(vertex, 2, joint, base,
				normal, tangent, influence);
		}
		assert_positions(vertex);
		if (attributes > 1) {
			assert_vector(&vertex[0].normal, 4, 6, 11);
			assert_vector(&vertex[1].normal, 1, 0, 0);
		} else {
			assert_memory_equal(
				&vertex[1].normal, &none, sizeof(none));
		}
		if (attributes > 2) {
			assert_vector(&vertex[0].tangent, 6, 17, 23);
			assert_vector(&vertex[1].tangent, 0, 0, 1);
		} else {
			assert_memory_equal(
				&vertex[1].tangent, &none, sizeof(none));
		}
	}
}

static void test_a_frame_adds_its_part_of_the_way(void **state)
{
	static const float source[3][3] = {{1, 2, 3}, {0, 0, 0}, {9, 9, 9}};
	static const float destiny[3][3] = {{3, 6, -1}, {4, 8, 16}, {1, 1, 1}};
	static const float want[3][3] = {
		{10.5f, 11, 9}, {21, 22, 24}, {30, 30, 30}};
	static const float height[3] = {1, -2, 0.5f};
	static const float raised[3][3] = {
		{11.5f, 9, 9.5f}, {22, 20, 24.5f}, {30, 30, 30}};
	float temporal[3][3] = {{10, 10, 10}, {20, 20, 20}, {30, 30, 30}};

	(void)state;
	an4044_by_frames(2, source, destiny, 4, temporal);
	assert_all_near(temporal, want, 9, 0);
	an4044_add(2, height, temporal);
	assert_all_near(temporal, raised, 9, 0);
}

static void test_a_mix_of_two_is_summed(void **state)
{
	static const float a[2][3] = {{1, 2, 4}, {5, 5, 5}};
	static const float b[2][3] = {{3, -2, 8}, {5, 5, 5}};
	static const float c[2][3] = {{10, 20, 30}, {5, 5, 5}};
	static const float way[2][3] = {{1.5f, 1, 5}, {7, 7, 7}};
	static const float sum[2][3] = {{7.5f, 11, 23}, {7, 7, 7}};
	static const float difference[2][3] = {{3.5f, 27, 14}, {7, 7, 7}};
	float out[2][3] = {{0}, {7, 7, 7}};

	(void)state;
	an4044_over_time(1, a, b, 0.25f, out);
	assert_all_near(out, way, 6, 0);
	an4044_two_targets(1, a, b, 0.5f, c, 0.5f, out);
	assert_all_near(out, sum, 6, 0);
	an4044_two_targets(1, a, b, -2.5f, c, 1, out);
	assert_all_near(out, difference, 6, 0);
}

struct fixture {
	float position[VERTICES][3], normal[VERTICES][3];
	uint16_t joint[VERTICES][WIDTH];
	float weight[VERTICES][WIDTH];
	mat4 palette[JOINTS];
	float want[2][VERTICES][3], got[2][VERTICES + 1][3];
};

/* last is the vertex of the last joint. */
static void skin_joints(struct fixture *f, int joints, int last, int cap)
{
	const struct kernel *kernel = kernel_find("an4044");
	struct model_primitive primitive = {.vertex_count = VERTICES,
		.position = f->position,
		.normal = f->normal,
		.influences = WIDTH,
		.joint = f->joint[0],
		.weight = f->weight[0]};
	struct arena arena = arena_empty();
	struct skin_stream stream;

	assert_non_null(kernel);
	for (int v = 0; v < VERTICES; v++) {
		scattered_point(v, f->position[v], f->normal[v]);
		scattered_influences(
			v, v % WIDTH + 1, joints, f->joint[v], f->weight[v]);
	}
	f->joint[last][0] = (uint16_t)(joints - 1);
	for (int i = 0; i < JOINTS * 16; i++) {
		f->palette[i / 16][i / 4 % 4][i % 4] = scattered(i);
	}
	assert_int_equal(skin_stream_init(&stream, &primitive, 1, &arena), 0);
	for (int normals = 0; normals < 2; normals++) {
		memset(f->got, 0, sizeof(f->got));
		kernel_float.skin(&stream, (const mat4 *)f->palette, cap,
			f->want[0], normals ? f->want[1] : NULL);
		kernel->skin(&stream, (const mat4 *)f->palette, cap, f->got[0],
			normals ? f->got[1] : NULL);
		assert_all_near(f->got[0], f->want[0], VERTICES * 3, 4e-6);
		assert_near(f->got[0][VERTICES][0], 0, 0);
		if (normals) {
			assert_all_near(
				f->got[1], f->want[1], VERTICES * 3, 1e-4);
		}
	}
	arena_release(&arena);
}

/* 256 matrices are copied at most; more are skinned in another way. */
static void test_any_number_of_joints_is_skinned(void **state)
{
	static const int joints[] = {1, 2, 255, 256, 257, JOINTS};
	static struct fixture f;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(joints); i++) {
		skin_joints(&f, joints[i], 0, 0);
		skin_joints(&f, joints[i], VERTICES - 1, 0);
		skin_joints(&f, joints[i], 5, 1);
		skin_joints(&f, joints[i], 5, 2);
	}
}

static void test_an_offset_of_any_axis_is_added(void **state)
{
	static const float from[1][3] = {{1, 2, 3}}, to[1][3] = {{5, 4, 11}};
	static const float way[3] = {2, 2.5f, 5};
	const struct kernel *kernel = kernel_find("an4044");

	(void)state;
	for (int i = 0; i < 8; i++) {
		const float offset[3] = {
			(float)(i & 1), (float)(i >> 1 & 1), (float)(i >> 2)};
		float out[1][3];

		kernel->morph_lerp(1, from, to, 0.25f, offset, out);
		for (int k = 0; k < 3; k++) {
			assert_near(out[0][k], way[k] + offset[k], 0);
		}
	}
}

/* Of the wanted attribute alone, one after the other, also in place. */
static void test_targets_are_taken_in_pairs(void **state)
{
	static const float from[2][3] = {{1, 2, 3}, {4, 5, 6}};
	static const float a[2][3] = {{1, 0, 2}, {0, 4, 0}};
	static const float b[2][3] = {{8, 0, 0}, {0, 0, 8}};
	static const float c[2][3] = {{0, 16, 0}, {16, 0, 0}};
	static const struct morph_term term[] = {{1, a, b, NULL},
		{7, NULL, NULL, NULL}, {0, c, c, NULL}, {0.5f, b, NULL, NULL},
		{0.25f, c, a, NULL}, {-1, a, c, NULL}};
	static const float want[][2][3] = {
		{{1, 2, 3}, {4, 5, 6}},
		{{2, 2, 5}, {4, 9, 6}},
		{{6, 2, 5}, {4, 9, 10}},
		{{6, 6, 5}, {8, 9, 10}},
		{{5, 6, 3}, {8, 5, 10}},
	};
	static const int terms[] = {0, 3, 4, 5, 6};
	static const float normals[2][3] = {{9.25f, -14, 3.5f}, {-12, 6, 14}};
	const struct kernel *kernel = kernel_find("an4044");
	float out[2][3];

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(terms); i++) {
		kernel->morph_targets(2, from, term, terms[i], false, out);
		assert_all_near(out, want[i], 6, 0);
	}
	memcpy(out, from, sizeof(out));
	kernel->morph_targets(2, (const float(*)[3])out, term, 6, true, out);
	assert_all_near(out, normals, 6, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_attribute_is_a_sum_of_influences),
		cmocka_unit_test(test_a_frame_adds_its_part_of_the_way),
		cmocka_unit_test(test_a_mix_of_two_is_summed),
		cmocka_unit_test(test_any_number_of_joints_is_skinned),
		cmocka_unit_test(test_an_offset_of_any_axis_is_added),
		cmocka_unit_test(test_targets_are_taken_in_pairs),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
