/*
 * Draws a model's pictures as `limber play --no-labels` does, with the driver
 * soft on any machine, and counts what they consist of.
 */
#ifndef APP_COMPARE_COST_DRAWING_H
#define APP_COMPARE_COST_DRAWING_H

#include "app/scene/instance/bounds.h"
#include "platform/gl/gl_counts.h"

struct drawing;

/*
 * Prepares pictures of instances of the instance's model, whose textures it
 * uploads. The camera frames the box, in scene units, in a picture of RGB565.
 * The model has its levels of detail (app/model/levels); it and the instance,
 * which is left in the rest pose, must outlive the drawing, which
 * drawing_destroy() releases. Returns 0, or -errno after logging an error.
 */
int drawing_create(struct instance *instance, const struct bounds *box,
	int width, int height, const struct log *log, struct drawing **out);

/* NULL is fine. */
void drawing_destroy(struct drawing *drawing);

/*
 * Draws the instance as it was updated last: background, floor, shadow and the
 * model, with as many triangles as its size in the picture asks for. extent is
 * drawing_extent() of it.
 */
void drawing_draw(
	struct drawing *drawing, struct instance *instance, float extent);

/*
 * From now on instances stand for their key frames, which have no joints:
 * levels of detail are chosen as the player chooses them for these.
 */
void drawing_show_keys(struct drawing *drawing);

/* The longest side of the rest pose in scene units, in which it is left. */
float drawing_extent(struct instance *instance);

/* Adds what is drawn from now on to *counts; NULL stops. */
void drawing_count(struct drawing *drawing, struct gl_counts *counts);

#endif
