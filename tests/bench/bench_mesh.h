/* The meshes of gl_states.c, in eye coordinates. */
#ifndef TESTS_BENCH_BENCH_MESH_H
#define TESTS_BENCH_BENCH_MESH_H

#include <stdint.h>

enum {
	BENCH_WIDTH = 480, /* of the picture */
	BENCH_HEIGHT = 640,
	BENCH_CELLS = 500,
	BENCH_VERTICES_MOST = BENCH_CELLS * 3,
};

enum bench_shape {
	BENCH_QUAD,     /* S1, S2 */
	BENCH_TURNED,   /* S1 turned about Y as well */
	BENCH_CUBE,     /* S4 */
	BENCH_SMALL,    /* S5: w differs by 5 % at most */
	BENCH_SMALL_W,  /* S5s: by 0.15 of depth 4 */
	BENCH_LAYERS,   /* 60 triangles of 120 x 120 */
	BENCH_BACKDROP, /* a quad that faces the eye, all of the screen */
};

struct bench_vertex {
	float position[3], normal[3], texcoord[2];
	uint8_t color[4];
};

struct bench_mesh {
	struct bench_vertex vertex[BENCH_VERTICES_MOST];
	int count;
};

/* Makes the triangles of a shape; three vertices each. */
void bench_mesh_make(struct bench_mesh *mesh, enum bench_shape shape);

#endif
