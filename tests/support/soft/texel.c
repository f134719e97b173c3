/* Colours of texels: formats, wrapping, filters and levels. */
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/run.h"
#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/vertex/number.h"
#include "tests/support/soft/reference.h"

/* How a texel's column or row is wrapped: clamped to low..high, then masked. */
struct wrap {
	int32_t low, high;
	uint32_t mask;
};

/* A texture coordinate along a span: texels of a level, in SOFT_TEXEL_FRACTION. */
struct along {
	int32_t at, step;
	struct wrap wrap;
};

static struct along find_along(const struct span *span, int name, int log2,
	int level_log2, GLenum mode, int32_t half)
{
	int shift = log2 - level_log2 + 16 - SOFT_TEXEL_FRACTION;
	uint32_t right = soft_texel_step(span->step[name], shift);
	int32_t last = (1 << level_log2) - 1;
	bool repeats = mode == GL_REPEAT;

	return (struct along){
		.at = (int32_t)soft_find_start((int32_t)span->value[name],
			span->step[name], (uint32_t)span->count >> 1, right,
			shift, half),
		.step = (int32_t)right,
		.wrap = {repeats ? INT32_MIN : 0, repeats ? INT32_MAX : last,
			(uint32_t)last},
	};
}

static uint32_t wrap_at(int32_t at, const struct wrap *wrap)
{
	at = at < wrap->low ? wrap->low : at;
	at = at > wrap->high ? wrap->high : at;
	return (uint32_t)at & wrap->mask;
}

/* Reads the texel that is right columns and down rows from the coordinates. */
static uint32_t read_texel(const struct level *level, const struct along *s,
	const struct along *t, int right, int down)
{
	uint32_t x = wrap_at((s->at >> SOFT_TEXEL_FRACTION) + right, &s->wrap);
	uint32_t y = wrap_at((t->at >> SOFT_TEXEL_FRACTION) + down, &t->wrap);
	size_t at = ((size_t)y << level->width_log2) + x;
	int bytes_log2 = soft_texel_bytes_log2(level->format);

	return soft_load_bytes(level->texels + (at << bytes_log2), bytes_log2);
}

static void sample_nearest(const struct level *level, const struct along *s,
	const struct along *t, uint8_t out[4])
{
	uint32_t texel = read_texel(level, s, t, 0, 0);

	for (enum soft_channel i = 0; i < 4; i++) {
		int bits = soft_field(level->format, i).bits;

		out[i] = (uint8_t)soft_widen_field(
			soft_get_field(level->format, i, texel), bits);
	}
}

static void sample_linear(const struct level *level, const struct along *s,
	const struct along *t, bool wide, uint8_t out[4])
{
	uint32_t s_at = (uint32_t)s->at, t_at = (uint32_t)t->at;
	const uint32_t above[2] = {
		read_texel(level, s, t, 0, 0), read_texel(level, s, t, 1, 0)};
	const uint32_t below[2] = {
		read_texel(level, s, t, 0, 1), read_texel(level, s, t, 1, 1)};

	if (level->format == TEXEL_8888) {
		struct soft_four four =
			soft_weigh_8888(above, below, s_at, t_at, wide);
		uint32_t red_blue = soft_mix_half(&four, false, wide);
		uint32_t green_alpha = soft_mix_half(&four, true, wide);

		out[0] = (uint8_t)red_blue;
		out[1] = (uint8_t)green_alpha;
		out[2] = (uint8_t)(red_blue >> 16);
		out[3] = (uint8_t)(green_alpha >> 16);
		return;
	}
	for (enum soft_channel i = 0; i < 4; i++) {
		int bits = soft_field(level->format, i).bits;

		out[i] = bits == 0
			? 0
			: (uint8_t)soft_narrow_mixed(
				  soft_mix_channel(level->format, i,
					  above[0] | above[1] << 16,
					  below[0] | below[1] << 16,
					  soft_weigh(s_at >> (SOFT_TEXEL_FRACTION -
								     5),
						  t_at >> (SOFT_TEXEL_FRACTION -
								  8))),
				  bits);
	}
}

static void mix_texels(
	const uint8_t a[4], const uint8_t b[4], int share_q8, uint8_t out[4])
{
	for (int i = 0; i < 4; i++) {
		out[i] = (uint8_t)(a[i] +
			(((b[i] - a[i]) * share_q8 + 128) >> 8));
	}
}

/* Samples one level for a span, whose s and t are given for level 0. */
static void sample_level(const struct texture_input *input, int number,
	bool linear, const struct span *span, int unit, bool wide,
	uint8_t (*out)[4])
{
	const struct texture *texture = input->texture;
	const struct level *level = &texture->level[number];
	int name = TEX_S + 2 * unit;
	struct along s = find_along(span, name, input->width_log2,
		level->width_log2, texture->wrap_s,
		soft_half_texel(level->format, linear, true));
	struct along t = find_along(span, name + 1, input->height_log2,
		level->height_log2, texture->wrap_t,
		soft_half_texel(level->format, linear, false));
	bool opaque = soft_field(level->format, SOFT_ALPHA).bits == 0;

	for (int i = 0; i < span->count; i++) {
		if (linear) {
			sample_linear(level, &s, &t, wide, out[i]);
		} else {
			sample_nearest(level, &s, &t, out[i]);
		}
		out[i][3] = opaque ? 255 : out[i][3];
		s.at += s.step;
		t.at += t.step;
	}
}

/*
 * GL ES 1.1 section 3.7.7: samples the magnified texture, one level or, for the
 * filters ..._MIPMAP_LINEAR, a mixture of two levels.
 */
void reference_sample(const struct texture_input *input,
	const struct span *span, int unit, bool wide, uint8_t (*out)[4])
{
	const struct texture *texture = input->texture;
	GLenum min = texture->min_filter;
	bool sharp = texture->mag_filter == GL_LINEAR &&
		(min == GL_NEAREST_MIPMAP_NEAREST ||
			min == GL_NEAREST_MIPMAP_LINEAR);
	int lod = span->lod[unit], last = input->levels - 1;
	uint8_t next[REFERENCE_PIXELS][4];
	int level;

	if (lod <= (sharp ? 128 : 0)) {
		sample_level(input, 0, texture->mag_filter == GL_LINEAR, span,
			unit, wide, out);
		return;
	}
	if (min != GL_NEAREST_MIPMAP_LINEAR && min != GL_LINEAR_MIPMAP_LINEAR) {
		level = clamp_int((lod + 127) >> 8, 0, last);
		sample_level(input, level, soft_rows_is_linear(min), span, unit,
			wide, out);
		return;
	}
	level = clamp_int(lod >> 8, 0, last);
	sample_level(
		input, level, soft_rows_is_linear(min), span, unit, wide, out);
	if (level < last) {
		/*
		 * lod is linear between powers of two; the share makes a
		 * logarithm of it, which lies above that line.
		 */
		int line = lod & 255;
		int share = line + (line * (256 - line) * 92 >> 16);

		sample_level(input, level + 1, soft_rows_is_linear(min), span,
			unit, wide, next);
		for (int i = 0; i < span->count; i++) {
			mix_texels(out[i], next[i], share, out[i]);
		}
	}
}
