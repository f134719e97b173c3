/* Lines that are one pixel wide, without a texture. */
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/points.h"
#include "platform/gl/soft/span/template.h"
#include "platform/gl/soft/span/tests.h"
#include "platform/gl/soft/span/walk.h"

enum {
	WIDTH_TWO_Q16 = 0x18000, /* the least width that is rounded to two */
	DIVIDED_STEP = 2, /* pixels of a run whose ends are divided exactly */
};

/*
 * The line's pixels (Bresenham's algorithm) and its values, which raster->plane
 * has by pixel along it. Each step leads one pixel along; whenever error, which
 * grows by add, reaches full, it is less by full and the step leads one pixel
 * across besides.
 */
struct walk {
	uint32_t error, add, full;
	int x, y;                /* of the next pixel */
	int along[2], across[2]; /* steps in x and y */
	int count;               /* pixels */
	int32_t length;          /* along, in sixteenths */
	int32_t off;             /* from the line's start to a centre, too */
	int32_t inverse;         /* 2^inverse_q / length */
	int inverse_q;
};

bool soft_lines_are_thin(const struct draw *draw, GLenum mode)
{
	const struct soft_spans *spans = &draw->spans;
	const struct soft *soft = draw->soft;

	return mode >= GL_LINES && mode <= GL_LINE_STRIP && !draw->smooth &&
		!draw->texture[0].used && !draw->texture[1].used &&
		!spans->stenciled && !spans->blended_last &&
		spans->color_mask == UINT32_MAX &&
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

/* A coordinate of both ends. */
struct ends {
	int32_t from, to;
};

/*
 * Finds the pixels: along u those whose centres lie from the first end on and
 * before the second; of v the pixel where the line meets their centres, of
 * borders between pixels the one to the left or below, as GL has it.
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

static void find_inverse(struct walk *walk)
{
	int zeros = LEADING_ZEROS_32((uint32_t)walk->length);

	walk->inverse = reciprocal((uint32_t)walk->length << zeros);
	walk->inverse_q = 62 - zeros;
}

/* As set_plane() in raster.c has it, of pixels along the line. */
static void set_plane(const struct walk *walk, int32_t from, int32_t to,
	int scale, struct plane *plane)
{
	/* Both are below 2^31. */
	int64_t product = (int64_t)(to - from) * walk->inverse;

	plane->dx = (int32_t)(product >> (walk->inverse_q - scale));
	plane->dy = 0;
	plane->start = ((uint32_t)from << (scale - 4)) +
		(uint32_t)(plane->dx >> 4) * (uint32_t)walk->off;
}

/* 1 / w of both ends in a common scale, below 2^29. */
static struct ends find_inverse_w(const struct vertex *a, const struct vertex *b)
{
	int most = a->w_zeros > b->w_zeros ? a->w_zeros : b->w_zeros;
	int32_t from = shift_by(a->inverse_w_q30, a->w_zeros - most - 2);
	int32_t to = shift_by(b->inverse_w_q30, b->w_zeros - most - 2);

	return (struct ends){from > 0 ? from : 1, to > 0 ? to : 1};
}

/* Whether colours that change by so much have to be divided by 1 / w. */
static bool is_divided(const struct draw *draw, const struct vertex *a,
	const struct vertex *b, uint32_t most)
{
	int32_t from = a->clip[3], to = b->clip[3];
	const struct perspective perspective = {
		.w_spread = raster_size(to - from),
		.w_least = (uint32_t)(from < to ? from : to),
	};

	return draw->perspective &&
		raster_bends(&perspective, most, rows_color_tolerance(draw));
}

/*
 * The ends' colours and fog, and which of them differ; what stays the same goes
 * into the span. Returns the most that one differs by.
 */
static uint32_t gather_colors(struct draw *draw, const struct vertex *a,
	const struct vertex *b, struct ends color[])
{
	const uint32_t wanted = draw->attributes & ~draw->spans.white_bits;
	struct raster *raster = &draw->raster;
	uint32_t most = 0;

	raster->moving_bits = 0;
	for (int i = RED; i <= FOG; i++) {
		bool flat = draw->soft->fragment.flat && i != FOG;
		int32_t white = (int32_t)(raster->span.value[i] >> 8);

		if (!(wanted >> i & 1)) {
			color[i] = (struct ends){white, white};
			continue;
		}
		color[i] = flat
			? (struct ends){draw->provoking->attribute[i],
				  draw->provoking->attribute[i]}
			: (struct ends){a->attribute[i], b->attribute[i]};
		raster->span.value[i] = (uint32_t)color[i].from << 8;
		raster->span.step[i] = 0;
		raster->moving_bits |= (uint32_t)(color[i].from != color[i].to)
			<< i;
		most = larger(most, raster_size(color[i].to - color[i].from));
	}
	return most;
}

static int32_t scale_by(int32_t value, int32_t inverse_w)
{
	return (int32_t)((int64_t)value * inverse_w >> 16);
}

/* Colours and fog as planes; divided by 1 / w, these are of their products. */
static void set_color_planes(struct draw *draw, const struct walk *walk,
	const struct vertex *a, const struct vertex *b)
{
	struct raster *raster = &draw->raster;
	struct ends color[FOG + 1], q = {0, 0};
	uint32_t most = gather_colors(draw, a, b, color);
	uint32_t planes = raster_color_planes(raster->moving_bits);

	raster->colors_divided = most > 0 && is_divided(draw, a, b, most);
	if (raster->colors_divided) {
		q = find_inverse_w(a, b);
		set_plane(walk, q.from, q.to, 4, &raster->plane[INVERSE_W]);
	}
	for (int i = RED; planes >> i; i++) {
		struct plane *plane = &raster->plane[i];

		if (raster->colors_divided) {
			set_plane(walk, scale_by(color[i].from, q.from),
				scale_by(color[i].to, q.to), 4, plane);
		} else {
			set_plane(walk, color[i].from, color[i].to, 12, plane);
		}
	}
}

static void place_divided_colors(const struct line *values, int x, int count)
{
	const struct walk_kind kind = {.colored = true, .colors_divided = true};
	const struct row_point from = find_point(values, kind, x);
	const struct row_point to = find_point(values, kind, x + count - 1);
	struct soft_spans *spans = &values->draw->spans;

	set_steps(values, kind, &from, &to, count - 1);
	set_colors(spans, from.colors.red, from.colors.green, from.colors.blue);
	set_more_colors(spans, &from.colors);
}

static ALWAYS_INLINE void draw_kind(const struct draw *draw, struct walk *given,
	int count, const struct soft_kind kind)
{
	const struct fragment_state *state = &draw->soft->fragment;
	const GLenum compares =
		state->depth_test ? state->depth_function : GL_ALWAYS;
	const bool writes_depth = state->depth_test && state->depth_mask;
	const struct soft_run *run = &draw->spans.run;
	/* No pixel lies in it, which the compiler cannot know. */
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
			soft_shade_pixel(&own, NULL, kind, &constants, &at,
				writes_depth ? depth : &unwritten,
				pixel_at(&buffers->target, walk.x, walk.y));
		}
		soft_step_pixel(&own, kind, &steps, &at);
		step(&walk);
	}
	*given = walk;
}

/*
 * The next pixels, whose values change linearly from the run's. The lines that
 * limber shows on the board are blended in RGB565: they have a loop of their own.
 */
static void draw_pixels(const struct draw *draw, struct walk *walk, int count)
{
	const struct soft_kind kind = {.finish = draw->spans.finish,
		.wide = draw->spans.pixel_log2 == 2};

	if (kind.finish == SOFT_BLENDED && !kind.wide) {
		draw_kind(draw, walk, count,
			(struct soft_kind){.finish = SOFT_BLENDED});
	} else {
		draw_kind(draw, walk, count, kind);
	}
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
	struct raster *raster = &draw->raster;
	struct walk walk;
	uint32_t moving;

	find_pixels(&walk, flat ? x : y, flat ? y : x, flat);
	if (walk.count <= 0) {
		return;
	}
	find_inverse(&walk);
	raster->perspective = false;
	raster->bent = false;
	if (draw->soft->fragment.depth_test) {
		set_plane(&walk, a->z, b->z, 12, &raster->plane[DEPTH]);
	}
	set_color_planes(draw, &walk, a, b);
	moving = soft_begin_walk(draw);
	soft_begin_steps(draw, moving);
	draw_runs(draw, &walk, moving != 0);
}
