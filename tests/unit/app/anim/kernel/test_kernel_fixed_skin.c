/*
 * The fixed-point layout of skinned primitives, and their palettes.
 */
#include "app/anim/kernel/kernel.h"
#include "app/anim/kernel/layout/fixed_skin.h"
#include "app/anim/kernel/run/fixed_palette.h"
#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/transform.h"
#include "app/anim/math/vec.h"
#include "tests/support/model/scattered.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <string.h>

enum {
	VERTICES = 200,
	WIDTH = 8,
	JOINTS = 7
};

struct fixture {
	float position[VERTICES][3];
	float normal[VERTICES][3];
	float tangent[VERTICES][4];
	uint16_t joint[VERTICES][WIDTH];
	float weight[VERTICES][WIDTH];
	mat4 palette[JOINTS];
	struct model_primitive primitive;
	struct arena arena;
	struct skin_stream stream;
	struct fixed_skin skin;
	struct fixed_matrix matrix[JOINTS];
	struct fixed_placement placement;
	struct fixed_vector out[VERTICES];
	float want[VERTICES][3], want_normal[VERTICES][3];
};

static void make_vertex(struct fixture *f, int v)
{
	scattered_point(v, f->position[v], f->normal[v]);
	memcpy(f->tangent[v], f->normal[v], sizeof(f->normal[v]));
	f->tangent[v][3] = 1;
	scattered_influences(
		v, v % WIDTH + 1, JOINTS, f->joint[v], f->weight[v]);
}

static void make_palette(struct fixture *f, float scale, float distance)
{
	for (int j = 0; j < JOINTS; j++) {
		struct transform t = transform_identity();

		for (int k = 0; k < 3; k++) {
			t.translation[k] = distance * scattered(j * 9 + k);
			t.rotation[k] = 0.5f * scattered(j * 9 + 3 + k);
			t.scale[k] = scale;
		}
		quat_normalize(t.rotation);
		transform_to_matrix(&t, f->palette[j]);
	}
}

static void set_up(struct fixture *f)
{
	memset(f, 0, sizeof(*f));
	make_palette(f, 1, 0.3f);
	for (int v = 0; v < VERTICES; v++) {
		make_vertex(f, v);
	}
	f->primitive = (struct model_primitive){.vertex_count = VERTICES,
		.position = f->position,
		.normal = f->normal,
		.tangent = f->tangent,
		.influences = WIDTH,
		.joint = f->joint[0],
		.weight = f->weight[0]};
	assert_int_equal(
		skin_stream_init(&f->stream, &f->primitive, 1, &f->arena), 0);
	assert_int_equal(fixed_skin_init(&f->skin, &f->primitive,
				 FIXED_NORMALS | FIXED_TANGENTS, &f->arena),
		0);
}

static void tear_down(struct fixture *f)
{
	arena_release(&f->arena);
}

/* The Q flag of the status register: a product or sum overflowed. */
static void clear_overflow(void)
{
#ifdef __arm__
	__asm__ volatile("msr APSR_nzcvq, %0" ::"r"(0) : "cc");
#endif
}

static bool has_overflowed(void)
{
	uint32_t status = 0;

#ifdef __arm__
	__asm__ volatile("mrs %0, APSR" : "=r"(status));
#endif
	return status >> 27 & 1;
}

/* Compares every kernel's positions with those in float. */
static void compare_positions(struct fixture *f, int cap, double tolerance)
{
	assert_int_equal(fixed_palette_make(&f->skin, (const mat4 *)f->palette,
				 f->matrix, &f->placement),
		0);
	kernel_float.skin(&f->stream, (const mat4 *)f->palette, cap, f->want,
		f->want_normal);
	for (int k = 0; kernel_registry[k]; k++) {
		const struct fixed_loops *loops = kernel_registry[k]->fixed;

		if (!loops) {
			continue;
		}
		clear_overflow();
		loops->skin(f->skin.group, f->skin.group_count,
			f->skin.base[FIXED_POSITION], f->matrix, f->out);
		assert_false(has_overflowed());
		for (int i = 0; i < VERTICES; i++) {
			const int16_t *got = &f->out[i].x;

			for (int axis = 0; axis < 3; axis++) {
				assert_near(got[axis] * f->placement.scale +
						f->placement.offset[axis],
					f->want[f->skin.order[i]][axis],
					tolerance);
			}
		}
	}
}

