#include "app/demo/duel/duel_board.h"
#include "app/scene/overlay/overlay_heat.h"

#include <stdio.h>

enum {
	ROWS = 3, /* time, bytes, error */
	FORMS = 3,
	RAMP_STEPS = 24
};

/* The number in a row of the board: lower is better; negative if unknown. */
static float figure(const struct contender *contender, int row)
{
	return row == 0    ? contender->ms
		: row == 1 ? (float)(contender->candidate.bytes.shared +
				     contender->candidate.bytes.own) /
			1024.0f
			   : contender->peak_px;
}

/* A row of figures is written in the first form that fits all columns. */
static const struct form {
	const char *format;
	float scale;
} forms[ROWS][FORMS] = {
	{{"%.2f ms", 1.0f}, {"%.1fms", 1.0f}, {"%.1f", 1.0f}},
	{{"%.0f KiB", 1.0f}, {"%.0fK", 1.0f}, {"%.1fM", 1.0f / 1024.0f}},
	{{"%.2f px", 1.0f}, {"%.1fpx", 1.0f}, {"%.1f", 1.0f}},
};

static void write_figure(
	float value, const struct form *form, char *text, size_t size)
{
	snprintf(text, size, form->format, (double)(value * form->scale));
}

static bool fits_all(const struct contender contender[CONTENDER_KINDS], int row,
	const struct form *form, int width, const struct hud *hud)
{
	char text[32];

	for (int i = 0; i < CONTENDER_KINDS; i++) {
		write_figure(
			figure(&contender[i], row), form, text, sizeof(text));
		if (hud_text_width(hud, text) > width - hud_em(hud) / 4) {
			return false;
		}
	}
	return true;
}

/* A figure that is cut would be read as another one. */
static const struct form *form_of(
	const struct contender contender[CONTENDER_KINDS], int row, int width,
	const struct hud *hud)
{
	int form = 0;

	while (form < FORMS - 1 &&
		!fits_all(contender, row, &forms[row][form], width, hud)) {
		form++;
	}
	return &forms[row][form];
}

static bool is_best(const struct contender *contender, int kind, int row)
{
	for (int i = 0; i < CONTENDER_KINDS; i++) {
		if (figure(&contender[i], row) < figure(&contender[kind], row)) {
			return false;
		}
	}
	return true;
}

static void write_centered(struct hud *hud, int left, int width, int y,
	struct hud_color color, const char *text)
{
	int text_width = hud_text_width(hud, text);

	hud_text_cut(hud,
		text_width < width ? left + (width - text_width) / 2 : left, y,
		width, color, text);
}

/* Writes what the technique plays the clip with, such as its number of keys. */
static void write_means(
	const struct contender *contender, char *text, size_t size)
{
	if (contender->key_count > 0) {
		snprintf(text, size, "%d keys", contender->key_count);
	} else {
		snprintf(text, size, "%s",
			contender->kind == CONTENDER_RIGID ? "rigid parts"
				: contender->reference->model->skin_count
				? "skin"
				: "the file's own");
	}
}

static void show_column(const struct contender *contender, int kind, int left,
	int width, int y, bool means, struct hud *hud)
{
	int line = hud_line_height(hud);
	char text[32];

	write_centered(
		hud, left, width, y, hud_color_text, contender[kind].title);
	y += line;
	if (means) {
		write_means(&contender[kind], text, sizeof(text));
		write_centered(hud, left, width, y, hud_color_dim, text);
	}
	for (int row = 0; row < ROWS; row++) {
		float value = figure(&contender[kind], row);

		if (value >= 0.0f) {
			write_figure(value, form_of(contender, row, width, hud),
				text, sizeof(text));
			write_centered(hud, left, width, y += line,
				is_best(contender, kind, row) ? hud_color_green
							      : hud_color_text,
				text);
		}
	}
}

/* Shows the colour scale of the errors in a line of the panel. */
static void show_ramp(float full_px, int y, struct hud *hud)
{
	int em = hud_em(hud), line = hud_line_height(hud);
	int bar = (hud->width - 2 * em) / 3;
	char text[32];
	int x = hud_text(hud, em, y, hud_color_dim, "off by 0 ") + em / 4;

	for (int i = 0; i < RAMP_STEPS; i++) {
		int from = x + bar * i / RAMP_STEPS;
		int to = x + bar * (i + 1) / RAMP_STEPS;
		uint8_t rgb[3];

		overlay_heat_ramp((float)i / (RAMP_STEPS - 1), rgb);
		hud_rectangle(hud, from, y + line / 4, to - from, line / 2,
			(struct hud_color){rgb[0], rgb[1], rgb[2], 255});
	}
	snprintf(text, sizeof(text), "%.0f px or more", (double)full_px);
	hud_text(hud, x + bar + em / 2, y, hud_color_dim, text);
}

void duel_board_show(const struct contender contender[CONTENDER_KINDS],
	float full_px, struct hud *hud)
{
	int em = hud_em(hud), line = hud_line_height(hud);
	int rows = 2 + ROWS - (contender[0].ms < 0.0f);
	int height = rows * line + em;
	int y = hud->height - hud->stacked_px[HUD_BOTTOM_LEFT] - height - em / 2;
	int left = em / 2, width = hud->width - em;
	int column = width / CONTENDER_KINDS;

	hud_panel(hud, left, y, width, height, em / 3, hud_color_panel);
	for (int i = 0; i < CONTENDER_KINDS; i++) {
		show_column(contender, i, left + i * column, column, y + em / 2,
			full_px <= 0.0f, hud);
	}
	if (full_px > 0.0f) {
		show_ramp(full_px, y + em / 2 + line, hud);
	}
	hud->stacked_px[HUD_BOTTOM_LEFT] += height + em / 2;
	hud->stacked_px[HUD_BOTTOM_RIGHT] += height + em / 2;
}
