/* Draws the span walk's runs by rows of tiles: depth, level, gray and alpha. */
#include "platform/gl/gl_counts.h"
#include "platform/gl/soft/fast/tiles.h"
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/halves.h"
#include "platform/gl/soft/span/spans.h"
#include "platform/gl/soft/stages/made.h"

enum {
	/* half of 1/32 in 8.16, so that 255 becomes 32/32 */
	SHARE_ROUND = 4 << 16,
	SHARE_STEP = 1 << 19, /* 1/32 in 8.16 */
	/* most pixels that share an alpha where it changes by more than a step */
	SHARE_PIXELS = 8,
	/* least pixels that share a depth where the row has several */
	DEPTH_PIXELS = 16,
};

static int choose_level(const struct draw *draw, int lod)
{
	const struct texture_input *input = &draw->texture[0];
	int number = clamp_int((lod + 127) >> 8, 0, input->levels - 1);

	/* levels with a side of one texel have none */
	while (!input->texture->level[number].tiles) {
		number--;
	}
	return number;
}

static void set_level(struct draw *draw, int lod)
{
	struct tiled *tiled = &draw->tiled;
	const int number = choose_level(draw, lod);
	const struct level *level = &draw->texture[0].texture->level[number];

	if (number == tiled->level) {
		return;
	}
	tiled->level = number;
	tiled->tiles = level->tiles;
	tiled->run.quads = level->tiles->quad;
	tiled->run.fine = level->tiles->fine;
	tiled->run.side_log2 = level->tiles->side_log2;
	tiled->run.shade = tiled->by_share ? draw->luminance : draw->shade;
}

/* The alpha, 0 to 32, in the middle of count pixels from number from on. */
static uint32_t find_share(
	const struct tiled *tiled, uint32_t from, uint32_t count)
{
	uint32_t middle = tiled->alpha +
		(uint32_t)tiled->alpha_right * (from + count / 2);

	return (middle + SHARE_ROUND) >> 19;
}

/*
 * Blends shaded pixels into the picture, with one alpha for as many pixels as
 * are off by less than a step.
 */
static void blend(const struct tiled *tiled, const uint16_t *shaded)
{
	uint32_t size = raster_size(tiled->alpha_right);
	int most = SHARE_PIXELS, count;

	while (most > 1 && size * (uint32_t)most >= 2 * SHARE_STEP) {
		most /= 2;
	}
	for (int i = 0; i < tiled->run.count; i += count) {
		count = tiled->run.count - i;
		if ((uint64_t)size * (uint32_t)count >= SHARE_STEP &&
			count > most) {
			count = most;
		}
		soft_mix_pixels(tiled->pixel + i, shaded + i, count,
			find_share(tiled, (uint32_t)i, (uint32_t)count));
	}
}

/* Converts a run's luminance to gray. Not inlined: the loop has all registers. */
static NEVER_INLINE void make_gray(
	const struct draw *draw, const uint16_t *luminance, uint16_t *out)
{
	const uint32_t *gray = draw->gray;
	const uint32_t right = (uint32_t)draw->tiled.share_right;
	const int count = draw->tiled.run.count;
	uint32_t share = draw->tiled.share;

	OPAQUE(gray); /* else compilers find it from draw for each pixel */
#pragma GCC unroll 8
	for (int i = 0; i < count; i++) {
		out[i] = (uint16_t)gray[WORD_BY_BOTTOM(share, luminance[i], 0)];
		share += right;
	}
}

/* Fills draw->mixed: each shade of the level, blended with a pixel by share. */
static NEVER_INLINE void make_mixed(
	struct draw *draw, uint16_t pixel, uint32_t share)
{
	struct tiled *tiled = &draw->tiled;
	const uint32_t made_of =
		pixel | share << 16 | (uint32_t)(tiled->level + 1) << 24;
	const uint32_t there = widen(pixel);

	if (tiled->mixed == made_of) {
		return;
	}
	for (uint32_t i = tiled->tiles->low; i <= tiled->tiles->high; i++) {
		draw->mixed[i] = twice_565(narrow(mix_wide(
			there, widen((uint16_t)draw->shade[i]), share)));
	}
	tiled->mixed = made_of;
}

/*
 * Draws a blended run by a table, draw->mixed, if it has one alpha and the
 * picture has one colour there, as rows of a gradient do; else returns false.
 */
