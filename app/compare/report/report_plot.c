#include "app/compare/report/report.h"

#include "app/compare/advice_price.h"
#include "platform/base/output_file.h"
#include "platform/base/scalar.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Pixels of the picture; the two charts stand side by side. */
enum {
	PICTURE_WIDTH = 980,
	PICTURE_HEIGHT = 460,
	CHART_WIDTH = 400,
	CHART_HEIGHT = 300,
	CHART_LEFT = 64,
	CHART_STEP = 480,
	CHART_TOP = 60,
	DECADES_MAX = 99
};

/* Smaller errors are drawn as this one, as the axis is logarithmic. */
static const double min_px = 0.01;

static const char *const color[TECHNIQUE_COUNT] = {
	[TECHNIQUE_MORPHING] = "#c2410c",
	[TECHNIQUE_HIERARCHICAL] = "#4d7c0f",
	[TECHNIQUE_SKELETAL] = "#1d4ed8",
	[TECHNIQUE_COMBINED] = "#7e22ce",
};

/* One chart: error against a cost, both on logarithmic axes. */
struct chart {
	const char *title;
	/* The cost of a row, which is its x coordinate. */
	double (*cost)(const struct comparison *comparison,
		const struct comparison_row *row);
	double left;                      /* pixels */
	int low_x, high_x, low_y, high_y; /* powers of ten */
};

static double memory_cost(
	const struct comparison *comparison, const struct comparison_row *row)
{
	(void)comparison;
	return (double)row->total.memory_bytes / 1024.0;
}

static double time_cost(
	const struct comparison *comparison, const struct comparison_row *row)
{
	/* Drawing is left out: it dominates, and differs little. */
	return advice_row_us(comparison, (int)(row - comparison->row)) -
		board_cost_us(&row->total.draw);
}

static double shown_px(const struct comparison_row *row)
{
	double px = (double)row->total.peak_px;

	return px > min_px ? px : min_px;
}

/* Widens a range of powers of ten so that it encloses a value. */
static void enclose(int *low, int *high, double value)
{
	double power = floor(log10(value));

	*low = scalar_to_int(fmin(*low, power), -DECADES_MAX, DECADES_MAX);
	*high = scalar_to_int(
		fmax(*high, power + 1.0), -DECADES_MAX, DECADES_MAX);
}

static void fit_axes(struct chart *chart, const struct comparison *comparison)
{
	chart->low_x = chart->low_y = DECADES_MAX;
	chart->high_x = chart->high_y = -DECADES_MAX;
	enclose(&chart->low_y, &chart->high_y,
		(double)comparison->request.bound_px);
	for (int i = 0; i < comparison->row_count; i++) {
		const struct comparison_row *row = &comparison->row[i];

		enclose(&chart->low_x, &chart->high_x,
			chart->cost(comparison, row) + 1e-9);
		enclose(&chart->low_y, &chart->high_y, shown_px(row));
	}
}

static double chart_x(const struct chart *chart, double value)
{
	return chart->left +
		CHART_WIDTH * (log10(value + 1e-9) - chart->low_x) /
		(chart->high_x - chart->low_x);
}

static double chart_y(const struct chart *chart, double value)
{
	return CHART_TOP + CHART_HEIGHT -
		CHART_HEIGHT * (log10(value) - chart->low_y) /
		(chart->high_y - chart->low_y);
}

static void draw_axes(const struct chart *chart, double bound_px, FILE *out)
{
	for (int power = chart->low_x; power <= chart->high_x; power++) {
		double x = chart_x(chart, pow(10.0, power));

		fprintf(out,
			"<path class='grid' d='M%.1f %d v%d'/>"
			"<text x='%.1f' y='%d' "
			"text-anchor='middle'>%g</text>\n",
			x, CHART_TOP, CHART_HEIGHT, x,
			CHART_TOP + CHART_HEIGHT + 18, pow(10.0, power));
	}
	for (int power = chart->low_y; power <= chart->high_y; power++) {
		double y = chart_y(chart, pow(10.0, power));

		fprintf(out,
			"<path class='grid' d='M%.1f %.1f h%d'/>"
			"<text x='%.1f' y='%.1f' text-anchor='end'>%g</text>\n",
			chart->left, y, CHART_WIDTH, chart->left - 6.0, y + 4.0,
			pow(10.0, power));
	}
	fprintf(out,
		"<path class='bound' d='M%.1f %.1f h%d'/>"
		"<text x='%.1f' y='%d' class='title'>%s</text>\n",
		chart->left, chart_y(chart, bound_px), CHART_WIDTH, chart->left,
		CHART_TOP - 14, chart->title);
}

