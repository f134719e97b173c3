/*
 * Walks the rows of triangles in which nothing is divided by w: lists their
 * runs, and calls the span function for many runs at once.
 */
#include "platform/gl/soft/raster/frame.h"
#include "platform/gl/soft/span/colors.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/span/walk.h"

/* The kind of a triangle's list, which is a constant of the loop. */
struct list_kind {
	bool textured, bent;
	bool certain; /* see struct run_list */
};

/* to + a * b as one instruction: compilers would sum all products first. */
static ALWAYS_INLINE uint32_t add_product(uint32_t to, uint32_t a, uint32_t b)
{
	to += a * b;
	OPAQUE(to);
	return to;
}

/* A value at column x of row y. */
static ALWAYS_INLINE uint32_t find_there(
	const struct plane *plane, uint32_t x, uint32_t y)
{
	return add_product(add_product(plane->start, (uint32_t)plane->dy, y),
		(uint32_t)plane->dx, x);
}

/* A run's first coordinate, counted from the window's, and its step. */
static ALWAYS_INLINE struct soft_coordinate find_coordinate(
	const struct list_coordinate *c, const struct list_kind kind,
	uint32_t x, uint32_t y, uint32_t count)
{
	const uint32_t half = count >> 1;
	uint32_t middle, right = c->level_right, at;

	if (kind.bent) {
		const uint32_t xx = (uint32_t)c->bend.xx;
		uint32_t slope = add_product(add_product((uint32_t)c->plane.dx,
						     (uint32_t)c->bend.xy, y),
			xx, x);
		uint32_t step = add_product(slope, xx, x + count);
		uint32_t down = add_product(
			(uint32_t)c->plane.dy, (uint32_t)c->bend.yy, y);

		middle = add_product(c->plane.start, down, y);
		middle = add_product(middle, slope, x);
		middle = add_product(middle, step, half);
		right = (uint32_t)((int32_t)(step + c->round) >> c->shift);
	} else {
		middle = find_there(&c->plane, x + half, y);
	}
	at = (uint32_t)((int32_t)middle >> c->shift) - right * half;
	return (struct soft_coordinate){
		kind.certain ? at : (at - c->offset) & c->mask, right};
}

static ALWAYS_INLINE bool is_outside(const struct list_coordinate *c,
	struct soft_coordinate found, uint32_t count)
{
	return found.at >= c->room ||
		found.at + found.right * (count - 1) >= c->room;
}

/* Draws a run that leaves the window at once, instead of listing it. */
static NEVER_INLINE void draw_outside(struct run_list *list,
	const struct soft_row *row, struct soft_coordinate s,
	struct soft_coordinate t)
{
	struct soft_spans *spans = &list->draw->spans;
	struct soft_run *run = &spans->run;

	run->row = *row;
	run->s = (struct soft_coordinate){s.at + list->s.first, s.right};
	run->t = (struct soft_coordinate){t.at + list->t.first, t.right};
	if (soft_find_window(&spans->levels[0].view, run)) {
		spans->draw(run);
	} else {
		soft_draw_across(spans);
	}
}

/* Sets a run's place, and those colours that are found from planes. */
static NEVER_INLINE void set_rare(
	const struct run_list *list, struct soft_row *row, int x, int y)
{
	const struct soft_spans *spans = &list->draw->spans;
	const struct soft_row *own = &spans->run.row;
	const struct line line = {.draw = list->draw, .row = y};

	row->place = (uint32_t)y << 16 | (uint32_t)x;
	if (list->colors_exact) {
		place_colors(&line, x, (int)row->count);
		row->red_blue = own->red_blue;
		row->green_alpha = own->green_alpha;
		row->fog = own->fog;
		return;
	}
	set_more_colors(spans, row, find_value(&line, ALPHA, x),
		find_value(&line, FOG, x));
}

/* Sets a run's texels; false if it left the window and is drawn already. */
static ALWAYS_INLINE bool set_texel(struct run_list *list,
	const struct list_kind kind, struct soft_row *row, uint32_t x,
	uint32_t y)
{
	const uint32_t count = row->count;
	const struct soft_coordinate s =
		find_coordinate(&list->s, kind, x, y, count);
	const struct soft_coordinate t =
		find_coordinate(&list->t, kind, x, y, count);

	row->texel = (t.at << 16) + s.at;
	row->texel_right = (t.right << 16) + s.right;
	if (!kind.certain &&
		(is_outside(&list->s, s, count) ||
			is_outside(&list->t, t, count))) {
		draw_outside(list, row, s, t);
		return false;
	}
	return true;
}

