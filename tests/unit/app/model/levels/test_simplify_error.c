/* What a collapse of one vertex of five changes, against plain formulas. */
#include "app/model/levels/simplify_error.h"

#include "app/model/levels/simplify_attributes.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	VERTICES = 5,
	TRIANGLES = 4
};

/* The middle of a square, and its corners. */
static const uint32_t fan[TRIANGLES][3] = {
	{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};

struct fixture {
	float position[VERTICES][3], normal[VERTICES][3];
	float texcoord[VERTICES][2], weight[VERTICES][4];
	float moved[2][VERTICES][3], turned[VERTICES][3];
	uint8_t color[VERTICES][4];
	uint16_t joint[VERTICES][4];
	uint32_t index[3 * TRIANGLES], leader[VERTICES], next[VERTICES];
	uint32_t to[VERTICES];
	uint32_t first_triangle[VERTICES + 1], triangle[3 * TRIANGLES];
	struct simplify_quadric quadric[VERTICES];
	struct simplify_target target[2];
	struct model_primitive primitive;
	struct simplify simplify;
};

static void link_arrays(struct fixture *f)
{
	f->primitive = (struct model_primitive){.vertex_count = VERTICES,
		.position = f->position,
		.normal = f->normal,
		.joint = f->joint[0],
		.weight = f->weight[0]};
	f->simplify = (struct simplify){.primitive = &f->primitive,
		.target = f->target,
		.position = f->position,
		.extent = 4.0f,
		.texture_scale = 0.25f,
		.index_count = 3 * TRIANGLES,
		.index = f->index,
		.leader = f->leader,
		.next = f->next,
		.to = f->to,
		.quadric = f->quadric,
		.first_triangle = f->first_triangle,
		.triangle = f->triangle};
}

/* The middle is at (0.6, 0.5, height). It goes to the corner 1, at (0, 0, 0). */
static void begin(struct fixture *f, float height)
{
	static const float corner[4][3] = {
		{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

	memset(f, 0, sizeof(*f));
	link_arrays(f);
	memcpy(f->position[1], corner, sizeof(corner));
	f->position[0][0] = 0.6f;
	f->position[0][1] = 0.5f;
	f->position[0][2] = height;
	for (uint32_t v = 0; v < VERTICES; v++) {
		f->leader[v] = f->next[v] = v;
		f->to[v] = v == 0 ? 1 : v;
		f->normal[v][2] = 1.0f;
	}
	memcpy(f->index, fan, sizeof(fan));
	simplify_mesh_link(&f->simplify);
}

static float attributes(const struct fixture *f)
{
	return simplify_error_of_attributes(&f->simplify, 0, 1);
}

/*
 * Without the middle, its place is in the triangle of the corners 1, 2 and 3,
 * with these shares.
 */
static const float share[VERTICES] = {0, 0.4f, 0.1f, 0.5f, 0};

static void test_what_lies_on_the_triangle_changes_nothing(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f, 0.25f);
	f.primitive.texcoord = f.texcoord;
	f.primitive.color = f.color;
	for (int v = 1; v < VERTICES; v++) {
		f.normal[v][0] = 0.1f * (float)v;
		f.texcoord[v][1] = 0.3f * (float)v;
		f.color[v][2] = (uint8_t)(50 * v);
		f.normal[0][0] += share[v] * f.normal[v][0];
		f.texcoord[0][1] += share[v] * f.texcoord[v][1];
		f.color[0][2] = (uint8_t)(f.color[0][2] +
			lrintf(share[v] * (float)f.color[v][2]));
	}
	assert_near(attributes(&f), 0, 1e-6);
}

/* Units of normals, of colours from black to white, and of the picture. */
static void test_shading_counts_by_its_difference(void **state)
{
	struct fixture f;
	double normal, color, texture;

	(void)state;
	begin(&f, 0.0f);
	f.primitive.texcoord = f.texcoord;
	f.primitive.color = f.color;
	f.normal[2][1] = 2.0f;
	f.normal[0][0] = 0.5f;
	f.normal[0][2] = 3.0f;
	/* (0.5, 0, 3) beside (0, 0.2, 1) */
	normal = 0.009 * sqrt(0.25 + 0.04 + 4.0);
	assert_near(attributes(&f), normal, 1e-6);
	f.color[3][0] = 200;
	f.color[0][1] = 60;
	f.color[0][3] = 99;
	color = 0.05 / 255 * hypot(100, 60);
	assert_near(attributes(&f), hypot(normal, color), 1e-6);
	f.texcoord[1][0] = 1.0f;
	f.texcoord[0][1] = 0.3f;
	texture = 0.25 * hypot(0.4, 0.3);
	assert_near(attributes(&f), hypot(hypot(normal, color), texture), 1e-6);
	f.simplify.shape_only = true;
	assert_near(attributes(&f), 0, 1e-6);
}

/* Each joint has all or a part of a vertex; weights are what one lacks. */
static void set_weights(
	struct fixture *f, int vertex, float first, float second, float third)
{
	const float weight[3] = {first, second, third};

	f->primitive.influences = 4;
	for (int i = 0; i < 3; i++) {
		f->joint[vertex][i] = (uint16_t)(7 + i);
		f->weight[vertex][i] = weight[i];
	}
}

static void test_weights_count_by_what_joints_lack(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f, 0.0f);
	for (int v = 1; v < VERTICES; v++) {
		set_weights(&f, v, 1, 0, 0);
	}
	set_weights(&f, 0, 0.25f, 0.5f, 0.25f);
	assert_near(attributes(&f), 0.05 * 0.75, 1e-6);
	f.simplify.shape_only = true;
	assert_near(attributes(&f), 0.05 * 0.75, 1e-6);
	/* Two influences of the joint are as good as one. */
	set_weights(&f, 0, 0.5f, 0.5f, 0);
	f.joint[0][1] = 7;
	assert_near(attributes(&f), 0, 1e-6);
}

/*
 * Where joints change along the triangle, each bends by half the covariance of
 * its weight and the position.
 */
static void test_limbs_that_bend_count_by_their_covariance(void **state)
{
	static const float weight[VERTICES][2] = {
		{0.45f, 0.55f}, {1, 0}, {0.5f, 0.5f}, {0, 1}, {0, 1}};
	struct fixture f;
	double sum = 0;

	(void)state;
	begin(&f, 0.0f);
	for (int v = 0; v < VERTICES; v++) {
		set_weights(&f, v, weight[v][0], weight[v][1], 0);
	}
	for (int j = 0; j < 2; j++) {
		double mean = 0, along[2] = {0, 0};

		for (int v = 1; v < 4; v++) {
			mean += (double)share[v] * (double)weight[v][j];
		}
		assert_near(mean, weight[0][j], 1e-6);
		for (int v = 1; v < 4; v++) {
			double factor = (double)share[v] *
				((double)weight[v][j] - mean);

			along[0] += factor * (double)f.position[v][0];
			along[1] += factor * (double)f.position[v][1];
		}
		sum += hypot(along[0], along[1]);
	}
	assert_true(sum > 0.1);
	assert_near(attributes(&f), 0.5 * sum, 1e-6);
	/* Influences without weight fill up vertices, with any joint. */
	for (int v = 0; v < VERTICES; v++) {
		f.joint[v][2] = f.joint[v][3] = 7;
	}
	assert_near(attributes(&f), 0.5 * sum, 1e-6);
}

/* Displacements are in the model's unit, of which the extent is four. */
static void test_the_target_that_changes_most_counts(void **state)
{
	struct fixture f;
	double place, normal;

	(void)state;
	begin(&f, 0.0f);
	f.simplify.target_count = 2;
	f.target[1].position = f.moved[1];
	f.target[1].normal = f.turned;
	assert_near(attributes(&f), 0, 1e-6);
	f.moved[1][0][0] = 3.0f;
	f.moved[1][3][2] = -8.0f;
	place = hypot(3, 4) / 4;
	assert_near(attributes(&f), place, 1e-6);
	f.turned[0][1] = 100.0f;
	normal = 0.009 * 100;
	assert_near(attributes(&f), hypot(place, normal), 1e-6);
	f.target[0].position = f.moved[0];
	f.moved[0][0][1] = 5.2f;
	f.simplify.shape_only = true;
	assert_near(attributes(&f), 1.3, 1e-6);
	f.moved[0][0][1] = 4.8f;
	assert_near(attributes(&f), place, 1e-6);
}

/* All vertices at the place count, each in its own triangles. */
static void test_vertices_at_a_seam_count_each(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f, 0.0f);
	/* The corner 4 moves to the middle, and has the triangles at the left. */
	memcpy(f.position[4], f.position[0], sizeof(f.position[0]));
	f.index[2 * 3 + 0] = f.index[3 * 3 + 0] = 4;
	f.index[2 * 3 + 2] = f.index[3 * 3 + 1] = 3;
	f.leader[4] = 0;
	f.next[0] = 4;
	f.next[4] = 0;
	f.to[4] = 1;
	simplify_mesh_link(&f.simplify);
	f.normal[0][0] = 1.0f;
	assert_near(attributes(&f), 0.009, 1e-6);
	f.normal[0][0] = 0.0f;
	assert_near(attributes(&f), 0, 1e-6);
}

