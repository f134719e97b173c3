#define SOFT_BY_FOUR

#include "platform/gl/soft/stages/made.h"

#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/stages/bytes.h"
#include "platform/gl/soft/stages/combine_rows.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

/* White's alpha in 8.7, with a half added. */
enum {
	WHITE_ALPHA = 0x7FC0,
};

/* A coordinate at a run's start and its step, where nothing is divided. */
static ALWAYS_INLINE struct bent find_coordinate(
	const struct raster *raster, int name, const struct soft_row *row)
{
	const struct plane *plane = &raster->plane[name];
	const uint32_t x = row->place & 0xFFFF, y = row->place >> 16;
	const uint32_t start = plane->start + (uint32_t)plane->dy * y;

	if (raster->bent) {
		return rows_find_bent(
			raster, name, start, (int)y, (int)x, (int)row->count);
	}
	return (struct bent){
		(int32_t)(start + (uint32_t)plane->dx * x), plane->dx};
}

/* The second texture's coordinates in perspective; chooses the row's level. */
static NEVER_INLINE struct soft_made_at find_second(
	struct draw *draw, const struct soft_row *row)
{
	int lod = draw->raster.lod[1];
	const struct soft_made_at at =
		soft_find_second(draw, (int)(row->place >> 16),
			(int)(row->place & 0xFFFF), (int)row->count, &lod);

	if (draw->spans.levels[1].level < 0 ||
		soft_rows_want_lod(&draw->texture[1])) {
		soft_set_level(draw, 1, lod);
	}
	return at;
}

struct soft_made_at soft_find_made_at(
	const struct draw *draw, int unit, const struct soft_row *row)
{
	const struct raster *raster = &draw->raster;
	const struct bent s = find_coordinate(raster, TEX_S + 2 * unit, row);
	const struct bent t = find_coordinate(raster, TEX_S + 2 * unit + 1, row);

	return (struct soft_made_at){{s.value, t.value}, {s.step, t.step}};
}

/* Reads a run's texels from a level, as RGBA8888 or packed words. */
static ALWAYS_INLINE void sample_row(const struct soft_levels *levels,
	const struct soft_view *view, const struct soft_made_at *at,
	struct soft_run *run)
{
	soft_set_texel_steps(view, at->step, run);
	soft_set_texels(view, at->at, at->step, run->row.count, run);
	if (soft_find_window(view, run)) {
		levels->sampler[1](run);
	} else {
		soft_cut_run(run, view, levels->sampler, 2);
	}
}

/*
 * Reads the texels of all runs, one run behind the other, from a unit's level
 * or the next one. known are the coordinates, if there is a single run; else
 * NULL. Returns the number of texels.
 */
static uint32_t sample_level(const struct draw *draw, int unit, bool next,
	const struct soft_made_at *known, uint32_t *out)
{
	const struct soft_run *runs = &draw->spans.run;
	const struct soft_levels *levels = &draw->spans.levels[unit];
	const struct soft_view *view = next ? &levels->next_view : &levels->view;
	uint32_t all = 0;
	/* soft_cut_run() also steps values that nothing reads */
	struct soft_run run = {.row.depth = (uint16_t *)out};

	soft_use_view(view, &run);
	for (uint32_t i = 0; i < runs->row_count; i++) {
		const struct soft_row *row = &runs->rows[i];
		const struct soft_made_at at =
			known ? *known : soft_find_made_at(draw, unit, row);
		const uint32_t count = row->count;

		run.row.pixel = (uint8_t *)(out + all);
		run.row.count = count;
		sample_row(levels, view, &at, &run);
		all += count;
	}
	return all;
}

