/*
 * The rows of small triangles: all of a triangle's runs are listed, value by
 * value, and the span function draws them in one call. Colours run in the run's
 * own numbers: such triangles are too small to lose more of them to rounding
 * than they have to spare.
 */
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/colors.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/span/walk.h"

enum {
	RUNS = 64, /* in a triangle, at most */
	/*
	 * Columns and rows: a step is off by half of 1/16384 in each. White
	 * times 255 leaves less room below 256 than times 31 below 32.
	 */
	SMALL_COLORS = 62,
	SMALL_COLORS_8888 = 40,
};

/* Where a run is: its first column, and the row from the triangle's first. */
struct place {
	uint32_t x, y;
	uint32_t s, s_right; /* in the window */
};

struct list {
	struct soft_row *end;
	struct place *place_end;
	struct place place[RUNS];
	struct soft_row row[RUNS];
};

/* A value of a run's, at column 0 of the first row; wraps. */
struct value {
	uint32_t start, right, down;
};

/* How a coordinate leads from the base's texels into the window. */
struct coordinate {
	struct value value;
	struct bend bend;
	uint32_t level_right; /* where it does not bend */
	uint32_t offset;      /* of the window, and half a texel */
	uint32_t mask, room;
	int shift;
};

static int find_most(const struct raster *raster)
{
	return raster->bent ? raster->bent_pixels : SOFT_RUN_PIXELS;
}

bool soft_is_small(const struct draw *draw, const struct setup *setup)
{
	const struct soft_spans *spans = &draw->spans;
	const struct raster *raster = &draw->raster;
	int columns = setup->columns, rows = setup->bottom - setup->top;
	int size = spans->pixel_log2 == 1 ? SMALL_COLORS : SMALL_COLORS_8888;

	if (columns + rows > size || !spans->lists_runs || spans->steep ||
		raster->perspective || raster->colors_bent ||
		(columns > find_most(raster) && rows > RUNS / 4)) {
		return false;
	}
	return !spans->textured ||
		(!spans->window.large &&
			spans->function[0] != spans->function[1]);
}

/* raster_side() of a triangle whose first row is shown. */
static ALWAYS_INLINE struct side find_side(
	const struct draw *draw, const struct vertex *a, const struct vertex *b)
{
	int32_t dy = b->y - a->y;
	int32_t step =
		mul_high((b->x - a->x) * (1 << 17), draw->inverse_q31[dy]);

	return (struct side){
		(a->x << 12) + (step >> 4) * ((8 - a->y) & 15), step};
}

/* Of the rows from y down to end, between two sides. */
static ALWAYS_INLINE void list_part(const struct draw *draw, struct list *list,
	int y, int end, struct side *left_side, struct side *right_side,
	int top, bool inside)
{
	const struct buffers *buffers = &draw->soft->buffers;
	const int stride = buffers->target.stride_bytes, width = buffers->width;
	const int most = find_most(&draw->raster);
	const int pixel_log2 = draw->spans.pixel_log2;
	uint16_t *depth = buffers->depth + (ptrdiff_t)y * width;
	uint8_t *pixel = buffers->target.data + (ptrdiff_t)y * stride;
	struct side first = *left_side, last = *right_side;
	struct soft_row *row = list->end;
	struct place *place = list->place_end;

	for (; y < end; y++) {
		int x = raster_column(first.x);
		int right = raster_column(last.x);

		if (!inside) {
			x = x > draw->box.left ? x : draw->box.left;
			right = right < draw->box.right ? right
							: draw->box.right;
		}
		for (; x < right; x += most) {
			row->depth = depth + x;
			row->pixel = pixel + (x << pixel_log2);
			row->count =
				(uint32_t)(right - x < most ? right - x : most);
			place->x = (uint32_t)x;
			place->y = (uint32_t)(y - top);
			row++;
			place++;
		}
		depth += width;
		pixel += stride;
		raster_next_side(&first);
		raster_next_side(&last);
	}
	list->end = row;
	list->place_end = place;
	*left_side = first;
	*right_side = last;
}

static ALWAYS_INLINE void list_parts(const struct draw *draw,
	const struct setup *setup, struct list *list, bool inside)
{
	int y = inside ? setup->top : raster_first_row(draw, setup);
	int bottom = inside || setup->bottom < draw->box.bottom
		? setup->bottom
		: draw->box.bottom;
	struct side side[2]; /* left and right */
	int part = setup->middle_left ? 0 : 1;

	side[!part] = inside ? find_side(draw, setup->v[0], setup->v[2])
			     : raster_side(draw, setup->v[0], setup->v[2], y);
	for (int i = 0; i < 2; i++) {
		int end = i == 0 && setup->middle < bottom ? setup->middle
							   : bottom;

		if (y < end) {
			const struct vertex *a = setup->v[i];
			const struct vertex *b = setup->v[i + 1];

			side[part] = inside ? find_side(draw, a, b)
					    : raster_side(draw, a, b, y);
			list_part(draw, list, y, end, &side[0], &side[1],
				setup->top, inside);
			y = end;
		}
	}
}

