/*
 * Groups of labels, values and bars in the corners of the picture.
 *
 *	hud_begin(&hud, width, height);
 *	group = hud_group_begin(&hud, HUD_TOP_LEFT, "Skeletal");
 *	hud_group_time(&group, "walk", time_s, duration_s, hud_color_blue);
 *	hud_group_weight(&group, "run", weight, hud_color_green);
 *	hud_group_end(&group);
 *	hud_end(&hud, gl);
 *
 * Each call adds one row: a label at the left, a value at the right and, for
 * some, a bar below. All rows are as wide as the group, whose width depends
 * only on the picture's. Nothing therefore moves while values change. Groups
 * in the same corner stack towards the middle of the picture.
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

/* Where labels go: a corner, and the height that figures leave free there. */
struct hud_place {
	enum hud_corner corner;
	int room; /* pixels */
};

/* A group between its begin and end. Only one may be open at a time. */
struct hud_group {
	struct hud *hud;
	enum hud_corner corner;
	int left, width; /* of the rows, pixels */
	int y;           /* top of the next row */
	int rows_left;   /* rows that may still be added */
	int room;        /* height that the group may take, pixels */
	int first_quad;
};

/* The part of a picture that groups take, in pixels from its left and top. */
struct hud_group_extent {
	int column; /* width of the groups in a left corner */
	int top;    /* height of a group in a top corner */
	int line;   /* height of a line of text */
	int em;     /* size of the typeface */
	/* of a wide group of keys without a title */
	int list_width, list_height;
};

/*
 * Returns what groups take of a picture of this size. The group in the top
 * corner has a title and this number of rows, of which bars have a bar; a list
 * of keys has as many rows.
 */
struct hud_group_extent hud_group_extent_of(
	int width, int height, int rows, int bars);

enum {
	HUD_GROUP_ROWS_NARROW = 4
};

/*
 * Returns how many rows a group shows at most in a picture of this size;
 * further rows are left out. In a picture less than twice as wide as a group,
 * figures have no room beside the labels. A group is then limited to
 * HUD_GROUP_ROWS_NARROW rows, or to fewer that leave figures the lower half of
 * the picture. If not even one row does so, or a group has less room than two
 * and a half ems for texts, the result is 0, and groups are not shown.
 */
int hud_group_rows_max(int width, int height);

/*
 * Returns true if a list of keys replaces the other groups: in a picture so
 * narrow that figures would have no room between the list and the groups.
 */
bool hud_group_list_is_alone(int width, int height);

/* Begins a group; the title may be NULL. */
struct hud_group hud_group_begin(
	struct hud *hud, enum hud_corner corner, const char *title);

/* The same, twice as wide if the picture is wide enough: for sentences. */
struct hud_group hud_group_begin_wide(
	struct hud *hud, enum hud_corner corner, const char *title);

/*
 * Widens a group in a left corner, by at most a quarter, so that the row of
 * this switch (hud_group_switch()) is not cut. Call it for all switches of the
 * group before the first row is added.
 */
void hud_group_widen(struct hud_group *group, const char *key, const char *what);

/* Leaves out rows with which group and margins would exceed this height. */
void hud_group_limit(struct hud_group *group, int height);

/* Returns true if this number of rows and a space of this height still fit. */
bool hud_group_fits(const struct hud_group *group, int rows, int space);

/*
 * Adds a label and a value; either may be "". A long label is cut. A row that
 * would end beyond the picture is left out. That holds for all kinds of rows
 * except spaces and switches.
 */
void hud_group_text(
	struct hud_group *group, const char *label, const char *value);

/* Adds a label and a value above a bar; the fraction is clamped to 0..1. */
void hud_group_bar(struct hud_group *group, const char *label,
	const char *value, float fraction, struct hud_color color);

/*
 * Adds "label    0.42 / 1.07 s" above a bar; times are clamped to 0..9999 s.
 * Beside a long label it leaves out the duration and, if that is not enough,
 * also the time, which the bar shows anyway.
 */
void hud_group_time(struct hud_group *group, const char *label, float time_s,
	float duration_s, struct hud_color color);

/* Adds "label    35%" above a bar; the weight is clamped to 0..1. */
void hud_group_weight(struct hud_group *group, const char *label, float weight,
	struct hud_color color);

/* Adds a coloured dot, a label and a value. */
void hud_group_mark(struct hud_group *group, const char *label,
	const char *value, struct hud_color color);

/*
 * Reserves a row of this height for the caller to draw in, group->width wide
 * from group->left, and returns its top. hud_group_end() moves what was drawn
 * together with the group.
 */
int hud_group_space(struct hud_group *group, int height);

/*
 * Adds a picture of a key and what the key does, if it fits below the last row.
 */
void hud_group_key(struct hud_group *group, const char *key, const char *what);

/*
 * Adds a picture of a key, what the key switches, and a switch on or off, if
 * they fit below the last row.
 */
void hud_group_switch(struct hud_group *group, const char *key,
	const char *what, bool on, struct hud_color color);

/* Moves the group with its panel to its place in the corner. */
void hud_group_end(struct hud_group *group);

/* A state of the display to which hud_go_back() can return. */
struct hud_mark {
	int quad_count;
	int stacked_px[HUD_CORNERS];
};

struct hud_mark hud_mark(const struct hud *hud);

/* Removes all elements that were added since the mark. */
void hud_go_back(struct hud *hud, const struct hud_mark *mark);

/* Returns true if the groups of a top corner overlap those below it. */
bool hud_groups_overlap(const struct hud *hud);

#endif
