/* What random collapses change in attributes, against plain formulas. */
#include "app/model/levels/simplify_attributes.h"

#include "tests/support/random.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	SIDES = 6,
	OTHER = SIDES + 1, /* the second vertex in the middle */
	SPARE = SIDES + 2, /* a triangle elsewhere begins here */
	VERTICES = SIDES + 5,
	TRIANGLES = SIDES + 1,
	JOINTS = 4,
	INFLUENCES = 3,
	TARGETS = 2,
	TO = 1,
	CASES = 600
};

struct fan {
	float position[VERTICES][3], normal[VERTICES][3];
	float texcoord[VERTICES][2], weight[VERTICES][INFLUENCES];
	float moved[TARGETS][VERTICES][3], turned[TARGETS][VERTICES][3];
	uint8_t color[VERTICES][4];
	uint16_t joint[VERTICES][INFLUENCES];
	uint32_t index[3 * TRIANGLES], leader[VERTICES], next[VERTICES];
	uint32_t to[VERTICES], source[VERTICES];
	uint32_t first_triangle[VERTICES + 1], triangle[3 * TRIANGLES];
	struct simplify_target target[TARGETS];
	struct model_primitive primitive;
	struct simplify simplify;
};

static float random_part(uint32_t *seed, float most)
{
	return most * (float)random_within(seed, 10000) / 10000.0f;
}

static void draw_vertex(struct fan *fan, uint32_t *seed, int v)
{
	for (int i = 0; i < 3; i++) {
		fan->position[v][i] = random_part(seed, 0.3f);
		fan->normal[v][i] = random_part(seed, 1.0f);
		fan->color[v][i] = (uint8_t)random_between(seed, 0, 255);
		for (int t = 0; t < TARGETS; t++) {
			fan->moved[t][v][i] = random_part(seed, 1.0f);
			fan->turned[t][v][i] = random_part(seed, 9.0f);
		}
	}
	fan->texcoord[v][0] = random_part(seed, 0.1f);
	fan->texcoord[v][1] = random_part(seed, 0.1f);
	for (int i = 0; i < INFLUENCES; i++) {
		fan->joint[v][i] = (uint16_t)random_between(seed, 0, JOINTS - 1);
		fan->weight[v][i] = random_one_in(seed, 3)
			? 0.0f
			: (float)random_between(seed, 1, 100) / 200.0f;
	}
	fan->leader[v] = fan->next[v] = fan->to[v] = (uint32_t)v;
	fan->source[v] = (uint32_t)((v * 3 + 1) % VERTICES);
}

/* Two vertices in the middle of a rim, and a triangle away from them. */
static void draw_fan(struct fan *fan, uint32_t *seed)
{
	memset(fan, 0, sizeof(*fan));
	for (int v = 0; v < VERTICES; v++) {
		draw_vertex(fan, seed, v);
		fan->position[v][0] += cosf(1.0471976f * (float)v);
		fan->position[v][1] += sinf(1.0471976f * (float)v);
	}
	memset(fan->position[0], 0, sizeof(float[3]));
	memcpy(fan->position[OTHER], fan->position[0], sizeof(float[3]));
	fan->leader[OTHER] = fan->next[OTHER] = 0;
	fan->next[0] = OTHER;
	fan->to[0] = fan->to[OTHER] = TO;
	for (int i = 0; i < SIDES; i++) {
		uint32_t *at = fan->index + 3 * i;

		at[i % 3] = i < SIDES / 2 ? 0 : OTHER;
		at[(i + 1) % 3] = 1 + (uint32_t)i;
		at[(i + 2) % 3] = 1 + (uint32_t)((i + 1) % SIDES);
	}
	for (uint32_t i = 0; i < 3; i++) {
		fan->index[3 * SIDES + i] = SPARE + i;
	}
	fan->primitive = (struct model_primitive){.vertex_count = VERTICES,
		.position = fan->position,
		.normal = fan->normal,
		.color = random_one_in(seed, 2) ? fan->color : NULL,
		.texcoord = random_one_in(seed, 2) ? fan->texcoord : NULL,
		.influences = random_one_in(seed, 2) ? INFLUENCES : 0,
		.joint = fan->joint[0],
		.weight = fan->weight[0]};
	fan->simplify = (struct simplify){.primitive = &fan->primitive,
		.target = fan->target,
		.target_count = random_between(seed, 0, TARGETS),
		.source = random_one_in(seed, 2) ? fan->source : NULL,
		.shape_only = random_one_in(seed, 3),
		.position = fan->position,
		.extent = 4.0f,
		.texture_scale = 0.25f,
		.index_count = 3 * TRIANGLES,
		.index = fan->index,
		.leader = fan->leader,
		.next = fan->next,
		.to = fan->to,
		.first_triangle = fan->first_triangle,
		.triangle = fan->triangle};
	for (int t = 0; t < TARGETS; t++) {
		fan->target[t].position = fan->moved[t];
		fan->target[t].normal = fan->turned[t];
	}
	simplify_mesh_link(&fan->simplify);
}

