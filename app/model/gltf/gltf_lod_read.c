#include "app/model/gltf/gltf_internal.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <float.h>
#include <math.h>

/*
 * A screen coverage c is converted to the error side / 640 / sqrt(c). This
 * error is one pixel if the mesh covers the fraction c of a screen of 640 x 640
 * pixels.
 */
static const double coverage_px = 640.0;

static float largest_side(const struct model_mesh *mesh)
{
	float low[3] = {FLT_MAX, FLT_MAX, FLT_MAX};
	float high[3] = {-FLT_MAX, -FLT_MAX, -FLT_MAX};
	float largest = 0;
	int p, v, k;

	for (p = 0; p < mesh->primitive_count; p++) {
		const struct model_primitive *primitive = &mesh->primitive[p];

		for (v = 0; v < primitive->vertex_count; v++) {
			for (k = 0; k < 3; k++) {
				float at = primitive->position[v][k];

				low[k] = scalar_min(at, low[k]);
				high[k] = scalar_max(at, high[k]);
			}
		}
	}
	for (k = 0; k < 3; k++) {
		largest =
			high[k] - low[k] > largest ? high[k] - low[k] : largest;
	}
	return largest;
}

static float error_of(
	const struct gltf_level *level, const struct model_mesh *mesh)
{
	double side = (double)largest_side(mesh);

	return level->error_m > 0.0f
		? level->error_m
		: (float)(side / coverage_px / sqrt((double)level->coverage));
}

/* Returns a level's place: the finest first, those for shadows last. */
static int sorted_index(
	const struct model_primitive *primitive, const struct model_lod *lod)
{
	int index = primitive->lod_count;

	while (index > 0) {
		const struct model_lod *before = &primitive->lod[index - 1];

		if (before->shadow_only == lod->shadow_only
				? before->error_m <= lod->error_m
				: lod->shadow_only) {
			break;
		}
		index--;
	}
	return index;
}

static int read_level(const struct gltf_at *mesh, int count,
	struct model_primitive *primitive, struct model_lod *level)
{
	struct gltf_at array = gltf_member(mesh, "primitives");
	struct gltf_at at = gltf_element(&array, primitive->file_index);
	int index;
	int error = gltf_read_triangles(&at, primitive->vertex_count,
		&level->index, &level->index_count);

	if (!error && !primitive->lod) {
		primitive->lod = GLTF_KEEP(&at, struct model_lod, count);
		error = primitive->lod ? 0 : -ENOMEM;
	}
	if (error) {
		return error;
	}
	index = sorted_index(primitive, level);
	for (int i = primitive->lod_count++; i > index; i--) {
		primitive->lod[i] = primitive->lod[i - 1];
	}
	primitive->lod[index] = *level;
	return 0;
}

static int read_mesh_level(const struct gltf_at *at, int count,
	const struct gltf_level *level, struct model_mesh *mesh)
{
	struct model_lod lod = {
		.error_m = error_of(level, mesh),
		.shadow_only = level->shadow_only,
	};
	int error = 0;
	int i;

	for (i = 0; i < mesh->primitive_count && !error; i++) {
		error = read_level(at, count, &mesh->primitive[i], &lod);
	}
	return error;
}

int gltf_read_levels(struct gltf *gltf, int mesh)
{
	struct gltf_at array = gltf_member(&gltf->root, "meshes");
	struct model_mesh *out = &gltf->model->mesh[gltf->mesh_index[mesh]];
	int error = 0;
	int i;

	for (i = gltf->level[mesh].first; i >= 0 && !error;
		i = gltf->level[i].next) {
		struct gltf_at at = gltf_element(&array, i);

		error = read_mesh_level(
			&at, gltf->level[mesh].count, &gltf->level[i], out);
		gltf_drop_element(gltf, "meshes", i);
	}
	return error;
}