static void test_positions_are_floats_at_every_cap(void **state)
{
	static struct fixture f;

	(void)state;
	set_up(&f);
	for (int cap = WIDTH + 1; cap >= 0; cap--) {
		fixed_skin_set_cap(&f.skin, cap);
		compare_positions(&f, cap, 4e-4);
	}
	tear_down(&f);
}

static void test_each_vertex_comes_out_once(void **state)
{
	static struct fixture f;
	bool seen[VERTICES] = {false};

	(void)state;
	set_up(&f);
	for (int i = 0; i < VERTICES; i++) {
		uint32_t v = f.skin.order[i];

		assert_true(v < VERTICES);
		assert_false(seen[v]);
		seen[v] = true;
		assert_int_equal(f.skin.inverse_order[v], i);
	}
	tear_down(&f);
}

static void assert_groups(const struct fixed_skin *skin, int cap)
{
	int vertices = 0, influences = 0;

	for (int g = 0; g < skin->group_count; g++) {
		const struct fixed_group *group = &skin->group[g];
		const int32_t *run = group->run;

		assert_in_range(group->influences, 1, cap ? cap : WIDTH);
		assert_true(g == 0 ||
			group->influences > skin->group[g - 1].influences);
		for (int r = 0; r < group->run_count; r++) {
			assert_true(*run > 0);
			vertices += *run;
			influences += *run * group->influences;
			run += 1 + group->influences;
		}
	}
	assert_int_equal(vertices, VERTICES);
	assert_int_equal(influences, skin->influence_count);
}

static void test_groups_hold_all_vertices_at_every_cap(void **state)
{
	static struct fixture f;

	(void)state;
	set_up(&f);
	for (int cap = 0; cap < WIDTH; cap++) {
		fixed_skin_set_cap(&f.skin, cap);
		assert_groups(&f.skin, cap);
	}
	tear_down(&f);
}

static void test_weights_sum_to_one_exactly(void **state)
{
	static struct fixture f;

	(void)state;
	set_up(&f);
	for (int cap = 0; cap < WIDTH; cap++) {
		const struct fixed_base *base = f.skin.base[FIXED_POSITION];

		fixed_skin_set_cap(&f.skin, cap);
		for (int g = 0; g < f.skin.group_count; g++) {
			int k = f.skin.group[g].influences;
			const int32_t *run = f.skin.group[g].run;

			for (int r = 0; r < f.skin.group[g].run_count; r++) {
				for (int i = 0; i < run[0]; i++, base += k) {
					int sum = 0;

					for (int j = 0; j < k; j++) {
						assert_true(base[j].w < 0);
						sum -= base[j].w / 2;
					}
					assert_int_equal(sum, 16384);
				}
				run += 1 + k;
			}
		}
	}
	tear_down(&f);
}

/* Skins the normals by the best kernel and compares them with want_normal. */
static void compare_normals(struct fixture *f)
{
	kernel_registry[0]->fixed->skin(f->skin.group, f->skin.group_count,
		f->skin.base[FIXED_NORMAL], f->matrix, f->out);
	for (int i = 0; i < VERTICES; i++) {
		float v[3] = {f->out[i].x, f->out[i].y, f->out[i].z};
		double length = vec_length(v);

		for (int axis = 0; axis < 3; axis++) {
			/* Normalising a short sum magnifies its error. */
			assert_near(v[axis] / length,
				f->want_normal[f->skin.order[i]][axis],
				1e-3 + 5 / length);
		}
	}
}