struct place {
	uint32_t vertex[3];
	double share[3], square;
};

static double dot(const double a[3], const double b[3])
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The nearest point of a triangle's plane, moved into the triangle. */
static void find_place(
	const struct fan *fan, uint32_t vertex, struct place *place)
{
	double u[3], v[3], d[3], n[3], area, sum = 0;

	for (int i = 0; i < 3; i++) {
		double a = (double)fan->position[place->vertex[0]][i];

		u[i] = (double)fan->position[place->vertex[1]][i] - a;
		v[i] = (double)fan->position[place->vertex[2]][i] - a;
		d[i] = (double)fan->position[vertex][i] - a;
	}
	area = dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v);
	n[1] = (dot(v, v) * dot(d, u) - dot(u, v) * dot(d, v)) / area;
	n[2] = (dot(u, u) * dot(d, v) - dot(u, v) * dot(d, u)) / area;
	n[0] = 1 - n[1] - n[2];
	for (int i = 0; i < 3; i++) {
		sum += fmax(n[i], 0);
	}
	for (int i = 0; i < 3; i++) {
		place->share[i] = fmax(n[i], 0) / sum;
	}
	place->square = 0;
	for (int i = 0; i < 3; i++) {
		place->square += pow(
			d[i] - place->share[1] * u[i] - place->share[2] * v[i],
			2);
	}
}

/* The square of what a vertex's values differ from those at a place. */
static double difference(const float *value, int width, uint32_t vertex,
	const struct place *place, const uint32_t *source)
{
	double square = 0;

	for (uint32_t i = 0; i < (uint32_t)width; i++) {
		uint32_t own = source ? source[vertex] : vertex;
		double d = (double)value[own * (uint32_t)width + i];

		for (int k = 0; k < 3; k++) {
			uint32_t at = place->vertex[k];

			at = source ? source[at] : at;
			d -= place->share[k] *
				(double)value[at * (uint32_t)width + i];
		}
		square += d * d;
	}
	return square;
}

static double weight_of(const struct fan *fan, uint32_t vertex, int joint)
{
	double sum = 0;

	for (int i = 0; i < INFLUENCES; i++) {
		sum += fan->joint[vertex][i] == joint
			? (double)fan->weight[vertex][i]
			: 0;
	}
	return sum;
}

