/*
 * The rows of small triangles: one loop lists all of a triangle's runs, and the
 * span function draws them in one call. Colours run in the run's own numbers:
 * such triangles are too small to lose more of them to rounding than they have
 * to spare.
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
	uint32_t round; /* half of what shift drops */
	int shift;
};

/* How the runs of a triangle are made; constants of the loop. */
struct list_kind {
	bool textured, bent;
	/* No texel lies outside of the window, and a row is one run. */
	bool certain;
};

struct list {
	struct draw *draw;
	struct value z, red_blue, green, alpha, fog;
	struct coordinate s, t;
	bool rare; /* alpha or fog moves */
	bool alpha_moves;
	int most;  /* pixels of a run */
	int pixel_log2;
	int width, stride_bytes;
	struct soft_row *end;
	struct soft_row row[RUNS];
};

static int find_most(const struct raster *raster)
{
	return raster->bent ? raster->bent_pixels : SOFT_RUN_PIXELS;
}

static bool is_in_box(const struct clip_box *box, const struct setup *setup)
{
	const struct vertex *const *v = setup->v;
	int left = raster_centre(raster_least(v[0]->x, v[1]->x, v[2]->x));
	int right = raster_centre(raster_most(v[0]->x, v[1]->x, v[2]->x));

	return setup->top >= box->top && setup->bottom <= box->bottom &&
		left >= box->left && right <= box->right;
}

bool soft_is_small(const struct draw *draw, const struct setup *setup)
{
	const struct soft_spans *spans = &draw->spans;
	const struct raster *raster = &draw->raster;
	int columns = setup->columns, rows = setup->bottom - setup->top;
	int size = spans->pixel_log2 == 1 ? SMALL_COLORS : SMALL_COLORS_8888;

	if (columns + rows > size || !spans->lists_runs || spans->steep ||
		raster->perspective || raster->colors_bent ||
		(columns > find_most(raster) && rows > RUNS / 4) ||
		(!setup->inside && !is_in_box(&draw->box, setup))) {
		return false;
	}
	return !spans->textured ||
		(!spans->part.large &&
			spans->function[0] != spans->function[1]);
}

/* raster_side() of a triangle whose first row is shown; rounded up. */
static ALWAYS_INLINE struct side find_side(
	const struct draw *draw, const struct vertex *a, const struct vertex *b)
{
	int32_t dy = b->y - a->y;
	int32_t step =
		mul_high((b->x - a->x) * (1 << 17), draw->inverse_q31[dy]);

	return (struct side){
		a->x * (1 << 12) + (step >> 4) * ((8 - a->y) & 15) + 0x7FFF, step};
}

/* One instruction: compilers add all products up first, then the rest. */
static ALWAYS_INLINE uint32_t add_product(uint32_t to, uint32_t a, uint32_t b)
{
	to += a * b;
	OPAQUE(to);
	return to;
}

/* What a value is at a row's column. */
static ALWAYS_INLINE uint32_t find_there(
	const struct value *value, uint32_t x, uint32_t y)
{
	return add_product(
		add_product(value->start, value->down, y), value->right, x);
}

/* A run's coordinate in the window, and its step there. */
struct found {
	uint32_t at, right;
};

static ALWAYS_INLINE struct found find_coordinate(const struct coordinate *c,
	const struct list_kind kind, uint32_t x, uint32_t y, uint32_t count)
{
	const uint32_t half = count >> 1;
	uint32_t middle, right = c->level_right, at;

	if (kind.bent) {
		const uint32_t xx = (uint32_t)c->bend.xx;
		uint32_t slope = add_product(
			add_product(c->value.right, (uint32_t)c->bend.xy, y),
			xx, x);
		uint32_t step = add_product(slope, xx, x + count);
		uint32_t down =
			add_product(c->value.down, (uint32_t)c->bend.yy, y);

		middle = add_product(c->value.start, down, y);
		middle = add_product(middle, slope, x);
		middle = add_product(middle, step, half);
		right = (uint32_t)((int32_t)(step + c->round) >> c->shift);
	} else {
		middle = find_there(&c->value, x + half, y);
	}
	at = (uint32_t)((int32_t)middle >> c->shift) - right * half;
	return (struct found){
		kind.certain ? at : (at - c->offset) & c->mask, right};
}

static ALWAYS_INLINE bool is_outside(
	const struct coordinate *c, struct found found, uint32_t count)
{
	return found.at >= c->room ||
		found.at + found.right * (count - 1) >= c->room;
}

