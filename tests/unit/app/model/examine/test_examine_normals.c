/* Which primitives have normals on the back of their triangles. */
#include "app/model/examine/examine.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <cglm/cglm.h>
#include <string.h>

enum {
	NODES = 4,
	MESHES = 2,
	TRIANGLES = 4
};

/* Roots without meshes; mesh m has one primitive of so many triangles. */
struct fixture {
	float position[MESHES][TRIANGLES * 3][3];
	float normal[MESHES][TRIANGLES * 3][3];
	uint32_t index[TRIANGLES * 3];
	struct model_primitive primitive[MESHES];
	struct model_mesh mesh[MESHES];
	struct model_node node[NODES];
	struct model_skin skin;
	int joint[2];
	mat4 bind[2];
	struct model model;
};

static void begin(struct fixture *f, int triangles)
{
	memset(f, 0, sizeof(*f));
	for (int n = 0; n < NODES; n++) {
		f->node[n] = (struct model_node){.name = "",
			.parent = -1,
			.mesh = -1,
			.skin = -1,
			.rest = {{0}, {0, 0, 0, 1}, {1, 1, 1}}};
	}
	for (uint32_t i = 0; i < TRIANGLES * 3; i++) {
		f->index[i] = i;
	}
	for (int m = 0; m < MESHES; m++) {
		f->primitive[m] =
			(struct model_primitive){.vertex_count = 3 * triangles,
				.position = f->position[m],
				.normal = f->normal[m],
				.index_count = 3 * triangles,
				.index = f->index};
		f->mesh[m] = (struct model_mesh){
			.primitive_count = 1, .primitive = &f->primitive[m]};
	}
	f->node[0].mesh = 0;
	f->skin = (struct model_skin){.joint_count = 2, .joint = f->joint};
	f->joint[0] = 2;
	f->joint[1] = 3;
	glm_mat4_identity_array(f->bind, 2);
	f->model = (struct model){.node_count = NODES,
		.node = f->node,
		.mesh_count = MESHES,
		.mesh = f->mesh,
		.skin_count = 1,
		.skin = &f->skin};
}

static int count(const struct fixture *f)
{
	struct arena arena = arena_empty();
	int reversed = examine_find_reversed(&f->model, &arena);

	arena_release(&arena);
	return reversed;
}

/* Triangle t of a mesh in the plane z = 0, its normals to the front or back. */
static void set_triangle(struct fixture *f, int mesh, int t, float z)
{
	for (int i = 0; i < 3; i++) {
		float *at = f->position[mesh][3 * t + i];

		at[0] = i == 1;
		at[1] = i == 2;
		at[2] = 0;
		f->normal[mesh][3 * t + i][2] = z;
	}
}

static const struct {
	float side[2][3];
	float front[3]; /* their cross product */
} planes[] = {
	{{{1, 0, 0}, {0, 1, 0}}, {0, 0, 1}},
	{{{0, 1, 0}, {0, 0, 1}}, {1, 0, 0}},
	{{{0, 0, 1}, {1, 0, 0}}, {0, 1, 0}},
	{{{1, 0, 0}, {0, 0, 1}}, {0, -1, 0}},
	{{{1, 2, 0}, {0, 1, 3}}, {6, -3, 1}},
	{{{-1, 1, 2}, {2, -1, 1}}, {3, 5, -1}},
};

/* Far from the origin, so that only the sides of the triangle matter. */
static void set_plane(struct fixture *f, size_t plane)
{
	static const float corner[3] = {30, -50, 70};

	for (int i = 0; i < 3; i++) {
		for (int axis = 0; axis < 3; axis++) {
			f->position[0][i][axis] = corner[axis] +
				(i ? planes[plane].side[i - 1][axis] : 0);
		}
	}
}

static void test_triangles_of_any_plane_have_a_back(void **state)
{
	(void)state;
	for (size_t p = 0; p < 2 * sizeof(planes) / sizeof(planes[0]); p++) {
		float sign = p % 2 ? -1.0f : 1.0f;
		struct fixture f;

		begin(&f, 1);
		set_plane(&f, p / 2);
		for (int i = 0; i < 3; i++) {
			for (int axis = 0; axis < 3; axis++) {
				f.normal[0][i][axis] =
					sign * planes[p / 2].front[axis];
			}
		}
		assert_int_equal(count(&f), p % 2);
	}
}

