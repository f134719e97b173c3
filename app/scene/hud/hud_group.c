#include "app/scene/hud/hud_group.h"

#include "platform/base/scalar.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

/* Lengths in eighths of an em; TEXT_SIZE counts bytes. */
enum {
	WIDTH_MIN = 88,
	WIDTH_MAX = 104,
	MARGIN = 6, /* from the edge of the picture, and between groups */
	PADDING_X = 5,
	PADDING_Y = 4,
	RADIUS = 3,
	ROW_GAP = 2,
	TITLE_GAP = 2,
	BAR_GAP = 1,
	BAR_HEIGHT = 2,
	COLUMN_GAP = 4,
	CAP_PADDING_X = 2,
	CAP_WIDTH_MIN = 20,
	CAP_RADIUS = 2,
	SWITCH_WIDTH = 12,
	SWITCH_HEIGHT = 6,
	KNOB_INSET = 1,
	MARK_SIDE = 4,
	MARK_GAP = 3,
	TEXT_LEAST = 20, /* a narrower text is little more than an ellipsis */
	TEXT_SIZE = 32
};

static const struct hud_color cap_color = {255, 255, 255, 40};
static const struct hud_color rule_color = {255, 255, 255, 36};
static const struct hud_color off_color = {255, 255, 255, 56};
static const struct hud_color off_knob = {196, 204, 214, 255};

static int eighths(const struct hud *hud, int count)
{
	int pixels = hud_em(hud) * count / 8;

	return pixels < 1 ? 1 : pixels;
}

static bool is_right(enum hud_corner corner)
{
	return corner == HUD_TOP_RIGHT || corner == HUD_BOTTOM_RIGHT;
}

static bool is_bottom(enum hud_corner corner)
{
	return corner == HUD_BOTTOM_LEFT || corner == HUD_BOTTOM_RIGHT;
}

/* The panel's width: three eighths of the picture's, within text's limits. */
static int width_for(int picture_width, int em)
{
	int min = em * WIDTH_MIN / 8, max = em * WIDTH_MAX / 8;
	int available = picture_width - 2 * (em * MARGIN / 8);
	int width = picture_width * 3 / 8;

	width = width < min ? min : width > max ? max : width;
	return width < available ? width : available;
}

static int group_width(const struct hud *hud)
{
	return width_for(hud->width, hud_em(hud));
}

/* The panel's width in a group of sentences: twice that, within the picture. */
static int wide_width_for(int picture_width, int em)
{
	int whole = picture_width - 2 * (em * MARGIN / 8);
	int width = 2 * width_for(picture_width, em);

	return width < whole ? width : whole;
}

struct hud_group_extent hud_group_extent_of(
	int width, int height, int rows, int bars)
{
	int scale;
	const struct font_face *face =
		hud_face_for(&font_default, height, &scale);
	int em = face->size * scale, line = face->line_height * scale;
	int row = line + em * ROW_GAP / 8;
	int bar = em * (BAR_GAP + BAR_HEIGHT + ROW_GAP) / 8;

	return (struct hud_group_extent){
		.column = width_for(width, em) + 2 * (em * MARGIN / 8),
		.top = line + rows * row + bars * bar +
			em * (2 * PADDING_Y + 2 * TITLE_GAP + 2 * MARGIN) / 8,
		.line = line,
		.em = em,
		.list_width = wide_width_for(width, em) + 2 * (em * MARGIN / 8),
		.list_height =
			rows * row + em * (2 * PADDING_Y + 2 * MARGIN) / 8,
	};
}

bool hud_group_list_is_alone(int width, int height)
{
	return width < 4 * hud_group_extent_of(width, height, 0, 0).column;
}

static bool is_too_narrow(int width, int height)
{
	int scale;
	const struct font_face *face =
		hud_face_for(&font_default, height, &scale);
	int em = face->size * scale;

	return width_for(width, em) < em * (TEXT_LEAST + 2 * PADDING_X) / 8;
}

