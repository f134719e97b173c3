/* The meshes of gl_states.c, in eye coordinates. */
#ifndef TESTS_BENCH_STATES_MESH_H
#define TESTS_BENCH_STATES_MESH_H

#include <stdint.h>

enum {
	STATES_WIDTH = 480, /* of the picture */
	STATES_HEIGHT = 640,
	STATES_CELLS = 500,
	STATES_VERTICES_MOST = STATES_CELLS * 3,
};

enum states_shape {
	STATES_QUAD,     /* S1, S2 */
	STATES_TURNED,   /* S1 turned about Y as well */
	STATES_CUBE,     /* S4 */
	STATES_SMALL,    /* S5: w differs by 5 % at most */
	STATES_SMALL_W,  /* S5s: by 0.15 of depth 4 */
	STATES_LAYERS,   /* 60 triangles of 120 x 120 */
	STATES_BACKDROP, /* a quad that faces the eye, all of the screen */
};

struct states_vertex {
	float position[3], normal[3], texcoord[2];
	uint8_t color[4];
};

struct states_mesh {
	struct states_vertex vertex[STATES_VERTICES_MOST];
	int count;
};

/* Makes the triangles of a shape; three vertices each. */
void states_mesh_make(struct states_mesh *mesh, enum states_shape shape);

#endif
