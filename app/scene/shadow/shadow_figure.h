/*
 * The shadows of a figure on ground that its model brings along, wherever the
 * figure stands and however it is turned.
 *
 * shadow_ground finds and draws that ground; if it is uneven, shadow_drape lays
 * the shadow upon it. Several figures may stand on one stage: each casts its
 * shadow on its own ground.
 */
#ifndef APP_SCENE_SHADOW_SHADOW_FIGURE_H
#define APP_SCENE_SHADOW_SHADOW_FIGURE_H

#include "app/scene/shadow/shadow_drape.h"
#include "app/scene/shadow/shadow_ground.h"

struct shadow_figure {
	struct shadow_ground ground;
	struct shadow_drape drape; /* if the ground is uneven */
	float longest;             /* that of the drape for large figures */
};

/*
 * Prepares the shadows of an instance in its arena; *out becomes NULL if it has
 * no ground. ground is what shadow_ground_find() found of it or of another
 * instance of its model, which has to outlive this one. Returns 0, or -ENOMEM
 * after logging an error.
 */
int shadow_figure_create(struct instance *instance,
	const struct shadow_ground *ground, const struct log *log,
	struct shadow_figure **out);

/*
 * Lays the shadow of the instance, as it was last updated, upon uneven ground.
 * place leads from the instance's scene units to the stage's, without shear.
 * In a picture of this height, edges of a few pixels are not divided; a height
 * of 0 stands for a large picture.
 * Does nothing for other ground, or without a figure. Allocates nothing.
 */
void shadow_figure_lay(struct shadow_figure *figure, const struct stage *stage,
	int height, struct instance *instance, const mat4 place);

/*
 * Draws the ground and the shadow on it, as it was laid. It expects the
 * camera's model-view matrix, multiplied by place, and that the shadows on the
 * stage's floor are drawn. The ground is hidden from draw_instance() until
 * shadow_figure_end(). Does nothing without a figure.
 */
void shadow_figure_draw(const struct shadow_figure *figure,
	const struct stage *stage, const struct gl *gl,
	struct instance *instance, const struct texture_set *textures,
	const mat4 place);

/* Shows the ground to draw_instance() again, after the figure was drawn. */
void shadow_figure_end(
	const struct shadow_figure *figure, struct instance *instance);

#endif
