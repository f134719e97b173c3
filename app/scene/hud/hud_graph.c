#include "app/scene/hud/hud_graph.h"

#include "platform/base/compiler.h"
#include "platform/base/scalar.h"

#include <stdio.h>

static const float update_ms = 250.0f;

/* Steps of the scale, and the frame times at which lines are drawn. */
static const float scales_ms[] = {5.0f, 20.0f, 40.0f, 100.0f, 250.0f, 1000.0f};
static const float marks_ms[] = {1000.0f / 60.0f, 1000.0f / 30.0f};

static const struct hud_color ground_color = {255, 255, 255, 22};
static const struct hud_color mark_color = {255, 255, 255, 110};

static const struct {
	const char *name;
	const struct hud_color *color;
} stages[HUD_STAGES] = {
	[HUD_ANIMATE] = {"animate", &hud_color_blue},
	[HUD_DRAW] = {"draw", &hud_color_green},
	[HUD_PRESENT] = {"present", &hud_color_amber},
};

static void update_texts(struct hud_graph *graph)
{
	float factor = 1.0f / (float)graph->sum.frames;

	graph->shown = graph->sum;
	graph->shown.interval_ms *= factor;
	for (int stage = 0; stage < HUD_STAGES; stage++) {
		graph->shown.stage_ms[stage] *= factor;
	}
	graph->sum = (struct hud_graph_means){.frames = 0};
}

void hud_graph_add(struct hud_graph *graph, const float stage_ms[HUD_STAGES],
	float interval_ms)
{
	struct hud_graph_means *sum = &graph->sum;

	for (int stage = 0; stage < HUD_STAGES; stage++) {
		float ms = scalar_max(stage_ms[stage], 0.0f);

		graph->ms[graph->next][stage] = ms;
		sum->stage_ms[stage] += ms;
	}
	graph->next = (graph->next + 1) % HUD_GRAPH_FRAMES;
	graph->count += graph->count < HUD_GRAPH_FRAMES;
	sum->interval_ms += interval_ms;
	sum->frames++;
	if (sum->interval_ms >= update_ms || graph->shown.frames == 0) {
		update_texts(graph);
	}
}

float hud_graph_rate(const struct hud_graph *graph)
{
	float ms = graph->shown.interval_ms;

	return ms > 0.0f ? 1000.0f / ms : 0.0f;
}

static float total_ms(const struct hud_graph *graph, int frame)
{
	float total = 0.0f;

	for (int stage = 0; stage < HUD_STAGES; stage++) {
		total += graph->ms[frame][stage];
	}
	return total;
}

float hud_graph_scale_ms(const struct hud_graph *graph)
{
	float tallest = 0.0f;
	size_t scale = 0;

	for (int i = 0; i < graph->count; i++) {
		float total = total_ms(graph, i);

		tallest = scalar_max(total, tallest);
	}
	while (scale + 1 < ARRAY_COUNT(scales_ms) && tallest > scales_ms[scale]) {
		scale++;
	}
	return scales_ms[scale];
}

/* The area of the bars. */
struct field {
	int left, width, bottom, height;
	float px_per_ms;
};

static void show_frame(const struct field *field, struct hud *hud,
	const float stage_ms[HUD_STAGES], int slot)
{
	int x = field->left + field->width * slot / HUD_GRAPH_FRAMES;
	int end = field->left + field->width * (slot + 1) / HUD_GRAPH_FRAMES;
	int gap = end - x > 2;
	float sum_ms = 0.0f;
	int from = 0;

	for (int stage = 0; stage < HUD_STAGES; stage++) {
		int to;

		sum_ms += stage_ms[stage];
		to = (int)(sum_ms * field->px_per_ms + 0.5f);
		to = to > field->height ? field->height : to;
		hud_rectangle(hud, x, field->bottom - to, end - x - gap,
			to - from, *stages[stage].color);
		from = to;
	}
}

static void show_marks(const struct field *field, struct hud *hud)
{
	for (size_t i = 0; i < ARRAY_COUNT(marks_ms); i++) {
		int up = (int)(marks_ms[i] * field->px_per_ms + 0.5f);

		if (up < field->height) {
			hud_rectangle(hud, field->left, field->bottom - up,
				field->width, hud->scale, mark_color);
		}
	}
}

enum {
	GRAPH_EMS = 3 /* height of the bars */
};

static int graph_height(const struct hud *hud)
{
	return GRAPH_EMS * hud_em(hud);
}

int hud_graph_room(int width, int height, int stage_count)
{
	bool bars = stage_count != HUD_GRAPH_RATE;
	struct hud_group_extent rows = hud_group_extent_of(
		width, height, bars ? 1 + stage_count : 1, 0);

	/* A last row keeps the room of a bar below it. */
	return rows.list_height + (bars ? GRAPH_EMS * rows.em : rows.em / 4);
}

