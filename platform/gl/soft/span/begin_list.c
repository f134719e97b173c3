/*
 * Sets up a triangle's list of runs from its planes. In small triangles colours
 * are stepped in the run's number format, with steps rounded to it: there, the
 * rounding errors stay within the range that colours have to spare.
 */
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/colors.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/span/walk.h"

enum {
	/* margin of a window: 1/8 texel; a texel for polynomials, see bend.c */
	SPARE = 1 << (SOFT_TEXEL_FRACTION - 3),
	SPARE_BENT = 8 * SPARE,
};

_Static_assert((SOFT_LISTED_SIZE / 2 + 1) * (SOFT_LISTED_SIZE / 2) <=
		SOFT_BATCH_PIXELS,
	"a small triangle's runs fit a batch");

/* A triangle's range of one coordinate in a level, 9 fraction bits. */
struct texel_place {
	int32_t low; /* a whole texel at or below the least coordinate */
	uint32_t first, room; /* low masked; the largest one minus low */
};

/* Whether a triangle's texels fit the halves of soft_row.texel. */
static ALWAYS_INLINE bool begins_in(
	const struct texel_place *place, uint32_t room)
{
	return place->room < SOFT_RUN_TEXELS << SOFT_TEXEL_FRACTION &&
		place->first < room;
}

static ALWAYS_INLINE bool is_within(
	const struct texel_place *place, uint32_t room)
{
	return begins_in(place, room) && place->room <= room - place->first;
}

/*
 * Finds the range. Far outside of the texture it wraps around; it is no range
 * where its ends lie so far apart that they may meet again.
 */
static ALWAYS_INLINE struct texel_place begin_coordinate(
	const struct raster *raster, int name, const struct soft_axis *axis,
	struct list_coordinate *out)
{
	const struct plane *plane = &raster->plane[name];
	/* the least and the largest coordinate, in 1/256 base texels */
	const int32_t *range = raster->texel_range[name - TEX_S];
	const int32_t spare = raster->bent ? SPARE_BENT : SPARE;
	const int shift = axis->shift;
	int32_t low = ((int32_t)((uint32_t)range[0] * 256) >> shift) -
		axis->half - spare;
	int32_t high = ((int32_t)((uint32_t)range[1] * 256) >> shift) -
		axis->half + spare;

	out->plane = *plane;
	out->shift = shift;
	if (raster->bent) {
		out->bend = raster->bend[name];
		out->round = 1u << (shift - 1);
	} else {
		out->level_right = soft_texel_step(plane->dx, shift);
	}
	low &= ~((1 << SOFT_TEXEL_FRACTION) - 1);
	return (struct texel_place){low, (uint32_t)low & axis->mask,
		(uint32_t)range[1] - (uint32_t)range[0] < 1u << 23
			? (uint32_t)high - (uint32_t)low
			: UINT32_MAX};
}

/* Whether each row is one run, with no edge to be clipped. */
static ALWAYS_INLINE bool has_whole_rows(
	const struct run_list *list, const struct setup *setup)
{
	return setup->columns <= list->most && !setup->wide &&
		raster_is_in_box(list->draw, setup);
}

/*
 * Whether all texels lie in the window and each row is one run. For this,
 * coordinates must change by less than 16 texels a pixel, so that rounding at
 * edges cannot leave the window: the triangle's thickness is twice its area
 * over its extent.
 */
static ALWAYS_INLINE bool is_certain(const struct run_list *list,
	const struct setup *setup, const struct texel_place *s,
	const struct texel_place *t)
{
	const struct soft_view *view = &list->draw->spans.levels[0].view;
	uint32_t room = s->room > t->room ? s->room : t->room;

	/* the product is below 2^16 * 2^11 */
	return is_within(s, view->s.room) && is_within(t, view->t.room) &&
		has_whole_rows(list, setup) &&
		room * (uint32_t)setup->extent <= (uint32_t)setup->area << 9;
}

/* Lets coordinates of listed runs count from a texel. */
static ALWAYS_INLINE void count_from(const struct texel_place *from,
	const struct soft_axis *axis, bool certain, struct list_coordinate *out)
{
	out->offset = (uint32_t)(from->low + axis->half);
	if (certain) {
		out->plane.start -= out->offset << axis->shift;
		return;
	}
	out->first = from->first;
	out->mask = axis->mask;
	out->room = axis->room - from->first;
}

