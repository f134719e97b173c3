/*
 * Labels of the overlays on the head-up display (overlay.h).
 */
#include "app/scene/hud/hud_group.h"
#include "app/scene/overlay/overlay.h"
#include "app/scene/overlay/overlay_curve.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum {
	RAMP_STEPS = 24
};

static const char *const path_name[] = {
	[MODEL_TRANSLATION] = "position",
	[MODEL_ROTATION] = "rotation",
	[MODEL_SCALE] = "scale",
	[MODEL_WEIGHTS] = "weights",
};

/* "skeleton, weights" or "all overlays". */
static void write_title(const struct overlay *overlay, char *out, size_t size)
{
	size_t used = 0;

	out[0] = '\0';
	for (int kind = 0; kind < OVERLAY_KINDS; kind++) {
		if (overlay_shows(overlay, (enum overlay_kind)kind) &&
			used < size) {
			used += (size_t)snprintf(out + used, size - used,
				"%s%s", used ? ", " : "",
				overlay_kind_name((enum overlay_kind)kind));
		}
	}
	if (overlay->kinds == (1U << OVERLAY_KINDS) - 1) {
		snprintf(out, size, "all overlays");
	}
	out[0] = (char)toupper((unsigned char)out[0]);
}

/* The colours from weight 0 to weight 1. */
static void show_ramp(struct hud_group *group)
{
	struct hud *hud = group->hud;
	int height = hud_em(hud) / 2, top = hud_group_space(group, height);

	for (int i = 0; i < RAMP_STEPS; i++) {
		int from = group->left + group->width * i / RAMP_STEPS;
		int to = group->left + group->width * (i + 1) / RAMP_STEPS;
		uint8_t rgb[3];

		overlay_heat_ramp((float)i / (RAMP_STEPS - 1), rgb);
		hud_rectangle(hud, from, top, to - from, height,
			(struct hud_color){rgb[0], rgb[1], rgb[2], 255});
	}
}

/* How well a channel suits the graph: 0 for not at all. */
static int rank_of(
	const struct overlay *overlay, const struct model_channel *channel)
{
	bool chosen =
		!overlay->chooses_target && channel->node == overlay->chosen;

	if (channel->path == MODEL_WEIGHTS) {
		return overlay->chooses_target ? 5 : 1;
	}
	if (!chosen) {
		return 1;
	}
	return channel->path == MODEL_ROTATION ? 4 : channel->constant ? 2 : 3;
}

static const struct model_channel *find_channel(
	const struct overlay *overlay, const struct model_clip *clip)
{
	const struct model_channel *found = NULL;
	int best = 0;

	for (int i = 0; i < clip->channel_count; i++) {
		int rank = rank_of(overlay, &clip->channel[i]);

		if (rank > best) {
			best = rank;
			found = &clip->channel[i];
		}
	}
	return found;
}

static void show_clip_curve(struct overlay *overlay,
	const struct overlay_motion *motion, struct hud_group *group)
{
	const struct model *model = overlay->subject.instance->model;
	const struct model_clip *clip = &model->clip[motion->clip];
	const struct model_channel *channel = find_channel(overlay, clip);
	struct overlay_curve curve;
	char number[HUD_NAME_BYTES];
	int first = 0;

	if (!channel) {
		return;
	}
	if (channel->path == MODEL_WEIGHTS && overlay->chooses_target &&
		overlay->chosen < channel->width) {
		first = overlay->chosen;
	}
	hud_group_text(group,
		first || channel->path == MODEL_WEIGHTS
			? overlay_chosen_name(overlay, number)
			: hud_name(model->node[channel->node].name, "node",
				  channel->node, number),
		path_name[channel->path]);
	curve = overlay_curve_of_channel(clip, channel, first, motion->time_s,
		motion->interpolation, overlay->sample);
	overlay_curve_show(&curve, group);
}

static void show_curve(struct overlay *overlay,
	const struct overlay_motion *motion, struct hud_group *group)
{
	if (motion->morphing) {
		struct overlay_way way = {
			motion->wave, motion->shape, motion->shape_user};
		struct overlay_curve curve =
			overlay_curve_of_morph(&way, motion->omega);

		overlay_curve_show(&curve, group);
	} else if (motion->clip >= 0) {
		show_clip_curve(overlay, motion, group);
	} else {
		hud_group_text(group, "nothing moves", "");
	}
}

static void show_layers(
	const struct overlay_motion *motion, struct hud_group *group)
{
	for (int i = 0; i < motion->layer_count; i++) {
		const struct overlay_layer *layer = &motion->layer[i];
		char number[HUD_NAME_BYTES];

		hud_group_weight(group,
			layer->kind ? hud_name(layer->name, layer->kind,
					      layer->number, number)
				    : layer->name,
			layer->weight,
			layer->mask ? hud_color_rose : hud_color_green);
	}
	if (motion->layer_count == 0) {
		hud_group_text(group, "no layers", "");
	}
}

