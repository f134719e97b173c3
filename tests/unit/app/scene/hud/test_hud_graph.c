/* The graph of frame times: its texts and its bars. */
#include "app/scene/hud/hud_graph.h"
#include "app/scene/hud/hud_group.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>

/* Figures take the whole picture. */
static const struct hud_place nowhere = {HUD_BOTTOM_LEFT, 0};

static void add(struct hud_graph *graph, int frames, float ms, float interval_ms)
{
	const float stage_ms[HUD_STAGES] = {0.25f * ms, 0.5f * ms, 0.25f * ms};

	for (int i = 0; i < frames; i++) {
		hud_graph_add(graph, stage_ms, interval_ms);
	}
}

static void test_texts_are_means_of_a_quarter_second(void **state)
{
	struct hud_graph graph = {.next = 0};

	(void)state;
	assert_near(hud_graph_rate(&graph), 0.0, 0.0);
	add(&graph, 1, 8.0f, 20.0f);
	assert_near(hud_graph_rate(&graph), 50.0, 1e-3);
	add(&graph, 12, 4.0f, 20.0f);
	assert_near(graph.shown.stage_ms[HUD_DRAW], 4.0, 1e-3);
	add(&graph, 1, 4.0f, 10.0f);
	assert_near(graph.shown.stage_ms[HUD_DRAW], 2.0, 1e-3);
	assert_near(hud_graph_rate(&graph), 1000.0 / (250.0 / 13.0), 1e-2);
}

static void test_the_scale_holds_the_tallest_frame_it_still_has(void **state)
{
	struct hud_graph graph = {.next = 0};

	(void)state;
	add(&graph, 3, 4.9f, 20.0f);
	assert_near(hud_graph_scale_ms(&graph), 5.0, 0.0);
	add(&graph, 1, 39.0f, 20.0f);
	assert_near(hud_graph_scale_ms(&graph), 40.0, 0.0);
	add(&graph, 1, 5000.0f, 20.0f);
	assert_near(hud_graph_scale_ms(&graph), 1000.0, 0.0);
	add(&graph, HUD_GRAPH_FRAMES, 4.9f, 20.0f);
	assert_near(hud_graph_scale_ms(&graph), 5.0, 0.0);
}

/* The number of pixels that the rectangles of a colour cover. */
static int pixels_of(const struct hud *hud, struct hud_color color)
{
	int sum = 0;

	for (int i = 0; i < hud->quad_count; i++) {
		const struct hud_vertex *v = &hud->vertex[i * 4];

		if (v->color.r == color.r && v->color.g == color.g &&
			v->color.b == color.b) {
			sum += (v[3].x - v[0].x) * (v[3].y - v[0].y);
		}
	}
	return sum;
}

static void test_bars_are_as_high_as_the_stages_last(void **state)
{
	const struct hud_facts facts = {
		.technique = "Skeletal", .driver = "soft", .triangles = 12};
	struct hud *hud = calloc(1, sizeof(*hud));
	struct hud_graph graph = {.next = 0};
	int blue, green;

	(void)state;
	assert_non_null(hud);
	hud->font = &font_default;
	add(&graph, HUD_GRAPH_FRAMES, 20.0f, 20.0f);
	hud_begin(hud, 480, 640);
	hud_graph_show(&graph, &facts, &nowhere, hud);
	blue = pixels_of(hud, hud_color_blue);
	green = pixels_of(hud, hud_color_green);
	assert_true(blue > 500);
	assert_in_range(green, blue * 3 / 2, blue * 5 / 2);
	assert_true(hud->quad_count < HUD_QUADS_MAX / 2);
	for (int i = 0; i < hud->quad_count * 4; i++) {
		assert_in_range(hud->vertex[i].x, 0, 480);
		assert_in_range(hud->vertex[i].y, 320, 640);
	}
	free(hud);
}

struct box {
	int left, top, right, bottom;
};

static struct box box_of(const struct hud *hud, int quad)
{
	const struct hud_vertex *v = &hud->vertex[quad * 4];

	return (struct box){v[0].x, v[0].y, v[3].x, v[3].y};
}