static bool draw_mixed(struct draw *draw)
{
	struct tiled *tiled = &draw->tiled;
	const int count = tiled->run.count;

	if (tiled->by_share ||
		4 * (tiled->tiles->high - tiled->tiles->low) > count ||
		(uint64_t)raster_size(tiled->alpha_right) * (uint32_t)count >=
			SHARE_STEP ||
		!soft_is_one_color(tiled->pixel, count)) {
		return false;
	}
	make_mixed(draw, *tiled->pixel, find_share(tiled, 0, (uint32_t)count));
	tiled->run.pixel = tiled->pixel;
	tiled->run.shade = draw->mixed;
	soft_tile_row(&tiled->run, tiled->from_fine);
	tiled->run.shade = draw->shade;
	return true;
}

static ALWAYS_INLINE void draw_visible(struct draw *draw)
{
	struct tiled *tiled = &draw->tiled;
	uint16_t *pixel = tiled->pixel;
	/* aside has the same alignment in words as pixel */
	uint16_t *aside = draw->shaded + ((uintptr_t)pixel / sizeof(*pixel)) % 2;

	if (tiled->from_fine == 2 && draw->soft->counts) {
		draw->soft->counts->fine += tiled->run.count;
	}
	if (draw->blended && draw_mixed(draw)) {
		return;
	}
	tiled->run.pixel = tiled->by_share || draw->blended ? aside : pixel;
	soft_tile_row(&tiled->run, tiled->from_fine);
	if (tiled->by_share) {
		make_gray(draw, aside, draw->blended ? aside : pixel);
	}
	if (draw->blended) {
		blend(tiled, aside);
	}
}

/* Converts a colour, 8.8 of 255, to 8.8 of 256; planes have a half added. */
static int32_t to_share(int32_t color_q8)
{
	return color_q8 * 257 >> 8;
}

/*
 * Chooses from_fine: two pixels a step where both differ little from the middle
 * between them. Not in the base level, which may be magnified: there, one pixel
 * a step, if no place of fine is wider than a pixel.
 */
static ALWAYS_INLINE void choose_places(struct tiled *tiled)
{
	struct tile_run *run = &tiled->run;
	const uint32_t most = tiled->tiles->by_two_most;
	const uint32_t s = raster_size(run->s_right),
		       t = raster_size(run->t_right);

	tiled->from_fine = 0;
	if (run->fine && tiled->level > 0 && s <= most && t <= most) {
		tiled->from_fine = 2;
		run->s += (uint32_t)(run->s_right >> 1);
		run->t += (uint32_t)(run->t_right >> 1);
		run->s_right *= 2;
		run->t_right *= 2;
	} else if (run->fine && most >= FINE_PLACE && (s | t) >= FINE_PLACE &&
		(s | t) < 1 << 16) {
		tiled->from_fine = 1;
	}
}

/* Sets a run's coordinates in the level from those in base texels, 16.16. */
static ALWAYS_INLINE void set_texels(
	struct tiled *tiled, const struct soft_made_at *at)
{
	const int level = tiled->level;
	struct tile_run *run = &tiled->run;

	run->s = (uint32_t)(at->at.s >> level) - 0x8000;
	run->t = (uint32_t)(at->at.t >> level) - 0x8000;
	run->s_right = at->step.s >> level;
	run->t_right = at->step.t >> level;
	choose_places(tiled);
	run->s_end = &tiled->tiles->patch->s[run->s_right >= 0];
	run->t_end = &tiled->tiles->patch->t[run->t_right >= 0];
	run->s_pixels = soft_tile_pixels(run->s_right, run->side_log2);
	run->t_pixels = soft_tile_pixels(run->t_right, run->side_log2);
}

/*
 * Writes a row's depths; a single value for pixels whose depths differ by less
 * than a unit, as in level planes: all, or parts of the row where corners on
 * multiples of 1/16 of a pixel tilt the plane.
 */
static void write_depth(uint16_t *depth, int count, uint32_t z, uint32_t z_right)
{
	const uint64_t slope = raster_size((int32_t)z_right);
	int part = count;

	while (slope * (uint32_t)part >= 1 << 16) {
		part /= 2;
	}
	if (part >= DEPTH_PIXELS || part == count) {
		for (; count > 0; count -= part, depth += part) {
			uint32_t middle = z;

			part = part < count ? part : count;
			middle += (uint32_t)((int32_t)z_right * part / 2);
			soft_fill_pixels(depth, part, (uint16_t)(middle >> 16));
			z += z_right * (uint32_t)part;
		}
		return;
	}
#pragma GCC unroll 8
	for (int i = 0; i < count; i++) {
		depth[i] = (uint16_t)(z >> 16);
		z += z_right;
	}
}