/* A sum of squared distances from planes, each with a weight. */
struct planes {
	double sum, weight;
};

static void normal_of(
	const struct fixture *f, const uint32_t *at, double n[3], double *area)
{
	double u[3], v[3];

	for (int i = 0; i < 3; i++) {
		u[i] = (double)f->position[at[1]][i] -
			(double)f->position[at[0]][i];
		v[i] = (double)f->position[at[2]][i] -
			(double)f->position[at[0]][i];
	}
	for (int i = 0; i < 3; i++) {
		n[i] = u[(i + 1) % 3] * v[(i + 2) % 3] -
			u[(i + 2) % 3] * v[(i + 1) % 3];
	}
	*area = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
	for (int i = 0; i < 3; i++) {
		n[i] /= *area;
	}
}

static void add_plane(const struct fixture *f, struct planes *to,
	const double n[3], uint32_t through, uint32_t point, double weight)
{
	double distance = 0;

	for (int i = 0; i < 3; i++) {
		distance += n[i] *
			((double)f->position[point][i] -
				(double)f->position[through][i]);
	}
	to->sum += distance * distance * weight;
	to->weight += weight;
}

/* The border from corner a to corner b, of the triangle with a normal. */
static void add_side(const struct fixture *f, struct planes *to, uint32_t a,
	uint32_t b, const double n[3], uint32_t point)
{
	double along[3], upright[3], length = 0;

	for (int i = 0; i < 3; i++) {
		along[i] = (double)f->position[b][i] - (double)f->position[a][i];
	}
	for (int i = 0; i < 3; i++) {
		upright[i] = along[(i + 1) % 3] * n[(i + 2) % 3] -
			along[(i + 2) % 3] * n[(i + 1) % 3];
		length += upright[i] * upright[i];
	}
	for (int i = 0; i < 3; i++) {
		upright[i] /= sqrt(length);
	}
	/* Ten times its length, squared; along is upright on the normal. */
	add_plane(f, to, upright, a, point, 10 * length);
}

