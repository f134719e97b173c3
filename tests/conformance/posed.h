/*
 * Reads posed vertices from a reference (JSON) or from the output of
 * `limber pose` (OBJ), and compares them.
 */
#ifndef TESTS_CONFORMANCE_POSED_H
#define TESTS_CONFORMANCE_POSED_H

#include <stddef.h>

/* The vertices of one node and primitive, in the accessor's order. */
struct posed_part {
	char name[64]; /* node<index>_prim<index> */
	size_t count;
	double (*position)[3];
};

struct posed {
	size_t count;
	struct posed_part *part;
};

/* A message that says what is wrong. */
struct posed_error {
	char text[256];
};

/*
 * 0, or -1 with *error filled and *out empty. The caller calls posed_release().
 * An OBJ file may only have comments and o, v and f lines; coordinates must be
 * finite, and faces must be triangles of their own object's vertices.
 */
int posed_read_reference(
	const char *path, struct posed *out, struct posed_error *error);
int posed_read_obj(
	const char *path, struct posed *out, struct posed_error *error);

void posed_release(struct posed *posed);

/* The largest side of the bounding box of all vertices. */
double posed_extent(const struct posed *posed);

/*
 * 0 when both hold the same parts with the same number of vertices and each
 * vertex is within the distance of its reference, component by component.
 * Otherwise -1 with *error filled. *worst becomes the largest difference seen.
 */
int posed_compare(const struct posed *actual, const struct posed *reference,
	double distance, double *worst, struct posed_error *error);

#endif
