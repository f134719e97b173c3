/*
 * The order of an instance's blended surfaces. One that is blended shows what
 * was drawn before it, so surfaces behind it have to be drawn first.
 */
#ifndef APP_SCENE_DRAW_ALPHA_H
#define APP_SCENE_DRAW_ALPHA_H

#include "app/scene/instance/instance_data.h"

/*
 * Lists the drawables whose alpha is MODEL_BLEND in instance.blended, which has
 * room for all drawables, in the model's order.
 */
void alpha_list_blended(struct instance *instance);

/*
 * Sorts instance.blended for an eye in scene units, in the instance's own
 * space: drawables whose middle is far come first, and equally far ones stay in
 * the model's order. The middle is that of the box around a drawable, or of a
 * few of its vertices if these are skinned. Call it after an update.
 */
void alpha_sort_blended(struct instance *instance, const float eye[3]);

#endif
