/*
 * Names of a model or a character file, as labels show them.
 *
 * The font has no letters but Latin ones. Names in other scripts would all be
 * rows of the same box, so that labels show a number in their place.
 */
#ifndef APP_SCENE_HUD_HUD_NAME_H
#define APP_SCENE_HUD_HUD_NAME_H

#include <stdbool.h>

enum {
	HUD_NAME_BYTES = 48
};

/*
 * Returns true if the font has at least half of the characters of a name or a
 * sentence other than blanks, and if there are some.
 */
bool hud_is_readable(const char *name);

/*
 * Returns the name without namespaces, which end in ':' or '|' before a letter:
 * exporters give all names of a file the same ones, as in "mixamorig:LeftArm"
 * or "Armature|walk", and a label has no room for them. If it is empty, or if
 * the font lacks more than half of its characters other than blanks, writes the
 * kind and the number, as in "clip 3", and returns out.
 */
const char *hud_name(const char *name, const char *kind, int number,
	char out[HUD_NAME_BYTES]);

#endif
