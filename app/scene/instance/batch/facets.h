/*
 * Facets: triangles that are lit by the normals of their own planes.
 *
 * A primitive without normals is drawn as facets (glTF 2.0, section 3.7.2.1),
 * whose normals follow the posed triangles. GL's flat shading takes a
 * triangle's colour from its last corner alone. Triangles may therefore share
 * vertices if no two of them have the same last corner. facets_make() rotates
 * each triangle's corners until its last one ends no other triangle; if all
 * three do, one of them is copied. A closed mesh has about two triangles for
 * each vertex, so its vertices become twice as many; three vertices for each
 * triangle would be six times as many.
 */
#ifndef APP_SCENE_INSTANCE_FACETS_H
#define APP_SCENE_INSTANCE_FACETS_H

#include "app/anim/kernel/fixed.h"
#include "app/model/model.h"
#include "platform/base/arena.h"

#include <stdint.h>

/* A primitive's triangles as facets, which have vertices of their own. */
struct facets {
	int vertex_count;
	/* [vertex_count]: the primitive's vertex of which each is a copy */
	const uint32_t *source;
	/* [primitive's vertex_count]: one copy of each of its vertices */
	const uint32_t *inverse_order;
	const uint16_t *index; /* [primitive's index_count] */
};

/*
 * Makes the facets of a primitive, in the arena. Returns 0, -ENOMEM, or -ERANGE
 * where they would have more than 65,536 vertices.
 */
int facets_make(const struct model_primitive *primitive, struct arena *arena,
	struct facets *out);

/*
 * Computes the normals of triangles from their corners and stores each at the
 * triangle's last corner: of unit length, or 0 for a triangle without an area.
 * If index is NULL, every three positions are a triangle, and all three corners
 * get its normal. count is the number of corners.
 */
void facets_find_normals(const uint16_t *index, int count,
	const float (*position)[3], float (*normal)[3]);

/*
 * Does the same in fixed point. The largest component of a normal is between
 * half of 32,767 and 32,767; GL has to normalize them.
 */
void facets_find_fixed_normals(const uint16_t *index, int count,
	const struct fixed_vector *position, struct fixed_vector *normal);

/* Corners of a primitive's index, whose triangles have the wanted normals. */
struct facets_corners {
	int count;
	const uint32_t *corner; /* [count] */
	const uint32_t *index;  /* the primitive's */
	/* NULL, or where each of the primitive's vertices is stored */
	const uint32_t *inverse_order;
};

/* Finds the normals [count] of the triangles that have these corners. */
void facets_find_normals_at(const struct facets_corners *corners,
	const float (*position)[3], float (*normal)[3]);
void facets_find_fixed_normals_at(const struct facets_corners *corners,
	const struct fixed_vector *position, struct fixed_vector *normal);

/* Negates normals, for a skin whose joints mirror it. */
void facets_turn_normals(int count, float (*normal)[3]);
void facets_turn_fixed_normals(int count, struct fixed_vector *normal);

#endif
