/* Colours, alpha and fog of a list of runs. */
#include "platform/gl/soft/span/colors.h"
#include "platform/gl/soft/span/list.h"

enum {
	/*
	 * Columns and rows of triangles whose colours run in the run's own
	 * numbers: a step is off by half of 1/16384 in each. White times 255
	 * leaves less room below 256 than times 31 below 32.
	 */
	SMALL_COLORS = 62,
	SMALL_COLORS_8888 = 40,
	ALPHA_SCALE = 1 << 23, /* from 8.16 to 8.7 */
};

/* From a value of 8.16 to a part of a row's word, and of its step. */
struct channel {
	int name;
	int32_t scale, half;
	int shift;
	size_t word, step;
};

static ALWAYS_INLINE uint32_t *find_word(struct soft_row *row, size_t offset)
{
	return (uint32_t *)(void *)((uint8_t *)row + offset);
}

static ALWAYS_INLINE void add(const struct channel *channel,
	struct soft_row *row, int32_t value, uint32_t step)
{
	*find_word(row, channel->word) +=
		(uint32_t)mul_high_add(channel->half, value, channel->scale)
		<< channel->shift;
	*find_word(row, channel->step) += step << channel->shift;
}

static NEVER_INLINE void add_linear(const struct draw *draw,
	struct soft_list *list, const struct channel *given)
{
	const struct channel channel = *given;
	const struct soft_list_value value =
		soft_list_begin(&draw->raster, channel.name);
	const uint32_t step = scale_step((int32_t)value.right, channel.scale);

	for (struct soft_row *row = list->row; row < list->end; row++) {
		add(&channel, row, (int32_t)soft_list_find(&value, row), step);
	}
}

static NEVER_INLINE void add_steep(const struct draw *draw,
	struct soft_list *list, const struct channel *channel)
{
	const struct soft_list_value value =
		soft_list_begin(&draw->raster, channel->name);

	for (struct soft_row *row = list->row; row < list->end; row++) {
		uint32_t steps = row->count > 0 ? row->count - 1 : 0;
		uint32_t at = soft_list_find(&value, row);
		int32_t from = limit_color((int32_t)at);
		int32_t to = limit_color((int32_t)(at + value.right * steps));

		add(channel, row, from,
			scale_step(rows_find_step(
					   from, to, draw->inverse_q31[steps]),
				channel->scale));
	}
}

static NEVER_INLINE void add_bent(const struct draw *draw,
	struct soft_list *list, const struct channel *channel)
{
	const struct raster *raster = &draw->raster;
	const struct plane *p = &raster->plane[channel->name];

	for (struct soft_row *row = list->row; row < list->end; row++) {
		int count = (int)row->count;
		struct bent at = rows_limit_bent(
			rows_find_bent(raster, channel->name,
				p->start + (uint32_t)p->dy * row->y,
				(int)row->y, (int)row->x, count),
			count, draw->inverse_q31[count]);

		add(channel, row, at.value, scale_step(at.step, channel->scale));
	}
}

static ALWAYS_INLINE int32_t divide(
	const struct soft_list_value *value, const struct soft_row *row)
{
	return limit_color(
		rows_find_quotient((int32_t)soft_list_find(value, row),
			row->inverse, row->shift, ROWS_COLOR_SCALE));
}

static NEVER_INLINE void add_divided(const struct draw *draw,
	struct soft_list *list, const struct channel *given)
{
	const struct channel channel = *given;
	const struct soft_list_value value =
		soft_list_begin(&draw->raster, channel.name);

	for (struct soft_row *row = list->row; row < list->end; row++) {
		int32_t from = divide(&value, row);

		while (row->count > 0) {
			const struct soft_row *next = row->next;
			int32_t to = divide(&value, next),
				step = rows_find_step(from, to,
					draw->inverse_q31[next->x - row->x]);
			uint32_t own = scale_step(step, channel.scale);

			for (; row < next; row++) {
				add(&channel, row, from, own);
				from = (int32_t)((uint32_t)from +
					(uint32_t)step * row->count);
			}
			from = to;
		}
	}
}

/* A step of 8.16, to the nearest of what a scale makes of it. */
static ALWAYS_INLINE uint32_t round_step(int32_t step, int32_t scale)
{
	int32_t twice = (int32_t)((uint32_t)step * 2);

	return (uint32_t)((mul_high(twice, scale) + 1) >> 1);
}