/* The ground of the bars: the first rectangle of their height. */
static struct box find_field(const struct hud *hud)
{
	for (int i = 0; i < hud->quad_count; i++) {
		struct box box = box_of(hud, i);

		if (box.bottom - box.top == 3 * hud_em(hud)) {
			return box;
		}
	}
	fail_msg("the graph has no ground");
	return (struct box){0};
}

/* The pixels of a column of the field in a stage's colour. */
static int stage_pixels(const struct hud *hud, const struct box *field, int x,
	struct hud_color color)
{
	int sum = 0;

	for (int i = 0; i < hud->quad_count; i++) {
		const struct hud_color *c = &hud->vertex[i * 4].color;
		struct box box = box_of(hud, i);

		if (c->r == color.r && c->g == color.g && c->b == color.b &&
			box.left <= x && x < box.right &&
			box.top >= field->top && box.bottom <= field->bottom) {
			sum += box.bottom - box.top;
		}
	}
	return sum;
}

/* Compares the bars of a graph with the times of its frames. */
static void expect_bars(const struct hud *hud, const struct hud_graph *graph,
	float ms[][HUD_STAGES], int frames)
{
	const struct hud_color *const colors[HUD_STAGES] = {
		&hud_color_blue, &hud_color_green, &hud_color_amber};
	const struct box field = find_field(hud);
	const int width = field.right - field.left;
	const int height = field.bottom - field.top;
	const int shown = frames < HUD_GRAPH_FRAMES ? frames : HUD_GRAPH_FRAMES;
	const double scale_ms = (double)hud_graph_scale_ms(graph);

	for (int slot = -1; slot <= HUD_GRAPH_FRAMES; slot++) {
		int x = field.left + width * slot / HUD_GRAPH_FRAMES;
		int frame = frames - HUD_GRAPH_FRAMES + slot;
		bool has_bar = slot >= HUD_GRAPH_FRAMES - shown &&
			slot < HUD_GRAPH_FRAMES;
		double sum_ms = 0.0;
		int seen = 0;

		for (int stage = 0; stage < HUD_STAGES; stage++) {
			seen += stage_pixels(hud, &field, x, *colors[stage]);
			sum_ms += has_bar ? (double)ms[frame][stage] : 0.0;
			assert_near(seen,
				fmin(sum_ms * height / scale_ms, height), 0.51);
		}
	}
}

/* A first frame stands at the right, and pushes those before it to the left. */
static void test_each_bar_is_its_frame(void **state)
{
	enum {
		MOST = 3 * HUD_GRAPH_FRAMES
	};
	const struct hud_facts facts = {
		.technique = "Skeletal", .driver = "soft", .triangles = 12};
	struct hud *hud = calloc(1, sizeof(*hud));
	struct hud_graph graph = {.next = 0};
	float ms[MOST][HUD_STAGES];
	uint32_t seed = 1;

	(void)state;
	assert_non_null(hud);
	hud->font = &font_default;
	for (int frame = 0; frame < MOST; frame++) {
		for (int stage = 0; stage < HUD_STAGES; stage++) {
			ms[frame][stage] =
				(float)random_between(&seed, 0, 90) / 8.0f;
		}
		hud_graph_add(&graph, ms[frame], 20.0f);
		hud_begin(hud, 480, 640);
		hud_graph_show(&graph, &facts, &nowhere, hud);
		expect_bars(hud, &graph, ms, frame + 1);
	}
	free(hud);
}

/* Shows the graph below labels of so many rows; whether they overlap. */
static bool overlaps_labels(struct hud *hud, int width, int height, int rows)
{
	const struct hud_facts facts = {.technique = "Skeletal",
		.driver = "soft",
		.triangles = 12,
		.memory_bytes = 1 << 24,
		.reduction = "shadow"};
	struct hud_graph graph = {.next = 0};
	struct hud_group group;

	hud_begin(hud, width, height);
	group = hud_group_begin(hud, HUD_TOP_LEFT, "Skeletal");
	for (int i = 0; i < rows; i++) {
		hud_group_text(&group, "elbow", "45");
	}
	hud_group_end(&group);
	hud_graph_show(&graph, &facts, &nowhere, hud);
	return hud_groups_overlap(hud);
}

