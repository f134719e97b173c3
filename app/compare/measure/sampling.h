/*
 * How many moments of its clips a comparison looks at.
 *
 * A comparison poses all vertices at each moment, for each technique. Clips of
 * an hour, or hundreds of clips, have more moments than errors, times and
 * drawing need: then a part of them, spread evenly over the clips, is compared.
 */
#ifndef APP_COMPARE_MEASURE_SAMPLING_H
#define APP_COMPARE_MEASURE_SAMPLING_H

#include "app/model/model.h"

enum {
	SAMPLING_TIMED_MAX = 48,   /* frames of a clip */
	SAMPLING_NORMALS_MAX = 500 /* moments of a clip */
};

struct sampling {
	/* The part of the moments that is compared; 1: all of them. */
	double share;
	int normal_moments; /* of each clip, at least 1; normals are compared */
	int timed_frames;
	int drawn_frames;
};

/*
 * How many vertices a pose of the model has: those of a mesh count for each
 * node of the scene that shows it. INT_MAX stands for more.
 */
int sampling_vertices(const struct model *model);

/*
 * At how many moments a model may be posed: their poses have at most usual
 * vertices together, but 2,000 moments, half a minute of clips, may have up to
 * most vertices. May be less than 1.
 */
double sampling_moments(double vertices, double usual, double most);

/* moments are those of the time grids of all clips. */
struct sampling sampling_choose(
	int vertex_count, int clip_count, double moments);

#endif