int hud_group_rows_max(int width, int height)
{
	int rows = HUD_GROUP_ROWS_NARROW;

	if (is_too_narrow(width, height)) {
		return 0;
	}
	if (width >= 2 * hud_group_extent_of(width, height, 0, 0).column) {
		return INT_MAX;
	}
	while (rows > 0 &&
		2 * hud_group_extent_of(width, height, rows, rows).top > height) {
		rows--;
	}
	return rows;
}

/* Adds the panel behind the rows, wider than they are by the padding. */
static void add_panel(const struct hud_group *group, int y, int height)
{
	const struct hud *hud = group->hud;
	int padding = eighths(hud, PADDING_X);

	hud_panel(group->hud, group->left - padding, y,
		group->width + 2 * padding, height, eighths(hud, RADIUS),
		hud_color_panel);
}

static struct hud_group begin(
	struct hud *hud, enum hud_corner corner, const char *title, int width)
{
	int margin = eighths(hud, MARGIN), padding = eighths(hud, PADDING_X);
	struct hud_group group = {.hud = hud,
		.corner = corner,
		.y = eighths(hud, PADDING_Y),
		.rows_left = hud_group_rows_max(hud->width, hud->height),
		.room = hud->height - 2 * margin - hud->stacked_px[corner],
		.first_quad = hud->quad_count};

	group.width = width - 2 * padding;
	group.left = is_right(corner) ? hud->width - margin - width + padding
				      : margin + padding;
	/* Reserves the quads below the rows until the height is known. */
	add_panel(&group, 0, hud->height);
	if (title) {
		hud_text_shorten(hud, group.left, group.y, group.width,
			hud_color_text, title);
		group.y += hud_line_height(hud) + eighths(hud, TITLE_GAP);
		hud_rectangle(hud, group.left, group.y, group.width, hud->scale,
			rule_color);
		group.y += hud->scale + eighths(hud, TITLE_GAP);
	}
	return group;
}

struct hud_group hud_group_begin(
	struct hud *hud, enum hud_corner corner, const char *title)
{
	return begin(hud, corner, title, group_width(hud));
}

struct hud_group hud_group_begin_wide(
	struct hud *hud, enum hud_corner corner, const char *title)
{
	return begin(
		hud, corner, title, wide_width_for(hud->width, hud_em(hud)));
}

void hud_group_limit(struct hud_group *group, int height)
{
	int room = height - 2 * eighths(group->hud, MARGIN);

	if (room < group->room) {
		group->room = room;
	}
}

/* Adds right-aligned text and returns its left edge. */
static int add_value(const struct hud_group *group, const char *value)
{
	int width = hud_text_width(group->hud, value);
	int x = group->left + group->width - width;

	x = x < group->left ? group->left : x;
	hud_text_shorten(
		group->hud, x, group->y, group->width, hud_color_text, value);
	return x;
}

static void add_line_from(const struct hud_group *group, int x,
	const char *label, const char *value)
{
	int right = add_value(group, value);

	if (*value) {
		right -= eighths(group->hud, COLUMN_GAP);
	}
	hud_text_shorten(
		group->hud, x, group->y, right - x, hud_color_dim, label);
}

static void add_line(
	const struct hud_group *group, const char *label, const char *value)
{
	add_line_from(group, group->left, label, value);
}

bool hud_group_fits(const struct hud_group *group, int rows, int space)
{
	const struct hud *hud = group->hud;
	int row = hud_line_height(hud) +
		eighths(hud, BAR_GAP + BAR_HEIGHT + PADDING_Y);

	return group->y + rows * row + space <= group->room &&
		group->rows_left >= rows;
}

/* Returns true if another row fits, and counts that row as added. */
static bool take_row(struct hud_group *group)
{
	return hud_group_fits(group, 1, 0) && group->rows_left-- > 0;
}

static void next_row(struct hud_group *group, int height)
{
	group->y += height + eighths(group->hud, ROW_GAP);
}

