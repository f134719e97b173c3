/*
 * Names of a model or a character file, as labels show them.
 *
 * The font has no letters but Latin ones. Names in other scripts would all be
 * rows of the same box, so that labels show a number in their place.
 */
#ifndef APP_SCENE_HUD_HUD_NAME_H
#define APP_SCENE_HUD_HUD_NAME_H

enum {
	HUD_NAME_BYTES = 48
};

/*
 * Returns the name. If it is empty, or if the font lacks more than half of its
 * characters other than blanks, writes the kind and the number, as in "clip 3",
 * and returns out.
 */
const char *hud_name(const char *name, const char *kind, int number,
	char out[HUD_NAME_BYTES]);

#endif