static void show_bars(const struct hud_graph *graph, struct hud_group *group)
{
	struct hud *hud = group->hud;
	int height = graph_height(hud);
	int top = hud_group_space(group, height);
	const struct field field = {
		.left = group->left,
		.width = group->width,
		.bottom = top + height,
		.height = height,
		.px_per_ms = (float)height / hud_graph_scale_ms(graph),
	};
	int first = graph->next - graph->count + HUD_GRAPH_FRAMES;

	hud_rectangle(hud, group->left, top, group->width, height, ground_color);
	for (int i = 0; i < graph->count; i++) {
		show_frame(&field, hud,
			graph->ms[(first + i) % HUD_GRAPH_FRAMES],
			HUD_GRAPH_FRAMES - graph->count + i);
	}
	show_marks(&field, hud);
}

static void show_stages(const struct hud_graph *graph, struct hud_group *group)
{
	char value[32];

	for (int stage = 0; stage < HUD_STAGES; stage++) {
		snprintf(value, sizeof(value), "%.1f ms",
			(double)graph->shown.stage_ms[stage]);
		hud_group_mark(
			group, stages[stage].name, value, *stages[stage].color);
	}
}

static void show_facts(const struct hud_facts *facts, struct hud_group *group)
{
	char value[32];

	/* The last ones are left out first. */
	if (facts->reduction) {
		hud_group_mark(
			group, "left out", facts->reduction, hud_color_rose);
	}
	hud_group_text(group, "GL driver", facts->driver);
	snprintf(value, sizeof(value), "%ld", facts->triangles);
	hud_group_text(group, "triangles", value);
	if (facts->memory_bytes > 0) {
		snprintf(value, sizeof(value), "%.1f MiB",
			(double)facts->memory_bytes / (1024.0 * 1024.0));
		hud_group_text(group, "memory", value);
	}
	hud_group_text(group, facts->technique, "");
}

/*
 * Returns the right corner if the labels at the left leave too little room for
 * the graph and the picture is wide enough for two columns.
 */
static enum hud_corner choose_corner(const struct hud *hud)
{
	const int *stacked = hud->stacked_px;
	struct hud_group_extent rows =
		hud_group_extent_of(hud->width, hud->height, 3, 0);
	int room =
		hud->height - stacked[HUD_TOP_LEFT] - stacked[HUD_BOTTOM_LEFT];

	return room < rows.list_height + graph_height(hud) &&
			2 * rows.column <= hud->width
		? HUD_BOTTOM_RIGHT
		: HUD_BOTTOM_LEFT;
}

/* The place beside figures, or else one over them. */
static struct hud_place choose_place(
	const struct hud *hud, const struct hud_place *beside)
{
	const int *stacked = hud->stacked_px;
	int least = hud_graph_room(hud->width, hud->height, HUD_GRAPH_RATE);
	int left =
		hud->height - stacked[HUD_TOP_LEFT] - stacked[HUD_BOTTOM_LEFT];
	struct hud_place place = *beside;
	bool is_left_column =
		place.room == hud->height && place.corner == HUD_BOTTOM_LEFT;
	int right;

	if (place.room < least || (is_left_column && left < least)) {
		place = (struct hud_place){choose_corner(hud), hud->height};
	}
	right = place.corner == HUD_BOTTOM_RIGHT;
	if (place.room == hud->height) {
		/* In a small picture the last facts give way to the labels. */
		place.room -= stacked[right ? HUD_TOP_RIGHT : HUD_TOP_LEFT] +
			stacked[place.corner];
	}
	return place;
}

void hud_graph_show(const struct hud_graph *graph, const struct hud_facts *facts,
	const struct hud_place *beside, struct hud *hud)
{
	struct hud_place place = choose_place(hud, beside);
	struct hud_group group = hud_group_begin(hud, place.corner, NULL);
	char rate[32];
	char scale[32];

	hud_group_limit(&group, place.room);
	snprintf(rate, sizeof(rate), "%.0f fps", (double)hud_graph_rate(graph));
	snprintf(scale, sizeof(scale), "0 to %.0f ms",
		(double)hud_graph_scale_ms(graph));
	if (place.room < hud_graph_room(hud->width, hud->height, 0)) {
		hud_group_text(&group, "", rate);
		hud_group_end(&group);
		return;
	}
	hud_group_text(&group, scale, rate);
	show_bars(graph, &group);
	show_stages(graph, &group);
	show_facts(facts, &group);
	hud_group_end(&group);
}