/* Sets a run at column x, row y, whose count is set; false if it is drawn. */
static ALWAYS_INLINE bool set_run(struct run_list *list,
	const struct list_kind kind, struct soft_row *row, uint32_t x,
	uint32_t y)
{
	row->z = find_there(&list->z, x, y);
	row->red_blue = find_there(&list->red_blue, x, y);
	row->green_alpha = find_there(&list->green, x, y);
	row->fog = list->fog;
	if (list->rare && list->alpha_alone) {
		row->green_alpha +=
			find_there(&list->draw->raster.plane[ALPHA], x, y) >> 9
				<< 16;
	} else if (list->rare) {
		set_rare(list, row, (int)x, (int)y);
	}
	return !kind.textured || set_texel(list, kind, row, x, y);
}

void soft_draw_runs(struct soft_spans *spans, const struct soft_row *rows,
	const struct soft_row *end)
{
	struct soft_run *run = &spans->run;

	run->rows = rows;
	run->row_count = (uint32_t)(end - rows);
	if (end > rows) {
		spans->draw(run);
	}
	run->rows = &run->row;
	run->row_count = 1;
}

/* Draws the runs before end; returns the list's first element, now free. */
static NEVER_INLINE struct soft_row *draw_listed(
	struct run_list *list, const struct soft_row *end)
{
	struct soft_spans *spans = &list->draw->spans;
	const uint8_t *first_texel = spans->run.first_texel;

	spans->run.first_texel = list->first_texel;
	soft_draw_runs(spans, list->row, end);
	/* It belongs to the window, which triangles of the same level keep. */
	spans->run.first_texel = first_texel;
	return list->row;
}

/* Lists the runs of the rows between list->edges. */
static ALWAYS_INLINE void list_rows(
	struct run_list *list, const struct list_kind kind)
{
	const struct draw *draw = list->draw;
	const struct buffers *buffers = &draw->soft->buffers;
	const struct clip_box box = draw->box;
	const int pixel_log2 = draw->spans.pixel_log2;
	const int width = buffers->width;
	const int stride_bytes = buffers->target.stride_bytes;
	struct band_edges edges = list->edges;
	struct soft_row *row = list->next;
	uint16_t *depth = list->depth;
	uint8_t *pixel = list->pixel;
	int y = list->y;

	for (; edges.rows > 0; band_next_row(&edges), y++) {
		int x = band_column(&edges, BAND_LEFT);
		int right = band_column(&edges, BAND_RIGHT);

		if (!kind.certain) {
			x = x > box.left ? x : box.left;
			right = right < box.right ? right : box.right;
		}
		while (x < right) {
			int count = right - x;

			count = kind.certain || count < list->most ? count
								   : list->most;
			row->depth = depth + x;
			row->pixel = pixel + (x << pixel_log2);
			row->count = (uint32_t)count;
			if (set_run(list, kind, row, (uint32_t)x, (uint32_t)y) &&
				++row == list->end) {
				row = draw_listed(list, row);
			}
			x += count;
			if (kind.certain) {
				break;
			}
		}
		depth += width;
		pixel += stride_bytes;
	}
	list->edges = edges;
	list->next = row;
	list->depth = depth;
	list->pixel = pixel;
	list->y = y;
}

#define LIST(name, ...)                                           \
	static void list_##name(void *list)                       \
	{                                                         \
		list_rows(list, (struct list_kind){__VA_ARGS__}); \
	}

LIST(plain, .textured = false)
LIST(certain_plain, .textured = false, .certain = true)
LIST(linear, .textured = true)
LIST(bent, .textured = true, .bent = true)
LIST(certain, .textured = true, .certain = true)
LIST(certain_bent, .textured = true, .bent = true, .certain = true)

void soft_walk_list(struct run_list *list, const struct setup *setup)
{
	const struct draw *draw = list->draw;
	const struct buffers *buffers = &draw->soft->buffers;
	const int top = raster_first_row(draw, setup);
	const bool bent = draw->raster.bent;
	void (*const function)(void *list) =
		!draw->spans.textured || draw->spans.made
		? (list->certain ? list_certain_plain : list_plain)
		: list->certain ? (bent ? list_certain_bent : list_certain)
		: bent          ? list_bent
				: list_linear;

	list->next = list->row;
	list->y = top - setup->top;
	list->depth = buffers->depth + (ptrdiff_t)top * buffers->width;
	list->pixel = buffers->target.data +
		(ptrdiff_t)top * buffers->target.stride_bytes;
	if ((list->certain || setup->inside) && !draw->fourth) {
		frame_draw_bands(draw, setup, true, setup->middle_left,
			&list->edges, function, list);
	} else {
		frame_draw_bands(draw, setup, false, setup->middle_left,
			&list->edges, function, list);
	}
	draw_listed(list, list->next);
}
