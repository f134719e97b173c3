/*
 * Draws a model as `limber play --no-labels` does, with the driver soft on any
 * machine, and counts the calls, vertices, triangles and pixels.
 */
#ifndef APP_COMPARE_COST_DRAWING_H
#define APP_COMPARE_COST_DRAWING_H

#include "app/scene/instance/bounds.h"
#include "platform/gl/gl_counts.h"

struct drawing;

/* What shadows on uneven ground of the model's own took before GL. */
struct drawing_shadow {
	double points; /* listed and posed */
	double rays;   /* that followed the light to the ground */
};

/*
 * Prepares an RGB565 picture of width x height pixels and uploads the textures
 * of the instance's model. The camera frames the box, in scene units. The
 * caller has made the model's levels of detail (app/model/levels). The instance
 * is left in the rest pose; it and its model must outlive the drawing. The
 * caller releases *out with drawing_destroy(). Returns 0, or -errno after
 * logging an error.
 */
int drawing_create(struct instance *instance, const struct bounds *box,
	int width, int height, const struct log *log, struct drawing **out);

/* NULL is fine. */
void drawing_destroy(struct drawing *drawing);

/*
 * From now on, the camera frames this box, in scene units, as the player's
 * camera frames the clip that is played. The floor stays where it is.
 */
void drawing_frame(struct drawing *drawing, const struct bounds *box);

/*
 * Draws background, floor, shadow and the instance in its last updated pose,
 * with the level of detail that suits its size in the picture. extent is the
 * instance's drawing_extent().
 */
void drawing_draw(
	struct drawing *drawing, struct instance *instance, float extent);

/*
 * From now on, levels of detail are chosen as the player chooses them for key
 * frames, which have no joints.
 */
void drawing_show_keys(struct drawing *drawing);

/*
 * The longest side, in scene units, of the rest pose, which the instance gets.
 */
float drawing_extent(struct instance *instance);

/*
 * Adds all that is drawn from now on to *counts and *shadow; both NULL stop
 * counting.
 */
void drawing_count(struct drawing *drawing, struct gl_counts *counts,
	struct drawing_shadow *shadow);

#endif