static ALWAYS_INLINE void begin_texels(
	struct run_list *list, const struct setup *setup)
{
	const struct raster *raster = &list->draw->raster;
	const struct soft_view *view = &list->draw->spans.levels[0].view;
	struct texel_place s =
		begin_coordinate(raster, TEX_S, &view->s, &list->s);
	struct texel_place t =
		begin_coordinate(raster, TEX_S + 1, &view->t, &list->t);
	const bool near = view->large && begins_in(&s, view->s.room) &&
		begins_in(&t, view->t.room);

	list->certain = is_certain(list, setup, &s, &t);
	if (!list->certain && !near) {
		/* runs count from the level's first texel */
		s = t = (struct texel_place){0};
	}
	list->first_texel = view->texels +
		(t.first >> SOFT_TEXEL_FRACTION << view->stride_log2) +
		(s.first >> SOFT_TEXEL_FRACTION << view->texel_log2);
	count_from(&s, &view->s, list->certain, &list->s);
	count_from(&t, &view->t, list->certain, &list->t);
	if (view->large && !list->certain && !near) {
		/* each run has its own first texel: none is listed */
		list->s.room = 0;
	}
}

/* A colour's plane in the run's number format, exact in v[0]'s column. */
static ALWAYS_INLINE struct plane find_scaled(
	const struct raster *raster, int name, int32_t half, int32_t scale)
{
	const int column = raster->frame.column;
	struct plane plane = raster->plane[name];

	plane.start += (uint32_t)plane.dx * (uint32_t)column;
	return scale_color(&plane, column, half, scale);
}

/* Sets a small triangle's colours, and their steps in spans->run. */
static ALWAYS_INLINE void begin_moving(struct run_list *list)
{
	const struct raster *raster = &list->draw->raster;
	struct soft_spans *spans = &list->draw->spans;
	const struct soft_scales *scales = &spans->scales;

	list->red_blue =
		pair_colors(find_scaled(raster, RED, scales->red_blue_half,
				    scales->red_blue),
			find_scaled(raster, BLUE, scales->red_blue_half,
				scales->red_blue));
	list->green =
		find_scaled(raster, GREEN, spans->green_start, scales->green);
	spans->run.red_blue_right = (uint32_t)list->red_blue.dx;
	spans->run.green_alpha_right = (uint32_t)list->green.dx;
	set_more_color_steps(
		spans, raster->plane[ALPHA].dx, raster->plane[FOG].dx);
}

static ALWAYS_INLINE void begin_colors(
	struct run_list *list, uint32_t moving, bool small)
{
	const struct soft_spans *spans = &list->draw->spans;

	list->colors_exact = moving && (spans->steep || !small);
	list->red_blue = list->green = (struct plane){0};
	if (list->colors_exact) {
		soft_begin_steps(list->draw, moving);
	} else if (moving) {
		begin_moving(list);
	} else {
		list->red_blue.start = spans->run.row.red_blue;
		list->green.start = spans->run.row.green_alpha;
	}
	list->fog = spans->run.row.fog;
	list->alpha_alone = !list->colors_exact && !spans->made &&
		!spans->read_second && !spans->fog_moves;
	list->rare = !list->alpha_alone || spans->alpha_moves;
}

void soft_draw_list(
	struct draw *draw, const struct setup *setup, uint32_t moving)
{
	const struct soft_spans *spans = &draw->spans;
	const struct plane *plane = draw->raster.plane, *z = &plane[DEPTH];
	const int size = setup->columns + setup->bottom - setup->top;
	const bool small = size <= SOFT_LISTED_SIZE;
	struct run_list list;

	list.draw = draw;
	list.first_texel = spans->run.first_texel;
	list.most = !spans->textured ? spans->plain_pixels
		: draw->raster.bent  ? draw->raster.bent_pixels
				    : rows_find_run_pixels(draw, plane[TEX_S].dx,
					      plane[TEX_S + 1].dx);
	begin_colors(&list, moving, size <= spans->stepped_size);
	list.z = (struct plane){z->start << 6, (int32_t)((uint32_t)z->dx << 6),
		(int32_t)((uint32_t)z->dy << 6)};
	if (spans->textured && !spans->made) {
		begin_texels(&list, setup);
	} else {
		list.certain = has_whole_rows(&list, setup);
	}
	/* Each run of steep colours has its own steps: it is drawn alone. */
	list.end = list.row +
		(spans->steep           ? 1
				: small ? SOFT_BATCH_RUNS
					: SOFT_BATCH_PIXELS / list.most);
	soft_walk_list(&list, setup);
	if (small) {
		draw->raster.top = RASTER_LISTED;
	}
}
