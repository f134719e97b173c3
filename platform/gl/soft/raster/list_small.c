/*
 * Small triangles, set up for walk_small.c at once: the values of runs, without
 * planes between. Depth, texture coordinates and alpha have the bits that the
 * planes of raster.c give them, so that the same fragments pass. Colours run in
 * the run's own numbers: such triangles are too small to lose more of them to
 * rounding than they have to spare.
 */
#include "platform/gl/soft/raster/frame.h"
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/raster/small_colors.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/stages/made.h"

enum {
	/* An eighth of a texel; a texel where values bend, see bend.c. */
	SPARE = 1 << (SOFT_TEXEL_FRACTION - 3),
	SPARE_BENT = 8 * SPARE,
};

_Static_assert((SOFT_LISTED_SIZE / 2 + 1) * (SOFT_LISTED_SIZE / 2) <=
		SOFT_BATCH_PIXELS,
	"a small triangle's runs fit a batch");

static bool is_in_box(const struct clip_box *box, const struct setup *setup)
{
	const struct vertex *const *v = setup->v;
	int left = raster_centre(raster_least(v[0]->x, v[1]->x, v[2]->x));
	int right = raster_centre(raster_most(v[0]->x, v[1]->x, v[2]->x));

	return setup->top >= box->top && setup->bottom <= box->bottom &&
		left >= box->left && right <= box->right;
}

static ALWAYS_INLINE struct frame_texels find_texels(
	const struct draw *draw, const struct setup *setup, int name)
{
	const struct texture_input *input = &draw->texture[(name - TEX_S) / 2];
	const struct texture *texture = input->texture;
	bool down = (name - TEX_S) % 2;

	return frame_find_texels(setup, name,
		down ? input->height_log2 : input->width_log2,
		(down ? texture->wrap_t : texture->wrap_s) == GL_REPEAT);
}

static ALWAYS_INLINE uint32_t find_extent(const struct frame_texels *texels)
{
	return (uint32_t)texels->high - (uint32_t)texels->low;
}

/* The largest spread of a colour, alpha or fog. */
static uint32_t find_color_spread(
	const struct draw *draw, const struct setup *setup)
{
	const uint32_t wanted = draw->attributes & ~draw->spans.white_bits;
	const int32_t *color[3];
	uint32_t most = 0;

	frame_choose_colors(draw, setup, color);
	for (int i = RED; i <= FOG; i++) {
		const int32_t *const fog[3] = {setup->v[0]->attribute,
			setup->v[1]->attribute, setup->v[2]->attribute};
		const struct delta delta = find_delta(i == FOG ? fog : color, i);
		uint32_t own = wanted >> i & 1
			? frame_find_spread(delta.d1, delta.d2)
			: 0;

		most = own > most ? own : most;
	}
	return most;
}

/*
 * Of a triangle in visible perspective: false where colours bend or something
 * has to be divided; else coordinates bend, where they have to, as
 * raster->plane and raster->bend say.
 */
static NEVER_INLINE bool bend(struct draw *draw, struct setup *setup,
	uint32_t w_spread, uint32_t w_least)
{
	struct raster *raster = &draw->raster;
	int tolerance = draw->spans.color_tolerance;
	uint32_t color = find_color_spread(draw, setup);
	struct perspective perspective = {w_spread, w_least, 0};
	const int count = draw->texture[1].used ? 4 : 2;
	struct delta delta[2 * SOFT_UNITS];

	if (raster_bends(&perspective, color, tolerance)) {
		return false;
	}
	if (!draw->spans.textured) {
		return true;
	}
	for (int i = 0; i < count; i++) {
		uint32_t own;

		delta[i] = find_texels(draw, setup, TEX_S + i).delta;
		own = frame_find_spread(delta[i].d1, delta[i].d2);
		raster->moving[i] = TEX_S + i;
		if (own > perspective.texel) {
			perspective.texel = own;
		}
	}
	if (!raster_bends(&perspective, perspective.texel, 0)) {
		return true;
	}
	raster->frame = frame_find(setup);
	raster->moving_count = count;
	return w_spread <= w_least &&
		soft_bend(draw, setup, delta, &perspective);
}

