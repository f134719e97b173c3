/* Colours of texels: formats, wrapping, filters and levels. */
#include "platform/gl/soft/draw.h"
#include "platform/gl/soft/number.h"
#include "platform/gl/soft/pixel.h"

static int wide_4(int nibble)
{
	return nibble * 17;
}

static void read_texel(const struct level *level, int x, int y, uint8_t out[4])
{
	size_t at = ((size_t)y << level->width_log2) + (size_t)x;
	const uint8_t *texels = level->texels;
	uint16_t packed;

	switch (level->format) {
	case TEXEL_565:
		unpack_565(load_16(texels + 2 * at), out);
		out[3] = 255;
		break;
	case TEXEL_4444:
		packed = load_16(texels + 2 * at);
		for (int i = 0; i < 4; i++) {
			out[i] = (uint8_t)wide_4(packed >> (12 - 4 * i) & 15);
		}
		break;
	case TEXEL_5551:
		packed = load_16(texels + 2 * at);
		for (int i = 0; i < 3; i++) {
			int five = packed >> (11 - 5 * i) & 31;

			out[i] = (uint8_t)(five << 3 | five >> 2);
		}
		out[3] = packed & 1 ? 255 : 0;
		break;
	case TEXEL_8888:
		memcpy(out, texels + 4 * at, 4);
		break;
	case TEXEL_L8:
		memset(out, texels[at], 3);
		out[3] = 255;
		break;
	case TEXEL_A8:
		memset(out, 0, 3);
		out[3] = texels[at];
		break;
	case TEXEL_LA88:
		memset(out, texels[2 * at], 3);
		out[3] = texels[2 * at + 1];
		break;
	default:
		memset(out, 255, 4);
		break;
	}
}

/* A whole coordinate into the level. */
static int wrap(GLenum mode, int at, int log2)
{
	int last = (1 << log2) - 1;

	return mode == GL_REPEAT ? at & last : clamp_int(at, 0, last);
}

static void sample_nearest(const struct texture *texture,
	const struct level *level, int32_t s_q16, int32_t t_q16, uint8_t out[4])
{
	read_texel(level, wrap(texture->wrap_s, s_q16 >> 16, level->width_log2),
		wrap(texture->wrap_t, t_q16 >> 16, level->height_log2), out);
}

static void mix_texels(
	const uint8_t a[4], const uint8_t b[4], int share_q8, uint8_t out[4])
{
	for (int i = 0; i < 4; i++) {
		out[i] = (uint8_t)(a[i] +
			(((b[i] - a[i]) * share_q8 + 128) >> 8));
	}
}

static void sample_linear(const struct texture *texture,
	const struct level *level, int32_t s_q16, int32_t t_q16, uint8_t out[4])
{
	int32_t s = (int32_t)((uint32_t)s_q16 - 32768);
	int32_t t = (int32_t)((uint32_t)t_q16 - 32768);
	int x[2], y[2];
	uint8_t corner[2][4], side[2][4];

	for (int i = 0; i < 2; i++) {
		x[i] = wrap(texture->wrap_s, (s >> 16) + i, level->width_log2);
		y[i] = wrap(texture->wrap_t, (t >> 16) + i, level->height_log2);
	}
	for (int i = 0; i < 2; i++) {
		read_texel(level, x[0], y[i], corner[0]);
		read_texel(level, x[1], y[i], corner[1]);
		mix_texels(corner[0], corner[1], s >> 8 & 255, side[i]);
	}
	mix_texels(side[0], side[1], t >> 8 & 255, out);
}

/* All three channels of an RGB565 texel by 256ths, 10 bits apart. */
static ALWAYS_INLINE void mix_565(
	const uint16_t texel[4], uint32_t across, uint32_t down, uint8_t out[4])
{
	static const int shift[3] = {11, 5, 0}, bits[3] = {5, 6, 5};

	for (int i = 0; i < 3; i++) {
		uint32_t mask = (1u << bits[i]) - 1;
		uint32_t above = (texel[0] >> shift[i] & mask) * (256 - across) +
			(texel[1] >> shift[i] & mask) * across;
		uint32_t below = (texel[2] >> shift[i] & mask) * (256 - across) +
			(texel[3] >> shift[i] & mask) * across;
		uint32_t all = above * (256 - down) + below * down;

		/* times 255 / 31 or 255 / 63, in 1/256 */
		out[i] = (uint8_t)(((all >> 8) * (bits[i] == 5 ? 2106 : 1036) +
					   32768) >>
			16);
	}
	out[3] = 255;
}

