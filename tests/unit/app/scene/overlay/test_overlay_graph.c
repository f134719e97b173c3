/* Where an overlay's graph of curves has its lines and its dots. */
#include "app/scene/overlay/overlay_curve.h"
#include "platform/base/compiler.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static struct hud shown, wanted;

/* The graph's field, in which a dot has room above and below the curves. */
struct graph {
	int left, top, width, height, dot;
	double low, high;
};

static struct graph show(const struct overlay_curve *curve, int height)
{
	struct hud *const both[] = {&shown, &wanted};
	struct hud_group group;
	struct graph graph = {.low = 0, .high = 0};

	for (int i = 0; i < 2; i++) {
		*both[i] = (struct hud){.font = &font_default};
		hud_begin(both[i], height * 3 / 4, height);
	}
	group = hud_group_begin(&shown, HUD_TOP_LEFT, NULL);
	/* The panel behind the group is not the graph's. */
	shown.quad_count = 0;
	graph.left = group.left;
	graph.top = group.y;
	graph.width = group.width;
	graph.height = hud_em(&shown) * OVERLAY_CURVE_EMS;
	graph.dot = hud_em(&shown) / 2;
	overlay_curve_show(curve, &group);
	assert_true(group.y >= graph.top + graph.height);
	for (int c = 0; c < curve->count; c++) {
		for (int p = 0; p < OVERLAY_CURVE_POINTS; p++) {
			graph.low = fmin(graph.low, (double)curve->value[c][p]);
			graph.high =
				fmax(graph.high, (double)curve->value[c][p]);
		}
	}
	if (graph.high - graph.low < 1e-6) {
		graph.high = graph.low + 1;
	}
	return graph;
}

static int row_of(const struct graph *graph, double value)
{
	double part = (graph->high - value) / (graph->high - graph->low);

	return graph->top + graph->dot / 2 +
		(int)floor(part * (graph->height - graph->dot - 1) + 0.5);
}

static int x_of(const struct graph *graph, int point)
{
	return graph->left + graph->width * point / (OVERLAY_CURVE_POINTS - 1);
}

/* Each step is a column from one height to the next, and one pixel more. */
static void want_curve(
	const struct graph *graph, const float *value, struct hud_color color)
{
	for (int p = 0; p + 1 < OVERLAY_CURVE_POINTS; p++) {
		int from = row_of(graph, (double)value[p]);
		int to = row_of(graph, (double)value[p + 1]);
		int top = from < to ? from : to, bottom = from < to ? to : from;

		hud_rectangle(&wanted, x_of(graph, p), top - 1,
			x_of(graph, p + 1) - x_of(graph, p), bottom - top + 2,
			color);
	}
}

/* The curve's value between two of its points. */
static double value_at(const float *value, double at)
{
	double place = fmin(fmax(at, 0), 1) * (OVERLAY_CURVE_POINTS - 1);
	int p = (int)fmin(place, OVERLAY_CURVE_POINTS - 2);

	return (double)value[p] +
		((double)value[p + 1] - (double)value[p]) * (place - p);
}

static void expect_graph(const struct overlay_curve *curve, int height)
{
	static const struct hud_color field = {255, 255, 255, 22};
	static const struct hud_color moment = {255, 255, 255, 90};
	const struct hud_color colors[] = {hud_color_rose, hud_color_green,
		hud_color_blue, hud_color_amber};
	struct graph graph = show(curve, height);
	int now = graph.left +
		(int)(fmin(fmax((double)curve->at, 0), 1) * (graph.width - 1) +
			1e-4);

	hud_rectangle(&wanted, graph.left, graph.top, graph.width, graph.height,
		field);
	hud_rectangle(&wanted, now, graph.top, 1, graph.height, moment);
	for (int c = curve->count - 1; c >= 0; c--) {
		want_curve(&graph, curve->value[c], colors[c]);
	}
	for (int c = 0; c < curve->count; c++) {
		int row = row_of(
			&graph, value_at(curve->value[c], (double)curve->at));

		hud_panel(&wanted, now - graph.dot / 2, row - graph.dot / 2,
			graph.dot, graph.dot, graph.dot / 2,
			c ? colors[c] : hud_color_text);
	}
	assert_int_equal(shown.quad_count, wanted.quad_count);
	assert_memory_equal(shown.vertex, wanted.vertex,
		(size_t)wanted.quad_count * 4 * sizeof(wanted.vertex[0]));
}

/* Multiples of an eighth between -4 and 4, so that rows are not rounded twice. */
static void test_curves_fill_the_graph_and_dots_show_the_moment(void **state)
{
	static const float moments[] = {0, 0.25f, 0.5f, 0.96f, 1, -1, 2};
	static const int heights[] = {320, 640, 1080};
	uint32_t seed = 1;

	(void)state;
	for (int i = 0; i < 7 * 3 * OVERLAY_CURVES_MAX; i++) {
		struct overlay_curve curve = {
			.count = 1 + i % OVERLAY_CURVES_MAX,
			.at = moments[i % 7]};

		for (int c = 0; c < curve.count; c++) {
			for (int p = 0; p < OVERLAY_CURVE_POINTS; p++) {
				curve.value[c][p] =
					(float)random_within(&seed, 32) / 8;
			}
		}
		expect_graph(&curve, heights[i / 7 % 3]);
	}
}

/* Zero is always in the graph: above it, below it, or alone. */
static void test_the_graph_reaches_to_zero(void **state)
{
	static const float values[] = {0, 3, -3, 1e-7f};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(values); i++) {
		struct overlay_curve curve = {.count = 1, .at = 0.5f};

		for (int p = 0; p < OVERLAY_CURVE_POINTS; p++) {
			curve.value[0][p] = values[i];
		}
		expect_graph(&curve, 640);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_curves_fill_the_graph_and_dots_show_the_moment),
		cmocka_unit_test(test_the_graph_reaches_to_zero),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
