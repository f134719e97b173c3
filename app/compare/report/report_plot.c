#include "app/compare/report/report.h"

#include "platform/base/output_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Points of the picture; the panels stand side by side. */
enum {
	PICTURE_WIDTH = 980,
	PICTURE_HEIGHT = 460,
	PANEL_WIDTH = 400,
	PANEL_HEIGHT = 300,
	PANEL_LEFT = 64,
	PANEL_STEP = 480,
	PANEL_TOP = 60
};

/* Errors below this are shown as this: the axis is logarithmic. */
static const double least_px = 0.01;

static const char *const cost_titles[COST_KINDS] = {
	[COST_PREDICTED] = "against us a frame on an ARM1136 (predicted)",
	[COST_INSTRUCTIONS] =
		"peak error in pixels against instructions a frame",
	[COST_TIME] = "peak error in pixels against us a frame",
};

static const char *const color[TECHNIQUE_COUNT] = {
	[TECHNIQUE_MORPHING] = "#c2410c",
	[TECHNIQUE_HIERARCHICAL] = "#4d7c0f",
	[TECHNIQUE_SKELETAL] = "#1d4ed8",
	[TECHNIQUE_COMBINED] = "#7e22ce",
};

/* A panel: what its x axis is, and the decades both axes show. */
struct panel {
	const char *title;
	double (*cost)(const struct comparison *comparison,
		const struct candidate *candidate);
	double left;
	int low_x, high_x, low_y, high_y; /* powers of ten */
};

static double memory_cost(
	const struct comparison *comparison, const struct candidate *candidate)
{
	(void)comparison;
	return (double)candidate->memory_bytes / 1024.0;
}

static double shown_px(const struct candidate *candidate)
{
	double px = (double)candidate->error.peak_px;

	return px > least_px ? px : least_px;
}

static void fit_axes(struct panel *panel, const struct comparison *comparison)
{
	panel->low_x = panel->low_y = 99;
	panel->high_x = panel->high_y = -99;
	for (int i = 0; i < comparison->candidate_count; i++) {
		double x = log10(
			panel->cost(comparison, &comparison->candidate[i]) +
			1e-9);
		double y = log10(shown_px(&comparison->candidate[i]));

		panel->low_x = (int)fmin(panel->low_x, floor(x));
		panel->high_x = (int)fmax(panel->high_x, floor(x) + 1.0);
		panel->low_y = (int)fmin(panel->low_y, floor(y));
		panel->high_y = (int)fmax(panel->high_y, floor(y) + 1.0);
	}
}

static double place_x(const struct panel *panel, double value)
{
	return panel->left +
		PANEL_WIDTH * (log10(value + 1e-9) - panel->low_x) /
		(panel->high_x - panel->low_x);
}

static double place_y(const struct panel *panel, double value)
{
	return PANEL_TOP + PANEL_HEIGHT -
		PANEL_HEIGHT * (log10(value) - panel->low_y) /
		(panel->high_y - panel->low_y);
}

static void draw_axes(const struct panel *panel, double bound_px, FILE *out)
{
	for (int power = panel->low_x; power <= panel->high_x; power++) {
		double x = place_x(panel, pow(10.0, power));

		fprintf(out,
			"<path class='grid' d='M%.1f %d v%d'/>"
			"<text x='%.1f' y='%d' "
			"text-anchor='middle'>%g</text>\n",
			x, PANEL_TOP, PANEL_HEIGHT, x,
			PANEL_TOP + PANEL_HEIGHT + 18, pow(10.0, power));
	}
	for (int power = panel->low_y; power <= panel->high_y; power++) {
		double y = place_y(panel, pow(10.0, power));

		fprintf(out,
			"<path class='grid' d='M%.1f %.1f h%d'/>"
			"<text x='%.1f' y='%.1f' text-anchor='end'>%g</text>\n",
			panel->left, y, PANEL_WIDTH, panel->left - 6.0, y + 4.0,
			pow(10.0, power));
	}
	fprintf(out,
		"<path class='bound' d='M%.1f %.1f h%d'/>"
		"<text x='%.1f' y='%d' class='title'>%s</text>\n",
		panel->left, place_y(panel, bound_px), PANEL_WIDTH, panel->left,
		PANEL_TOP - 14, panel->title);
}

/* qsort() hands nothing through, so both panels have their order. */
static int by_memory(const void *a, const void *b)
{
	const struct candidate *x = *(const struct candidate *const *)a;
	const struct candidate *y = *(const struct candidate *const *)b;

	return (x->memory_bytes > y->memory_bytes) -
		(x->memory_bytes < y->memory_bytes);
}

static int collect(const struct comparison *comparison,
	enum technique technique, const struct candidate **point)
{
	int count = 0;

