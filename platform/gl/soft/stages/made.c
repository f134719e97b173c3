#include "platform/gl/soft/stages/made.h"

#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/stages/bytes.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

/* White's alpha, 8.7. */
enum {
	WHITE_ALPHA = 0x7FC0,
};

bool soft_mixes_levels(const struct texture_input *input)
{
	GLenum min;

	if (!input->used || input->levels <= 1) {
		return false;
	}
	min = input->texture->min_filter;
	return min == GL_NEAREST_MIPMAP_LINEAR || min == GL_LINEAR_MIPMAP_LINEAR;
}

/* GL ES 1.1 section 3.7.7: the level, or two and their shares. */
static void choose_levels(const struct texture_input *input, int lod,
	struct soft_made_levels *levels)
{
	const struct texture *texture = input->texture;
	bool small = soft_rows_is_small(input, lod),
	     mixed = soft_mixes_levels(input);
	GLenum filter = small ? texture->min_filter : texture->mag_filter;
	bool linear = soft_rows_is_linear(filter);
	int last = input->levels - 1, line = lod & 255;
	int level = small
		? clamp_int(mixed ? lod >> 8 : (lod + 127) >> 8, 0, last)
		: 0;

	/* lod runs straight between powers of two, a logarithm above. */
	levels->share = !mixed || !small || level == last
		? 0
		: line + (line * (256 - line) * 92 >> 16);
	if (level == levels->level && linear == levels->linear) {
		return;
	}
	levels->level = level;
	levels->linear = linear;
	levels->sampler = soft_samplers[(linear ? SOFT_LINEAR : SOFT_NEAREST) +
		(int)input->base->format - 1];
	levels->view = soft_find_view(input, level, linear);
	levels->next_view =
		soft_find_view(input, level < last ? level + 1 : level, linear);
}

void soft_set_made_levels(struct draw *draw, int lod)
{
	choose_levels(&draw->texture[0], lod, &draw->spans.made_levels[0]);
}

/* The texels of a level, as bytes. */
static void sample_level(const struct soft_made_levels *levels,
	const struct soft_view *view, const struct soft_made_at *at,
	uint32_t count, uint32_t *out)
{
	/* The depths are not read. */
	struct soft_run run = {.row = {.depth = (uint16_t *)out,
				       .pixel = (uint8_t *)out,
				       .count = count}};

	soft_use_view(view, &run);
	run.s_right = soft_texel_step(at->s_step, view->s_shift);
	run.t_right = soft_texel_step(at->t_step, view->t_shift);
	run.row.texel_right =
		((uint32_t)run.t_right << 16) + (uint32_t)run.s_right;
	run.s = soft_find_start(at->s, at->s_step, count >> 1, run.s_right,
		view->s_shift, view->s_half);
	run.t = soft_find_start(at->t, at->t_step, count >> 1, run.t_right,
		view->t_shift, view->t_half);
	if (soft_find_window(&view->window, view->texel_log2, &run)) {
		levels->sampler[1](&run);
	} else {
		soft_cut_run(&run, view, levels->sampler, 2);
	}
}

/* From one to the other of four bytes by 0..255 of 256. */
static uint32_t mix(uint32_t from, uint32_t to, uint32_t share)
{
	const uint32_t mask = 0x00FF00FF, half = 0x00800080;
	uint32_t low = (from & mask) * (256 - share) + (to & mask) * share;
	uint32_t high =
		(from >> 8 & mask) * (256 - share) + (to >> 8 & mask) * share;

	return ((low + half) >> 8 & mask) | ((high + half) & ~mask);
}

static void sample(const struct soft_made_levels *levels,
	const struct soft_made_at *at, uint32_t count, uint32_t *texel)
{
	uint32_t next[SOFT_RUN_PIXELS], share = (uint32_t)levels->share;

	sample_level(levels, &levels->view, at, count, texel);
	if (share > 0) {
		sample_level(levels, &levels->next_view, at, count, next);
		for (uint32_t i = 0; i < count; i++) {
			texel[i] = mix(texel[i], next[i], share);
		}
	}
}

