/*
 * The rows of small triangles: one loop lists all of a triangle's runs, and the
 * span function draws them in one call.
 */
#include "platform/gl/soft/raster/frame.h"
#include "platform/gl/soft/raster/small_list.h"
#include "platform/gl/soft/span/texels.h"

/* How the runs of a triangle are made; constants of the loop. */
struct list_kind {
	bool textured, bent;
	bool certain; /* see struct small_list */
};

/* One instruction: compilers add all products up first, then the rest. */
static ALWAYS_INLINE uint32_t add_product(uint32_t to, uint32_t a, uint32_t b)
{
	to += a * b;
	OPAQUE(to);
	return to;
}

/* What a value is at a row's column. */
static ALWAYS_INLINE uint32_t find_there(
	const struct small_value *value, uint32_t x, uint32_t y)
{
	return add_product(
		add_product(value->start, value->down, y), value->right, x);
}

/* A run's coordinate in the window, and its step there. */
struct found {
	uint32_t at, right;
};

static ALWAYS_INLINE struct found find_coordinate(
	const struct small_coordinate *c, const struct list_kind kind,
	uint32_t x, uint32_t y, uint32_t count)
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
	const struct small_coordinate *c, struct found found, uint32_t count)
{
	return found.at >= c->room ||
		found.at + found.right * (count - 1) >= c->room;
}

/* A run that leaves the window is drawn at once, and not listed. */
static NEVER_INLINE void draw_outside(struct small_list *list,
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

/* Where the run is, fog, and alpha, which is exact so that alpha tests are. */
static NEVER_INLINE void set_rare(const struct small_list *list,
	struct soft_row *row, uint32_t x, uint32_t y)
{
	row->place = y << 16 | x;
	row->fog = find_there(&list->fog, x, y);
	if (list->alpha_moves) {
		row->green_alpha += find_there(&list->alpha, x, y) >> 9 << 16;
	}
}

/* False where the run is drawn already. */
static ALWAYS_INLINE bool set_texel(struct small_list *list,
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
static ALWAYS_INLINE bool set_run(struct small_list *list,
	const struct list_kind kind, struct soft_row *row, uint32_t x,
	uint32_t y)
{
	row->z = find_there(&list->z, x, y);
	row->red_blue = find_there(&list->red_blue, x, y);
	row->green_alpha = find_there(&list->green, x, y);
	row->fog = list->fog.start;
	if (list->rare) {
		set_rare(list, row, x, y);
	}
	return !kind.textured || set_texel(list, kind, row, x, y);
}

/* The runs of rows from y to end, counted from the triangle's first one. */
static ALWAYS_INLINE void list_rows(struct small_list *list,
	const struct list_kind kind, int top, int y, int end,
	struct side *first, struct side *last)
{
	const struct buffers *buffers = &list->draw->soft->buffers;
	const int pixel_log2 = list->draw->spans.pixel_log2;
	const int width = buffers->width;
	const int stride_bytes = buffers->target.stride_bytes;
	int32_t left = first->x, right = last->x;
	uint16_t *depth = buffers->depth + (ptrdiff_t)(top + y) * width;
	uint8_t *pixel =
		buffers->target.data + (ptrdiff_t)(top + y) * stride_bytes;
	struct soft_row *row = list->end;

	for (; y < end; y++) {
		int x = left >> 16, count = (right >> 16) - x;

		while (count > 0) {
			row->depth = depth + x;
			row->pixel = pixel + (x << pixel_log2);
			row->count =
				(uint32_t)(kind.certain || count < list->most
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
		depth += width;
		pixel += stride_bytes;
		left += first->step;
		right += last->step;
	}
	list->end = row;
	first->x = left;
	last->x = right;
}

/* All rows, above and below the middle vertex. */
static ALWAYS_INLINE void list_all(struct small_list *list,
	const struct setup *setup, const struct list_kind kind)
{
	const struct draw *draw = list->draw;
	const int part = setup->middle_left ? 0 : 1;
	struct side side[2]; /* left and right */
	int y = setup->top;

	side[!part] = frame_find_side(draw, setup->v[0], setup->v[2]);
	for (int i = 0; i < 2; i++) {
		int end = i == 0 ? setup->middle : setup->bottom;

		if (y < end) {
			side[part] = frame_find_side(
				draw, setup->v[i], setup->v[i + 1]);
			list_rows(list, kind, setup->top, y - setup->top,
				end - setup->top, &side[0], &side[1]);
			y = end;
		}
	}
}

#define LIST(name, ...)                                                 \
	static NEVER_INLINE void list_##name(                           \
		struct small_list *list, const struct setup *setup)     \
	{                                                               \
		list_all(list, setup, (struct list_kind){__VA_ARGS__}); \
	}

LIST(plain, .textured = false)
LIST(linear, .textured = true)
LIST(bent, .textured = true, .bent = true)
LIST(certain, .textured = true, .certain = true)
LIST(certain_bent, .textured = true, .bent = true, .certain = true)

static void draw_list(const struct small_list *list)
{
	struct soft_spans *spans = &list->draw->spans;
	struct soft_run *run = &spans->run;
	const uint8_t *first_texel = run->first_texel;

	run->rows = list->row;
	run->row_count = (uint32_t)(list->end - list->row);
	run->first_texel = list->first_texel;
	spans->draw(run);
	run->rows = &run->row;
	run->row_count = 1;
	/* A triangle of the same level keeps the window that this belongs to. */
	run->first_texel = first_texel;
}

void soft_walk_small(struct small_list *list, const struct setup *setup)
{
	bool bent = list->draw->raster.bent;

	if (!list->draw->spans.textured || list->draw->spans.made) {
		list_plain(list, setup);
	} else if (list->certain) {
		(bent ? list_certain_bent : list_certain)(list, setup);
	} else {
		(bent ? list_bent : list_linear)(list, setup);
	}
	if (list->end != list->row) {
		draw_list(list);
	}
}
