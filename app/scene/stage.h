/*
 * What is around a model: background, floor, light, shadow.
 *
 * A frame is stage_begin(), the models, stage_end(). Shadows go between the
 * floor and the models: stage_shadow_begin(), the shapes, stage_shadow_end().
 */
#ifndef APP_SCENE_STAGE_H
#define APP_SCENE_STAGE_H

#include "app/scene/camera.h"
#include "platform/display/pixels.h"

enum {
	STAGE_RINGS = 6,
	STAGE_SPOKES = 32
};

struct stage {
	struct camera camera;
	float floor_y;         /* scene units */
	float floor_center[2]; /* x, z */
	float floor_radius;    /* 0: no floor */
	float floor_offset[2]; /* how far the floor has run under the models */
	float tile;            /* side of a floor tile */
	bool has_stencil;
	GLuint floor_texture;

	float floor_position[STAGE_RINGS * STAGE_SPOKES + 1][3];
	float floor_texcoord[STAGE_RINGS * STAGE_SPOKES + 1][2];
	uint8_t floor_color[STAGE_RINGS * STAGE_SPOKES + 1][4];
	uint16_t floor_index[(STAGE_RINGS * 2 - 1) * STAGE_SPOKES * 3];
};

/*
 * A stage whose camera frames the box and whose floor lies under it. 0, or
 * -ENOMEM after a sentence. Release with stage_finish().
 */
int stage_init(struct stage *stage, const struct gl *gl,
	const struct bounds *bounds, float aspect, enum pixel_format target,
	const struct log *log);

void stage_finish(struct stage *stage, const struct gl *gl);

/* Clears, draws background and floor, loads camera and lights. */
void stage_begin(
	const struct stage *stage, const struct gl *gl, int width, int height);

/*
 * Until stage_shadow_end(), shapes are drawn flattened onto the floor along
 * the main light, in a dark see-through colour. Nothing without a floor.
 */
void stage_shadow_begin(const struct stage *stage, const struct gl *gl);
void stage_shadow_end(const struct stage *stage, const struct gl *gl);

#endif
