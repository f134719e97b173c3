/* Boxes that tests of the camera frame. */
#ifndef TESTS_UNIT_APP_SCENE_STAGE_BOX_H
#define TESTS_UNIT_APP_SCENE_STAGE_BOX_H

#include "app/scene/instance/bounds.h"

static inline struct bounds box(float x, float y, float z)
{
	return (struct bounds){.low = {-x, 0.0f, -z}, .high = {x, y, z}};
}

#endif