/* Blends the four bytes of from with to by share / 256; share is below 256. */
static ALWAYS_INLINE soft_word mix(soft_word from, soft_word to, uint32_t share)
{
	const uint32_t mask = 0x00FF00FF, half = 0x00800080;
	const soft_word by = (soft_word){0} + HALVES_TWICE(share);
	const soft_word rest = HALVES_TWICE(256u) - by;
	soft_word low =
		HALVES_TIMES(from & mask, rest) + HALVES_TIMES(to & mask, by);
	soft_word high = HALVES_TIMES(from >> 8 & mask, rest) +
		HALVES_TIMES(to >> 8 & mask, by);

	return ((low + half) >> 8 & mask) | ((high + half) & ~mask);
}

/*
 * Reads a unit's texels for all runs, and returns their number. Mixes two
 * levels where the filter does.
 */
static uint32_t sample(struct draw *draw, int unit, uint32_t *texel)
{
	const struct soft_spans *spans = &draw->spans;
	const struct soft_row *rows = spans->run.rows;
	const struct soft_made_at *known = NULL;
	struct soft_made_at at;
	uint32_t next[SOFT_BATCH_ROOM], share, count;

	if (unit == 0 && rows == &spans->run.row) {
		known = &spans->made_at;
	} else if (draw->raster.perspective) {
		at = find_second(draw, rows);
		known = &at;
	}
	count = sample_level(draw, unit, false, known, texel);
	share = (uint32_t)spans->levels[unit].share;
	if (share > 0) {
		sample_level(draw, unit, true, known, next);
		for (uint32_t i = 0; i < count; i += SOFT_LANES) {
			soft_put_words(texel + i,
				mix(soft_get_words(texel + i),
					soft_get_words(next + i), share));
		}
	}
	return count;
}

/*
 * Sets out to the vertices' colours of all runs, as RGBA8888. With texels, sets
 * only alpha, to the fragments' one, with its fraction, times the texels'.
 */
static ALWAYS_INLINE void fill_primary(
	const struct soft_run *run, const uint32_t *texel, uint32_t *out)
{
	const uint32_t rb_right = run->red_blue_right;
	const uint32_t ga_right = run->green_alpha_right;

	for (uint32_t i = 0; i < run->row_count; i++) {
		const struct soft_row *row = &run->rows[i];
		soft_word rb = row->red_blue + soft_spread(rb_right, false);
		soft_word ga = row->green_alpha + soft_spread(ga_right, false);
		soft_word color;

		for (uint32_t x = 0; x < row->count; x += SOFT_LANES) {
			if (texel) {
				color = (soft_get_words(out + x) & 0x00FFFFFF) |
					soft_scale_alpha(ga >> 16,
						soft_get_words(texel + x) >> 24)
						<< 24;
			} else {
				color = ODD_BYTES_AS_HALVES(rb) |
					(ga & 0xFF00) | ga >> 23 << 24;
			}
			soft_put_words(out + x, color);
			rb += soft_spread(rb_right, true);
			ga += soft_spread(ga_right, true);
		}
		out += row->count;
		if (texel) {
			texel += row->count;
		}
	}
}

/* Computes colours by the environments from vertices' colours and textures. */
static void combine(
	struct draw *draw, uint32_t *texel, uint32_t *color, uint32_t count)
{
	const struct soft_spans *spans = &draw->spans;
	const struct soft_run *run = &spans->run;
	const struct texture_input *input = &draw->texture[0];
	uint32_t own[SOFT_BATCH_ROOM], *primary = input->used ? own : color;

	fill_primary(run, NULL, primary);
	if (!input->used) {
		return;
	}
	soft_combine_row(
		&spans->environment[0], texel, primary, primary, color, count);
	if (input->mode == GL_MODULATE &&
		soft_base_has_alpha(input->base->base_format)) {
		fill_primary(run, texel, color);
	}
	if (draw->texture[1].used) {
		sample(draw, 1, texel);
		soft_combine_row(&spans->environment[1], texel, primary, color,
			color, count);
	}
}