/* Whether the present triangles have an edge from one vertex to another. */
static bool has_edge(const struct fixture *f, uint32_t from, uint32_t to)
{
	for (int i = 0; i < f->simplify.index_count; i++) {
		if (f->index[i] == from &&
			f->index[i / 3 * 3 + (i + 1) % 3] == to) {
			return true;
		}
	}
	return false;
}

/* Adds the planes that a vertex stands for, and how far a point is from them. */
static void add_planes(const struct fixture *f, struct planes *to,
	uint32_t vertex, uint32_t point)
{
	for (int t = 0; t < f->simplify.index_count; t += 3) {
		const uint32_t *at = f->index + t;
		double n[3], area;

		normal_of(f, at, n, &area);
		if (at[0] == vertex || at[1] == vertex || at[2] == vertex) {
			add_plane(f, to, n, at[0], point, area);
		}
		for (int i = 0; i < 3; i++) {
			uint32_t a = at[i], b = at[(i + 1) % 3];

			if ((a == vertex || b == vertex) && !has_edge(f, b, a)) {
				add_side(f, to, a, b, n, point);
			}
		}
	}
}

static double distance(const struct planes *planes)
{
	return sqrt(planes->sum / planes->weight);
}

/* Of the whole fan and of parts of it, where ends have unlike triangles. */
static void test_the_shape_counts_by_planes_and_borders(void **state)
{
	(void)state;
	for (int i = 0; i < 3 * TRIANGLES; i++) {
		struct fixture f;

		begin(&f, 0.3f);
		f.simplify.index_count = 3 * (1 + i / 3);
		for (int k = 0; k < f.simplify.index_count; k++) {
			f.index[k] = fan[k / 3][(k + i) % 3];
		}
		simplify_mesh_link(&f.simplify);
		simplify_error_begin(&f.simplify);
		for (int k = 0; k < VERTICES * VERTICES; k++) {
			uint32_t from = f.index[k % f.simplify.index_count];
			uint32_t to = (uint32_t)(k / VERTICES);
			double error = (double)simplify_error_of_shape(
				&f.simplify, from, to);
			struct planes planes = {0};

			add_planes(&f, &planes, from, to);
			/* Roots of rounding errors are larger than those. */
			assert_near(error * error, planes.sum / planes.weight,
				1e-6);
		}
	}
}