static void test_directions_are_floats(void **state)
{
	static struct fixture f;

	(void)state;
	set_up(&f);
	compare_positions(&f, 0, 4e-4);
	compare_normals(&f);
	/* The fixture has the same tangents as normals. */
	assert_memory_equal(f.skin.base[FIXED_NORMAL],
		f.skin.base[FIXED_TANGENT],
		(size_t)f.skin.influence_count *
			sizeof(*f.skin.base[FIXED_NORMAL]));
	for (int i = 0; i < f.skin.influence_count; i++) {
		assert_int_equal(f.skin.base[FIXED_NORMAL][i].w, 0);
	}
	tear_down(&f);
}

static void test_normals_may_have_their_own_matrices(void **state)
{
	static struct fixture f;

	(void)state;
	set_up(&f);
	for (int i = -12; i <= 12; i += 3) {
		make_palette(&f, ldexpf(1.3f, i), 0);
		for (int j = 0; j < JOINTS; j++) {
			for (int k = 0; k < 9; k++) {
				f.palette[j][k / 3][k % 3] *=
					(float)(1 + (j + k % 3) % 3);
			}
		}
		assert_int_equal(
			fixed_palette_make(&f.skin, (const mat4 *)f.palette,
				f.matrix, &f.placement),
			0);
		for (int j = 0; j < JOINTS; j++) {
			matrix_normals((const mat4 *)&f.palette[j],
				(mat4 *)&f.palette[j]);
		}
		kernel_float.skin_directions(&f.stream,
			(const float(*)[4])f.stream.normal,
			(const mat4 *)f.palette, 0, f.want_normal);
		fixed_palette_make_normals(&f.skin, &f.placement,
			(const mat4 *)f.palette, f.matrix);
		clear_overflow();
		compare_normals(&f);
		assert_false(has_overflowed());
	}
	tear_down(&f);
}

/* Of joints that move nothing, and behind the last one. */
static void test_other_matrices_for_normals_stay(void **state)
{
	static struct fixture f;
	struct fixed_matrix matrix[JOINTS + 1], before;
	int joints, used = 0;

	(void)state;
	set_up(&f);
	joints = f.skin.joint_count;
	assert_in_range(joints, 2, JOINTS);
	memset(&before, 0x5A, sizeof(before));
	for (int j = 0; j <= joints; j++) {
		matrix[j] = before;
	}
	make_palette(&f, 1.3f, 0);
	assert_int_equal(fixed_palette_make(&f.skin, (const mat4 *)f.palette,
				 f.matrix, &f.placement),
		0);
	fixed_palette_make_normals(
		&f.skin, &f.placement, (const mat4 *)f.palette, matrix);
	assert_memory_equal(&matrix[joints], &before, sizeof(before));
	for (int j = 0; j < joints; j++) {
		bool written = memcmp(&matrix[j], &before, sizeof(before)) != 0;

		assert_int_equal(written, f.skin.joint[j].used);
		used += written;
	}
	assert_true(used > 0);
	tear_down(&f);
}

static void test_no_scale_or_distance_wraps(void **state)
{
	static struct fixture f;

	(void)state;
	set_up(&f);
	for (int s = -12; s <= 12; s += 3) {
		for (int d = -12; d <= 12; d += 3) {
			float scale = ldexpf(1.3f, s);
			float distance = ldexpf(0.7f, d);

			make_palette(&f, scale, distance);
			compare_positions(
				&f, 0, 4e-4 * (2 * scale + 2 * distance));
		}
	}
	tear_down(&f);
}