/* Where the run is in the picture, which the depth's place says. */
static int find_place(const struct draw *draw, int *row)
{
	const struct buffers *buffers = &draw->soft->buffers;
	uint32_t place = (uint32_t)(draw->spans.run.row.depth - buffers->depth);

	*row = (int)(place / (uint32_t)buffers->width);
	return (int)place - *row * buffers->width;
}

/* The second texture's texels. */
static void sample_second(struct draw *draw, uint32_t count, uint32_t *texel)
{
	struct soft_made_levels *levels = &draw->spans.made_levels[1];
	int y;
	struct span span = {.x = find_place(draw, &y), .count = (int)count};

	soft_rows_find_second(draw, y - draw->raster.top, &span);
	choose_levels(&draw->texture[1], span.lod[1], levels);
	sample(levels,
		&(struct soft_made_at){(int32_t)span.value[TEX_S + 2],
			(int32_t)span.value[TEX_S + 3], span.step[TEX_S + 2],
			span.step[TEX_S + 3]},
		count, texel);
}

/* The vertices' colours. */
static void fill_primary(const struct soft_run *run, uint32_t *out)
{
	uint32_t rb = run->row.red_blue, rb_right = run->red_blue_right;
	uint32_t ga = run->row.green_alpha, ga_right = run->green_alpha_right;
	const uint32_t *end = out + run->row.count;

	for (; out != end; out++) {
		*out = ODD_BYTES_AS_HALVES(rb) | (ga & 0xFF00) | ga >> 23 << 24;
		rb += rb_right;
		ga += ga_right;
	}
}

/* Alpha by the texel's with its fraction, as the span functions have it. */
static void scale_alphas(
	const struct soft_run *run, const uint32_t *texel, uint32_t *color)
{
	uint32_t ga = run->row.green_alpha, ga_right = run->green_alpha_right;
	const uint32_t *end = color + run->row.count;

	for (; color != end; color++, texel++, ga += ga_right) {
		uint32_t alpha = soft_scale_alpha(ga >> 16, *texel >> 24);

		*color = (*color & 0x00FFFFFF) | alpha << 24;
	}
}

/* What the environments make of the vertices' colours and the textures. */
static void combine(struct draw *draw, uint32_t *texel, uint32_t *color)
{
	const struct soft_spans *spans = &draw->spans;
	const struct soft_run *run = &spans->run;
	uint32_t primary[SOFT_RUN_PIXELS];

	fill_primary(run, color);
	if (!draw->texture[0].used) {
		return;
	}
	memcpy(primary, color, run->row.count * sizeof(*primary));
	soft_combine_row(
		&spans->environment[0], texel, primary, color, run->row.count);
	if (spans->stages.alpha_scaled) {
		scale_alphas(run, texel, color);
	}
	if (draw->texture[1].used) {
		sample_second(draw, run->row.count, texel);
		soft_combine_row(&spans->environment[1], texel, primary, color,
			run->row.count);
	}
}

/* Whether all of the run lies behind what is there. */
static bool is_hidden(const struct soft_spans *spans)
{
	const struct soft_run *run = &spans->run;
	uint32_t z = run->row.z;

	if (!spans->depth_by_less) {
		return false;
	}
	for (uint32_t i = 0; i < run->row.count; i++, z += run->z_right) {
		if (z >> 16 <= run->row.depth[i]) {
			return false;
		}
	}
	return true;
}

/* Draws a row of colours as far as a smooth point or line covers it. */
static NEVER_INLINE void draw_covered(struct draw *draw, uint32_t *color)
{
	struct soft_run *run = &draw->spans.run;
	const struct soft_row whole = run->row;
	int row, column = find_place(draw, &row);

	run->first_texel = (const uint8_t *)(color +
		soft_cover(&draw->spans, column, row, color));
	if (run->row.count > 0) {
		draw->spans.draw_row(run);
	}
	run->row = whole;
}