/* The corners are added: a long normal to the back outweighs two short ones. */
static void test_one_corner_may_outvote_two(void **state)
{
	(void)state;
	for (int one = 0; one < 3; one++) {
		for (size_t p = 0; p < sizeof(planes) / sizeof(planes[0]); p++) {
			struct fixture f;

			begin(&f, 1);
			set_plane(&f, p);
			for (int i = 0; i < 3; i++) {
				for (int axis = 0; axis < 3; axis++) {
					f.normal[0][i][axis] =
						planes[p].front[axis] *
						(i == one ? -1.0f : 0.4f);
				}
			}
			assert_int_equal(count(&f), 1);
			for (int axis = 0; axis < 3; axis++) {
				f.normal[0][one][axis] *= 0.7f;
			}
			assert_int_equal(count(&f), 0);
		}
	}
}

/* Against the cross product of whole numbers. */
static void test_any_triangle_is_told_from_its_back(void **state)
{
	uint32_t seed = 20;

	(void)state;
	for (int n = 0; n < RANDOM_CASES(600); n++) {
		int at[3][3], sum[3] = {0}, product = 0;
		struct fixture f;

		begin(&f, 1);
		for (int i = 0; i < 9; i++) {
			int normal = random_within(&seed, 3);

			at[i / 3][i % 3] = random_within(&seed, 9);
			f.position[0][i / 3][i % 3] = (float)at[i / 3][i % 3];
			f.normal[0][i / 3][i % 3] = (float)normal;
			sum[i % 3] += normal;
		}
		for (int i = 0; i < 3; i++) {
			int k = (i + 1) % 3, l = (i + 2) % 3;

			product += sum[i] *
				((at[1][k] - at[0][k]) * (at[2][l] - at[0][l]) -
					(at[1][l] - at[0][l]) *
						(at[2][k] - at[0][k]));
		}
		assert_int_equal(count(&f), product < 0);
	}
}

/* Each triangle has a vote, however large it is; one without an area has none. */
static void test_most_triangles_decide(void **state)
{
	static const struct {
		float z[TRIANGLES];
		int expected;
	} cases[] = {
		{{1, 1, 1, -9}, 0},
		{{-1, -1, 9, -1}, 1},
		{{-1, 9, -1, 9}, 0},
		{{-1, -1, 1, 0}, 1},
		{{0, 0, 0, -1}, 1},
		{{-1, 0, 0, 0}, 1},
		{{0, 0, 0, 0}, 0},
		{{1, 0, 0, 0}, 0},
		{{9, -1, -1, 0}, 1},
		{{0.001f, 0.001f, -9, 0}, 0},
		{{-0.001f, -0.001f, 9, 0}, 1},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct fixture f;

		begin(&f, TRIANGLES);
		for (int t = 0; t < TRIANGLES; t++) {
			set_triangle(&f, 0, t, cases[i].z[t]);
		}
		if (count(&f) != cases[i].expected) {
			fail_msg("case %zu", i);
		}
		f.primitive[0].normal = NULL;
		assert_int_equal(count(&f), 0);
	}
}

/* By the sides on which its nodes show it; a mesh that none shows has none. */
static void test_primitives_of_all_meshes_are_counted(void **state)
{
	struct fixture f;
	struct model_primitive two[2];

	(void)state;
	begin(&f, 1);
	set_triangle(&f, 0, 0, -1);
	set_triangle(&f, 1, 0, -1);
	assert_int_equal(count(&f), 1);
	f.node[NODES - 1].mesh = 1;
	assert_int_equal(count(&f), 2);
	f.node[1].mesh = 1; /* once more */
	assert_int_equal(count(&f), 2);
	two[0] = two[1] = f.primitive[1];
	f.mesh[1].primitive = two;
	f.mesh[1].primitive_count = 2;
	assert_int_equal(count(&f), 3);
	two[1].position = f.position[0];
	set_triangle(&f, 0, 0, 1);
	two[1].normal = f.normal[0];
	assert_int_equal(count(&f), 1);
}