static ALWAYS_INLINE void draw_row(
	const struct soft_run *run, const struct soft_row *row)
{
	struct draw *draw = run->draw;
	struct tiled *tiled = &draw->tiled;

	set_texels(tiled, &draw->spans.made_at);
	tiled->pixel = (uint16_t *)(void *)row->pixel;
	tiled->run.count = (int)row->count;
	if (draw->blended) {
		tiled->alpha = row->green_alpha >> 16 << 9;
		/* to 8.16 from 8.7 above green, which may have borrowed one */
		tiled->alpha_right =
			(int32_t)((run->green_alpha_right + 0x8000) &
				0xFFFF0000) >>
			7;
	}
	if (tiled->by_share) {
		tiled->share = (uint32_t)to_share(row->red_blue & 0xFFFF);
		tiled->share_right = to_share((int16_t)run->red_blue_right);
	}
	if (draw->spans.depth_written) {
		write_depth(row->depth, tiled->run.count, row->z, run->z_right);
	}
	draw_visible(draw);
}

/* These draw runs in place of a span function; their colours are 8.8. */
static void draw_divided(const struct soft_run *run)
{
	draw_row(run, &run->row);
}

static void draw_listed(const struct soft_run *run)
{
	struct draw *draw = run->draw;

	for (uint32_t i = 0; i < run->row_count; i++) {
		draw->spans.made_at = soft_find_made_at(draw, 0, &run->rows[i]);
		draw_row(run, &run->rows[i]);
	}
}

/* Converts luminance in halves of 127ths to 0 to 255. */
static uint32_t luminance_of(uint32_t halves)
{
	return (halves * 257 + 128) >> 8;
}

static void make_shades(struct draw *draw, const uint32_t color[3])
{
	for (uint32_t i = 0; i < 255; i++) {
		uint32_t luminance = luminance_of(i);
		int c[3];

		for (int k = 0; k < 3; k++) {
			c[k] = (int)(((color[k] >> 16) * luminance * 257 +
					     32896) >>
				16);
		}
		draw->shade[i] = twice_565(pack_565(c[0], c[1], c[2]));
	}
	memcpy(draw->shade_color, color, sizeof(draw->shade_color));
}

/* Whether red, green and blue change, and are equal everywhere. */
static bool is_gray(const struct raster *raster)
{
	const uint32_t colors = 7u << RED;
	const struct plane *plane = raster->plane;

	return (raster->moving_bits & colors) == colors &&
		memcmp(&plane[RED], &plane[GREEN], sizeof(*plane)) == 0 &&
		memcmp(&plane[RED], &plane[BLUE], sizeof(*plane)) == 0;
}

void soft_luminance_init(struct draw *draw)
{
	draw->shade_color[0] = UINT32_MAX; /* no colour is equal to it */
	for (uint32_t i = 0; i < 255; i++) {
		draw->luminance[i] = twice_565(luminance_of(i));
	}
	for (int i = 0; i < 256; i++) {
		draw->gray[i] = pack_565(i, i, i);
	}
}

/* Walks the rows with longer runs, which are drawn here. */
static void walk(struct draw *draw, const struct setup *setup)
{
	static const struct soft_scales bytes = {1 << 24, 1 << 24, 0, 0};
	struct soft_spans *spans = &draw->spans;
	const soft_span_function function = spans->draw;
	const soft_span_function counted = spans->counted;
	const struct soft_scales scales = spans->scales;

	spans->made = true;
	spans->set_level = set_level;
	spans->longest = LUMINANCE_RUN;
	spans->scales = bytes;
	spans->draw = draw->raster.perspective ? draw_divided : draw_listed;
	if (draw->soft->counts) {
		soft_count_runs(spans);
	}
	draw->tiled.level = -1;
	draw->tiled.mixed = 0;
	soft_walk_rows(draw, setup);
	spans->made = false;
	spans->set_level = NULL;
	spans->longest = SOFT_RUN_PIXELS;
	spans->scales = scales;
	spans->draw = function;
	spans->counted = counted;
}

/* Triangles in one colour or in varying gray are drawn here. */
void soft_fill_luminance(struct draw *draw, struct setup *setup)
{
	const struct raster *raster = &draw->raster;

	soft_raster_set_up(draw, setup);
	draw->tiled.by_share = raster->moving_bits & 7u << RED;
	if (draw->tiled.by_share && !is_gray(raster)) {
		soft_walk_rows(draw, setup);
		return;
	}
	if (!draw->tiled.by_share &&
		memcmp(raster->constant, draw->shade_color,
			sizeof(draw->shade_color)) != 0) {
		make_shades(draw, raster->constant);
	}
	walk(draw, setup);
}
