/* Draws lines that are one pixel wide and have no texture. */
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/points.h"
#include "platform/gl/soft/span/template.h"
#include "platform/gl/soft/span/tests.h"
#include "platform/gl/soft/span/walk.h"

enum {
	WIDTH_TWO_Q16 = 0x18000, /* widths from here on round to two pixels */
	DIVIDED_STEP = 2, /* pixels of a run if colours are divided by 1 / w */
	HEIGHT = 256,     /* of set_planes()'s triangle, in 1/16 pixels */
};

/*
 * The line's pixels, by Bresenham's algorithm. Each step goes one pixel along
 * and adds add to error; where error reaches full, full is subtracted and the
 * step goes one pixel across, too. raster->plane has the line's values, with x
 * the number of the pixel.
 */
struct walk {
	uint32_t error, add, full;
	int x, y;                /* of the next pixel */
	int along[2], across[2]; /* steps in x and y */
	int count;               /* pixels */
	int32_t length;          /* along the longer axis, in 1/16 pixels */
	int32_t off; /* from the line's start to the first centre, the same */
};

bool soft_lines_are_thin(const struct draw *draw, GLenum mode)
{
	const struct soft_spans *spans = &draw->spans;
	const struct soft *soft = draw->soft;

	return mode >= GL_LINES && mode <= GL_LINE_STRIP && !draw->smooth &&
		!draw->texture[0].used && !draw->texture[1].used &&
		!soft->fragment.stencil.enabled && !spans->blended_last &&
		soft->fragment.color_bits == UINT32_MAX &&
		soft->fragment.line_width < WIDTH_TWO_Q16 && !soft->fill &&
		!soft->counts;
}

static bool is_in_box(const struct clip_box *box, int x, int y)
{
	return x >= box->left && x < box->right && y >= box->top &&
		y < box->bottom;
}

static ALWAYS_INLINE void step(struct walk *walk)
{
	walk->error += walk->add;
	walk->x += walk->along[0];
	walk->y += walk->along[1];
	if (walk->error >= walk->full) {
		walk->error -= walk->full;
		walk->x += walk->across[0];
		walk->y += walk->across[1];
	}
}

/* One coordinate of the line's ends, in 1/16 pixels. */
struct ends {
	int32_t from, to;
};

/*
 * Finds the pixels. Along u, the longer axis, they are those whose centres lie
 * from the first end on and before the second; in v, each is the one that the
 * line crosses there; on a border the left or lower one, as in GL.
 */
static void find_pixels(
	struct walk *walk, struct ends u, struct ends v, bool flat)
{
	bool back = u.to < u.from, up = v.to < v.from;
	int32_t length = back ? u.from - u.to : u.to - u.from;
	int32_t dv = v.to - v.from, full = 16 * length, error;
	int first = back ? (u.from - 8) >> 4 : raster_centre(u.from);
	int end = back ? (u.to - 8) >> 4 : raster_centre(u.to);
	int pixel = v.from >> 4, off = 16 * first + 8 - u.from;

	walk->count = back ? first - end : end - first;
	walk->length = length;
	walk->off = back ? -off : off;
	error = (v.from & 15) * length + dv * walk->off + (flat ? length : 0) -
		1;
	if (error < 0 || error >= full) {
		pixel += error < 0 ? -1 : 1;
		error += error < 0 ? full : -full;
	}
	walk->error = (uint32_t)(up ? full - 1 - error : error);
	walk->add = 16 * (uint32_t)(up ? -dv : dv);
	walk->full = (uint32_t)full;
	walk->x = flat ? first : pixel;
	walk->y = flat ? pixel : first;
	walk->along[!flat] = back ? -1 : 1;
	walk->along[flat] = 0;
	walk->across[flat] = up ? -1 : 1;
	walk->across[!flat] = 0;
}

/*
 * Sets up planes as of a triangle whose upper side is the line, laid level: its
 * first pixel is at column 0 and row 0, the others follow to the right, and
 * downwards values are constant.
 */
