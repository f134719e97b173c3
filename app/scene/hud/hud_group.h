/*
 * Rows of labels, values and bars in a corner of the picture.
 *
 *	hud_begin(&hud, width, height);
 *	group = hud_group_begin(&hud, HUD_TOP_LEFT, "Skeletal");
 *	hud_group_time(&group, "walk", time_s, duration_s, hud_color_blue);
 *	hud_group_weight(&group, "run", weight, hud_color_green);
 *	hud_group_end(&group);
 *	hud_end(&hud, gl);
 *
 * A row has its label at the left, its value at the right and, if it has one,
 * its bar below. All rows are as wide as the group, whose width depends on the
 * picture alone, so that nothing moves while values change. Groups of the
 * same corner stack towards the middle of the picture.
 */
#ifndef APP_SCENE_HUD_HUD_GROUP_H
#define APP_SCENE_HUD_HUD_GROUP_H

#include "app/scene/hud/hud.h"

#include <stdbool.h>

enum hud_corner {
	HUD_TOP_LEFT,
	HUD_TOP_RIGHT,
	HUD_BOTTOM_LEFT,
	HUD_BOTTOM_RIGHT
};

/* A group under way; use one at a time. */
struct hud_group {
	struct hud *hud;
	enum hud_corner corner;
	int left, width; /* of the rows, pixels */
	int y;           /* top of the next row */
	int first_quad;
};

/* Begins a group; the title may be NULL. */
struct hud_group hud_group_begin(
	struct hud *hud, enum hud_corner corner, const char *title);

/* A label and a value; either may be "". Long labels are cut. */
void hud_group_text(
	struct hud_group *group, const char *label, const char *value);

/* The same over a bar filled by a share of 0..1. */
void hud_group_bar(struct hud_group *group, const char *label,
	const char *value, float share, struct hud_color color);

/* "label    0.42 / 1.07 s" over a bar; times up to 9999 s. */
void hud_group_time(struct hud_group *group, const char *label, float time_s,
	float duration_s, struct hud_color color);

/* "label    35%" over a bar; weight 0..1. */
void hud_group_weight(struct hud_group *group, const char *label, float weight,
	struct hud_color color);

/* A label behind a spot of that colour, and a value. */
void hud_group_mark(struct hud_group *group, const char *label,
	const char *value, struct hud_color color);

/*
 * Room of that height for the caller to fill, as wide as the rows, from
 * group.left on; returns its top. It moves with the group until it ends.
 */
int hud_group_space(struct hud_group *group, int height);

/* A key's cap and what it does. */
void hud_group_key(struct hud_group *group, const char *key, const char *what);

/* A key's cap, what it switches, and whether that is on. */
void hud_group_switch(struct hud_group *group, const char *key,
	const char *what, bool on, struct hud_color color);

/* Places the group and its backdrop. */
void hud_group_end(struct hud_group *group);

#endif
