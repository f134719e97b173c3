/* Coordinates of a texture's texels for a list of runs. */
#include "platform/gl/soft/span/list.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/span/walk.h"

/* From the base's texels to those of the level. */
struct coordinate {
	int shift;
	int32_t half;
	bool made; /* they stay the base's */
	size_t at, step;
};

static ALWAYS_INLINE int32_t *find_word(struct soft_row *row, size_t offset)
{
	return (int32_t *)(void *)((uint8_t *)row + offset);
}

static ALWAYS_INLINE int32_t find_right(
	const struct coordinate *c, uint32_t step)
{
	return c->made ? (int32_t)step
		       : soft_texel_step((int32_t)step, c->shift);
}

static ALWAYS_INLINE void set(const struct coordinate *c, struct soft_row *row,
	uint32_t at, uint32_t step, int32_t right)
{
	if (!c->made) {
		uint32_t half_count = row->count >> 1;

		at = (uint32_t)((int32_t)(at + step * half_count) >> c->shift) -
			(uint32_t)right * half_count - (uint32_t)c->half;
	}
	*find_word(row, c->at) = (int32_t)at;
	*find_word(row, c->step) = right;
}

static NEVER_INLINE void list_linear(const struct draw *draw,
	struct soft_list *list, int name, const struct coordinate *given)
{
	const struct coordinate c = *given;
	const struct soft_list_value value =
		soft_list_begin(&draw->raster, name);
	const int32_t right = find_right(&c, value.right);

	for (struct soft_row *row = list->row; row < list->end; row++) {
		set(&c, row, soft_list_find(&value, row), value.right, right);
	}
}

static NEVER_INLINE void list_bent(const struct draw *draw,
	struct soft_list *list, int name, const struct coordinate *given)
{
	const struct coordinate c = *given;
	const struct soft_list_value value =
		soft_list_begin(&draw->raster, name);
	const struct bend bend = *value.bend;
	const uint32_t xx = (uint32_t)bend.xx;

	for (struct soft_row *row = list->row; row < list->end; row++) {
		uint32_t x = row->x, y = row->y;
		uint32_t slope = value.right + (uint32_t)bend.xy * y + xx * x;

		uint32_t step = slope + xx * (x + row->count);

		set(&c, row,
			value.start + (value.down + (uint32_t)bend.yy * y) * y +
				slope * x,
			step, find_right(&c, step));
	}
}

static ALWAYS_INLINE int32_t divide(
	const struct soft_list_value *value, const struct soft_row *row)
{
	return rows_find_quotient((int32_t)soft_list_find(value, row),
		row->inverse, row->shift, value->scale);
}

static ALWAYS_INLINE void divide_all(const struct draw *draw,
	struct soft_list *list, int name, const struct coordinate c)
{
	const struct soft_list_value value =
		soft_list_begin(&draw->raster, name);

	for (struct soft_row *row = list->row; row < list->end; row++) {
		int32_t from = divide(&value, row);

		while (row->count > 0) {
			const struct soft_row *next = row->next;
			int32_t to = divide(&value, next);
			uint32_t at = (uint32_t)from,
				 step = (uint32_t)rows_find_step(from, to,
					 draw->inverse_q31[next->x - row->x]);
			int32_t right = find_right(&c, step);

			for (; row < next; row++) {
				set(&c, row, at, step, right);
				at += step * row->count;
			}
			from = to;
		}
	}
}

static NEVER_INLINE void list_divided(const struct draw *draw,
	struct soft_list *list, int name, const struct coordinate *c)
{
	struct coordinate level = *c;

	level.made = false;
	divide_all(draw, list, name, level);
}

static NEVER_INLINE void list_divided_made(const struct draw *draw,
	struct soft_list *list, int name, const struct coordinate *c)
{
	struct coordinate made = *c;

	made.made = true;
	divide_all(draw, list, name, made);
}

/* The level of detail where the list begins. */
static void set_level(struct draw *draw, const struct soft_row *row)
{
	struct raster *raster = &draw->raster;
	const struct soft_list_value q = soft_list_begin(raster, INVERSE_W);
	struct point point;

	rows_find_divisor((int32_t)soft_list_find(&q, row), &point);
	for (int i = TEX_S; i < TEX_S + 2; i++) {
		const struct soft_list_value value = soft_list_begin(raster, i);

		point.value[i] = divide(&value, row);
	}
	soft_rows_find_lod(draw, &point, &raster->span);
	soft_set_level(draw, raster->span.lod[0]);
}

