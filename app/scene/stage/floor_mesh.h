/*
 * The part of uneven ground that a camera sees, as a mesh.
 *
 * Its rows and columns are regular in the picture, the rows denser towards the
 * horizon, so that triangles are about equally large wherever the camera is,
 * and none is out of view. Like the strips of level ground, the near rows are
 * opaque and the far ones fade out.
 */
#ifndef APP_SCENE_STAGE_FLOOR_MESH_H
#define APP_SCENE_STAGE_FLOOR_MESH_H

#include "app/scene/instance/bounds.h"
#include "app/scene/stage/camera.h"

enum {
	FLOOR_OPAQUE_ROWS = 12,
	FLOOR_FADING_ROWS = 3,
	FLOOR_ROWS = FLOOR_OPAQUE_ROWS + FLOOR_FADING_ROWS,
	FLOOR_COLUMNS = 4,
	FLOOR_VERTICES = (FLOOR_ROWS + 1) * (FLOOR_COLUMNS + 1),
	FLOOR_FADING_INDICES = FLOOR_FADING_ROWS * FLOOR_COLUMNS * 6,
	FLOOR_OPAQUE_INDICES = FLOOR_OPAQUE_ROWS * FLOOR_COLUMNS * 6,
	FLOOR_INDICES = FLOOR_FADING_INDICES + FLOOR_OPAQUE_INDICES,
	FLOOR_RUNS_MAX = 2 * FLOOR_ROWS,
};

struct floor_mesh {
	bool seen;                         /* the rest is valid */
	float position[FLOOR_VERTICES][3]; /* scene units */
	uint8_t alpha[FLOOR_VERTICES];
};

/* Where the ground is; lengths are in scene units. */
struct floor_mesh_ground {
	float y;           /* the height of level ground */
	float wave_height; /* greatest distance from y */
	/* Level distances from the eye to where ground fades, and ends. */
	float opaque_end, end;
};

/*
 * Where the things are that are drawn after the ground and tested against its
 * depths: in these two boxes, each of which may be empty, or, if bounded is
 * false, anywhere.
 */
struct floor_content {
	bool bounded;
	struct bounds standing; /* in eye space */
	struct bounds lying;    /* on the ground, in scene units */
};

/* Triangles of the index that are drawn in one call. */
struct floor_run {
	int index_count;
	bool fading;
	/* their depths are written, because content may need them */
	bool with_depth;
};

/* All triangles of the mesh in drawing order, far rows first. */
struct floor_order {
	int run_count, index_count;
	struct floor_run run[FLOOR_RUNS_MAX];
	uint16_t index[FLOOR_INDICES];
};

/*
 * Computes the vertices of the level mesh. It is so large that it still covers
 * what the camera sees when vertices move up or down by at most wave_height. A
 * camera in or under the waves may see the mesh's near edge.
 */
void floor_mesh_find(struct floor_mesh *mesh, const struct camera *camera,
	int width, int height, const struct floor_mesh_ground *ground);

/*
 * Writes the mesh's index, far rows first: in this order near hills cover what
 * is behind them without a depth test. The fading rows are thus first.
 */
void floor_mesh_list(uint16_t index[FLOOR_INDICES]);

/*
 * Returns true if a hill may hide, from the eye, a part of what lies on the
 * ground in a box. A hill that hides something has a triangle that faces away
 * from the eye, so it looks for such a triangle that is neither beyond the box
 * nor beside it. The mesh must have the ground's heights.
 */
bool floor_mesh_may_hide(const struct floor_mesh *mesh,
	const uint16_t index[FLOOR_INDICES], const float eye[3],
	const struct bounds *box);

/*
 * Orders the triangles of floor_mesh_list() for drawing; the mesh must have the
 * ground's heights. Triangles whose picture does not overlap that of the
 * content are drawn without writing depths. The lying content counts only if a
 * hill may hide a part of it.
 */
void floor_mesh_order(const struct floor_mesh *mesh,
	const uint16_t index[FLOOR_INDICES], const struct camera *camera,
	const struct floor_content *content, struct floor_order *out);

#endif