	for (int i = 0; i < comparison->candidate_count; i++) {
		if (comparison->candidate[i].technique == technique) {
			point[count++] = &comparison->candidate[i];
		}
	}
	qsort(point, (size_t)count, sizeof(point[0]), by_memory);
	return count;
}

static void draw_points(const struct panel *panel,
	const struct comparison *comparison, const struct candidate **point,
	int count, FILE *out)
{
	for (int i = 0; i < count; i++) {
		bool advised =
			point[i] == &comparison->candidate[comparison->advised];
		const char *paint = color[point[i]->technique];

		fprintf(out,
			"<circle cx='%.1f' cy='%.1f' r='%d' fill='%s' "
			"stroke='%s'><title>%s: %.3f px</title></circle>\n",
			place_x(panel, panel->cost(comparison, point[i])),
			place_y(panel, shown_px(point[i])), advised ? 7 : 4,
			point[i]->even ? "white" : paint, paint, point[i]->name,
			(double)point[i]->error.peak_px);
	}
}

/* Evenly spread keys are a point beside the curve of the fitted ones. */
static void draw_curve(const struct panel *panel,
	const struct comparison *comparison, enum technique technique, FILE *out)
{
	const struct candidate *point[CANDIDATES_MAX];
	int count = collect(comparison, technique, point);
	const char *begin = "<path class='curve' d='M";
	bool drawn = false;

	for (int i = 0; i < count; i++) {
		if (!point[i]->even) {
			fprintf(out, "%s%.1f %.1f", drawn ? " L" : begin,
				place_x(panel, panel->cost(comparison, point[i])),
				place_y(panel, shown_px(point[i])));
			drawn = true;
		}
	}
	if (drawn) {
		fprintf(out, "' stroke='%s'/>\n", color[technique]);
	}
	draw_points(panel, comparison, point, count, out);
}

static void draw_legend(const struct comparison *comparison, FILE *out)
{
	double x = PANEL_LEFT;

	for (int t = 0; t < TECHNIQUE_COUNT; t++) {
		bool present = false;

		for (int i = 0; i < comparison->candidate_count; i++) {
			present = present ||
				(int)comparison->candidate[i].technique == t;
		}
		if (present) {
			fprintf(out,
				"<circle cx='%.1f' cy='%d' r='5' fill='%s'/>"
				"<text x='%.1f' y='%d'>%s</text>\n",
				x, PICTURE_HEIGHT - 38, color[t], x + 12.0,
				PICTURE_HEIGHT - 33, technique_rating[t].name);
			x += 40.0 +
				8.0 * (double)strlen(technique_rating[t].name);
		}
	}
	fprintf(out,
		"<text x='%d' y='%d'>Dashed: the error that may be, %g px. "
		"Large: the one to take, \"%s\". "
		"Hollow: keys evenly spread.</text>\n",
		PANEL_LEFT, PICTURE_HEIGHT - 12,
		(double)comparison->request.bound_px,
		comparison->candidate[comparison->advised].name);
}

static void draw(const struct comparison *comparison, FILE *out)
{
	struct panel panels[] = {
		{.title = "peak error in pixels against memory in KiB",
			.cost = memory_cost,
			.left = PANEL_LEFT},
		{.title = cost_titles[comparison->cost],
			.cost = comparison_cost,
			.left = PANEL_LEFT + PANEL_STEP},
	};

	fprintf(out,
		"<svg xmlns='http://www.w3.org/2000/svg' width='%d' "
		"height='%d' viewBox='0 0 %d %d'>\n"
		"<style>text{font:13px sans-serif;fill:#333}"
		".title{font-weight:bold;font-size:15px}"
		".grid{stroke:#ddd}.bound{stroke:#333;stroke-dasharray:6 4}"
		".curve{fill:none;stroke-width:2}</style>\n"
		"<rect width='100%%' height='100%%' fill='white'/>\n",
		PICTURE_WIDTH, PICTURE_HEIGHT, PICTURE_WIDTH, PICTURE_HEIGHT);
	for (size_t i = 0; i < ARRAY_COUNT(panels); i++) {
		fit_axes(&panels[i], comparison);
		draw_axes(&panels[i], (double)comparison->request.bound_px, out);
		for (int t = 0; t < TECHNIQUE_COUNT; t++) {
			draw_curve(
				&panels[i], comparison, (enum technique)t, out);
		}
	}
	draw_legend(comparison, out);
	fprintf(out, "</svg>\n");
}

int report_plot(const struct comparison *comparison, const char *path,
	const struct log *log)
{
	struct output_file *file;
	int error = output_file_create_for("--plot", path, log, &file);

	if (error) {
		return error;
	}
	draw(comparison, output_file_stream(file));
	return output_file_commit(file);
}