static NEVER_INLINE void list_inside(
	const struct draw *draw, const struct setup *setup, struct list *list)
{
	list_parts(draw, setup, list, true);
}

static NEVER_INLINE void list_clipped(
	const struct draw *draw, const struct setup *setup, struct list *list)
{
	list_parts(draw, setup, list, false);
}

/* What a run's other values are at a place. */
static ALWAYS_INLINE uint32_t find_there(
	const struct value *value, const struct place *place)
{
	return value->start + value->down * place->y + value->right * place->x;
}

/* A step of 8.16, to the nearest of what a scale makes of it. */
static ALWAYS_INLINE uint32_t round_step(int32_t step, int32_t scale)
{
	int32_t twice = (int32_t)((uint32_t)step * 2);

	return (uint32_t)((mul_high(twice, scale) + 1) >> 1);
}

/* What a scale makes of a plane, from a column on that is near the triangle. */
static ALWAYS_INLINE struct value scale_plane(
	const struct plane *plane, int column, int32_t half, int32_t scale)
{
	int32_t start =
		(int32_t)(plane->start + (uint32_t)plane->dx * (uint32_t)column);
	uint32_t right = round_step(plane->dx, scale);

	return (struct value){(uint32_t)mul_high_add(half, start, scale) -
			right * (uint32_t)column,
		right, round_step(plane->dy, scale)};
}

static ALWAYS_INLINE struct value pair_values(
	const struct value *high, const struct value *low)
{
	return (struct value){(high->start << 16) + low->start,
		(high->right << 16) + low->right,
		(high->down << 16) + low->down};
}

static ALWAYS_INLINE struct value find_depth(const struct plane *plane)
{
	return (struct value){plane->start << 6, (uint32_t)plane->dx << 6,
		(uint32_t)plane->dy << 6};
}

static NEVER_INLINE void list_still(struct draw *draw, struct list *list)
{
	const struct soft_row still = draw->spans.run.row;
	const struct value z = find_depth(&draw->raster.plane[DEPTH]);
	const struct place *place = list->place;

	for (struct soft_row *row = list->row; row < list->end; row++, place++) {
		row->z = find_there(&z, place);
		row->red_blue = still.red_blue;
		row->green_alpha = still.green_alpha;
		row->fog = still.fog;
	}
}

static NEVER_INLINE void list_colors(struct draw *draw, struct list *list)
{
	const struct plane *plane = draw->raster.plane;
	const int column = draw->raster.basis.column;
	struct soft_spans *spans = &draw->spans;
	const struct soft_scales *scales = &spans->scales;
	const struct value red = scale_plane(
		&plane[RED], column, scales->red_blue_half, scales->red_blue);
	const struct value blue = scale_plane(
		&plane[BLUE], column, scales->red_blue_half, scales->red_blue);
	const struct value green = scale_plane(
		&plane[GREEN], column, spans->green_start, scales->green);
	const struct value red_blue = pair_values(&blue, &red);
	const struct value z = find_depth(&plane[DEPTH]);
	const struct place *place = list->place;
	const uint32_t fog = spans->run.row.fog;

	spans->run.red_blue_right = red_blue.right;
	spans->run.green_alpha_right = green.right;
	for (struct soft_row *row = list->row; row < list->end; row++, place++) {
		row->z = find_there(&z, place);
		row->red_blue = find_there(&red_blue, place);
		row->green_alpha = find_there(&green, place);
		row->fog = fog;
	}
}

/* Alpha is exact, so that alpha tests are. */
static NEVER_INLINE void list_alpha(struct draw *draw, struct list *list)
{
	const struct plane *p = &draw->raster.plane[ALPHA];
	const struct value alpha = {p->start, (uint32_t)p->dx, (uint32_t)p->dy};
	const struct place *place = list->place;

	draw->spans.run.green_alpha_right += (uint32_t)soft_alpha_step(p->dx)
		<< 16;
	for (struct soft_row *row = list->row; row < list->end; row++, place++) {
		row->green_alpha += find_there(&alpha, place) >> 9 << 16;
	}
}

static NEVER_INLINE void list_fog(struct draw *draw, struct list *list)
{
	const struct value fog = scale_plane(&draw->raster.plane[FOG],
		draw->raster.basis.column, 0, SOFT_FOG_SCALE);
	const struct place *place = list->place;

	draw->spans.run.fog_right = fog.right;
	for (struct soft_row *row = list->row; row < list->end; row++, place++) {
		row->fog = find_there(&fog, place);
	}
}

/* A run's coordinate in the window, and its step there. */
struct found {
	uint32_t at, right;
};

