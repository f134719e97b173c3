#include "app/compare/measure/sampling.h"

#include "platform/base/scalar.h"

#include <limits.h>
#include <stdbool.h>

/*
 * All moments are compared as long as they have this many vertices together,
 * which takes about half a minute on a PC with two cores. Half a minute of
 * clips may have vertices_most, as that of a model of 65,000 vertices.
 */
static const double vertices_usual = 3e7, vertices_most = 1.3e8;
/* Normals take longest. */
static const double normals_most = 4e7;

enum {
	MOMENTS_MIN = 2000, /* half a minute of a clip */
	MOMENTS_MAX = 60000,
	DRAWN_FRAMES = 6,
	/* Of all clips together. */
	NORMALS_TOTAL = 2000, /* if a part of the moments is compared */
	TIMED_TOTAL = 40 * SAMPLING_TIMED_MAX,
	DRAWN_TOTAL = 40 * DRAWN_FRAMES
};

int sampling_vertices(const struct model *model)
{
	double count = 0.0;

	for (int n = 0; n < model->node_count; n++) {
		const struct model_node *node = &model->node[n];
		const struct model_mesh *mesh = model_node_shows_mesh(node)
			? &model->mesh[node->mesh]
			: NULL;

		for (int p = 0; mesh && p < mesh->primitive_count; p++) {
			count += (double)mesh->primitive[p].vertex_count;
		}
	}
	return scalar_to_int(count, 0, INT_MAX);
}

double sampling_moments(double vertices, double usual, double most)
{
	double least = most / vertices;

	least = least < MOMENTS_MIN ? least : MOMENTS_MIN;
	return usual / vertices > least ? usual / vertices : least;
}

struct sampling sampling_choose(int vertex_count, int clip_count, double moments)
{
	int most = scalar_to_int(sampling_moments((double)vertex_count,
					 vertices_usual, vertices_most),
		1, MOMENTS_MAX);
	int normals = scalar_to_int(
		normals_most / (double)vertex_count, 1, NORMALS_TOTAL);
	bool all = moments <= (double)most;

	return (struct sampling){
		.share = all ? 1.0 : (double)most / moments,
		.normal_moments = all
			? SAMPLING_NORMALS_MAX
			: scalar_to_int((double)normals / clip_count, 1,
				  SAMPLING_NORMALS_MAX),
		.timed_frames = scalar_to_int((double)TIMED_TOTAL / clip_count,
			1, SAMPLING_TIMED_MAX),
		.drawn_frames = scalar_to_int(
			(double)DRAWN_TOTAL / clip_count, 1, DRAWN_FRAMES),
	};
}