/* As sample_level(), of what most textures are. */
static void sample_linear_565(const struct level *level, int count, uint32_t s,
	uint32_t t, const int32_t step[2], const int shift[2], uint8_t (*out)[4])
{
	const uint32_t mask_s = (1u << level->width_log2) - 1;
	const uint32_t mask_t = (1u << level->height_log2) - 1;
	const uint16_t *texels = (const uint16_t *)(const void *)level->texels;

	for (int i = 0; i < count; i++) {
		uint32_t at_s = (uint32_t)((int32_t)s >> shift[0]) - 32768;
		uint32_t at_t = (uint32_t)((int32_t)t >> shift[1]) - 32768;
		uint32_t x0 = at_s >> 16 & mask_s, x1 = (x0 + 1) & mask_s;
		uint32_t y0 = at_t >> 16 & mask_t, y1 = (y0 + 1) & mask_t;
		const uint16_t *row = texels + (y0 << level->width_log2);
		const uint16_t *next = texels + (y1 << level->width_log2);
		const uint16_t four[4] = {row[x0], row[x1], next[x0], next[x1]};

		mix_565(four, at_s >> 8 & 255, at_t >> 8 & 255, out[i]);
		s += (uint32_t)step[0];
		t += (uint32_t)step[1];
	}
}

/* One level for all of a span, as s and t run at level 0. */
static void sample_level(const struct texture_input *input, int number,
	bool linear, const struct span *span, int unit, uint8_t (*out)[4])
{
	const struct texture *texture = input->texture;
	const struct level *level = &texture->level[number];
	int s_name = TEX_S + 2 * unit;
	uint32_t s = span->value[s_name], t = span->value[s_name + 1];
	int s_shift = input->width_log2 - level->width_log2;
	int t_shift = input->height_log2 - level->height_log2;

	if (linear && level->format == TEXEL_565 &&
		texture->wrap_s == GL_REPEAT && texture->wrap_t == GL_REPEAT) {
		const int shift[2] = {s_shift, t_shift};

		sample_linear_565(level, span->count, s, t, &span->step[s_name],
			shift, out);
		return;
	}
	for (int i = 0; i < span->count; i++) {
		int32_t at_s = (int32_t)s >> s_shift;
		int32_t at_t = (int32_t)t >> t_shift;

		if (linear) {
			sample_linear(texture, level, at_s, at_t, out[i]);
		} else {
			sample_nearest(texture, level, at_s, at_t, out[i]);
		}
		s += (uint32_t)span->step[s_name];
		t += (uint32_t)span->step[s_name + 1];
	}
}

static bool is_linear(GLenum filter)
{
	return filter == GL_LINEAR || filter == GL_LINEAR_MIPMAP_NEAREST ||
		filter == GL_LINEAR_MIPMAP_LINEAR;
}

/* GL ES 1.1 section 3.7.7: between two levels when both filters ask for it. */
void soft_sample(const struct texture_input *input, const struct span *span,
	int unit, uint8_t (*out)[4])
{
	const struct texture *texture = input->texture;
	GLenum min = texture->min_filter;
	bool sharp = texture->mag_filter == GL_LINEAR &&
		(min == GL_NEAREST_MIPMAP_NEAREST ||
			min == GL_NEAREST_MIPMAP_LINEAR);
	int lod = span->lod[unit], last = input->levels - 1;
	uint8_t next[SPAN_PIXELS][4];
	int level;

	if (lod <= (sharp ? 128 : 0)) {
		sample_level(input, 0, texture->mag_filter == GL_LINEAR, span,
			unit, out);
		return;
	}
	if (min != GL_NEAREST_MIPMAP_LINEAR && min != GL_LINEAR_MIPMAP_LINEAR) {
		level = clamp_int((lod + 127) >> 8, 0, last);
		sample_level(input, level, is_linear(min), span, unit, out);
		return;
	}
	level = clamp_int(lod >> 8, 0, last);
	sample_level(input, level, is_linear(min), span, unit, out);
	if (level < last) {
		/* lod runs straight between powers of two, a logarithm above. */
		int line = lod & 255;
		int share = line + (line * (256 - line) * 92 >> 16);

		sample_level(input, level + 1, is_linear(min), span, unit, next);
		for (int i = 0; i < span->count; i++) {
			mix_texels(out[i], next[i], share, out[i]);
		}
	}
}
