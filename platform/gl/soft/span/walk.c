/*
 * The rows of a triangle, cut into runs. Values run linearly along a row where
 * perspective bends them too little to be seen, see raster.c; else they bend or
 * are divided every few pixels.
 */
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/span/colors.h"
#include "platform/gl/soft/span/list.h"

/* What is the same for all of a triangle's lists. */
struct walk {
	struct draw *draw;
	const struct setup *setup;
	uint32_t moving;
	int most; /* pixels of a run */
	int pixel_log2;
	/* that may be listed; of what is divided, that may begin a distance */
	const struct soft_row *last;
	struct soft_list list;
};

/* How runs are listed, by constants. */
struct listing {
	bool inside; /* all of the triangle is, and it is not wide */
	bool divided;
};

static NEVER_INLINE void find_inverses(
	const struct draw *draw, struct soft_list *list)
{
	const struct soft_list_value value =
		soft_list_begin(&draw->raster, INVERSE_W);

	for (struct soft_row *row = list->row; row < list->end; row = row->next) {
		int32_t q = (int32_t)soft_list_find(&value, row);
		uint32_t size = (uint32_t)(q > 0 ? q : 1), zeros;

		OPAQUE(size); /* else all that follows is conditional */
		zeros = (uint32_t)LEADING_ZEROS_32(size);
		row->inverse = reciprocal(size << zeros);
		row->shift = zeros - 2;
	}
}

/* What the triangle has one of. */
static NEVER_INLINE void set_still(
	const struct draw *draw, struct soft_list *list)
{
	const struct soft_row still = draw->spans.run.row;
	const struct soft_list_value z = soft_list_begin_z(&draw->raster);

	for (struct soft_row *row = list->row; row < list->end; row++) {
		row->z = soft_list_find(&z, row);
		row->red_blue = still.red_blue;
		row->green_alpha = still.green_alpha;
		row->red_blue_right = 0;
		row->green_alpha_right = 0;
	}
}

static NEVER_INLINE void set_fog(const struct draw *draw, struct soft_list *list)
{
	const struct soft_spans *spans = &draw->spans;
	const uint32_t fog = spans->fog_moves ? 0 : spans->run.row.fog;

	for (struct soft_row *row = list->row; row < list->end; row++) {
		row->fog = fog;
		row->fog_right = 0;
	}
}

/* One by one, where the span function takes no list. */
static void draw_singly(struct soft_spans *spans, const struct soft_list *list)
{
	const struct soft_row still = spans->run.row;

	for (const struct soft_row *row = list->row; row < list->end; row++) {
		if (row->count == 0) {
			continue;
		}
		spans->run.row = *row;
		if (spans->made && spans->textured) {
			spans->made_at = (struct soft_made_at){
				row->s, row->t, row->s_right, row->t_right};
		}
		spans->draw(&spans->run);
	}
	spans->run.row = still;
}

static void draw_all(struct soft_spans *spans, const struct soft_list *list)
{
	struct soft_run *run = &spans->run;

	if (!spans->lists_runs) {
		draw_singly(spans, list);
		return;
	}
	run->rows = list->row;
	run->row_count = (uint32_t)(list->end - list->row);
	spans->draw(run);
	run->rows = &run->row;
	run->row_count = 1;
}

static NEVER_INLINE void draw_list(struct walk *walk)
{
	struct draw *draw = walk->draw;
	struct soft_spans *spans = &draw->spans;
	struct soft_list *list = &walk->list;

	if (draw->raster.perspective) {
		find_inverses(draw, list);
	}
	if (spans->fogged) {
		set_fog(draw, list);
	}
	if (walk->moving) {
		soft_list_colors(draw, walk->setup, list);
	} else {
		set_still(draw, list);
	}
	if (spans->textured) {
		soft_list_texels(draw, list);
	}
	draw_all(spans, list);
	list->end = list->row;
}

/* raster_side() of a triangle that is inside. */
static ALWAYS_INLINE struct side find_side(
	const struct draw *draw, const struct vertex *a, const struct vertex *b)
{
	int32_t dy = b->y - a->y;
	int32_t step =
		mul_high((b->x - a->x) * (1 << 17), draw->inverse_q31[dy]);

	return (struct side){
		(a->x << 12) + (step >> 4) * ((8 - a->y) & 15), step};
}

static ALWAYS_INLINE struct side begin_side(const struct walk *walk,
	const struct listing how, int from, int to, int y)
{
	const struct vertex *const *v = walk->setup->v;

	return how.inside ? find_side(walk->draw, v[from], v[to])
			  : raster_side(walk->draw, v[from], v[to], y);
}

/* How many pixels apart divisions are. */
static ALWAYS_INLINE int find_spacing(
	const struct raster *raster, int y, int x, int right)
{
	const struct plane *q = &raster->plane[INVERSE_W];
	uint32_t left_q = q->start + (uint32_t)q->dy * (uint32_t)y +
		(uint32_t)q->dx * (uint32_t)x;

	return rows_find_spacing(raster, left_q,
		left_q + (uint32_t)q->dx * (uint32_t)(right - 1 - x));
}

static ALWAYS_INLINE struct soft_row *draw_listed(
	struct walk *walk, struct soft_row *end)
{
	walk->list.end = end;
	draw_list(walk);
	return walk->list.row;
}

/* A row under way. */
struct line {
	uint16_t *depth; /* of column 0 */
	uint8_t *pixel;
	int y; /* from the triangle's first one */
};