/* Makes runs whose texture is a row of colours; returns their number. */
static uint32_t place_rows(
	const struct draw *draw, uint32_t *color, struct soft_row *out)
{
	const struct soft_spans *spans = &draw->spans;
	const struct soft_run *run = &spans->run;
	struct soft_row *row = out;
	uint32_t next = 0;

	for (uint32_t i = 0; i < run->row_count; i++) {
		uint32_t at = next;

		*row = run->rows[i];
		next += row->count;
		if (spans->coverage.used) {
			at += soft_cover(draw, row, color + at);
		}
		row->texel = at;
		row->texel_right = 1;
		if (spans->combined) {
			row->red_blue = spans->white[0];
			row->green_alpha = spans->white[1];
		}
		row += row->count > 0;
	}
	return (uint32_t)(row - out);
}

static void draw_made(const struct soft_run *given)
{
	struct draw *draw = given->draw;
	struct soft_spans *spans = &draw->spans;
	struct soft_run *run = &spans->run;
	const struct soft_row *rows = run->rows;
	const uint32_t row_count = run->row_count;
	const uint32_t red_blue_right = run->red_blue_right;
	const uint32_t green_alpha_right = run->green_alpha_right;
	uint32_t texel[SOFT_BATCH_ROOM], color[SOFT_BATCH_ROOM];
	uint32_t *made = texel, count = 0;
	struct soft_row row[SOFT_BATCH_RUNS];

	if (spans->textured) {
		count = sample(draw, 0, texel);
	}
	if (spans->multiplied) {
		sample(draw, 1, color);
		for (uint32_t i = 0; i < count; i += SOFT_LANES) {
			soft_put_words(texel + i,
				soft_multiply_bytes(soft_get_words(texel + i),
					soft_get_words(color + i)));
		}
	} else if (spans->combined) {
		combine(draw, texel, color, count);
		made = color;
		run->red_blue_right = 0;
		run->green_alpha_right = 0;
	}
	run->row_count = place_rows(draw, made, row);
	run->rows = row;
	run->first_texel = (const uint8_t *)made;
	spans->draw_row(run);
	run->rows = rows;
	run->row_count = row_count;
	run->red_blue_right = red_blue_right;
	run->green_alpha_right = green_alpha_right;
}

/* Converts RGBA8888 to words of soft_run.second. */
static void pack_second(uint32_t *texel, uint32_t count)
{
	for (uint32_t i = 0; i < count; i++) {
		const uint32_t red_blue = BYTES_AS_HALVES(texel[i]) * 249;
		const uint32_t green = (texel[i] >> 8 & 255) * 253;

		/* times 31 / 255 and 63 / 255, nearly: white is 31, 63 and 31 */
		texel[i] = (red_blue & 0xFFC0) << 16 | (green & 0xFFE0) << 6 |
			red_blue >> 21;
	}
}

void soft_read_second(struct draw *draw, uint32_t *texel)
{
	const uint32_t count = sample(draw, 1, texel);

	if (!draw->spans.wide && !draw->spans.levels[1].packed) {
		pack_second(texel, count);
	}
	draw->spans.run.second = (uintptr_t)texel;
}

static void prepare_combined(struct draw *draw)
{
	struct soft_spans *spans = &draw->spans;
	const bool alpha = (spans->finish & SOFT_MIXED) != 0 || spans->wide;

	for (int i = 0; i < SOFT_UNITS; i++) {
		if (draw->texture[i].used) {
			soft_find_environment(
				&draw->texture[i], &spans->environment[i]);
		}
	}
	spans->environment[draw->texture[1].used].alpha_wanted = alpha;
	spans->white[1] |= alpha ? WHITE_ALPHA << 16 : 0;
}

void soft_prepare_made(struct draw *draw)
{
	struct soft_spans *spans = &draw->spans;

	if (spans->combined) {
		prepare_combined(draw);
	}
	for (int i = 0; i < 3 && draw->texture[0].used; i++) {
		spans->stages.environment[i] =
			(uint32_t)soft_byte(draw->texture[0].env->color[i])
				<< 8 |
			128;
	}
	soft_set_functions(
		spans, (*spans->table)[spans->made_source][spans->finish]);
	spans->draw_row = spans->draw;
	spans->draw = draw_made;
}