/* Shows mesh 0 with the skin, whose joints stand on their own. */
static void begin_skinned(struct fixture *f, float z)
{
	begin(f, 1);
	set_triangle(f, 0, 0, z);
	f->node[0].skin = 0;
	f->node[0].parent = -1;
	f->skin.inverse_bind = f->bind;
}

/* Of three axes an odd number that are turned mirrors; a flat one does not. */
static void test_each_axis_of_a_skinned_node_mirrors(void **state)
{
	(void)state;
	for (int axes = 0; axes < 8; axes++) {
		bool mirrors = axes == 1 || axes == 2 || axes == 4 || axes == 7;
		struct fixture f;

		begin_skinned(&f, 1);
		for (int axis = 0; axis < 3; axis++) {
			f.node[0].rest.scale[axis] =
				axes >> axis & 1 ? -0.5f : 2.0f;
		}
		assert_int_equal(count(&f), mirrors);
		f.node[0].rest.scale[axes % 3] = 0.0f;
		assert_int_equal(count(&f), 0);
	}
}

/* Two mirrors above each other are none. */
static void test_mirrors_above_a_skinned_node_count(void **state)
{
	struct fixture f;

	(void)state;
	begin_skinned(&f, 1);
	f.node[1] = f.node[0];
	f.node[0].mesh = f.node[0].skin = -1;
	f.node[1].parent = 0;
	f.node[0].rest.scale[1] = -1;
	assert_int_equal(count(&f), 1);
	f.node[1].rest.scale[2] = -1;
	assert_int_equal(count(&f), 0);
	f.node[0].rest.scale[1] = 1;
	assert_int_equal(count(&f), 1);
}

/* The first joint that has a volume decides where the skin's vertices go. */
static void test_the_first_joint_with_a_volume_decides(void **state)
{
	struct fixture f;

	(void)state;
	begin_skinned(&f, 1);
	f.node[0].rest.scale[0] = -1;
	assert_int_equal(count(&f), 1);
	f.bind[0][2][2] = -1;
	assert_int_equal(count(&f), 0);
	f.bind[0][2][2] = 0;
	assert_int_equal(count(&f), 1);
	f.bind[1][1][1] = -1;
	assert_int_equal(count(&f), 0);
	f.node[3].rest.scale[2] = -3;
	assert_int_equal(count(&f), 1);
	f.bind[1][1][1] = 0; /* none has one */
	assert_int_equal(count(&f), 0);
	f.skin.inverse_bind = NULL; /* identities */
	assert_int_equal(count(&f), 1);
	f.node[2].rest.scale[2] = -3;
	assert_int_equal(count(&f), 0);
	f.node[2].rest.scale[2] = 0;
	assert_int_equal(count(&f), 0);
}

/* Both are wrong where two nodes show a mesh from both sides. */
static void test_a_mesh_shown_in_both_ways_is_wrong_in_one(void **state)
{
	(void)state;
	for (int way = 0; way < 2; way++) {
		struct fixture f;

		begin_skinned(&f, way ? 1 : -1);
		assert_int_equal(count(&f), !way);
		f.node[1] = f.node[0];
		f.node[way].rest.scale[0] = -1;
		assert_int_equal(count(&f), 1);
		f.node[!way].rest.scale[0] = -1;
		assert_int_equal(count(&f), way);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_triangles_of_any_plane_have_a_back),
		cmocka_unit_test(test_one_corner_may_outvote_two),
		cmocka_unit_test(test_any_triangle_is_told_from_its_back),
		cmocka_unit_test(test_most_triangles_decide),
		cmocka_unit_test(test_primitives_of_all_meshes_are_counted),
		cmocka_unit_test(test_each_axis_of_a_skinned_node_mirrors),
		cmocka_unit_test(test_mirrors_above_a_skinned_node_count),
		cmocka_unit_test(test_the_first_joint_with_a_volume_decides),
		cmocka_unit_test(test_a_mesh_shown_in_both_ways_is_wrong_in_one),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