/* The order of a curve's points in both charts: qsort() passes no chart. */
static int by_memory(const void *a, const void *b)
{
	const struct comparison_row *x =
		*(const struct comparison_row *const *)a;
	const struct comparison_row *y =
		*(const struct comparison_row *const *)b;

	return (x->total.memory_bytes > y->total.memory_bytes) -
		(x->total.memory_bytes < y->total.memory_bytes);
}

static int collect(const struct comparison *comparison,
	enum technique technique, const struct comparison_row **point)
{
	int count = 0;

	for (int i = 0; i < comparison->row_count; i++) {
		if (comparison->row[i].technique == technique) {
			point[count++] = &comparison->row[i];
		}
	}
	qsort(point, (size_t)count, sizeof(point[0]), by_memory);
	return count;
}

static void draw_points(const struct chart *chart,
	const struct comparison *comparison,
	const struct comparison_row **point, int count, FILE *out)
{
	for (int i = 0; i < count; i++) {
		bool advised = point[i] == &comparison->row[comparison->advised];
		const char *fill = color[point[i]->technique];

		fprintf(out,
			"<circle cx='%.1f' cy='%.1f' r='%d' fill='%s' "
			"stroke='%s'%s><title>%s: %.3f px</title></circle>\n",
			chart_x(chart, chart->cost(comparison, point[i])),
			chart_y(chart, shown_px(point[i])), advised ? 7 : 4,
			point[i]->kind == COMPARISON_MORPH_EVEN ? "white" : fill,
			point[i]->front ? "black" : fill,
			point[i]->front ? " stroke-width='2.5'" : "",
			point[i]->name, (double)point[i]->total.peak_px);
	}
}

/* A morph with evenly spaced keys is a point off the curve of fitted morphs. */
static void draw_curve(const struct chart *chart,
	const struct comparison *comparison, enum technique technique, FILE *out)
{
	const struct comparison_row *point[COMPARISON_ROWS_MAX];
	int count = collect(comparison, technique, point);
	const char *begin = "<path class='curve' d='M";
	bool drawn = false;

	for (int i = 0; i < count; i++) {
		if (point[i]->kind != COMPARISON_MORPH_EVEN) {
			fprintf(out, "%s%.1f %.1f", drawn ? " L" : begin,
				chart_x(chart, chart->cost(comparison, point[i])),
				chart_y(chart, shown_px(point[i])));
			drawn = true;
		}
	}
	if (drawn) {
		fprintf(out, "' stroke='%s'/>\n", color[technique]);
	}
	draw_points(chart, comparison, point, count, out);
}

static void draw_legend(const struct comparison *comparison, FILE *out)
{
	double x = CHART_LEFT;

	for (int t = 0; t < TECHNIQUE_COUNT; t++) {
		if (comparison_has(comparison, (enum technique)t)) {
			fprintf(out,
				"<circle cx='%.1f' cy='%d' r='5' fill='%s'/>"
				"<text x='%.1f' y='%d'>%s</text>\n",
				x, PICTURE_HEIGHT - 38, color[t], x + 12.0,
				PICTURE_HEIGHT - 33, technique_ratings[t].name);
			x += 40.0 +
				8.0 * (double)strlen(technique_ratings[t].name);
		}
	}
	fprintf(out,
		"<text x='%d' y='%d'>Dashed: the accepted error, %g px. Large: recommended, \"%s\". Black rim: Pareto front. Hollow: even keys.</text>\n",
		CHART_LEFT, PICTURE_HEIGHT - 12,
		(double)comparison->request.bound_px,
		comparison->row[comparison->advised].name);
}

static void draw(const struct comparison *comparison, FILE *out)
{
	struct chart charts[] = {
		{.title = "peak error in pixels against memory in KiB",
			.cost = memory_cost,
			.left = CHART_LEFT},
		{.title = "against us of posing on an ARM1136 (predicted)",
			.cost = time_cost,
			.left = CHART_LEFT + CHART_STEP},
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
	for (size_t i = 0; i < ARRAY_COUNT(charts); i++) {
		fit_axes(&charts[i], comparison);
		draw_axes(&charts[i], (double)comparison->request.bound_px, out);
		for (int t = 0; t < TECHNIQUE_COUNT; t++) {
			draw_curve(
				&charts[i], comparison, (enum technique)t, out);
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
