/*
 * Facets: triangles that are lit as their own plane lies.
 *
 * A primitive without normals is drawn so (glTF 2.0, section 3.7.2.1), and its
 * normals follow the posed triangles. GL's flat shading takes a triangle's
 * colour from its last corner alone. Triangles therefore may share vertices if
 * no two of them end in the same one: their corners are turned, and where all
 * three are taken, one of them gets a copy. A closed mesh has about two
 * triangles a vertex, and twice its vertices then; three for each triangle
 * would be six times as many.
 */
#ifndef APP_SCENE_INSTANCE_FACETS_H
#define APP_SCENE_INSTANCE_FACETS_H

#include "app/anim/kernel/fixed.h"
#include "app/model/model.h"
#include "platform/base/arena.h"

#include <stdint.h>

/* A primitive's triangles, of vertices of their own. */
struct facets {
	int vertex_count;
	const uint32_t *source; /* [vertex_count] the primitive's vertices */
	const uint32_t *inverse_order; /* of each of these, one that it became */
	const uint16_t *index;         /* as many as the primitive has */
};

/*
 * Makes the facets of a primitive, in the arena. Returns 0, -ENOMEM, or -ERANGE
 * where they would have more than 65,536 vertices.
 */
int facets_make(const struct model_primitive *primitive, struct arena *arena,
	struct facets *out);

/*
 * Computes the normals of triangles from their corners, and stores each at the
 * last corner: of unit length, or 0 for a triangle that is a line. Without an
 * index (NULL) each three positions are a triangle, whose corners all get it.
 */
void facets_find_normals(const uint16_t *index, int count,
	const float (*position)[3], float (*normal)[3]);

/*
 * The same in fixed point: normals are from half to all of 32,767 long in their
 * longest direction, for GL to bring to unit length.
 */
void facets_find_fixed_normals(const uint16_t *index, int count,
	const struct fixed_vector *position, struct fixed_vector *normal);

/* Turns normals to the other side of their triangles, as those of a mirrored skin. */
void facets_turn_normals(int count, float (*normal)[3]);
void facets_turn_fixed_normals(int count, struct fixed_vector *normal);

#endif