static NEVER_INLINE void draw_outside(struct draw *draw, struct soft_row *row)
{
	struct soft_spans *spans = &draw->spans;
	const struct soft_row still = spans->run.row;

	spans->run.row = *row;
	spans->run.row.first_texel = still.first_texel;
	spans->run.row.s += (int32_t)spans->window.s_first;
	spans->run.row.t += (int32_t)spans->window.t_first;
	row->count = 0;
	soft_draw_across(spans);
	spans->run.row = still;
}

/* The part of the level that a run's halves of words count from. */
static ALWAYS_INLINE bool enter(const struct soft_spans *spans,
	const uint8_t *first_texel, struct soft_row *row, uint32_t *s,
	uint32_t *t, uint32_t s_end, uint32_t t_end)
{
	uint32_t x = (*s < s_end ? *s : s_end) >> SOFT_TEXEL_FRACTION;
	uint32_t y = (*t < t_end ? *t : t_end) >> SOFT_TEXEL_FRACTION;

	OPAQUE(x); /* else they are masked, too */
	OPAQUE(y);
	row->first_texel = first_texel + (y << spans->run.stride_log2) +
		(x << spans->view.texel_log2);
	x <<= SOFT_TEXEL_FRACTION;
	y <<= SOFT_TEXEL_FRACTION;
	*s -= x;
	*t -= y;
	return ((*s | *t | (s_end - x) | (t_end - y)) >> 16) == 0;
}

/*
 * Whether texels lie in the window, from whose first ones they count, and
 * where. A window of more texels than the halves of a word can count is entered
 * anew by each run.
 */
static ALWAYS_INLINE void find_texels(
	struct draw *draw, struct soft_list *list, bool large)
{
	const struct soft_spans *spans = &draw->spans;
	const struct soft_window *window = &spans->window;
	const uint32_t s_mask = window->s_mask, t_mask = window->t_mask;
	const uint32_t s_room = window->s_room, t_room = window->t_room;
	const struct soft_row *end = list->end;
	const uint8_t *first_texel = spans->run.row.first_texel;

	for (struct soft_row *row = list->row; row < end; row++) {
		uint32_t last = row->count - 1;
		uint32_t s = (uint32_t)row->s & s_mask;
		uint32_t t = (uint32_t)row->t & t_mask;
		uint32_t s_right = (uint32_t)row->s_right;
		uint32_t t_right = (uint32_t)row->t_right;
		uint32_t s_end = s + s_right * last, t_end = t + t_right * last;

		if (!large) {
			row->first_texel = first_texel;
		}
		row->texel_right = (t_right << 16) + s_right;
		if (s < s_room && t < t_room) {
			OPAQUE(s_end);
			if (s_end < s_room && t_end < t_room &&
				(!large ||
					enter(spans, first_texel, row, &s, &t,
						s_end, t_end))) {
				row->texel = (t << 16) + s;
				continue;
			}
		}
		if (row->count > 0) {
			draw_outside(draw, row);
		}
	}
}

static NEVER_INLINE void find_few_texels(
	struct draw *draw, struct soft_list *list)
{
	find_texels(draw, list, false);
}

static NEVER_INLINE void find_many_texels(
	struct draw *draw, struct soft_list *list)
{
	find_texels(draw, list, true);
}

static struct coordinate begin_coordinate(
	const struct soft_spans *spans, bool is_t)
{
	const struct soft_view *view = &spans->view;
	const struct soft_window *window = &spans->window;
	int32_t s_half = view->s_half + (int32_t)window->s_first;
	int32_t t_half = view->t_half + (int32_t)window->t_first;

	return is_t ? (struct coordinate){view->t_shift, t_half, spans->made,
			      offsetof(struct soft_row, t),
			      offsetof(struct soft_row, t_right)}
		    : (struct coordinate){view->s_shift, s_half, spans->made,
			      offsetof(struct soft_row, s),
			      offsetof(struct soft_row, s_right)};
}

void soft_list_texels(struct draw *draw, struct soft_list *list)
{
	const struct soft_spans *spans = &draw->spans;
	const struct raster *raster = &draw->raster;

	if (spans->level_by_row) {
		set_level(draw, list->row);
	}
	for (int i = 0; i < 2; i++) {
		const struct coordinate c = begin_coordinate(spans, i);

		(raster->bent                          ? list_bent
				: !raster->perspective ? list_linear
				: spans->made
				? list_divided_made
				: list_divided)(draw, list, TEX_S + i, &c);
	}
	if (!spans->made) {
		(spans->window.large ? find_many_texels : find_few_texels)(
			draw, list);
	}
}
