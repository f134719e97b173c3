/*
 * The space that a character takes, for the camera.
 */
#ifndef APP_DEMO_VIEWER_BEHAVIOUR_BOUNDS_H
#define APP_DEMO_VIEWER_BEHAVIOUR_BOUNDS_H

#include "app/character/character_data.h"
#include "app/scene/instance/bounds.h"

/*
 * Returns the box, in scene units, of all that the model's clips, the morphs,
 * the parts' shifts and the targets' balls reach. What goes so far that the
 * model would be less than half as large in the picture is left out. Leaves the
 * instance in the rest pose.
 */
struct bounds behaviour_bounds(const struct character *character);

/* What a number of the file can be: a parameter's range, or what it is. */
void behaviour_range(const struct character *character, const float *value,
	float *low, float *high);

#endif
