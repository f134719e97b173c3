/* The stages behind the textures on a row of colours, for any blend function. */
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/stages/bytes.h"
#include "platform/gl/soft/stages/made.h"
#include "platform/gl/soft/vertex/draw.h"

enum {
	SRC_ALPHA_SATURATE = 0x0308,
};

/* Which fragments pass the depth test and the alpha test, as bits. */
static uint32_t find_passing(const struct soft_run *run, const uint32_t *color)
{
	const struct soft_fragment_stages *stages = run->stages;
	uint32_t z = run->row.z, passing = 0;

	for (uint32_t i = 0; i < run->row.count; i++, z += run->z_right) {
		uint32_t above = (color[i] >> 24) - stages->alpha_low;

		if (z >> 16 < run->row.depth[i] &&
			(above & 255) <= stages->alpha_range) {
			passing |= 1u << i;
		}
	}
	return passing;
}

static void add_fog(const struct soft_run *run, uint32_t *color)
{
	const uint8_t *to = run->stages->fog_color;
	uint32_t fog = run->row.fog;

	for (uint32_t i = 0; i < run->row.count; i++, fog += run->fog_right) {
		uint32_t out = color[i] & 0xFF000000;

		for (int k = 0; k < 3; k++) {
			int own = (int)(color[i] >> 8 * k & 255) - to[k];

			own = to[k] + ((own * (int)fog + (1 << 14)) >> 15);
			out |= (uint32_t)own << 8 * k;
		}
		color[i] = out;
	}
}

/* RGB565 has no alpha: it reads as 255. */
static void load_picture(const struct soft_run *run, uint32_t *out)
{
	if (run->draw->soft->format == PIXELS_RGBA8888) {
		memcpy(out, run->row.pixel, run->row.count * 4);
		return;
	}
	for (uint32_t i = 0; i < run->row.count; i++) {
		uint32_t p = load_16(run->row.pixel + 2 * i);
		uint32_t r = p >> 11, g = p >> 5 & 63, b = p & 31;

		out[i] = r << 3 | r >> 2 | (g << 2 | g >> 4) << 8 |
			(b << 3 | b >> 2) << 16 | 0xFF000000;
	}
}

static uint32_t saturate_alpha(uint32_t from, uint32_t to)
{
	uint32_t own = from >> 24, left = 255 - (to >> 24);

	return (own < left ? own : left) * 0x010101 | 0xFF000000;
}

static void fill_factors(GLenum factor, const uint32_t *from,
	const uint32_t *to, uint32_t *out, uint32_t count)
{
	/* Above GL_ONE each factor's complement is the next number, an odd one. */
	const uint32_t flip = factor > GL_ONE && factor & 1 ? UINT32_MAX : 0;
	uint32_t i = 0;

	switch (factor & ~1u) {
	case GL_SRC_COLOR:
		for (; i < count; i++) {
			out[i] = from[i] ^ flip;
		}
		break;
	case GL_DST_COLOR:
		for (; i < count; i++) {
			out[i] = to[i] ^ flip;
		}
		break;
	case GL_SRC_ALPHA:
		for (; i < count; i++) {
			out[i] = ((from[i] >> 24) * 0x01010101) ^ flip;
		}
		break;
	case GL_DST_ALPHA:
		for (; i < count; i++) {
			out[i] = ((to[i] >> 24) * 0x01010101) ^ flip;
		}
		break;
	case SRC_ALPHA_SATURATE:
		for (; i < count; i++) {
			out[i] = saturate_alpha(from[i], to[i]);
		}
		break;
	default:
		for (; i < count; i++) {
			out[i] = factor == GL_ZERO ? 0 : UINT32_MAX;
		}
		break;
	}
}

/* A sum of two products over 255, at most 255. */
static ALWAYS_INLINE uint32_t finish_sum(int32_t sum)
{
	sum = (sum + (sum >> 8)) >> 8;
	return (uint32_t)(sum > 255 ? 255 : sum);
}

/* Two bytes in the halves of words: the products' sum. */
static ALWAYS_INLINE uint32_t blend_lanes(
	uint32_t from, uint32_t source, uint32_t to, uint32_t destination)
{
	return finish_sum(HALVES_BB(
		       from, source, HALVES_BB(to, destination, 128))) |
		finish_sum(
			HALVES_TT(from, source, HALVES_TT(to, destination, 128)))
		<< 16;
}

static void blend(const struct soft_run *run, uint32_t *color)
{
	const struct soft_fragment_stages *stages = run->stages;
	uint32_t to[SOFT_RUN_PIXELS] = {0}, source[SOFT_RUN_PIXELS];
	uint32_t destination[SOFT_RUN_PIXELS];
	const uint32_t count = run->row.count;

	load_picture(run, to);
	fill_factors(stages->blend_source, color, to, source, count);
	fill_factors(stages->blend_destination, color, to, destination, count);
	for (uint32_t i = 0; i < count; i++) {
		uint32_t c = color[i], s = source[i];
		uint32_t p = to[i], d = destination[i];

		color[i] = blend_lanes(BYTES_AS_HALVES(c), BYTES_AS_HALVES(s),
				   BYTES_AS_HALVES(p), BYTES_AS_HALVES(d)) |
			blend_lanes(ODD_BYTES_AS_HALVES(c),
				ODD_BYTES_AS_HALVES(s), ODD_BYTES_AS_HALVES(p),
				ODD_BYTES_AS_HALVES(d))
				<< 8;
	}
}

static void store(
	const struct soft_run *run, const uint32_t *color, uint32_t passing)
{
	bool wide = run->draw->soft->format == PIXELS_RGBA8888;
	uint32_t z = run->row.z;

	for (uint32_t i = 0; i < run->row.count; i++, z += run->z_right) {
		uint32_t c = color[i];

		if (!(passing >> i & 1)) {
			continue;
		}
		run->row.depth[i] = (uint16_t)(z >> 16);
		if (wide) {
			memcpy(run->row.pixel + 4 * i, &c, 4);
		} else {
			store_16(run->row.pixel + 2 * i,
				pack_565((int)(c & 255), (int)(c >> 8 & 255),
					(int)(c >> 16 & 255)));
		}
	}
}

void soft_finish_row(const struct soft_run *run)
{
	uint32_t color[SOFT_RUN_PIXELS], passing;

	memcpy(color, run->first_texel, run->row.count * sizeof(*color));
	passing = find_passing(run, color);
	if (passing == 0) {
		return;
	}
	if (run->stages->fogged) {
		add_fog(run, color);
	}
	blend(run, color);
	store(run, color, passing);
}
