/*
 * The ground: tiles that fade into the background far out. Uneven ground is a
 * disc; level ground is what the camera sees of a plane (floor_strips.h).
 *
 * It can run under a figure that walks on the spot, and it can be uneven. The
 * figure stays, the offset grows; height and tiles move with it.
 */
#ifndef APP_SCENE_STAGE_FLOOR_H
#define APP_SCENE_STAGE_FLOOR_H

#include "app/scene/instance/bounds.h"
#include "app/scene/stage/floor_strips.h"
#include "platform/display/pixels.h"
#include "platform/gl/gl.h"

enum {
	FLOOR_RINGS = 12,
	FLOOR_SPOKES = 40,
	/* Up to these rings a quarter and a half of the spokes are enough. */
	FLOOR_QUARTER_RING = 3,
	FLOOR_HALF_RING = 5,
	FLOOR_VERTICES = FLOOR_RINGS * FLOOR_SPOKES + 1,
	/* A ring's spokes and the next one's are the triangles between them. */
	FLOOR_INNER_QUARTERS = (FLOOR_QUARTER_RING * 2 - 1) + 3 +
		(FLOOR_HALF_RING - FLOOR_QUARTER_RING - 1) * 4 + 6,
	FLOOR_INNER_INDICES = FLOOR_INNER_QUARTERS * (FLOOR_SPOKES / 4) * 3,
	FLOOR_INDICES = FLOOR_INNER_INDICES +
		(FLOOR_RINGS - FLOOR_HALF_RING - 1) * 2 * FLOOR_SPOKES * 3,
	/* Up to this ring it is opaque, from there on it fades. */
	FLOOR_OPAQUE_RING = 9,
	FLOOR_OPAQUE_INDICES = FLOOR_INNER_INDICES +
		(FLOOR_OPAQUE_RING - FLOOR_HALF_RING - 1) * 2 * FLOOR_SPOKES * 3,
};

struct floor {
	float y;         /* scene units */
	float center[2]; /* x, z */
	float radius;
	float tile;        /* side of a tile */
	float offset[2];   /* how far it has run */
	float wave_height; /* height of its waves; 0: flat */
	GLuint texture;

	float position[FLOOR_VERTICES][3];
	float texcoord[FLOOR_VERTICES][2];
	uint8_t color[FLOOR_VERTICES][4];
	uint16_t index[FLOOR_INDICES]; /* from the middle outwards */
};

/*
 * A flat floor under the box, at least so large as least_radius. 0, or -ENOMEM
 * after a sentence; release with floor_finish().
 */
int floor_init(struct floor *floor, const struct gl *gl,
	const struct bounds *bounds, float least_radius,
	enum pixel_format target, const struct log *log);

void floor_finish(struct floor *floor, const struct gl *gl);

/* Runs on by a distance along x and z. */
void floor_scroll(struct floor *floor, float dx, float dz);

/* Makes it uneven, or flat again with 0. */
void floor_set_wave_height(struct floor *floor, float relief);

/* Its height at a place, in scene units. */
float floor_height(const struct floor *floor, float x, float z);

/*
 * How far off that it may be drawn where it is solid: its triangles are level
 * between their corners.
 */
float floor_mesh_error(const struct floor *floor);

/* What a camera sees of it: of uneven ground that it may be anywhere. */
void floor_visible_strips(const struct floor *floor, const struct camera *camera,
	int width, int height, struct floor_strips *out);

/* With the camera's model-view matrix loaded; leaves lighting off. */
void floor_draw(const struct floor *floor, const struct floor_strips *strips,
	const struct gl *gl);

#endif