void hud_group_text(
	struct hud_group *group, const char *label, const char *value)
{
	if (!take_row(group)) {
		return;
	}
	add_line(group, label, value);
	next_row(group, hud_line_height(group->hud));
}

void hud_group_bar(struct hud_group *group, const char *label,
	const char *value, float fraction, struct hud_color color)
{
	const struct hud *hud = group->hud;
	int below = hud_line_height(hud) + eighths(hud, BAR_GAP);
	int height = eighths(hud, BAR_HEIGHT);

	if (!take_row(group)) {
		return;
	}
	add_line(group, label, value);
	hud_bar(group->hud, group->left, group->y + below, group->width, height,
		fraction, color);
	next_row(group, below + height + eighths(hud, ROW_GAP));
}

static int hundredths(float value, float limit)
{
	return (int)(scalar_clamp(value, 0.0f, limit) * 100.0f + 0.5f);
}

/*
 * Returns true if the label fits beside a value of this text without being cut.
 */
static bool is_whole(
	const struct hud_group *group, const char *label, const char *value)
{
	const struct hud *hud = group->hud;

	return !*label ||
		hud_text_width(hud, label) + eighths(hud, COLUMN_GAP) +
			hud_text_width(hud, value) <=
		group->width;
}

/* Tries the longest time, so that the text does not change as time runs. */
void hud_group_time(struct hud_group *group, const char *label, float time_s,
	float duration_s, struct hud_color color)
{
	int time = hundredths(time_s, 9999.0f);
	int all = hundredths(duration_s, 9999.0f);
	char value[TEXT_SIZE], widest[TEXT_SIZE];

	snprintf(widest, sizeof(widest), "%d.%02d / %d.%02d s", all / 100,
		all % 100, all / 100, all % 100);
	snprintf(value, sizeof(value), "%d.%02d / %d.%02d s", time / 100,
		time % 100, all / 100, all % 100);
	if (!is_whole(group, label, widest)) {
		snprintf(widest, sizeof(widest), "%d.%02d s", all / 100,
			all % 100);
		snprintf(value, sizeof(value), "%d.%02d s", time / 100,
			time % 100);
		value[is_whole(group, label, widest) ? strlen(value) : 0] = 0;
	}
	hud_group_bar(group, label, value,
		duration_s > 0.0f ? time_s / duration_s : 0.0f, color);
}

void hud_group_weight(struct hud_group *group, const char *label, float weight,
	struct hud_color color)
{
	char value[TEXT_SIZE];

	snprintf(value, sizeof(value), "%d%%", hundredths(weight, 1.0f));
	hud_group_bar(group, label, value, weight, color);
}

static int cap_width(const struct hud *hud, const char *key)
{
	int min = eighths(hud, CAP_WIDTH_MIN);
	int width = hud_text_width(hud, key) + 2 * eighths(hud, CAP_PADDING_X);

	return width < min ? min : width;
}

void hud_group_widen(struct hud_group *group, const char *key, const char *what)
{
	const struct hud *hud = group->hud;
	int standard = group_width(hud) - 2 * eighths(hud, PADDING_X);
	int wanted = cap_width(hud, key) + hud_text_width(hud, what) +
		eighths(hud, SWITCH_WIDTH) + 2 * eighths(hud, COLUMN_GAP);

	wanted = wanted < standard * 5 / 4 ? wanted : standard * 5 / 4;
	group->width = wanted > group->width ? wanted : group->width;
}

/* Draws a key's cap and returns the x where the text after it begins. */
static int add_cap(const struct hud_group *group, const char *key)
{
	struct hud *hud = group->hud;
	int text = hud_text_width(hud, key);
	int width = cap_width(hud, key);

	hud_panel(hud, group->left, group->y, width, hud_line_height(hud),
		eighths(hud, CAP_RADIUS), cap_color);
	hud_text(hud, group->left + (width - text) / 2, group->y,
		hud_color_text, key);
	return group->left + width + eighths(hud, COLUMN_GAP);
}

