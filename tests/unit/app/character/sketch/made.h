/* Models of a few rigid parts, as tests of how parts turn need them. */
#ifndef TESTS_UNIT_APP_CHARACTER_SKETCH_MADE_H
#define TESTS_UNIT_APP_CHARACTER_SKETCH_MADE_H

#include "app/model/model.h"

#include <math.h>
#include <string.h>

enum {
	MOST = 4,
	SPOKES = 12
};

enum form {
	BOX,
	ROUND_X, /* the box contains a cylinder along this axis */
	ROUND_Y,
	ROUND_Z,
	BALL,
	SQUARES /* an octahedron with a square around z */
};

/* A node and the box of its mesh, around the node's origin. */
struct made {
	const char *name;
	int parent;
	float low[3], high[3];
	float rotation[4];
	enum form form;
	float place[3];
	float scale[3]; /* 0 0 0: 1 1 1 */
};

struct scene {
	struct model_node node[MOST];
	struct model_mesh mesh[MOST];
	struct model_primitive primitive[MOST];
	float corner[MOST][2 * SPOKES * SPOKES][3];
	struct model model;
};

/* Places a vertex in the box, at -1..1 of its half sides from the middle. */
static inline void place(
	const struct made *made, const float at[3], float out[3])
{
	for (int i = 0; i < 3; i++) {
		out[i] = 0.5f *
			(made->low[i] + made->high[i] +
				at[i] * (made->high[i] - made->low[i]));
	}
}

/* Returns the number of vertices. */
static inline int make_form(const struct made *made, float (*vertex)[3])
{
	static const float squares[6][3] = {{1, 1, 0}, {1, -1, 0}, {-1, 1, 0},
		{-1, -1, 0}, {0, 0, 1}, {0, 0, -1}};
	int count = 0, rings = made->form == BALL ? SPOKES : 2;
	int along = made->form == BALL ? 0 : (int)made->form - ROUND_X;

	if (made->form == BOX) {
		memcpy(vertex[0], made->low, sizeof(made->low));
		memcpy(vertex[1], made->high, sizeof(made->high));
		return 2;
	}
	if (made->form == SQUARES) {
		for (int i = 0; i < 6; i++) {
			place(made, squares[i], vertex[i]);
		}
		return 6;
	}
	for (int ring = 0; ring < rings; ring++) {
		float at[3], level = -1 + 2 * (float)ring / (float)(rings - 1);
		float radius = made->form == BALL ? sqrtf(1 - level * level) : 1;

		for (int i = 0; i < SPOKES; i++) {
			float angle = 6.2831853f * (float)i / SPOKES;

			at[along] = level;
			at[(along + 1) % 3] = radius * cosf(angle);
			at[(along + 2) % 3] = radius * sinf(angle);
			place(made, at, vertex[count++]);
		}
	}
	return count;
}

static inline void make(const struct made *made, int count, struct scene *scene)
{
	static const float none[4] = {0};

	*scene = (struct scene){.model = {.node = scene->node,
					.node_count = count,
					.mesh = scene->mesh,
					.mesh_count = count}};
	for (int i = 0; i < count; i++) {
		struct transform rest = {{0}, {0, 0, 0, 1}, {1, 1, 1}};

		if (memcmp(made[i].rotation, none, sizeof(none)) != 0) {
			memcpy(rest.rotation, made[i].rotation, sizeof(none));
		}
		if (memcmp(made[i].scale, none, sizeof(made[i].scale)) != 0) {
			memcpy(rest.scale, made[i].scale, sizeof(rest.scale));
		}
		memcpy(rest.translation, made[i].place, sizeof(made[i].place));
		scene->primitive[i] = (struct model_primitive){
			.vertex_count = make_form(&made[i], scene->corner[i]),
			.position = scene->corner[i]};
		scene->mesh[i] = (struct model_mesh){.primitive_count = 1,
			.primitive = &scene->primitive[i]};
		scene->node[i] = (struct model_node){.name = made[i].name,
			.parent = made[i].parent,
			.in_scene = true,
			.rest = rest,
			.mesh = i,
			.skin = -1,
			.camera = -1};
	}
}

#endif