/* Then the planes of both count. */
static void test_a_collapse_adds_what_a_vertex_stood_for(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f, 0.3f);
	simplify_error_begin(&f.simplify);
	simplify_error_collapse(&f.simplify, 0, 1);
	for (uint32_t to = 0; to < VERTICES; to++) {
		struct planes planes = {0};

		add_planes(&f, &planes, 0, to);
		add_planes(&f, &planes, 1, to);
		assert_near(simplify_error_of_shape(&f.simplify, 1, to),
			distance(&planes), 1e-5);
	}
}

static void test_a_vertex_without_triangles_has_no_error(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f, 0.3f);
	assert_near(simplify_error_of_shape(&f.simplify, 0, 1), 0, 0);
	/* A triangle without area has no plane. */
	memcpy(f.position[0], f.position[1], sizeof(f.position[0]));
	f.simplify.index_count = 3;
	simplify_mesh_link(&f.simplify);
	simplify_error_begin(&f.simplify);
	assert_near(simplify_error_of_shape(&f.simplify, 0, 3), 0, 0);
	/* It leaves the planes of others as they are. */
	f.simplify.index_count = 3 * TRIANGLES;
	simplify_mesh_link(&f.simplify);
	simplify_error_begin(&f.simplify);
	assert_true(simplify_error_of_shape(&f.simplify, 2, 4) > 0.1f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_what_lies_on_the_triangle_changes_nothing),
		cmocka_unit_test(test_shading_counts_by_its_difference),
		cmocka_unit_test(test_weights_count_by_what_joints_lack),
		cmocka_unit_test(test_limbs_that_bend_count_by_their_covariance),
		cmocka_unit_test(test_the_target_that_changes_most_counts),
		cmocka_unit_test(test_vertices_at_a_seam_count_each),
		cmocka_unit_test(test_the_shape_counts_by_planes_and_borders),
		cmocka_unit_test(test_a_collapse_adds_what_a_vertex_stood_for),
		cmocka_unit_test(test_a_vertex_without_triangles_has_no_error),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
