/*
 * An instance painted by numbers: a colour a vertex in place of its materials.
 *
 * Light falls on it as before. Drawables without normals keep their looks.
 */
#ifndef APP_DEMO_VERTEX_TINT_H
#define APP_DEMO_VERTEX_TINT_H

#include "app/scene/instance/instance.h"

struct vertex_tint {
	struct instance *instance;       /* not owned */
	const struct model *kept;        /* the instance's own model */
	struct model plain;              /* the same, with white materials */
	const uint8_t (**kept_color)[4]; /* [drawable_count] */
	uint8_t (**color)[4]; /* [drawable_count][vertex_count], or NULL */
};

/* Off. Memory is the instance's arena's. 0 or -ENOMEM. */
int vertex_tint_init(struct vertex_tint *tint, struct instance *instance);

void vertex_tint_switch(struct vertex_tint *tint, bool on);

/* The colour of a drawable's vertex, numbered as in its primitive. */
void vertex_tint_set(struct vertex_tint *tint, int drawable, int vertex,
	const uint8_t rgb[3]);

/* From blue for 0 over green and yellow to red for 1; clamps. */
void vertex_tint_ramp(float fraction, uint8_t rgb[3]);

#endif
