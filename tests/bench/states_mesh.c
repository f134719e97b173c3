#include "tests/bench/states_mesh.h"

#include <math.h>
#include <stdbool.h>

#include "tests/support/random.h"

static uint8_t to_byte(double value)
{
	return (uint8_t)(value * 255.0 + 0.5);
}

static void set_color(struct states_vertex *v, const double color[3])
{
	for (int i = 0; i < 3; i++) {
		v->color[i] = to_byte(color[i]);
	}
	v->color[3] = 255;
}

static const double turn_x = 40.0 * 3.14159265358979 / 180.0;
static const double turn_y = 20.0 * 3.14159265358979 / 180.0;

/* Where the ray through a corner of the screen meets the plane. */
static void cut_plane(struct states_vertex *v, double x, double y, bool turned)
{
	double normal[3] = {0.0, -sin(turn_x), cos(turn_x)};
	double right[3] = {1.0, 0.0, 0.0},
	       up[3] = {0.0, cos(turn_x), sin(turn_x)};
	double ray[3] = {0.375 * x, 0.5 * y, -1.0}, t, s = 0.0, r = 0.0;

	if (turned) {
		right[0] = cos(turn_y);
		right[2] = -sin(turn_y);
		normal[0] = sin(turn_y) * cos(turn_x);
		normal[2] = cos(turn_y) * cos(turn_x);
		up[0] = sin(turn_y) * sin(turn_x);
		up[2] = cos(turn_y) * sin(turn_x);
	}
	t = -3.0 * normal[2] /
		(ray[0] * normal[0] + ray[1] * normal[1] + ray[2] * normal[2]);
	for (int i = 0; i < 3; i++) {
		double at = ray[i] * t - (i == 2 ? -3.0 : 0.0);

		v->position[i] = (float)(ray[i] * t);
		s += at * right[i];
		r += at * up[i];
	}
	v->texcoord[0] = (float)(0.833 * s);
	v->texcoord[1] = (float)(0.833 * r);
}

/*
 * The quad that the corners of the screen, times 0.9995, cut from the plane
 * through (0, 0, -3) turned 40 degrees about X.
 */
static void make_quad(struct states_mesh *mesh, bool turned)
{
	static const double at[6][2] = {
		{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
	static const double color[6][3] = {{1.0, 0.6, 0.5}, {0.5, 1.0, 0.6},
		{0.9, 0.4, 1.0}, {1.0, 0.6, 0.5}, {0.9, 0.4, 1.0},
		{0.7, 0.9, 0.3}};

	mesh->count = 6;
	for (int i = 0; i < 6; i++) {
		cut_plane(&mesh->vertex[i], at[i][0] * 0.9995,
			at[i][1] * 0.9995, turned);
		set_color(&mesh->vertex[i], color[i]);
	}
}

static void make_backdrop(struct states_mesh *mesh)
{
	static const float at[6][2] = {
		{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};

	mesh->count = 6;
	for (int i = 0; i < 6; i++) {
		struct states_vertex *v = &mesh->vertex[i];

		v->position[0] = at[i][0] * 3.0f * 0.375f;
		v->position[1] = at[i][1] * 3.0f * 0.5f;
		v->position[2] = -3.0f;
		v->texcoord[0] = at[i][0] * 0.5f + 0.5f;
		v->texcoord[1] = at[i][1] * 0.5f + 0.5f;
	}
}

/* From -1 to 1, each face all of the texture. */
static void make_cube(struct states_mesh *mesh)
{
	static const float corner[6][2] = {
		{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};

	mesh->count = 36;
	for (int i = 0; i < 36; i++) {
		struct states_vertex *v = &mesh->vertex[i];
		int axis = i / 12, side = i / 6 % 2 ? 1 : -1;
		float s = corner[i % 6][0], t = corner[i % 6][1];

		v->position[axis] = (float)side;
		v->position[(axis + 1) % 3] = s * (float)side;
		v->position[(axis + 2) % 3] = t;
		v->normal[axis] = (float)side;
		v->texcoord[0] = s * 0.5f + 0.5f;
		v->texcoord[1] = t * 0.5f + 0.5f;
	}
}

static double between(uint32_t *seed, double low, double high)
{
	return low + (high - low) * random_between(seed, 0, 10000) / 10000.0;
}

/* From pixels at a depth to eye coordinates. */
static void place(struct states_vertex *v, double x, double y, double depth)
{
	v->position[0] = (float)((x / (STATES_WIDTH / 2) - 1.0) * 0.375 * depth);
	v->position[1] = (float)((1.0 - y / (STATES_HEIGHT / 2)) * 0.5 * depth);
	v->position[2] = (float)-depth;
}

static void make_triangle(struct states_vertex *v, const double cell[4],
	const bool mirror[2], double depth, double spread, double texels,
	uint32_t *seed)
{
	static const double corner[3][2] = {{0, 0}, {0.98, 0.12}, {0.32, 1}};
	double s = between(seed, 0, 1), t = between(seed, 0, 1);

	for (int k = 0; k < 3; k++) {
		double x = mirror[0] ? 1 - corner[k][0] : corner[k][0];
		double y = mirror[1] ? 1 - corner[k][1] : corner[k][1];
		double color[3];

		place(&v[k], cell[0] + x * cell[2], cell[1] + y * cell[3],
			k == 0 ? depth : depth + between(seed, -spread, spread));
		v[k].texcoord[0] = (float)(s + corner[k][0] * texels);
		v[k].texcoord[1] = (float)(t + corner[k][1] * texels);
		for (int i = 0; i < 3; i++) {
			color[i] = between(seed, 0.4, 1);
		}
		set_color(&v[k], color);
	}
}

/* A grid of 20 x 25 cells. */
static void make_small(struct states_mesh *mesh, double spread)
{
	uint32_t seed = 5;

	mesh->count = STATES_CELLS * 3;
	for (int i = 0; i < STATES_CELLS; i++) {
		double depth = between(&seed, 4, 4.3);
		const double cell[4] = {i % 20 * 24.0, i / 20 * 25.6, 24, 25.6};
		const bool mirror[2] = {i % 2, i / 20 % 2};

		make_triangle(&mesh->vertex[3 * i], cell, mirror, depth,
			spread > 0 ? spread : depth * 0.05, 28.0 / 256.0, &seed);
	}
}

/* Three layers of 4 x 5 cells, the nearest last; two texels a pixel. */
static void make_layers(struct states_mesh *mesh)
{
	uint32_t seed = 7;

	mesh->count = 180;
	for (int i = 0; i < 60; i++) {
		double depth = 5.0 - i / 20 * 0.5;
		const double cell[4] = {
			i % 4 * 120.0, i / 4 % 5 * 126.0, 120, 120};
		const bool mirror[2] = {i % 2, i / 4 % 2};

		make_triangle(&mesh->vertex[3 * i], cell, mirror, depth, 0.1,
			240.0 / 256.0, &seed);
	}
}

void states_mesh_make(struct states_mesh *mesh, enum states_shape shape)
{
	switch (shape) {
	case STATES_QUAD:
	case STATES_TURNED:
		make_quad(mesh, shape == STATES_TURNED);
		break;
	case STATES_CUBE:
		make_cube(mesh);
		break;
	case STATES_SMALL:
	case STATES_SMALL_W:
		make_small(mesh, shape == STATES_SMALL_W ? 0.15 : 0.0);
		break;
	case STATES_LAYERS:
		make_layers(mesh);
		break;
	default:
		make_backdrop(mesh);
		break;
	}
}
