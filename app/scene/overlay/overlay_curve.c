#include "app/scene/overlay/overlay_curve.h"

#include "platform/base/scalar.h"

static const struct hud_color field_color = {255, 255, 255, 22};
static const struct hud_color moment_color = {255, 255, 255, 90};
static const struct hud_color *const colors[OVERLAY_CURVES_MAX] = {
	&hud_color_rose, &hud_color_green, &hud_color_blue, &hud_color_amber};

struct overlay_curve overlay_curve_of_morph(
	const struct overlay_way *way, float omega)
{
	struct overlay_curve curve = {
		.count = way->wave == 0.0f ? 1 : 3, .at = omega};

	for (int i = 0; i < OVERLAY_CURVE_POINTS; i++) {
		float at = (float)i / (OVERLAY_CURVE_POINTS - 1);
		float signal = way->wave * scalar_sin(SCALAR_PI * at);
		float slope = way->shape ? way->shape(way->user, at) : at;

		curve.value[0][i] = slope + signal;
		curve.value[1][i] = signal;
		curve.value[2][i] = slope;
	}
	return curve;
}

struct overlay_curve overlay_curve_of_channel(const struct model_clip *clip,
	const struct model_channel *channel, int first, float time_s,
	enum clip_interpolation interpolation, float *value)
{
	struct overlay_curve curve = {0};
	int key = 0;

	/* A small rotation's x, y and z are half its angles; w stays near 1. */
	curve.count =
		channel->path == MODEL_ROTATION ? 3 : channel->width - first;
	if (curve.count > OVERLAY_CURVES_MAX) {
		curve.count = OVERLAY_CURVES_MAX;
	}
	if (clip->duration_s > 0.0f) {
		curve.at = scalar_clamp(time_s / clip->duration_s, 0.0f, 1.0f);
	}
	for (int i = 0; i < OVERLAY_CURVE_POINTS; i++) {
		float at = clip->duration_s * (float)i /
			(OVERLAY_CURVE_POINTS - 1);

		clip_sample_channel(channel, at, interpolation, &key, value);
		for (int c = 0; c < curve.count; c++) {
			curve.value[c][i] = value[first + c];
		}
	}
	return curve;
}

struct range {
	float low, high;
};

static struct range range_of(const struct overlay_curve *curve)
{
	struct range range = {0.0f, 0.0f};

	for (int c = 0; c < curve->count; c++) {
		for (int i = 0; i < OVERLAY_CURVE_POINTS; i++) {
			float value = curve->value[c][i];

			range.low = scalar_min(value, range.low);
			range.high = scalar_max(value, range.high);
		}
	}
	if (range.high - range.low < 1e-6f) {
		range.high = range.low + 1.0f;
	}
	return range;
}

/* The graph's rectangle in pixels. */
struct field {
	int left, top, width, height;
	struct range range;
};

static int row_of(const struct field *field, float value)
{
	float part = (field->range.high - value) /
		(field->range.high - field->range.low);

	return field->top +
		(int)(scalar_clamp(part, 0.0f, 1.0f) *
				(float)(field->height - 1) +
			0.5f);
}

/*
 * Draws one step of the curve as a column that is as high as the curve rises or
 * falls in this step.
 */
static void draw_step(struct hud *hud, const struct field *field,
	const float *value, int i, struct hud_color color)
{
	int steps = OVERLAY_CURVE_POINTS - 1;
	int left = field->left + field->width * i / steps;
	int right = field->left + field->width * (i + 1) / steps;
	int from = row_of(field, value[i]), to = row_of(field, value[i + 1]);
	int top = from < to ? from : to, bottom = from < to ? to : from;

	hud_rectangle(hud, left, top - 1, right - left, bottom - top + 2, color);
}

/* Interpolates the value at the present moment between two points. */
static float value_now(const struct overlay_curve *curve, int c)
{
	float at = scalar_clamp(curve->at, 0.0f, 1.0f) *
		(OVERLAY_CURVE_POINTS - 1);
	int i = (int)at;

	i = i < OVERLAY_CURVE_POINTS - 2 ? i : OVERLAY_CURVE_POINTS - 2;
	return curve->value[c][i] +
		(curve->value[c][i + 1] - curve->value[c][i]) * (at - (float)i);
}

void overlay_curve_show(
	const struct overlay_curve *curve, struct hud_group *group)
{
	struct hud *hud = group->hud;
	int em = hud_em(hud), dot = em / 2 < 4 ? 4 : em / 2;
	int height = em * OVERLAY_CURVE_EMS;
	int top = hud_group_space(group, height);
	int now = group->left +
		(int)(scalar_clamp(curve->at, 0.0f, 1.0f) *
			(float)(group->width - 1));
	struct field field = {group->left, top + dot / 2, group->width,
		height - dot, range_of(curve)};

	hud_rectangle(hud, group->left, top, group->width, height, field_color);
	hud_rectangle(hud, now, top, 1, height, moment_color);
	for (int c = curve->count - 1; c >= 0; c--) {
		for (int i = 0; i + 1 < OVERLAY_CURVE_POINTS; i++) {
			draw_step(hud, &field, curve->value[c], i, *colors[c]);
		}
	}
	for (int c = 0; c < curve->count; c++) {
		hud_panel(hud, now - dot / 2,
			row_of(&field, value_now(curve, c)) - dot / 2, dot, dot,
			dot / 2, c == 0 ? hud_color_text : *colors[c]);
	}
}