static ALWAYS_INLINE struct found find_coordinate(const struct coordinate *c,
	const struct place *place, uint32_t count, bool bent)
{
	const uint32_t half = count >> 1, x = place->x, y = place->y;
	uint32_t middle, right = c->level_right;

	if (bent) {
		uint32_t xx = (uint32_t)c->bend.xx;
		uint32_t slope =
			c->value.right + (uint32_t)c->bend.xy * y + xx * x;
		uint32_t step = slope + xx * (x + count);

		middle = c->value.start +
			(c->value.down + (uint32_t)c->bend.yy * y) * y +
			slope * x + step * half;
		right = (uint32_t)soft_texel_step((int32_t)step, c->shift);
	} else {
		middle = c->value.start + c->value.down * y +
			c->value.right * (x + half);
	}
	return (struct found){((uint32_t)((int32_t)middle >> c->shift) -
				      right * half - c->offset) &
			c->mask,
		right};
}

static ALWAYS_INLINE bool is_outside(
	uint32_t at, uint32_t right, uint32_t count, uint32_t room)
{
	return at >= room || at + right * (count - 1) >= room;
}

/* A run that leaves the window is drawn at once, and taken off the list. */
static NEVER_INLINE void draw_outside(struct draw *draw, struct soft_row *row,
	const struct place *place, struct found t)
{
	struct soft_spans *spans = &draw->spans;
	struct soft_run *run = &spans->run;

	run->row = *row;
	run->row.texel_right = (t.right << 16) + place->s_right;
	run->s = (int32_t)(place->s + spans->window.s_first);
	run->t = (int32_t)(t.at + spans->window.t_first);
	run->s_right = (int32_t)place->s_right;
	run->t_right = (int32_t)t.right;
	soft_draw_across(spans);
	row->count = 0;
}

static ALWAYS_INLINE struct coordinate begin_coordinate(
	const struct draw *draw, int name)
{
	const struct plane *p = &draw->raster.plane[name];
	const struct soft_view *view = &draw->spans.view;
	const struct soft_window *window = &draw->spans.window;
	bool t = name != TEX_S;
	int shift = t ? view->t_shift : view->s_shift;

	return (struct coordinate){
		.value = {p->start, (uint32_t)p->dx, (uint32_t)p->dy},
		.bend = draw->raster.bend[name],
		.level_right = (uint32_t)soft_texel_step(p->dx, shift),
		.offset = t ? (uint32_t)view->t_half + window->t_first
			    : (uint32_t)view->s_half + window->s_first,
		.mask = t ? window->t_mask : window->s_mask,
		.room = t ? window->t_room : window->s_room,
		.shift = shift,
	};
}

static ALWAYS_INLINE void list_s(
	const struct draw *draw, struct list *list, bool bent)
{
	const struct coordinate c = begin_coordinate(draw, TEX_S);
	struct place *place = list->place;

	for (const struct soft_row *row = list->row; row < list->end;
		row++, place++) {
		struct found s = find_coordinate(&c, place, row->count, bent);

		place->s = s.at;
		place->s_right = s.right;
	}
}

static ALWAYS_INLINE void list_t(struct draw *draw, struct list *list, bool bent)
{
	const struct coordinate c = begin_coordinate(draw, TEX_S + 1);
	const uint32_t s_room = draw->spans.window.s_room;
	const struct place *place = list->place;

	for (struct soft_row *row = list->row; row < list->end; row++, place++) {
		struct found t = find_coordinate(&c, place, row->count, bent);

		row->texel = (t.at << 16) + place->s;
		row->texel_right = (t.right << 16) + place->s_right;
		if (is_outside(place->s, place->s_right, row->count, s_room) ||
			is_outside(t.at, t.right, row->count, c.room)) {
			draw_outside(draw, row, place, t);
		}
	}
}

static NEVER_INLINE void list_linear_s(
	const struct draw *draw, struct list *list)
{
	list_s(draw, list, false);
}

static NEVER_INLINE void list_linear_t(struct draw *draw, struct list *list)
{
	list_t(draw, list, false);
}

static NEVER_INLINE void list_bent_s(const struct draw *draw, struct list *list)
{
	list_s(draw, list, true);
}

static NEVER_INLINE void list_bent_t(struct draw *draw, struct list *list)
{
	list_t(draw, list, true);
}

static NEVER_INLINE void draw_list(struct draw *draw, const struct list *list)
{
	struct soft_run *run = &draw->spans.run;

	run->rows = list->row;
	run->row_count = (uint32_t)(list->end - list->row);
	draw->spans.draw(run);
	run->rows = &run->row;
	run->row_count = 1;
}

void soft_walk_small(struct draw *draw, const struct setup *setup, bool moving)
{
	const struct soft_spans *spans = &draw->spans;
	struct list list;

	list.end = list.row;
	list.place_end = list.place;
	(setup->inside ? list_inside : list_clipped)(draw, setup, &list);
	if (list.end == list.row) {
		return;
	}
	(moving ? list_colors : list_still)(draw, &list);
	if (moving && spans->alpha_moves) {
		list_alpha(draw, &list);
	}
	if (moving && spans->fog_moves) {
		list_fog(draw, &list);
	}
	if (spans->textured && draw->raster.bent) {
		list_bent_s(draw, &list);
		list_bent_t(draw, &list);
	} else if (spans->textured) {
		list_linear_s(draw, &list);
		list_linear_t(draw, &list);
	}
	draw_list(draw, &list);
}
