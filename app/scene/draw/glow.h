/*
 * Tells the triangles that may emit light by a texture from those that do not.
 *
 * In most emissive textures a few lamps shine and the rest is black. The
 * triangles of the rest need no second texture: on an ARM11 it triples the cost
 * of their pixels.
 */
#ifndef APP_SCENE_DRAW_GLOW_H
#define APP_SCENE_DRAW_GLOW_H

#include "app/scene/instance/instance_data.h"

/* Where an emissive texture shines; at first set to zeros. */
struct glow_map {
	const struct model_image *image;
	int columns, rows;
	/*
	 * [rows + 1][columns + 1]: how many of the cells above and to the left
	 * of this corner have a texel that shines.
	 */
	uint32_t *shining;
};

/*
 * Puts the triangles of the drawable's lists that may shine behind the others,
 * and sets glow_from of its batches and of their coarser lists. Lists whose
 * order matters (blended ones) and those with few dark triangles stay as they
 * are. map keeps what was found about the last texture. Returns 0 or -ENOMEM.
 */
int glow_sort(struct drawable *drawable, const struct model *model,
	struct glow_map *map, struct arena *arena);

/* Frees what the map holds. */
void glow_map_release(struct glow_map *map);

#endif
