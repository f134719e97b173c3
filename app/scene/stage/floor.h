/*
 * The floor: tiled ground that fades into the background with distance.
 *
 * Level ground is drawn as two strips that cover what the camera sees of the
 * plane (floor_strips.h). Uneven ground is a disc of triangles. Under a figure
 * that walks on the spot the floor scrolls: the mesh stays, and an offset moves
 * its tiles and heights.
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
	/* Up to these rings a quarter and a half of the spokes are used. */
	FLOOR_QUARTER_RING = 3,
	FLOOR_HALF_RING = 5,
	FLOOR_VERTICES = FLOOR_RINGS * FLOOR_SPOKES + 1,
	/*
	 * Two rings have as many triangles between them as they have spokes
	 * together; here counted in quarters of FLOOR_SPOKES.
	 */
	FLOOR_INNER_QUARTERS = (FLOOR_QUARTER_RING * 2 - 1) + 3 +
		(FLOOR_HALF_RING - FLOOR_QUARTER_RING - 1) * 4 + 6,
	FLOOR_INNER_INDICES = FLOOR_INNER_QUARTERS * (FLOOR_SPOKES / 4) * 3,
	FLOOR_INDICES = FLOOR_INNER_INDICES +
		(FLOOR_RINGS - FLOOR_HALF_RING - 1) * 2 * FLOOR_SPOKES * 3,
	/* The disc is opaque up to this ring and fades beyond it. */
	FLOOR_OPAQUE_RING = 9,
	FLOOR_OPAQUE_INDICES = FLOOR_INNER_INDICES +
		(FLOOR_OPAQUE_RING - FLOOR_HALF_RING - 1) * 2 * FLOOR_SPOKES * 3,
};

/* Lengths are in scene units. */
struct floor {
	float y;         /* the height of level ground */
	float center[2]; /* x, z */
	float radius;
	float tile;        /* side of a tile */
	float offset[2];   /* x, z; how far the floor has scrolled */
	float wave_height; /* greatest distance from y; 0 means level ground */
	GLuint texture;

	/* The disc of uneven ground. */
	float position[FLOOR_VERTICES][3];
	float texcoord[FLOOR_VERTICES][2];
	uint8_t color[FLOOR_VERTICES][4];
	uint16_t index[FLOOR_INDICES]; /* from the middle outwards */
};

/*
 * Makes level ground under the box with at least the given radius. Returns 0,
 * or -ENOMEM after logging an error. Release it with floor_finish().
 */
int floor_init(struct floor *floor, const struct gl *gl,
	const struct bounds *bounds, float min_radius, enum pixel_format target,
	const struct log *log);

void floor_finish(struct floor *floor, const struct gl *gl);

/* Scrolls the floor by a distance along x and z. */
void floor_scroll(struct floor *floor, float dx, float dz);

/* Makes the ground uneven, or level with 0. */
void floor_set_wave_height(struct floor *floor, float wave_height);

/* Returns the ground's height at a point, in scene units. */
float floor_height(const struct floor *floor, float x, float z);

/*
 * Returns how far the drawn surface may be from floor_height() at a point where
 * the disc is opaque: its triangles are flat, the ground between their corners
 * is not. Triangles are larger outwards, and so is the error.
 */
float floor_mesh_error(const struct floor *floor, float x, float z);

/*
 * Computes what a camera sees of level ground. Uneven ground may be anywhere in
 * the picture: it gets no strips and a horizon at the picture's upper edge.
 */
void floor_visible_strips(const struct floor *floor, const struct camera *camera,
	int width, int height, struct floor_strips *out);

/* Draws with the camera's model-view matrix loaded; leaves lighting off. */
void floor_draw(const struct floor *floor, const struct floor_strips *strips,
	const struct gl *gl);

#endif
