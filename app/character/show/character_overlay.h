/*
 * What overlays show of a character.
 */
#ifndef APP_CHARACTER_SHOW_CHARACTER_OVERLAY_H
#define APP_CHARACTER_SHOW_CHARACTER_OVERLAY_H

#include "app/character/character_data.h"
#include "app/scene/overlay/overlay.h"

/* Describes what moves the figure; *out is overlay_motion_none() before. */
void character_overlay_describe(
	const struct character *character, struct overlay_motion *out);

#endif