static void frame(struct hud *hud, int x, int y, int w, int h, int line,
	struct hud_color color)
{
	hud_rectangle(hud, x, y, w, line, color);
	hud_rectangle(hud, x, y + h - line, w, line, color);
	hud_rectangle(hud, x, y + line, line, h - 2 * line, color);
	hud_rectangle(hud, x + w - line, y + line, line, h - 2 * line, color);
}

static bool shows_row(const struct overlay *overlay)
{
	return overlay_shows(overlay, OVERLAY_KEYS) && overlay->chooses_target;
}

void overlay_reserve_row(const struct overlay *overlay, struct hud *hud)
{
	int height = overlay_row_of(overlay, hud->width, hud->height).height;

	if (shows_row(overlay)) {
		hud->stacked_px[HUD_BOTTOM_LEFT] += height;
		hud->stacked_px[HUD_BOTTOM_RIGHT] += height;
	}
}

/* Marks a morph's source and destiny in the row of small pictures. */
static void mark_row(const struct overlay *overlay,
	const struct overlay_motion *motion, struct hud *hud)
{
	struct overlay_row row =
		overlay_row_of(overlay, hud->width, hud->height);
	const int key[2] = {motion->from + 1, motion->to + 1};
	int line = hud_em(hud) / 6 < 2 ? 2 : hud_em(hud) / 6;

	for (int i = 0; motion->morphing && i < 2; i++) {
		if (key[i] < row.count) {
			frame(hud, key[i] * row.width, hud->height - row.height,
				row.width, row.height, line,
				i ? hud_color_amber : hud_color_blue);
		}
	}
}

static void show_keys(const struct overlay *overlay,
	const struct overlay_motion *motion, struct hud_group *group)
{
	if (!overlay->chooses_target) {
		hud_group_mark(group, "before", "", hud_color_blue);
		hud_group_mark(group, "after", "", hud_color_amber);
	} else if (motion->morphing) {
		hud_group_mark(group, "source", "", hud_color_blue);
		hud_group_mark(group, "destiny", "", hud_color_amber);
	} else {
		hud_group_text(group, "neutral, targets", "");
	}
}

static bool has_rows(const struct overlay *overlay)
{
	return overlay->kinds &
		~(1U << OVERLAY_SKELETON | 1U << OVERLAY_WIREFRAME);
}

/* Shows what the overlays that have rows say, as far as the group has room. */
static void show_rows(struct overlay *overlay,
	const struct overlay_motion *motion, struct hud_group *group)
{
	int em = hud_em(group->hud);
	char number[HUD_NAME_BYTES];

	if (overlay_shows(overlay, OVERLAY_WEIGHTS) &&
		hud_group_fits(group, 1, em / 2)) {
		hud_group_text(group,
			overlay->chooses_target ? "target" : "joint",
			overlay_chosen_name(overlay, number));
		show_ramp(group);
	}
	if (overlay_shows(overlay, OVERLAY_KEYS) &&
		hud_group_fits(group,
			overlay->chooses_target && !motion->morphing ? 1 : 2,
			0)) {
		show_keys(overlay, motion, group);
	}
	if (overlay_shows(overlay, OVERLAY_PIVOTS) &&
		hud_group_fits(group, 3, 0)) {
		hud_group_mark(group, "x", "", hud_color_rose);
		hud_group_mark(group, "y", "", hud_color_green);
		hud_group_mark(group, "z", "", hud_color_blue);
	}
	if (overlay_shows(overlay, OVERLAY_CURVE) &&
		hud_group_fits(group, motion->morphing ? 0 : 1,
			OVERLAY_CURVE_EMS * em)) {
		show_curve(overlay, motion, group);
	}
	if (overlay_shows(overlay, OVERLAY_LAYERS)) {
		show_layers(motion, group);
	}
}

bool overlay_label(struct overlay *overlay, const struct overlay_motion *motion,
	const struct hud_place *place, struct hud *hud)
{
	struct hud_group group;
	char title[64];
	int top;

	if (!overlay->kinds) {
		return true;
	}
	write_title(overlay, title, sizeof(title));
	if (shows_row(overlay)) {
		mark_row(overlay, motion, hud);
	}
	group = hud_group_begin(
		hud, place->corner, has_rows(overlay) ? title : NULL);
	hud_group_limit(&group, place->room);
	top = group.y;
	if (!has_rows(overlay)) {
		hud_group_text(&group, title, "");
	}
	show_rows(overlay, motion, &group);
	hud_group_end(&group);
	return group.y > top;
}