/* False where bend() says so; most triangles need not be asked for. */
static ALWAYS_INLINE bool find_perspective(
	struct draw *draw, struct setup *setup, uint32_t texel)
{
	const struct vertex *const *v = setup->v;
	int32_t a = v[0]->clip[3], b = v[1]->clip[3], c = v[2]->clip[3];
	uint32_t low = (uint32_t)raster_least(a, b, c);
	uint32_t spread = (uint32_t)raster_most(a, b, c) - low;

	/* Colours spread by less than 2^16: see raster_bends(). */
	if (spread <= low >> 6 &&
		(uint64_t)texel * spread <= (uint64_t)low << 8) {
		return true;
	}
	return bend(draw, setup, spread, low);
}

/* log2 of how many texels a pixel has, as soft_rows_find_affine_lod(). */
static ALWAYS_INLINE int find_lod(
	const struct small_value *s, const struct small_value *t)
{
	uint32_t right = raster_length(
		raster_size((int32_t)s->right), raster_size((int32_t)t->right));
	uint32_t down = raster_length(
		raster_size((int32_t)s->down), raster_size((int32_t)t->down));

	return raster_log2_q8(right > down ? right : down);
}

static ALWAYS_INLINE void set_level(struct draw *draw,
	const struct small_value *s, const struct small_value *t)
{
	struct soft_spans *spans = &draw->spans;
	struct span *span = &draw->raster.span;

	if (!spans->lod_wanted) {
		if (spans->level < 0) {
			soft_set_level(draw, 0);
		}
	} else if (draw->raster.bent) {
		soft_rows_find_affine_lod(draw, span);
		soft_set_level(draw, span->lod[0]);
	} else {
		soft_set_level(draw, find_lod(s, t));
	}
}

static ALWAYS_INLINE bool is_within(
	const struct texel_place *place, uint32_t room)
{
	const uint32_t most = SOFT_RUN_TEXELS << SOFT_TEXEL_FRACTION;

	return place->room < most && place->room <= room &&
		place->first <= room - place->room;
}

/*
 * Beyond the edges of a level that does not repeat a coordinate stays on the
 * last texel, as find_clamped() in span/cut.c has it: here that of all of a
 * triangle.
 */
static NEVER_INLINE struct texel_place hold_beyond(struct small_coordinate *c,
	struct texel_place place, uint32_t room, uint32_t last, int32_t half)
{
	int32_t at = 0;

	if (place.room >= SOFT_RUN_TEXELS << SOFT_TEXEL_FRACTION) {
		return place;
	}
	if (place.low >= (int32_t)room) {
		at = (int32_t)(last << SOFT_TEXEL_FRACTION);
	} else if (place.low + (int32_t)place.room >= 0) {
		return place;
	}
	c->value = (struct small_value){(uint32_t)(at + half) << c->shift, 0, 0};
	c->bend = (struct bend){0};
	c->level_right = 0;
	return (struct texel_place){at, (uint32_t)at, 0};
}

static ALWAYS_INLINE void begin_coordinate(const struct draw *draw, int name,
	int shift, struct small_coordinate *out)
{
	out->shift = shift;
	if (draw->raster.bent) {
		out->bend = draw->raster.bend[name];
		out->round = 1u << (shift - 1);
	} else {
		out->level_right = (uint32_t)soft_texel_step(
			(int32_t)out->value.right, shift);
	}
}

/*
 * What of the window the triangle may need, where some of its texels may lie
 * outside. False where the texture is none for a list.
 */
static NEVER_INLINE bool begin_part(struct small_list *list, int32_t s_low,
	int32_t s_high, int32_t t_low, int32_t t_high)
{
	struct draw *draw = list->draw;
	struct raster *raster = &draw->raster;
	const struct soft_spans *spans = &draw->spans;
	const struct soft_window *part = &spans->part;

	raster->texel_range[0][0] = s_low;
	raster->texel_range[0][1] = s_high;
	raster->texel_range[1][0] = t_low;
	raster->texel_range[1][1] = t_high;
	soft_set_window(draw);
	list->s.offset = spans->part_s + (uint32_t)spans->view.s_half;
	list->t.offset = spans->part_t + (uint32_t)spans->view.t_half;
	list->s.mask = part->s_mask;
	list->t.mask = part->t_mask;
	list->s.room = part->s_room;
	list->t.room = part->t_room;
	list->certain = false;
	list->first_texel = spans->part_texel;
	return !part->large;
}