/* What a scale makes of a plane, from a column on that is near the triangle. */
static ALWAYS_INLINE struct soft_list_value scale_plane(
	const struct plane *plane, int column, int32_t half, int32_t scale)
{
	int32_t start =
		(int32_t)(plane->start + (uint32_t)plane->dx * (uint32_t)column);
	uint32_t right = round_step(plane->dx, scale);

	return (struct soft_list_value){
		.start = (uint32_t)mul_high_add(half, start, scale) -
			right * (uint32_t)column,
		.right = right,
		.down = round_step(plane->dy, scale),
	};
}

static ALWAYS_INLINE struct soft_list_value pair_values(
	const struct soft_list_value *high, const struct soft_list_value *low)
{
	return (struct soft_list_value){
		.start = (high->start << 16) + low->start,
		.right = (high->right << 16) + low->right,
		.down = (high->down << 16) + low->down,
	};
}

/* Red, green and blue of a small triangle. */
static NEVER_INLINE void set_small(
	const struct draw *draw, struct soft_list *list)
{
	const struct plane *plane = draw->raster.plane;
	const int column = draw->raster.basis.column;
	const struct soft_spans *spans = &draw->spans;
	const struct soft_scales *scales = &spans->scales;
	const struct soft_list_value red = scale_plane(
		&plane[RED], column, scales->red_blue_half, scales->red_blue);
	const struct soft_list_value blue = scale_plane(
		&plane[BLUE], column, scales->red_blue_half, scales->red_blue);
	const struct soft_list_value green = scale_plane(
		&plane[GREEN], column, spans->green_start, scales->green);
	const struct soft_list_value red_blue = pair_values(&blue, &red);
	const struct soft_list_value z = soft_list_begin_z(&draw->raster);

	for (struct soft_row *row = list->row; row < list->end; row++) {
		row->z = soft_list_find(&z, row);
		row->red_blue = soft_list_find(&red_blue, row);
		row->green_alpha = soft_list_find(&green, row);
		row->red_blue_right = red_blue.right;
		row->green_alpha_right = green.right;
	}
}

static NEVER_INLINE void set_zero(
	const struct draw *draw, struct soft_list *list)
{
	const struct soft_list_value z = soft_list_begin_z(&draw->raster);

	for (struct soft_row *row = list->row; row < list->end; row++) {
		row->z = soft_list_find(&z, row);
		row->red_blue = 0;
		row->green_alpha = 0;
		row->red_blue_right = 0;
		row->green_alpha_right = 0;
	}
}

typedef void (*add_function)(const struct draw *draw, struct soft_list *list,
	const struct channel *channel);

static void add_colors(const struct draw *draw, struct soft_list *list,
	add_function add_channel)
{
	const struct soft_spans *spans = &draw->spans;
	const struct soft_scales *scales = &spans->scales;
	struct channel channel = {RED, scales->red_blue, scales->red_blue_half,
		0, offsetof(struct soft_row, red_blue),
		offsetof(struct soft_row, red_blue_right)};

	add_channel(draw, list, &channel);
	channel.name = BLUE;
	channel.shift = 16;
	add_channel(draw, list, &channel);
	channel = (struct channel){GREEN, scales->green, spans->green_start, 0,
		offsetof(struct soft_row, green_alpha),
		offsetof(struct soft_row, green_alpha_right)};
	add_channel(draw, list, &channel);
}

static void add_others(const struct draw *draw, struct soft_list *list,
	add_function add_channel)
{
	static const struct channel alpha = {ALPHA, ALPHA_SCALE, 0, 16,
		offsetof(struct soft_row, green_alpha),
		offsetof(struct soft_row, green_alpha_right)};
	static const struct channel fog = {FOG, SOFT_FOG_SCALE, 0, 0,
		offsetof(struct soft_row, fog),
		offsetof(struct soft_row, fog_right)};

	if (draw->spans.alpha_moves) {
		add_channel(draw, list, &alpha);
	}
	if (draw->spans.fog_moves) {
		add_channel(draw, list, &fog);
	}
}

void soft_list_colors(const struct draw *draw, const struct setup *setup,
	struct soft_list *list)
{
	const struct raster *raster = &draw->raster;
	int extent = setup->columns + setup->bottom - setup->top;
	int most =
		draw->spans.pixel_log2 == 1 ? SMALL_COLORS : SMALL_COLORS_8888;
	add_function add_channel = draw->spans.steep ? add_steep
		: raster->colors_bent                ? add_bent
		: raster->colors_divided             ? add_divided
						     : add_linear;

	if (add_channel == add_linear && extent <= most) {
		set_small(draw, list);
	} else {
		set_zero(draw, list);
		add_colors(draw, list, add_channel);
	}
	add_others(draw, list, add_channel);
}
