#include "app/scene/stage/framing.h"

#include "app/scene/hud/hud_graph.h"

/* shortest side of a region; the picture's sides are 2 */
static const float least_side = 0.4f;

/* what figures keep of the height above the graph of frame times, */
static const float kept_side = 0.8f;
/* and above what is left of it in a small picture */
static const float rate_side = 0.3f;

/* Returns the lower edge of a region above a list of this many rows. */
static float above_list(int rows, int width, int height)
{
	int taken = hud_group_extent_of(width, height, rows, 0).list_height;

	return 2.0f * (float)taken / (float)height - 1.0f;
}

/*
 * Finds the regions that a list of keys leaves free: above the list (and beside
 * the labels, if these are shown), and beside the list. Returns their number.
 */
static int regions_of_keys(
	int rows, int width, int height, struct camera_region out[2])
{
	struct hud_group_extent keys = hud_group_extent_of(width, height, 0, 0);
	bool alone = hud_group_list_is_alone(width, height);
	float left = 2.0f * (float)keys.list_width / (float)width - 1.0f;
	float bottom = above_list(rows, width, height);
	float beside = 2.0f * (float)keys.column / (float)width - 1.0f;
	int count = 0;

	if (bottom < 1.0f - least_side) {
		out[count++] = (struct camera_region){
			alone ? -1.0f : beside, 1.0f, bottom, 1.0f};
	}
	if (left < 1.0f - least_side) {
		out[count++] = (struct camera_region){left, 1.0f, -1.0f, 1.0f};
	}
	return count;
}

/*
 * Finds the lower edge of a region above the graph of frame times, which stands
 * at bottom. The graph has this many stages, or is less. Returns false if that
 * leaves figures too little below top.
 */
static bool above_times(
	int width, int height, int stages, float top, float *bottom)
{
	int taken = hud_graph_room(width, height, stages);
	float edge = *bottom + 2.0f * (float)taken / (float)height;
	float kept = stages == HUD_GRAPH_RATE ? rate_side : kept_side;

	if (!(edge < top - kept)) {
		return false;
	}
	*bottom = edge;
	return true;
}

/* Does the same for as much of the graph as there is room for. */
static bool above_some_times(int width, int height, float top, float *bottom)
{
	return above_times(width, height, HUD_STAGES, top, bottom) ||
		above_times(width, height, 0, top, bottom) ||
		above_times(width, height, HUD_GRAPH_RATE, top, bottom);
}

/*
 * Finds the regions that the graph of frame times leaves free in a picture
 * without labels in its corners: beside the graph and above it. In a picture
 * too small for both, it is the one above a graph of less. Lines of text end at
 * bottom. Returns their number.
 */
static int regions_of_times(
	int width, int height, float bottom, struct camera_region out[2])
{
	int column = hud_group_extent_of(width, height, 0, 0).column;
	float left = 2.0f * (float)column / (float)width - 1.0f;
	float above = bottom;
	int count = 0;

	if (left < 1.0f - least_side) {
		out[count++] = (struct camera_region){left, 1.0f, bottom, 1.0f};
	}
	if (above_some_times(width, height, 1.0f, &above)) {
		out[count++] = (struct camera_region){-1.0f, 1.0f, above, 1.0f};
	}
	return count;
}

/* The extent of the labels, as many as the picture has room for. */
static struct hud_group_extent extent_of_labels(
	const struct framing *framing, int width, int height)
{
	int most = hud_group_rows_max(width, height);
	int rows = framing->label_rows < most ? framing->label_rows : most;
	int bars = framing->label_bars < rows ? framing->label_bars : rows;

	return hud_group_extent_of(width, height, rows, bars);
}

/* Where the lines of text end; at the edge if they leave too little. */
static float above_lines(const struct framing *framing,
	const struct hud_group_extent *labels, int height)
{
	float edge = 2.0f * (float)(framing->lines_below * labels->line) /
			(float)height -
		1.0f;

	return edge > 1.0f - least_side ? -1.0f : edge;
}

/*
 * Finds the regions beside labels and below them, above the bottom. Returns
 * their number.
 */
static int regions_of_labels(const struct framing *framing,
	const struct hud_group_extent *labels, const int size[2], float bottom,
	struct camera_region out[2])
{
	int width = size[0], height = size[1], count = 0;
	float left = 2.0f * (float)labels->column / (float)width - 1.0f;
	float top = 1.0f - 2.0f * (float)labels->top / (float)height;
	int rate = labels->top + hud_graph_room(width, height, HUD_GRAPH_RATE);

	if (left < 1.0f - least_side) {
		out[count] = (struct camera_region){left, 1.0f, bottom, 1.0f};
		if (framing->frame_times && rate > height) {
			/* Labels may fill the column, but seldom do. */
			(void)above_times(width, height, HUD_GRAPH_RATE, 1.0f,
				&out[count].bottom);
		}
		count++;
	}
	if (framing->below.switches > 0) {
		bottom = above_list(framing->below.switches, width, height);
	}
	if (framing->frame_times) {
		(void)above_some_times(width, height, top, &bottom);
	}
	if (top > bottom + (framing->frame_times ? rate_side : least_side)) {
		out[count++] = (struct camera_region){-1.0f, 1.0f, bottom, top};
	}
	return count;
}

/*
 * Finds the regions that labels leave free. Returns their number. If labels
 * leave too little of a small picture, the only region is the whole picture
 * above the lines of text.
 */
static int free_regions(const struct framing *framing, int width, int height,
	struct camera_region out[2])
{
	struct hud_group_extent labels =
		extent_of_labels(framing, width, height);
	float bottom = above_lines(framing, &labels, height);
	int count;

	out[0] = (struct camera_region){-1.0f, 1.0f, bottom, 1.0f};
	if (hud_group_rows_max(width, height) == 0) {
		/* Such a picture has no groups, the frame times neither. */
		count = 0;
	} else if (framing->label_rows == 0) {
		count = framing->frame_times
			? regions_of_times(width, height, bottom, out)
			: 0;
	} else if (framing->below.keys > 0) {
		count = regions_of_keys(framing->below.keys, width, height, out);
	} else {
		count = regions_of_labels(framing, &labels,
			(const int[]){width, height}, bottom, out);
	}
	return count > 0 ? count : 1;
}

struct camera_region framing_region(const struct framing *framing,
	const struct bounds *bounds, int width, int height)
{
	struct camera_framing tried = framing->camera;
	struct camera_region region[2], best = {0.0f, 0.0f, 0.0f, 0.0f};
	int count = free_regions(framing, width, height, region);
	float least = 0.0f;

	tried.aspect = (float)width / (float)height;
	for (int i = 0; i < count; i++) {
		struct camera camera = camera_default();

		tried.region = region[i];
		camera_frame(&camera, bounds, &tried);
		if (i == 0 || camera.distance < least) {
			least = camera.distance;
			best = region[i];
		}
	}
	if (framing->labels_right) {
		best = (struct camera_region){
			-best.right, -best.left, best.bottom, best.top};
	}
	return best;
}