/* A run that leaves the window is drawn at once, and not listed. */
static NEVER_INLINE void draw_outside(struct list *list,
	const struct soft_row *row, struct found s, struct found t)
{
	struct soft_spans *spans = &list->draw->spans;
	struct soft_run *run = &spans->run;

	run->row = *row;
	run->s = (int32_t)(s.at + spans->part.s_first);
	run->t = (int32_t)(t.at + spans->part.t_first);
	run->s_right = (int32_t)s.right;
	run->t_right = (int32_t)t.right;
	if (soft_find_window(&spans->window, spans->view.texel_log2, run)) {
		spans->draw(run);
	} else {
		soft_draw_across(spans);
	}
}

/* Alpha is exact, so that alpha tests are. */
static NEVER_INLINE void add_alpha(
	const struct list *list, struct soft_row *row, uint32_t x, uint32_t y)
{
	row->green_alpha += find_there(&list->alpha, x, y) >> 9 << 16;
}

/* False where the run is drawn already. */
static ALWAYS_INLINE bool set_texel(struct list *list,
	const struct list_kind kind, struct soft_row *row, uint32_t x,
	uint32_t y)
{
	const uint32_t count = row->count;
	const struct found s = find_coordinate(&list->s, kind, x, y, count);
	const struct found t = find_coordinate(&list->t, kind, x, y, count);

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

/* A run whose place and count are set. */
static ALWAYS_INLINE bool set_run(struct list *list,
	const struct list_kind kind, struct soft_row *row, uint32_t x,
	uint32_t y)
{
	row->z = find_there(&list->z, x, y);
	row->red_blue = find_there(&list->red_blue, x, y);
	row->green_alpha = find_there(&list->green, x, y);
	row->fog = list->fog.start;
	if (list->rare) {
		row->fog = find_there(&list->fog, x, y);
		if (list->alpha_moves) {
			add_alpha(list, row, x, y);
		}
	}
	return !kind.textured || set_texel(list, kind, row, x, y);
}

/* The runs of rows from y to end, counted from the triangle's first one. */
static ALWAYS_INLINE void list_rows(struct list *list,
	const struct list_kind kind, int top, int y, int end,
	struct side *first, struct side *last)
{
	const struct buffers *buffers = &list->draw->soft->buffers;
	int32_t left = first->x, right = last->x;
	uint16_t *depth = buffers->depth + (ptrdiff_t)(top + y) * list->width;
	uint8_t *pixel = buffers->target.data +
		(ptrdiff_t)(top + y) * list->stride_bytes;
	struct soft_row *row = list->end;

	for (; y < end; y++) {
		int x = left >> 16, count = (right >> 16) - x;

		while (count > 0) {
			row->depth = depth + x;
			row->pixel = pixel + (x << list->pixel_log2);
			row->count = (uint32_t)(kind.certain ||
						count < list->most
					? count
					: list->most);
			if (set_run(list, kind, row, (uint32_t)x, (uint32_t)y)) {
				row++;
			}
			if (kind.certain) {
				break;
			}
			x += list->most;
			count -= list->most;
		}
		depth += list->width;
		pixel += list->stride_bytes;
		left += first->step;
		right += last->step;
	}
	list->end = row;
	first->x = left;
	last->x = right;
}

/* All rows, above and below the middle vertex. */
static ALWAYS_INLINE void list_all(struct list *list,
	const struct setup *setup, const struct list_kind kind)
{
	const struct draw *draw = list->draw;
	const int part = setup->middle_left ? 0 : 1;
	struct side side[2]; /* left and right */
	int y = setup->top;

	side[!part] = find_side(draw, setup->v[0], setup->v[2]);
	for (int i = 0; i < 2; i++) {
		int end = i == 0 ? setup->middle : setup->bottom;

		if (y < end) {
			side[part] = find_side(
				draw, setup->v[i], setup->v[i + 1]);
			list_rows(list, kind, setup->top, y - setup->top,
				end - setup->top, &side[0], &side[1]);
			y = end;
		}
	}
}

#define LIST(name, ...)                                                    \
	static NEVER_INLINE void list_##name(                              \
		struct list *list, const struct setup *setup)              \
	{                                                                  \
		list_all(list, setup, (struct list_kind){__VA_ARGS__});    \
	}

LIST(plain, .textured = false)
LIST(linear, .textured = true)
LIST(bent, .textured = true, .bent = true)
LIST(certain, .textured = true, .certain = true)
LIST(certain_bent, .textured = true, .bent = true, .certain = true)

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

static void begin_still(struct list *list)
{
	const struct soft_row *still = &list->draw->spans.run.row;

	list->red_blue = (struct value){still->red_blue, 0, 0};
	list->green = (struct value){still->green_alpha, 0, 0};
}

