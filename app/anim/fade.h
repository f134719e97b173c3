/*
 * A cross-fade from the pose that was shown when it began.
 *
 * It keeps a copy of that pose and no clip. So it may begin at any moment, also
 * during another fade and also onto the clip that is already playing.
 */
#ifndef APP_ANIM_FADE_H
#define APP_ANIM_FADE_H

#include "app/anim/ease.h"
#include "app/anim/pose.h"

struct fade {
	struct pose from;
	enum ease ease;
	float duration_s;
	float elapsed_s;
	bool running;
};

/* Allocates the copy of the pose. 0 or -ENOMEM. */
int fade_init(struct fade *fade, const struct model *model, struct arena *arena);

/*
 * Starts from the pose that is shown now. With a duration of 0 or less the next
 * update ends it.
 */
void fade_begin(struct fade *fade, const struct pose *shown, float duration_s,
	enum ease ease);

/*
 * Advances by step_s and mixes the copy into pose, less and less until
 * duration_s has passed; after that it leaves pose alone. Returns true while
 * the fade runs.
 */
bool fade_update(struct fade *fade, float step_s, struct pose *pose);

#endif
