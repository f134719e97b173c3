/*
 * Level of detail: how many triangles of a model are drawn.
 *
 * A model may have coarser triangle lists over the same vertices (model_lod),
 * each with its geometric error. An instance is drawn with the coarsest lists
 * whose error is at most a limit in pixels where the instance is nearest to the
 * eye. An error is what 99 of 100 surface points keep within; the mean is a
 * quarter of it. A model whose file has no levels gets them when it is loaded
 * (app/model/levels). Shadows have lists of their own, and influence_cap.h
 * limits the influences of a vertex.
 */
#ifndef APP_SCENE_INSTANCE_LOD_H
#define APP_SCENE_INSTANCE_LOD_H

#include "app/scene/stage/camera.h"

enum lod_kind {
	LOD_AUTO,  /* errors of at most LOD_ERROR_PX */
	LOD_ERROR, /* errors of at most error_px */
	LOD_ALL,   /* every triangle */
	LOD_LEVEL, /* the level of this number or the last one; 0 is the finest */
};

struct lod {
	enum lod_kind kind;
	float error_px;
	int level;
};

#define LOD_ERROR_PX         1.5f
/* A shadow's error may be this many times the limit for its figure. */
#define LOD_SHADOW_TOLERANCE 3.0f
/*
 * Where a side of a pixel covers more texels of a normal map than this, the
 * mean of their normals is nearly the surface's own, and bumps are left out.
 */
#define LOD_BUMP_TEXELS      2.5f

/*
 * Parses "auto", "off", "level:N" or a number of pixels up to 100. Returns
 * false for anything else.
 */
bool lod_parse(const char *text, struct lod *out);

/*
 * Returns the same setting with an error limit of at least min_px; 0 changes
 * nothing. LOD_ALL and LOD_LEVEL are returned unchanged.
 */
struct lod lod_relax(const struct lod *lod, float min_px);

/*
 * Returns the pixels of one scene unit at the depth where the updated instance
 * is nearest to the eye, which is found from its joints and from the boxes
 * around its drawables without a skin. extent is the length of the instance's
 * longest side in scene units.
 */
float lod_px_per_unit(const struct instance *instance,
	const struct camera *camera, float extent, int picture_height);

/* The same at a depth in scene units. */
float lod_px_per_unit_at(
	const struct camera *camera, float depth, int picture_height);

/* The same for a box in scene units, which may not be empty. */
float lod_px_per_unit_of_box(const struct bounds *box,
	const struct camera *camera, int picture_height);

/*
 * Returns the factor that converts the errors of a drawable's levels, which are
 * in the unit of the model's positions, to scene units in the drawable's last
 * pose. That of a skin is at least half of what its largest joint has.
 */
float lod_error_units(
	const struct instance *instance, const struct drawable *drawable);

/*
 * Chooses the triangle lists that draw the instance from now on. To avoid
 * flicker, a change of px_per_unit by less than a tenth is ignored.
 */
void lod_choose(struct instance *instance, const struct lod *setting,
	float px_per_unit);

/* Returns the number of triangles that draw all visible drawables. */
long lod_triangles(const struct instance *instance);

#endif