static ALWAYS_INLINE void set_run(struct soft_row *row, const struct walk *walk,
	const struct line *line, int x, int count)
{
	row->count = (uint32_t)count;
	row->x = (uint32_t)x;
	row->y = (uint32_t)line->y;
	row->depth = line->depth + x;
	row->pixel = line->pixel + (x << walk->pixel_log2);
}

/* Where a line, or a list within it, ends. */
static ALWAYS_INLINE void set_end(
	struct soft_row *row, const struct line *line, int x)
{
	row->count = 0;
	row->x = (uint32_t)x;
	row->y = (uint32_t)line->y;
	row->next = row + 1;
}

static ALWAYS_INLINE struct soft_row *list_row(struct walk *walk,
	struct soft_row *row, const struct line *line, int x, int right)
{
	const int most = walk->most;

	for (; right - x > most; x += most) {
		set_run(row, walk, line, x, most);
		row++;
		if (row == walk->last) {
			row = draw_listed(walk, row);
		}
	}
	set_run(row, walk, line, x, right - x);
	row++;
	return row == walk->last ? draw_listed(walk, row) : row;
}

/* The same where something is divided. */
static ALWAYS_INLINE struct soft_row *list_divided_row(struct walk *walk,
	struct soft_row *row, const struct line *line, int x, int right)
{
	const int spacing = find_spacing(&walk->draw->raster, line->y, x, right);
	const int most = walk->most;

	while (x < right) {
		int next = right - x > spacing ? x + spacing : right;
		struct soft_row *first;

		if (row > walk->last) {
			set_end(row, line, x);
			row = draw_listed(walk, row + 1);
		}
		first = row;
		do {
			int count = next - x < most ? next - x : most;

			set_run(row, walk, line, x, count);
			row++;
			x += count;
		} while (x < next);
		first->next = row;
	}
	set_end(row, line, right - 1);
	row++;
	return walk->draw->spans.level_by_row ? draw_listed(walk, row) : row;
}

/* Rows between two edges; y counts from the triangle's first one. */
static ALWAYS_INLINE void list_part(struct walk *walk, const struct listing how,
	int y, int end, struct side *left_side, struct side *right_side)
{
	const struct buffers *buffers = &walk->draw->soft->buffers;
	const struct clip_box *box = &walk->draw->box;
	const int width = buffers->width, top = walk->setup->top;
	const int stride_bytes = buffers->target.stride_bytes;
	struct line line = {
		.depth = buffers->depth + (ptrdiff_t)(top + y) * width,
		.pixel = buffers->target.data +
			(ptrdiff_t)(top + y) * stride_bytes,
		.y = y,
	};
	const int box_left = box->left, box_right = box->right;
	struct side first = *left_side, last = *right_side;
	struct soft_row *row = walk->list.end;

	for (; line.y < end; line.y++) {
		int left = raster_column(first.x);
		int right = raster_column(last.x);

		if (!how.inside) {
			left = left > box_left ? left : box_left;
			right = right < box_right ? right : box_right;
		}
		if (left < right) {
			row = how.divided
				? list_divided_row(walk, row, &line, left, right)
				: list_row(walk, row, &line, left, right);
		}
		raster_next_side(&first);
		raster_next_side(&last);
		line.depth += width;
		line.pixel += stride_bytes;
	}
	walk->list.end = row;
	*left_side = first;
	*right_side = last;
}

/* All rows, above and below the middle vertex. */
static ALWAYS_INLINE void list_rows(struct walk *walk, const struct listing how)
{
	const struct setup *setup = walk->setup;
	const struct draw *draw = walk->draw;
	int y = raster_first_row(draw, setup), top = setup->top;
	int bottom = setup->bottom < draw->box.bottom ? setup->bottom
						      : draw->box.bottom;
	struct side side[2]; /* left and right */
	int part = setup->middle_left ? 0 : 1;

	walk->list.end = walk->list.row;
	side[!part] = begin_side(walk, how, 0, 2, y);
	for (int i = 0; i < 2; i++) {
		int end = i == 0 && setup->middle < bottom ? setup->middle
							   : bottom;

		if (y < end) {
			side[part] = begin_side(walk, how, i, i + 1, y);
			list_part(walk, how, y - top, end - top, &side[0],
				&side[1]);
			y = end;
		}
	}
	if (walk->list.end != walk->list.row) {
		draw_list(walk);
	}
}

static NEVER_INLINE void list_inside(struct walk *walk)
{
	list_rows(walk, (struct listing){.inside = true});
}

static NEVER_INLINE void list_clipped(struct walk *walk)
{
	list_rows(walk, (struct listing){.inside = false});
}

static NEVER_INLINE void list_divided(struct walk *walk)
{
	list_rows(walk, (struct listing){.divided = true});
}

void soft_walk_rows(struct draw *draw, const struct setup *setup)
{
	const struct raster *raster = &draw->raster;
	struct walk walk;

	walk.draw = draw;
	walk.setup = setup;
	walk.moving = soft_begin_walk(draw);
	walk.most = raster->bent       ? raster->bent_pixels
		: draw->spans.textured ? SOFT_RUN_PIXELS
				       : draw->spans.plain_pixels;
	walk.pixel_log2 = draw->spans.pixel_log2;
	walk.last = &walk.list.row[SOFT_LIST_RUNS];
	if (raster->perspective) {
		walk.last -= SOFT_PLAIN_PIXELS / SOFT_RUN_PIXELS + 1;
		list_divided(&walk);
	} else if (setup->inside && !setup->wide) {
		list_inside(&walk);
	} else {
		list_clipped(&walk);
	}
}