/*
 * Whether all texels lie in the window and a row is one run. Coordinates have
 * to change by less than 16 texels a pixel for that, so that rounding at edges
 * cannot lead out of it: the triangle is as thick as twice its area over its
 * extent.
 */
static ALWAYS_INLINE bool is_certain(const struct small_list *list,
	const struct setup *setup, const struct texel_place *s,
	const struct texel_place *t)
{
	const struct soft_window *window = &list->draw->spans.view.window;
	uint32_t room = s->room > t->room ? s->room : t->room;

	/* below 2^16 times 2^10 */
	return is_within(s, window->s_room) && is_within(t, window->t_room) &&
		setup->columns <= list->most &&
		room * (uint32_t)setup->extent <= (uint32_t)setup->area << 9;
}

/* Whether all runs fit the list. */
static ALWAYS_INLINE bool fits(
	const struct small_list *list, const struct setup *setup)
{
	return setup->columns <= list->most ||
		setup->bottom - setup->top <= SMALL_RUNS / 4;
}

static ALWAYS_INLINE bool begin_texels(struct small_list *list,
	const struct setup *setup, const struct frame_texels s,
	const struct frame_texels t)
{
	struct draw *draw = list->draw;
	const struct soft_view *view = &draw->spans.view;
	const struct soft_window *window = &view->window;
	struct texel_place in_s, in_t;
	int32_t spare = draw->raster.bent ? SPARE_BENT : SPARE;

	set_level(draw, &list->s.value, &list->t.value);
	begin_coordinate(draw, TEX_S, view->s_shift, &list->s);
	begin_coordinate(draw, TEX_S + 1, view->t_shift, &list->t);
	in_s = soft_find_place(s.low, s.high, view->s_shift, view->s_half,
		spare, window->s_mask);
	in_t = soft_find_place(t.low, t.high, view->t_shift, view->t_half,
		spare, window->t_mask);
	if (window->s_mask == UINT32_MAX) {
		in_s = hold_beyond(&list->s, in_s, window->s_room, view->s_last,
			view->s_half);
	}
	if (window->t_mask == UINT32_MAX) {
		in_t = hold_beyond(&list->t, in_t, window->t_room, view->t_last,
			view->t_half);
	}
	if (!is_certain(list, setup, &in_s, &in_t)) {
		return begin_part(list, s.low, s.high, t.low, t.high);
	}
	list->certain = true;
	list->first_texel = view->texels +
		(in_t.first >> SOFT_TEXEL_FRACTION << view->stride_log2) +
		(in_s.first >> SOFT_TEXEL_FRACTION << view->texel_log2);
	list->s.value.start -= (uint32_t)(in_s.low + view->s_half)
		<< view->s_shift;
	list->t.value.start -= (uint32_t)(in_t.low + view->t_half)
		<< view->t_shift;
	return true;
}

static ALWAYS_INLINE void begin_depth(struct small_list *list,
	const struct setup *setup, const struct small *small)
{
	const struct vertex *const *v = setup->v;
	const struct delta delta = {
		v[0]->z, v[1]->z - v[0]->z, v[2]->z - v[0]->z};
	const struct run run = find_run(small, &delta);

	list->z = enter(small, run);
	if (list->draw->offset) {
		list->z.start += (uint32_t)soft_raster_offset_depth(
			list->draw, setup, run.right, run.down);
	}
	list->z.start <<= 6;
	list->z.right <<= 6;
	list->z.down <<= 6;
	list->draw->spans.run.z_right = list->z.right;
}

static ALWAYS_INLINE struct small_value find_coordinate(
	const struct small *small, const struct frame_texels *texels)
{
	struct small_value value = enter(small, find_run(small, &texels->delta));

	value.start += TEXEL_NUDGE;
	return value;
}

static struct small_value plane_value(const struct plane *plane)
{
	return (struct small_value){
		plane->start, (uint32_t)plane->dx, (uint32_t)plane->dy};
}

