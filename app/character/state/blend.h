/*
 * Blending two clips of a state, in fewer instructions than pose_mix().
 */
#ifndef APP_CHARACTER_STATE_BLEND_H
#define APP_CHARACTER_STATE_BLEND_H

#include "app/character/character_data.h"

/* What of a node may differ between the clips of a state. */
enum {
	CHARACTER_DIFFERS_TURN = 1,
	CHARACTER_DIFFERS_PLACE = 2, /* translation or scale */
	CHARACTER_DIFFERS_WEIGHTS = 4
};

/*
 * pose = pose + (other - pose) * t, for what differs. Rotations are mixed
 * linearly and normalised: they lie on the shorter arc, as those of slerp.
 */
void character_blend(struct pose *pose, const struct pose *other, float t,
	const uint8_t *differs);

/* Finds what differs between the clips of a state: [node_count]. */
void character_blend_find(const struct character_state *state,
	const struct model *model, uint8_t *differs);

#endif