/* All coordinates and matrices at the limits of their ranges. */
static void test_the_corners_of_a_box_do_not_overflow(void **state)
{
	static struct fixture f;

	(void)state;
	set_up(&f);
	for (int v = 0; v < VERTICES; v++) {
		for (int k = 0; k < 3; k++) {
			f.position[v][k] = v >> k & 1 ? 1 : -1;
		}
	}
	for (int angle = 0; angle < 16; angle++) {
		for (int j = 0; j < JOINTS; j++) {
			struct transform t = transform_identity();

			quat_from_axis_angle((const float[3]){0.6f, 0, 0.8f},
				(float)(angle + j) * 0.3927f, t.rotation);
			t.translation[j % 3] = j & 1 ? 1.5f : -1.5f;
			transform_to_matrix(&t, f.palette[j]);
		}
		arena_release(&f.arena);
		f.arena = arena_empty();
		assert_int_equal(
			skin_stream_init(&f.stream, &f.primitive, 1, &f.arena),
			0);
		assert_int_equal(
			fixed_skin_init(&f.skin, &f.primitive, 0, &f.arena), 0);
		compare_positions(&f, 0, 8e-4);
	}
	tear_down(&f);
}

static void test_what_is_no_number_is_refused(void **state)
{
	static struct fixture f;
	static const float bad[] = {NAN, -NAN, INFINITY, -INFINITY, 1e30f};
	struct fixed_skin skin;

	(void)state;
	set_up(&f);
	for (size_t i = 0; i < sizeof(bad) / sizeof(bad[0]); i++) {
		for (int column = 0; column < 4; column++) {
			float good = f.palette[3][column][1];

			f.palette[3][column][1] = bad[i];
			assert_int_equal(fixed_palette_make(&f.skin,
						 (const mat4 *)f.palette,
						 f.matrix, &f.placement),
				-ERANGE);
			f.palette[3][column][1] = good;
		}
		f.position[5][1] = bad[i];
		assert_int_equal(
			fixed_skin_init(&skin, &f.primitive, 0, &f.arena),
			-ERANGE);
		f.position[5][1] = 0;
	}
	tear_down(&f);
}

static void test_a_collapsed_figure_is_one_point(void **state)
{
	static struct fixture f;

	(void)state;
	set_up(&f);
	memset(f.palette, 0, sizeof(f.palette));
	compare_positions(&f, 0, 1e-9);
	tear_down(&f);
}

static void test_joints_beyond_the_palettes_reach_are_refused(void **state)
{
	static struct fixture f;
	static uint16_t joint[VERTICES * 16];
	static float weight[VERTICES * 16], position[VERTICES * 16][3];
	struct fixed_skin skin;

	(void)state;
	set_up(&f);
	for (int v = 0; v < VERTICES * 16; v++) {
		joint[v] = (uint16_t)v;
		weight[v] = 1;
	}
	f.primitive.influences = 1;
	f.primitive.joint = joint;
	f.primitive.weight = weight;
	f.primitive.position = position;
	f.primitive.vertex_count = 2048;
	assert_int_equal(fixed_skin_init(&skin, &f.primitive, 0, &f.arena), 0);
	f.primitive.vertex_count = 2049;
	assert_int_equal(
		fixed_skin_init(&skin, &f.primitive, 0, &f.arena), -ERANGE);
	tear_down(&f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_positions_are_floats_at_every_cap),
		cmocka_unit_test(test_each_vertex_comes_out_once),
		cmocka_unit_test(test_groups_hold_all_vertices_at_every_cap),
		cmocka_unit_test(test_weights_sum_to_one_exactly),
		cmocka_unit_test(test_directions_are_floats),
		cmocka_unit_test(test_normals_may_have_their_own_matrices),
		cmocka_unit_test(test_other_matrices_for_normals_stay),
		cmocka_unit_test(test_no_scale_or_distance_wraps),
		cmocka_unit_test(test_the_corners_of_a_box_do_not_overflow),
		cmocka_unit_test(test_what_is_no_number_is_refused),
		cmocka_unit_test(test_a_collapsed_figure_is_one_point),
		cmocka_unit_test(
			test_joints_beyond_the_palettes_reach_are_refused),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