static void draw_made(const struct soft_run *given)
{
	struct draw *draw = given->draw;
	struct soft_spans *spans = &draw->spans;
	struct soft_run *run = &spans->run;
	const struct soft_run whole = *run;
	uint32_t texel[SOFT_RUN_PIXELS], color[SOFT_RUN_PIXELS], *row = texel;

	if (is_hidden(spans)) {
		return;
	}
	if (spans->textured) {
		sample(&spans->made_levels[0], &spans->made_at, run->row.count,
			texel);
	}
	if (spans->multiplied) {
		sample_second(draw, run->row.count, color);
		for (uint32_t i = 0; i < run->row.count; i++) {
			texel[i] = soft_multiply_bytes(texel[i], color[i]);
		}
	} else if (spans->combined) {
		combine(draw, texel, color);
		row = color;
		run->row.red_blue = spans->white[0];
		run->row.green_alpha = spans->white[1];
		run->red_blue_right = 0;
		run->green_alpha_right = 0;
	}
	run->first_texel = (const uint8_t *)row;
	run->row.texel = 0;
	if (spans->coverage.used) {
		draw_covered(draw, color);
	} else {
		spans->draw_row(run);
	}
	run->row.red_blue = whole.row.red_blue;
	run->row.green_alpha = whole.row.green_alpha;
	run->red_blue_right = whole.red_blue_right;
	run->green_alpha_right = whole.green_alpha_right;
}

/* The second texture's texels for a whole run; false where it is hidden. */
static bool sample_before(struct soft_spans *spans)
{
	struct soft_run *run = &spans->run;

	if (is_hidden(spans)) {
		return false;
	}
	run->second = spans->second;
	spans->scaled_depth = run->row.depth;
	sample_second(run->draw, run->row.count, spans->second);
	return true;
}

static void draw_scaled(const struct soft_run *run)
{
	struct soft_spans *spans = &run->draw->spans;

	if (sample_before(spans)) {
		spans->scaled[1](run);
	}
}

static void draw_part(struct soft_spans *spans, int inside)
{
	struct soft_run *run = &spans->run;

	run->second = spans->second + (run->row.depth - spans->scaled_depth);
	spans->scaled[inside](run);
}

static void draw_part_anywhere(const struct soft_run *run)
{
	draw_part(&run->draw->spans, 0);
}

static void draw_part_inside(const struct soft_run *run)
{
	draw_part(&run->draw->spans, 1);
}

static void draw_scaled_across(const struct soft_run *run)
{
	static const soft_span_function parts[2] = {
		draw_part_anywhere, draw_part_inside};
	struct soft_spans *spans = &run->draw->spans;

	if (sample_before(spans)) {
		soft_cut_run(
			&spans->run, &spans->view, parts, spans->pixel_log2);
	}
}

void soft_prepare_second(struct soft_spans *spans)
{
	bool scaled = spans->finish == SOFT_SCALED;

	spans->made_levels[1].level = -1;
	spans->run.second = NULL;
	spans->draw_scaled = scaled ? draw_scaled : NULL;
	spans->draw_across = scaled ? draw_scaled_across : NULL;
}

static void prepare_combined(struct draw *draw)
{
	struct soft_spans *spans = &draw->spans;
	bool alpha = spans->finish != SOFT_OPAQUE &&
		spans->finish != SOFT_OPAQUE_FOG;

	alpha |= spans->table == &soft_spans_8888;
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
	spans->made_levels[0].level = -1;
	soft_set_functions(spans,
		(*spans->table)[SOFT_NEAREST + TEXEL_8888 - 1][spans->finish]);
	spans->draw_row = spans->draw;
	/* All runs come here: none lies in the window. */
	spans->window.s_room = 0;
	spans->draw = draw_made;
	spans->draw_anywhere = draw_made;
	spans->draw_across = draw_made;
	spans->run.row.texel_right = 1 << SOFT_TEXEL_FRACTION;
	spans->run.stride_log2 = 0;
}