static double skin_square(
	const struct fan *fan, uint32_t vertex, const struct place *place)
{
	double mean[JOINTS], lack = 0, bend = 0;

	for (int j = 0; j < JOINTS; j++) {
		double along[3] = {0, 0, 0};

		mean[j] = 0;
		for (int k = 0; k < 3; k++) {
			mean[j] += place->share[k] *
				weight_of(fan, place->vertex[k], j);
		}
		for (int k = 0; k < 3; k++) {
			uint32_t at = place->vertex[k];
			double factor = place->share[k] *
				(weight_of(fan, at, j) - mean[j]);

			for (int i = 0; i < 3; i++) {
				along[i] +=
					factor * (double)fan->position[at][i];
			}
		}
		bend += 0.5 * sqrt(dot(along, along));
	}
	for (int i = 0; i < INFLUENCES; i++) {
		lack += fmax((double)fan->weight[vertex][i] -
				mean[fan->joint[vertex][i]],
			0);
	}
	return pow(0.05 * lack, 2) + bend * bend;
}

static double square_at(
	const struct fan *fan, uint32_t vertex, const struct place *place)
{
	const struct simplify *simplify = &fan->simplify;
	bool shaded = !simplify->shape_only;
	double square = 0, color = 0;

	for (int t = 0; t < simplify->target_count; t++) {
		double own = difference(fan->moved[t][0], 3, vertex, place,
				     simplify->source) /
			16;

		own += shaded ? difference(fan->turned[t][0], 3, vertex, place,
					simplify->source) *
				pow(0.009, 2)
			      : 0;
		square = fmax(square, own);
	}
	square +=
		fan->primitive.influences ? skin_square(fan, vertex, place) : 0;
	square += shaded ? pow(0.009, 2) *
			difference(fan->normal[0], 3, vertex, place, NULL)
			 : 0;
	for (int i = 0; i < 3; i++) {
		double d = fan->color[vertex][i];

		for (int k = 0; k < 3; k++) {
			d -= place->share[k] * fan->color[place->vertex[k]][i];
		}
		color += d * d;
	}
	square +=
		shaded && fan->primitive.color ? pow(0.05 / 255, 2) * color : 0;
	square += shaded && fan->primitive.texcoord ? pow(0.25, 2) *
			difference(fan->texcoord[0], 2, vertex, place, NULL)
						    : 0;
	return square;
}

/* The nearest of the triangles that stay, with the corner moved. */
static double vertex_square(const struct fan *fan, uint32_t vertex)
{
	struct place best = {.square = INFINITY};

	for (int t = 0; t < SIDES; t++) {
		const uint32_t *at = fan->index + 3 * t;
		struct place place;
		bool used = false, stays = true;

		for (int i = 0; i < 3; i++) {
			used = used || at[i] == vertex;
			stays = stays && at[i] != TO;
			place.vertex[i] = at[i] == vertex ? TO : at[i];
		}
		if (used && stays) {
			find_place(fan, vertex, &place);
			best = place.square < best.square ? place : best;
		}
	}
	return square_at(fan, vertex, &best);
}

static void test_a_collapse_changes_what_its_vertices_had(void **state)
{
	static struct fan fan;
	uint32_t seed = 5;

	(void)state;
	for (int i = 0; i < RANDOM_CASES(CASES); i++) {
		double expected;

		draw_fan(&fan, &seed);
		expected = sqrt(fmax(
			vertex_square(&fan, 0), vertex_square(&fan, OTHER)));
		assert_near(simplify_error_of_attributes(&fan.simplify, 0, TO),
			expected, 1e-5 + 1e-4 * expected);
	}
}

static void test_a_merge_changes_what_the_vertices_differ_by(void **state)
{
	const struct place place = {
		.vertex = {OTHER, OTHER, OTHER}, .share = {1, 0, 0}};
	static struct fan fan;
	uint32_t seed = 6;

	(void)state;
	for (int i = 0; i < RANDOM_CASES(CASES); i++) {
		double expected;

		draw_fan(&fan, &seed);
		expected = square_at(&fan, 0, &place);
		assert_near(simplify_square_of_merge(&fan.simplify, 0, OTHER),
			expected, 1e-6 + 1e-4 * expected);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_collapse_changes_what_its_vertices_had),
		cmocka_unit_test(
			test_a_merge_changes_what_the_vertices_differ_by),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
