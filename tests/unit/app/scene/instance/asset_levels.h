/*
 * The models in assets/ with their levels of detail.
 */
#ifndef TESTS_UNIT_APP_SCENE_INSTANCE_ASSET_LEVELS_H
#define TESTS_UNIT_APP_SCENE_INSTANCE_ASSET_LEVELS_H

#include "app/model/levels/levels.h"
#include "app/model/model.h"
#include "tests/support/test.h"

static const char *const assets[] = {
	"assets/walker.glb", "assets/face.glb", "assets/arm.glb"};

static inline struct model *load(const char *path)
{
	struct log nowhere = log_to_nowhere();
	struct model *model;

	assert_int_equal(model_load(path, &nowhere, &model), 0);
	/* Files have no levels of meshes with morph targets. */
	assert_int_equal(levels_make(model), 0);
	return model;
}

#endif