/* The most texels along a coordinate in 256ths, with those of the second texture. */
static NEVER_INLINE uint32_t add_second(
	const struct draw *draw, const struct setup *setup, uint32_t most)
{
	for (int i = 2; i < 4 && draw->texture[1].used; i++) {
		const struct frame_texels texels =
			find_texels(draw, setup, TEX_S + i);
		uint32_t own = find_extent(&texels);

		most = own > most ? own : most;
	}
	return most;
}

/* The planes and levels of textures, which stages/made.c reads. */
static NEVER_INLINE void begin_planes(
	struct small_list *list, const struct setup *setup)
{
	struct draw *draw = list->draw;
	struct small small;
	struct raster *raster = &draw->raster;
	const int end = draw->texture[1].used ? 2 : 1;

	small.frame = frame_find(setup);
	for (int i = 0; i < 2 * end && !raster->bent; i++) {
		const struct frame_texels texels =
			find_texels(draw, setup, TEX_S + i);
		const struct small_value value =
			find_coordinate(&small, &texels);

		raster->plane[TEX_S + i] = (struct plane){
			value.start, (int32_t)value.right, (int32_t)value.down};
	}
	raster->perspective = false;
	soft_rows_find_affine_lod(draw, &raster->span);
	for (int i = 0; i < end; i++) {
		soft_set_made_levels(draw, i, raster->span.lod[i]);
	}
	if (!raster->bent) {
		list->most =
			rows_find_run_pixels(draw, (int32_t)list->s.value.right,
				(int32_t)list->t.value.right);
	}
}

/* How the first texture's coordinates run. */
static ALWAYS_INLINE void begin_coordinates(struct small_list *list,
	const struct small *small, const struct frame_texels *s,
	const struct frame_texels *t)
{
	const struct raster *raster = &list->draw->raster;

	if (raster->bent) {
		list->s.value = plane_value(&raster->plane[TEX_S]);
		list->t.value = plane_value(&raster->plane[TEX_S + 1]);
		list->most = raster->bent_pixels;
	} else {
		list->s.value = find_coordinate(small, s);
		list->t.value = find_coordinate(small, t);
	}
}

static ALWAYS_INLINE bool begin_texture(
	struct small_list *list, struct setup *setup, const struct small *small)
{
	struct draw *draw = list->draw;
	const struct frame_texels s = find_texels(draw, setup, TEX_S),
				  t = find_texels(draw, setup, TEX_S + 1);
	uint32_t in_s = find_extent(&s), in_t = find_extent(&t);
	uint32_t most = in_s > in_t ? in_s : in_t;

	if (draw->spans.made) {
		most = add_second(draw, setup, most);
	}
	if (most >= SMALL_DELTA ||
		(draw->perspective && !find_perspective(draw, setup, most))) {
		return false;
	}
	begin_coordinates(list, small, &s, &t);
	if (draw->spans.made) {
		begin_planes(list, setup);
	}
	return fits(list, setup) &&
		(draw->spans.made || begin_texels(list, setup, s, t));
}

static ALWAYS_INLINE bool set_up(struct draw *draw, struct setup *setup,
	int size, struct small_list *list)
{
	struct small small;

	small.frame = frame_find(setup);
	setup->middle_left = small.frame.middle_left;
	small.is_steep = false;
	frame_choose_colors(draw, setup, small.color);
	small.steep = size <= EXACT_SIZE ? STEEP_EXACT : STEEP;
	list->draw = draw;
	list->end = list->row;
	list->most = draw->spans.textured ? SOFT_RUN_PIXELS
					  : draw->spans.plain_pixels;
	draw->raster.bent = false;
	if (draw->spans.textured ? !begin_texture(list, setup, &small)
				 : draw->perspective &&
				!find_perspective(draw, setup, 0)) {
		return false;
	}
	begin_colors(list, setup, &small);
	begin_depth(list, setup, &small);
	return !small.is_steep;
}

bool soft_draw_small(struct draw *draw, struct setup *setup)
{
	const struct soft_spans *spans = &draw->spans;
	int size = setup->columns + setup->bottom - setup->top;
	struct small_list list;

	if (size > spans->listed_size ||
		(!setup->inside && !is_in_box(&draw->box, setup)) ||
		!set_up(draw, setup, size, &list)) {
		return false;
	}
	soft_walk_small(&list, setup);
	draw->raster.top = RASTER_LISTED;
	return true;
}
