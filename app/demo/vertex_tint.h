/*
 * Paints an instance with a colour a vertex in place of its materials, as a
 * heat map.
 *
 * The instance stays lit. Drawables without normals keep their materials.
 */
#ifndef APP_DEMO_VERTEX_TINT_H
#define APP_DEMO_VERTEX_TINT_H

#include "app/scene/instance/instance.h"

struct vertex_tint {
	struct instance *instance;       /* not owned */
	const struct model *kept;        /* the instance's own model */
	struct model plain;              /* the same with white materials */
	const uint8_t (**kept_color)[4]; /* [drawable_count] */
	uint8_t (**color)[4]; /* [drawable_count][vertex_count], or NULL */
};

/*
 * Prepares painting, switched off. Memory comes from the instance's arena.
 * Returns 0 or -ENOMEM.
 */
int vertex_tint_init(struct vertex_tint *tint, struct instance *instance);

/* Shows the painted colours or the materials. */
void vertex_tint_switch(struct vertex_tint *tint, bool on);

/* Sets the colour of a drawable's vertex; vertex is an index of the primitive. */
void vertex_tint_set(struct vertex_tint *tint, int drawable, int vertex,
	const uint8_t rgb[3]);

#endif