static void set_planes(struct draw *draw, const struct walk *walk,
	const struct vertex *a, const struct vertex *b)
{
	struct vertex corner[3] = {*a, *b, *a};
	struct setup setup = {
		.v = {&corner[0], &corner[1], &corner[2]},
		.wide = walk->length > SMALL_EXTENT,
		.area = (uint64_t)walk->length * HEIGHT,
	};

	for (int i = 0; i < 3; i++) {
		corner[i].x = 8 - walk->off + (i == 1 ? walk->length : 0);
		corner[i].y = 8 + (i == 2 ? HEIGHT : 0);
		if (draw->soft->fragment.flat) {
			memcpy(corner[i].attribute, draw->provoking->attribute,
				sizeof(corner[i].back));
		}
	}
	soft_raster_set_up(draw, &setup);
}

static void place_divided_colors(const struct line *values, int x, int count)
{
	const struct walk_kind kind = {.colored = true, .colors_divided = true};
	const struct row_point from = find_point(values, kind, 0, x);
	const struct row_point to = find_point(values, kind, 0, x + count - 1);
	struct soft_spans *spans = &values->draw->spans;

	set_steps(values, kind, &from, &to, count - 1);
	set_colors(spans, from.colors.red, from.colors.green, from.colors.blue);
	set_more_colors(
		spans, &spans->run.row, from.colors.alpha, from.colors.fog);
}

/* Draws the next count pixels, linear from spans.run's values. */
static void draw_pixels(const struct draw *draw, struct walk *given, int count)
{
	const struct soft_kind kind = {.finish = draw->spans.finish,
		.wide = draw->spans.pixel_log2 == 2};
	const struct fragment_state *state = &draw->soft->fragment;
	const GLenum compares =
		state->depth_test ? state->depth_function : GL_ALWAYS;
	const bool writes_depth = state->depth_test && state->depth_mask;
	const struct soft_run *run = &draw->spans.run;
	/* a local copy: the compiler sees that no pixel overwrites it */
	const struct soft_run own = {
		.fog_right = run->fog_right, .stages = run->stages};
	const struct buffers *buffers = &draw->soft->buffers;
	const struct clip_box box = draw->box;
	struct walk walk = *given;
	struct soft_steps steps = soft_find_steps(run);
	const struct soft_constants constants = soft_find_constants(&own, kind);
	struct soft_pixel at = {.z = run->row.z,
		.red_blue = run->row.red_blue,
		.green_alpha = run->row.green_alpha,
		.fog = run->row.fog};
	uint16_t unwritten;

	for (; count > 0; count--) {
		const bool seen = is_in_box(&box, walk.x, walk.y);
		uint16_t *depth = buffers->depth +
			(seen ? (ptrdiff_t)walk.y * buffers->width + walk.x : 0);

		if (seen && soft_compares(compares, at.z >> 16, *depth)) {
			soft_shade_pixel(&own, NULL, kind, &constants, &at, 1,
				writes_depth ? depth : &unwritten,
				pixel_at(&buffers->target, walk.x, walk.y));
		}
		soft_step_pixel(&own, kind, &steps, &at);
		step(&walk);
	}
	*given = walk;
}

/* Draws runs of pixels whose values change linearly. */
static void draw_runs(struct draw *draw, struct walk *walk, bool moving)
{
	const struct line values = {.draw = draw};
	const bool divided = draw->raster.colors_divided;
	const int most = divided ? DIVIDED_STEP : draw->spans.plain_pixels;
	struct soft_run *run = &draw->spans.run;

	for (int x = 0; x < walk->count; x += most) {
		int count = walk->count - x < most ? walk->count - x : most;

		if (divided) {
			place_divided_colors(&values, x, count);
		} else if (moving) {
			place_colors(&values, x, count);
		}
		run->row.z = (uint32_t)find_value(&values, DEPTH, x) << 6;
		draw_pixels(draw, walk, count);
	}
}

void soft_draw_thin_line(
	struct draw *draw, const struct vertex *a, const struct vertex *b)
{
	const struct ends x = {a->x, b->x}, y = {a->y, b->y};
	bool flat = raster_size(x.to - x.from) >= raster_size(y.to - y.from);
	struct walk walk;
	uint32_t moving;

	find_pixels(&walk, flat ? x : y, flat ? y : x, flat);
	if (walk.count <= 0) {
		return;
	}
	set_planes(draw, &walk, a, b);
	moving = soft_begin_walk(draw, 127);
	soft_begin_steps(draw, moving);
	draw_runs(draw, &walk, moving != 0);
}