void hud_group_mark(struct hud_group *group, const char *label,
	const char *value, struct hud_color color)
{
	struct hud *hud = group->hud;
	int side = eighths(hud, MARK_SIDE);
	int top = group->y + (hud_line_height(hud) - side) / 2;

	if (!take_row(group)) {
		return;
	}
	hud_panel(hud, group->left, top, side, side, side / 2, color);
	add_line_from(group, group->left + side + eighths(hud, MARK_GAP), label,
		value);
	next_row(group, hud_line_height(hud));
}

int hud_group_space(struct hud_group *group, int height)
{
	int top = group->y;

	next_row(group, height);
	return top;
}

/* Returns true if a row of a key fits below the last row. */
static bool has_room_for_key(const struct hud_group *group)
{
	const struct hud *hud = group->hud;

	return group->y + hud_line_height(hud) + eighths(hud, PADDING_Y) <=
		group->room;
}

void hud_group_key(struct hud_group *group, const char *key, const char *what)
{
	int x;

	if (!has_room_for_key(group)) {
		return;
	}
	x = add_cap(group, key);
	hud_text_shorten(group->hud, x, group->y,
		group->left + group->width - x, hud_color_dim, what);
	next_row(group, hud_line_height(group->hud));
}

void hud_group_switch(struct hud_group *group, const char *key,
	const char *what, bool on, struct hud_color color)
{
	struct hud *hud = group->hud;
	int x, width = eighths(hud, SWITCH_WIDTH);
	int height = eighths(hud, SWITCH_HEIGHT);
	int inset = eighths(hud, KNOB_INSET), knob = height - 2 * inset;
	int left = group->left + group->width - width;
	int top = group->y + (hud_line_height(hud) - height) / 2;

	if (!has_room_for_key(group)) {
		return;
	}
	x = add_cap(group, key);
	hud_text_shorten(hud, x, group->y, left - eighths(hud, COLUMN_GAP) - x,
		on ? hud_color_text : hud_color_dim, what);
	hud_panel(hud, left, top, width, height, height / 2,
		on ? color : off_color);
	hud_panel(hud, on ? left + width - inset - knob : left + inset,
		top + inset, knob, knob, knob / 2,
		on ? hud_color_text : off_knob);
	next_row(group, hud_line_height(hud));
}

void hud_group_end(struct hud_group *group)
{
	struct hud *hud = group->hud;
	int *stacked = &hud->stacked_px[group->corner];
	int margin = eighths(hud, MARGIN);
	int height = group->y - eighths(hud, ROW_GAP) + eighths(hud, PADDING_Y);
	int y = is_bottom(group->corner)
		? hud->height - margin - *stacked - height
		: margin + *stacked;
	int end = hud->quad_count;

	hud->quad_count = group->first_quad;
	if (hud_group_rows_max(hud->width, hud->height) == 0) {
		return;
	}
	add_panel(group, 0, height);
	hud->quad_count = end;
	hud_move(hud, group->first_quad, 0, y);
	*stacked += height + margin;
}

struct hud_mark hud_mark(const struct hud *hud)
{
	struct hud_mark mark = {.quad_count = hud->quad_count};

	memcpy(mark.stacked_px, hud->stacked_px, sizeof(mark.stacked_px));
	return mark;
}

void hud_go_back(struct hud *hud, const struct hud_mark *mark)
{
	hud->quad_count = mark->quad_count;
	memcpy(hud->stacked_px, mark->stacked_px, sizeof(hud->stacked_px));
}

bool hud_groups_overlap(const struct hud *hud)
{
	const int *stacked = hud->stacked_px;

	return stacked[HUD_TOP_LEFT] + stacked[HUD_BOTTOM_LEFT] > hud->height ||
		stacked[HUD_TOP_RIGHT] + stacked[HUD_BOTTOM_RIGHT] > hud->height;
}
