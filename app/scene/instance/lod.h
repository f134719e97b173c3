/*
 * Level of detail: how many triangles.
 *
 * A model may have coarser lists of triangles (model_lod), each with how far
 * its surface is from the full one's. An instance is drawn by the coarsest ones
 * whose error is too small to see: at most so many pixels where the instance is
 * nearest. The models here state what 99 of 100 points of a surface keep
 * within; the mean is a quarter of that, so a pixel stands for much less than
 * it sounds. Shadows have a list of their own, see shadow_proxy.h. The number
 * of influences of a vertex is limited by influence_cap.h.
 */
#ifndef APP_SCENE_INSTANCE_LOD_H
#define APP_SCENE_INSTANCE_LOD_H

#include "app/scene/stage/camera.h"

enum lod_kind {
	LOD_AUTO,  /* errors of at most LOD_ERROR_PX */
	LOD_ERROR, /* of at most error_px */
	LOD_ALL,   /* every triangle */
	LOD_LEVEL, /* the level of that number, or the last one; 0: all */
};

struct lod {
	enum lod_kind kind;
	float error_px;
	int level;
};

#define LOD_ERROR_PX 1.0f

/* Reads "auto", "off", "level:N" or a number of pixels up to 100. */
bool lod_parse(const char *text, struct lod *out);

/* The same with errors of so many pixels at least; 0: as it is. */
struct lod lod_relax(const struct lod *lod, float least_px);

/*
 * How many pixels a scene unit has where the instance is nearest to the eye,
 * after an update. extent is its largest side.
 */
float lod_px_per_unit(const struct instance *instance,
	const struct camera *camera, float extent, int picture_height);

/*
 * Chooses the lists that the instance is drawn by from now on. What has been
 * chosen stays as long as px_per_unit changes little.
 */
void lod_choose(
	struct instance *instance, const struct lod *lod, float px_per_unit);

/* Triangles of all that is not hidden, as it is drawn. */
long lod_triangles(const struct instance *instance);

#endif