/* Beside figures if there is room for the times, and over them if not. */
static void test_the_graph_goes_where_no_figure_is(void **state)
{
	static const struct {
		struct hud_place beside;
		enum hud_corner wanted;
	} cases[] = {{{HUD_BOTTOM_LEFT, 320}, HUD_BOTTOM_LEFT},
		{{HUD_BOTTOM_RIGHT, 320}, HUD_BOTTOM_RIGHT},
		{{HUD_TOP_LEFT, 100}, HUD_TOP_LEFT},
		{{HUD_TOP_RIGHT, 100}, HUD_TOP_RIGHT},
		{{HUD_BOTTOM_LEFT, 100}, HUD_BOTTOM_LEFT},
		{{HUD_TOP_LEFT, 60}, HUD_TOP_LEFT},
		{{HUD_TOP_LEFT, 30}, HUD_BOTTOM_LEFT}};
	const struct hud_facts facts = {
		.technique = "Skeletal", .driver = "soft", .triangles = 12};
	struct hud_graph graph = {.next = 0};
	struct hud *hud = calloc(1, sizeof(*hud));

	(void)state;
	assert_non_null(hud);
	hud->font = &font_default;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		hud_begin(hud, 240, 320);
		hud_graph_show(&graph, &facts, &cases[i].beside, hud);
		for (int corner = 0; corner < HUD_CORNERS; corner++) {
			assert_int_equal(hud->stacked_px[corner] > 0,
				corner == (int)cases[i].wanted);
		}
		if (cases[i].beside.room == 100) {
			assert_in_range(
				hud->stacked_px[cases[i].wanted], 70, 100);
		}
	}
	free(hud);
}

static void test_in_small_pictures_facts_give_way_to_labels(void **state)
{
	struct hud *hud = calloc(1, sizeof(*hud));

	(void)state;
	assert_non_null(hud);
	hud->font = &font_default;
	for (int rows = 0; rows <= 10; rows++) {
		assert_false(overlaps_labels(hud, 320, 240, rows));
		assert_false(overlaps_labels(hud, 240, 320, rows));
		assert_false(overlaps_labels(hud, 480, 640, rows));
	}
	assert_false(overlaps_labels(hud, 320, 240, 3));
	assert_true(hud->stacked_px[HUD_BOTTOM_LEFT] > 100);
	assert_false(overlaps_labels(hud, 320, 240, 8));
	assert_int_equal(hud->stacked_px[HUD_BOTTOM_LEFT], 0);
	assert_true(hud->stacked_px[HUD_BOTTOM_RIGHT] > 200);
	free(hud);
}

/* The largest scale is a second: a longer frame has a bar of the same height. */
static void test_a_bar_ends_at_the_top_of_the_graph(void **state)
{
	const struct hud_facts facts = {.technique = "a", .driver = "b"};
	static struct hud hud[2];

	(void)state;
	for (int stage = 0; stage < HUD_STAGES; stage++) {
		for (int i = 0; i < 2; i++) {
			struct hud_graph graph = {.next = 0};
			float stage_ms[HUD_STAGES] = {0};

			stage_ms[stage] = i ? 5000 : 1000;
			hud_graph_add(&graph, stage_ms, 20);
			hud[i] = (struct hud){.font = &font_default};
			hud_begin(&hud[i], 480, 640);
			hud_graph_show(&graph, &facts, &nowhere, &hud[i]);
		}
		assert_true(pixels_of(&hud[0], hud_color_blue) > 0);
		assert_int_equal(pixels_of(&hud[0], hud_color_blue),
			pixels_of(&hud[1], hud_color_blue));
		assert_int_equal(pixels_of(&hud[0], hud_color_green),
			pixels_of(&hud[1], hud_color_green));
		assert_int_equal(pixels_of(&hud[0], hud_color_amber),
			pixels_of(&hud[1], hud_color_amber));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_texts_are_means_of_a_quarter_second),
		cmocka_unit_test(
			test_the_scale_holds_the_tallest_frame_it_still_has),
		cmocka_unit_test(test_bars_are_as_high_as_the_stages_last),
		cmocka_unit_test(test_each_bar_is_its_frame),
		cmocka_unit_test(test_the_graph_goes_where_no_figure_is),
		cmocka_unit_test(test_in_small_pictures_facts_give_way_to_labels),
		cmocka_unit_test(test_a_bar_ends_at_the_top_of_the_graph),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
