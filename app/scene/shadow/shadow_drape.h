/*
 * Shadows on uneven ground: a figure's triangles, laid upon the ground.
 *
 * Each vertex of the lists that draw a figure's shadow moves along the light
 * down to the ground, and edges that are long compared with the figure are
 * divided, so that the triangles follow the ground. The stencil counts the
 * triangles on each pixel, so that each pixel is darkened only once. The shadow
 * is drawn when the depth buffer holds the ground but not the figure, so the
 * figure casts no shadow on itself.
 */
#ifndef APP_SCENE_SHADOW_SHADOW_DRAPE_H
#define APP_SCENE_SHADOW_SHADOW_DRAPE_H

#include "app/scene/instance/instance.h"
#include "app/scene/shadow/shadow_lay.h"
#include "platform/gl/gl.h"

/*
 * Cloth that a figure wears: triangles that belong to no mesh and are seen from
 * both sides. The positions move, and the rest stays.
 */
struct shadow_cloth {
	const float (*position)[3]; /* [vertex_count] */
	int vertex_count, index_count;
	const uint16_t *index; /* [index_count] */
	float scale;           /* of the positions, to scene units */
	bool hidden;           /* casts no shadow now */
};

/*
 * The shadow of one batch, or of one cloth; the arrays are parts of the drape's
 * arrays.
 */
struct shadow_sheet {
	const struct shadow_cloth *cloth; /* or NULL */
	const struct drawable *drawable;  /* NULL for cloth */
	const struct batch *batch;
	bool two_sided; /* its triangles need not enclose a body */
	int vertex_count, index_count;
	float (*posed)[3];
	float (*position)[3]; /* [vertex_count], on the ground, scene units */
	uint16_t *index;
};

struct shadow_drape {
	int sheet_count;
	struct shadow_sheet *sheet;
	float longest;     /* longest edge that is not divided, scene units */
	struct bounds box; /* around all positions, hardly larger */
	struct shadow_grid grid;

	/* scratch: where each vertex of a batch is in sheet.posed */
	uint32_t *place;
	float (*posed)[3], (*position)[3];
	uint16_t *index;
	int index_max, vertex_max;
	int divisions_left; /* that the current update may still make */
};

/*
 * Allocates the sheets of the instance and of its cloths, [cloth_count], in the
 * instance's arena. The cloths must outlive the drape. Edges are divided when
 * they are longer than a part of the instance as it was last updated. Returns
 * 0, or -ENOMEM after logging an error.
 */
int shadow_drape_init(struct shadow_drape *drape, struct instance *instance,
	const struct shadow_cloth *cloth, int cloth_count,
	const struct log *log);

/*
 * The same for ground of the model's own: edges are divided, too, when they are
 * longer than four cells of its relief.
 */
int shadow_drape_init_on(struct shadow_drape *drape, struct instance *instance,
	const struct shadow_cloth *cloth, int cloth_count,
	const struct shadow_relief *relief, const struct log *log);

/*
 * Lays the shadows of the instance, as it was last updated, and of its cloths
 * upon the ground. They are moved towards the eye just so far that the ground's
 * triangles do not hide them. Allocates nothing. A light at or below the
 * horizon casts none.
 */
void shadow_drape_update(struct shadow_drape *drape,
	const struct instance *instance, const struct shadow_light *light);

/*
 * Darkens the ground in the shadow by strength, 0..1, where the stencil buffer
 * is mark. Expects the camera's model-view matrix. If may_be_hidden is true, depths
 * are tested, and the depth buffer has to hold the ground and all that may hide
 * the shadow. Leaves the stencil test off and the stencil buffer changed.
 */
void shadow_drape_draw(const struct shadow_drape *drape, const struct gl *gl,
	float strength, int mark, bool may_be_hidden);

#endif
