/*
 * Draws lines that are one pixel wide, and points: without a texture or smooth
 * edges. Their runs are listed for the span function.
 */
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/points.h"
#include "platform/gl/soft/span/walk.h"

enum {
	WIDTH_TWO_Q16 = 0x18000, /* widths from here on round to two pixels */
	DIVIDED_STEP = 2, /* pixels of a run if colours are divided by 1 / w */
	HEIGHT = 256,     /* of set_planes()'s triangle, in 1/16 pixels */
};

/*
 * The line's pixels, by Bresenham's algorithm. Each step goes one pixel along
 * u, which is x of flat lines and y of steep ones, and adds add to error; where
 * error reaches full, full is subtracted and the step goes one pixel along v,
 * too. raster->plane has the line's values, with x the number of the pixel.
 */
struct walk {
	uint32_t error, add, full;
	int u, v;       /* of the next pixel */
	int v_step;     /* 1 or -1; u grows */
	int count;      /* pixels */
	int32_t length; /* along u, in 1/16 pixels */
	int32_t off; /* from the line's start to the first centre, the same */
	bool flat;
};

bool soft_lists_primitives(const struct draw *draw)
{
	const struct soft *soft = draw->soft;

	return draw->primitive != GL_TRIANGLES && !draw->smooth &&
		!draw->texture[0].used &&
		(draw->primitive == GL_POINTS ||
			soft->fragment.line_width < WIDTH_TWO_Q16) &&
		!soft->fill && !soft->counts;
}

/* Sets where a run of columns from x to right is, in draw->box. */
static ALWAYS_INLINE void place_run(
	const struct draw *draw, int x, int right, int y, struct soft_row *row)
{
	const struct buffers *buffers = &draw->soft->buffers;

	row->depth = buffers->depth + (ptrdiff_t)y * buffers->width + x;
	row->pixel = buffers->target.data +
		(ptrdiff_t)y * buffers->target.stride_bytes +
		(x << draw->spans.pixel_log2);
	row->count = (uint32_t)(right - x);
}

/* One coordinate of the line's ends, in 1/16 pixels. */
struct ends {
	int32_t from, to;
};

/*
 * Finds the pixels of a line along which u grows, or fell before its ends were
 * exchanged. Along u, the longer axis, they are those whose centres lie from
 * the first end on and before the second; in v, each is the one that the line
 * crosses there; on a border the left or lower one, as in GL.
 */
