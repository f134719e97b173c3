#include "app/compare/measure/sampling.h"

#include "platform/base/scalar.h"

#include <stdbool.h>

/*
 * All moments are compared as long as they have this many vertices together,
 * which takes about half a minute on a PC with two cores.
 */
static const double vertices_most = 3e7;

enum {
	MOMENTS_MIN = 2000, /* half a minute of a clip */
	MOMENTS_MAX = 60000,
	DRAWN_FRAMES = 6,
	/* Of all clips together. */
	NORMALS_TOTAL = 2000, /* if a part of the moments is compared */
	TIMED_TOTAL = 40 * SAMPLING_TIMED_MAX,
	DRAWN_TOTAL = 40 * DRAWN_FRAMES
};

struct sampling sampling_choose(int vertex_count, int clip_count, double moments)
{
	int most = scalar_to_int(
		vertices_most / (double)vertex_count, MOMENTS_MIN, MOMENTS_MAX);

	bool all = moments <= (double)most;

	return (struct sampling){
		.share = all ? 1.0 : (double)most / moments,
		.normal_moments = all
			? SAMPLING_NORMALS_MAX
			: scalar_to_int((double)NORMALS_TOTAL / clip_count, 1,
				  SAMPLING_NORMALS_MAX),
		.timed_frames = scalar_to_int((double)TIMED_TOTAL / clip_count,
			1, SAMPLING_TIMED_MAX),
		.drawn_frames = scalar_to_int(
			(double)DRAWN_TOTAL / clip_count, 1, DRAWN_FRAMES),
	};
}