static void begin_rare(struct list *list)
{
	const struct draw *draw = list->draw;
	const struct plane *p = &draw->raster.plane[ALPHA];
	struct soft_run *run = &list->draw->spans.run;

	list->fog.right = list->fog.down = 0;
	list->alpha_moves = draw->spans.alpha_moves;
	if (list->alpha_moves) {
		list->alpha = (struct value){
			p->start, (uint32_t)p->dx, (uint32_t)p->dy};
		run->green_alpha_right += (uint32_t)soft_alpha_step(p->dx)
			<< 16;
	}
	if (draw->spans.fog_moves) {
		list->fog = scale_plane(&draw->raster.plane[FOG],
			draw->raster.basis.column, 0, SOFT_FOG_SCALE);
		run->fog_right = list->fog.right;
	}
}

static void begin_colors(struct list *list)
{
	const struct raster *raster = &list->draw->raster;
	const struct plane *plane = raster->plane;
	const int column = raster->basis.column;
	struct soft_spans *spans = &list->draw->spans;
	const struct soft_scales *scales = &spans->scales;
	const struct value red = scale_plane(
		&plane[RED], column, scales->red_blue_half, scales->red_blue);
	const struct value blue = scale_plane(
		&plane[BLUE], column, scales->red_blue_half, scales->red_blue);

	list->green = scale_plane(
		&plane[GREEN], column, spans->green_start, scales->green);
	list->red_blue = pair_values(&blue, &red);
	spans->run.red_blue_right = list->red_blue.right;
	spans->run.green_alpha_right = list->green.right;
	list->rare = spans->alpha_moves || spans->fog_moves;
	if (list->rare) {
		begin_rare(list);
	}
}

static ALWAYS_INLINE void begin_coordinate(const struct draw *draw, int name,
	bool certain, struct coordinate *out)
{
	const struct plane *p = &draw->raster.plane[name];
	const struct soft_view *view = &draw->spans.view;
	const struct soft_window *window = &draw->spans.part;
	bool t = name != TEX_S;
	int shift = t ? view->t_shift : view->s_shift;
	uint32_t low = t ? draw->spans.part_t : draw->spans.part_s;
	low += (uint32_t)(t ? view->t_half : view->s_half);
	out->offset = low;
	out->value = (struct value){certain ? p->start - (low << shift) : p->start,
		(uint32_t)p->dx, (uint32_t)p->dy};
	out->mask = t ? window->t_mask : window->s_mask;
	out->room = t ? window->t_room : window->s_room;
	out->shift = shift;
	if (draw->raster.bent) {
		out->bend = draw->raster.bend[name];
		out->round = 1u << (shift - 1);
	} else {
		out->level_right = (uint32_t)soft_texel_step(p->dx, shift);
	}
}

static void draw_list(const struct list *list)
{
	struct soft_spans *spans = &list->draw->spans;
	struct soft_run *run = &spans->run;

	run->rows = list->row;
	run->row_count = (uint32_t)(list->end - list->row);
	run->first_texel = spans->part_texel;
	spans->draw(run);
	run->rows = &run->row;
	run->row_count = 1;
}

static void begin(struct list *list, struct draw *draw)
{
	const struct buffers *buffers = &draw->soft->buffers;
	const struct plane *depth = &draw->raster.plane[DEPTH];

	list->draw = draw;
	list->z = (struct value){depth->start << 6, (uint32_t)depth->dx << 6,
		(uint32_t)depth->dy << 6};
	list->fog.start = draw->spans.run.row.fog;
	list->rare = false;
	list->most = find_most(&draw->raster);
	list->pixel_log2 = draw->spans.pixel_log2;
	list->width = buffers->width;
	list->stride_bytes = buffers->target.stride_bytes;
	list->end = list->row;
}

/*
 * Whether coordinates change by less than 16 texels a pixel, so that rounding at
 * edges cannot lead out of the window: the triangle is as thick as twice its
 * area over its extent.
 */
static bool is_flat(const struct soft_window *part, const struct setup *setup)
{
	uint32_t room =
		part->s_room > part->t_room ? part->s_room : part->t_room;

	/* below 2^16 times 2^10 */
	return room * (uint32_t)setup->extent <= (uint32_t)setup->area << 9;
}

static void list_textured(struct list *list, const struct setup *setup)
{
	const struct draw *draw = list->draw;
	bool certain = draw->spans.certain && setup->columns <= list->most &&
		is_flat(&draw->spans.part, setup);
	bool bent = draw->raster.bent;

	begin_coordinate(draw, TEX_S, certain, &list->s);
	begin_coordinate(draw, TEX_S + 1, certain, &list->t);
	if (certain) {
		(bent ? list_certain_bent : list_certain)(list, setup);
	} else {
		(bent ? list_bent : list_linear)(list, setup);
	}
}

void soft_walk_small(struct draw *draw, const struct setup *setup, bool moving)
{
	struct list list;

	begin(&list, draw);
	(moving ? begin_colors : begin_still)(&list);
	(draw->spans.textured ? list_textured : list_plain)(&list, setup);
	if (list.end != list.row) {
		draw_list(&list);
	}
}