static void find_pixels(struct walk *walk, struct ends u, struct ends v,
	bool flat, bool exchanged)
{
	const bool up = v.to < v.from;
	const int32_t length = u.to - u.from, full = 16 * length;
	/* a centre on an end belongs to the line at its first end alone */
	const int first = raster_centre(u.from + exchanged);
	const int end = raster_centre(u.to + exchanged);
	const int off = 16 * first + 8 - u.from;
	int32_t dv = v.to - v.from, error;
	int pixel = v.from >> 4;

	error = (v.from & 15) * length + dv * off + (flat ? length : 0) - 1;
	if (error < 0 || error >= full) {
		pixel += error < 0 ? -1 : 1;
		error += error < 0 ? full : -full;
	}
	*walk = (struct walk){
		.error = (uint32_t)(up ? full - 1 - error : error),
		.add = 16 * (uint32_t)(up ? -dv : dv),
		.full = (uint32_t)full,
		.u = first,
		.v = pixel,
		.v_step = up ? -1 : 1,
		.count = end - first,
		.length = length,
		.off = off,
		.flat = flat,
	};
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

static ALWAYS_INLINE void set_linear(struct plane *plane,
	const struct walk *walk, const int32_t *inverse_q31, int32_t from,
	int32_t to)
{
	plane->dx =
		mul_high((to - from) * (1 << 12), inverse_q31[walk->length]) * 2;
	plane->dy = 0;
	plane->start = ((uint32_t)from << 8) +
		(uint32_t)((plane->dx >> 4) * walk->off);
}

/* Sets planes of a short line whose values are linear; false of any other. */
static bool set_linear_planes(struct draw *draw, const struct walk *walk,
	const struct vertex *a, const struct vertex *b)
{
	const struct setup setup = {.v = {a, b, b}};
	const bool flat = draw->soft->fragment.flat;
	const uint32_t wanted = draw->attributes & ~draw->spans.white_bits;
	struct raster *raster = &draw->raster;

	if (walk->length > SMALL_EXTENT ||
		!rows_are_linear(draw, &setup, rows_color_tolerance(draw))) {
		return false;
	}
	raster->perspective = raster->colors_divided = raster->bent = false;
	raster->moving_bits = 0;
	set_linear(&raster->plane[DEPTH], walk, draw->inverse_q31, a->z, b->z);
	for (int i = RED; i <= FOG; i++) {
		const bool one = flat && i <= ALPHA;
		const struct vertex *from = one ? draw->provoking : a;
		const struct vertex *to = one ? from : b;

		if (wanted >> i & 1) {
			raster->constant[i] = (uint32_t)from->attribute[i] << 8;
			raster->moving_bits |=
				(uint32_t)(from->attribute[i] != to->attribute[i])
				<< i;
			set_linear(&raster->plane[i], walk, draw->inverse_q31,
				from->attribute[i], to->attribute[i]);
		} else if (i <= BLUE) {
			raster->plane[i] =
				(struct plane){raster->constant[i], 0, 0};
		}
	}
	return true;
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

/*
 * Draws the next count pixels, linear from spans.run's values at the first one:
 * a run for each row of the picture.
 */
static ALWAYS_INLINE void draw_pixels(
	struct draw *draw, struct walk *given, int count, bool flat)
{
	const struct clip_box box = draw->box;
	struct soft_run *run = &draw->spans.run;
	struct soft_row list[SOFT_BATCH_RUNS], *row = list;
	struct walk walk = *given;
	const int from = walk.u, end = walk.u + count;

	*row = run->row;
	while (walk.u != end) {
		const int u = walk.u, v = walk.v;
		int x, right, y;
		uint32_t off;

		do {
			walk.u++;
			walk.error += walk.add;
			if (walk.error >= walk.full) {
				walk.error -= walk.full;
				walk.v += walk.v_step;
			}
		} while (flat && walk.v == v && walk.u != end);
		x = flat ? u : v;
		right = flat ? walk.u : v + 1;
		y = flat ? v : u;
		x = x > box.left ? x : box.left;
		right = right < box.right ? right : box.right;
		if (x >= right || y < box.top || y >= box.bottom) {
			continue;
		}
		place_run(draw, x, right, y, row);
		off = (uint32_t)((flat ? x : y) - from);
		row->z = run->row.z + run->z_right * off;
		row->red_blue = run->row.red_blue + run->red_blue_right * off;
		row->green_alpha =
			run->row.green_alpha + run->green_alpha_right * off;
		row->fog = run->row.fog + run->fog_right * off;
		if (++row == list + SOFT_BATCH_RUNS) {
			soft_draw_runs(&draw->spans, list, row);
			row = list;
		}
	}
	soft_draw_runs(&draw->spans, list, row);
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
		if (walk->flat) {
			draw_pixels(draw, walk, count, true);
		} else {
			draw_pixels(draw, walk, count, false);
		}
	}
}

void soft_draw_thin_line(
	struct draw *draw, const struct vertex *a, const struct vertex *b)
{
	const bool flat = raster_size(b->x - a->x) >= raster_size(b->y - a->y);
	const bool back = flat ? b->x < a->x : b->y < a->y;
	const struct vertex *from = back ? b : a, *to = back ? a : b;
	const struct ends x = {from->x, to->x}, y = {from->y, to->y};
	struct walk walk;
	uint32_t moving;

	find_pixels(&walk, flat ? x : y, flat ? y : x, flat, back);
	if (walk.count <= 0) {
		return;
	}
	if (!set_linear_planes(draw, &walk, from, to)) {
		set_planes(draw, &walk, from, to);
	}
	moving = soft_begin_walk(draw, 127);
	soft_begin_steps(draw, moving);
	draw_runs(draw, &walk, moving != 0);
}

void soft_draw_sharp_point(
	struct draw *draw, const struct vertex *v, struct clip_box place)
{
	struct soft_run *run = &draw->spans.run;
	struct soft_row list[SOFT_BATCH_RUNS], *row = list;
	int width;

	place = raster_clip(draw, place);
	width = place.right - place.left;
	if (width <= 0) {
		return;
	}
	*row = run->row;
	for (int i = RED; i <= FOG; i++) {
		if (draw->attributes & ~draw->spans.white_bits & 1u << i) {
			draw->raster.constant[i] = (uint32_t)v->attribute[i]
				<< 8;
		}
	}
	draw->raster.moving_bits = 0;
	draw->raster.plane[DEPTH].dx = 0;
	soft_begin_walk(draw, 1);
	run->row.z = (uint32_t)v->z << 14;
	for (int y = place.top; y < place.bottom; y++) {
		*row = run->row;
		place_run(draw, place.left, place.right, y, row++);
		if ((row - list + 1) * width > SOFT_BATCH_PIXELS) {
			soft_draw_runs(&draw->spans, list, row);
			row = list;
		}
	}
	soft_draw_runs(&draw->spans, list, row);
}
