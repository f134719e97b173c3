/*
 * Functions that only read a run's texels, one for each format and filter, and
 * write them as RGBA8888; or RGB565 ones as words for soft_run.second.
 */
#define SOFT_BY_FOUR

#include "platform/gl/soft/span/stages.h"

static ALWAYS_INLINE soft_word widen_channel(struct soft_kind kind,
	enum soft_channel channel, const struct soft_texel *texel)
{
	int bits = soft_field(kind.format, channel).bits;
	soft_word value = texel->channel[channel];

	return kind.linear && bits > 0 ? soft_narrow_mixed(value, bits)
				       : soft_widen_field(value, bits);
}

/* A texel as RGBA8888. */
static ALWAYS_INLINE soft_word widen_texel(
	struct soft_kind kind, const struct soft_texel *texel)
{
	if (kind.format == TEXEL_8888) {
		return soft_join(texel);
	}
	return widen_channel(kind, SOFT_RED, texel) |
		widen_channel(kind, SOFT_GREEN, texel) << 8 |
		widen_channel(kind, SOFT_BLUE, texel) << 16 | texel->alpha << 24;
}

/* An RGB565 texel as a word for soft_run.second. */
static ALWAYS_INLINE soft_word pack_second(
	struct soft_kind kind, const struct soft_texel *texel)
{
	const soft_word *c = texel->channel;

	/* filtered channels are 2^18 times their values */
	return kind.linear
		? (c[0] & 0x7FE000) << 9 | (c[1] & 0xFFE000) >> 2 | c[2] >> 12
		: c[0] << 27 | c[1] << 16 | c[2] << 6;
}

/*
 * Reads a run's texels; kinds that are not wide give words for second. May
 * write three words behind them, too.
 */
static ALWAYS_INLINE void read_texels(
	const struct soft_run *given, const struct soft_kind kind)
{
	const struct soft_run own = *given, *run = &own;
	const uint32_t at_right = run->row.texel_right;
	soft_word at = run->row.texel + soft_spread(at_right, false);
	soft_word s = run->s.at + soft_spread(run->s.right, false);
	soft_word t = run->t.at + soft_spread(run->t.right, false);
	const struct soft_rows rows = {
		.first = run->first_texel, .stride = 1u << run->stride_log2};
	uint32_t *out = (uint32_t *)(void *)run->row.pixel;
	uint32_t *const end = out + run->row.count;

	for (; out < end; out += SOFT_LANES) {
		struct soft_texel texel = {.alpha = SOFT_OPAQUE_ALPHA};

		if (kind.inside) {
			soft_sample_inside(run, &rows, kind,
				soft_safe(at, soft_live(end - out)), &texel);
			at += soft_spread(at_right, true);
		} else {
			soft_sample_anywhere(
				run, run->texels, kind, s, t, &texel);
			s += soft_spread(run->s.right, true);
			t += soft_spread(run->t.right, true);
		}
		soft_finish_texel(kind, &texel);
		soft_put_words(out,
			kind.wide ? widen_texel(kind, &texel)
				  : pack_second(kind, &texel));
	}
}

#define READ_TEXELS(name, ...)                                              \
	static void name(const struct soft_run *run)                        \
	{                                                                   \
		read_texels(run,                                            \
			(struct soft_kind){.textured = true, __VA_ARGS__}); \
	}

#define BOTH_FUNCTIONS(name, texels, is_wide)                                 \
	READ_TEXELS(nearest_##name, .format = texels, .wide = is_wide)        \
	READ_TEXELS(nearest_##name##_inside, .format = texels,                \
		.wide = is_wide, .inside = true)                              \
	READ_TEXELS(linear_##name, .format = texels, .linear = true,          \
		.wide = is_wide)                                              \
	READ_TEXELS(linear_##name##_inside, .format = texels, .linear = true, \
		.wide = is_wide, .inside = true)

SOFT_EACH_FORMAT(BOTH_FUNCTIONS, true)
BOTH_FUNCTIONS(second, TEXEL_565, false)

/* clang-format off */
#define ROWS(name, texels, ...)                                              \
	[SOFT_NEAREST + texels - 1] = {nearest_##name,                       \
		nearest_##name##_inside},                                    \
	[SOFT_LINEAR + texels - 1] = {linear_##name, linear_##name##_inside},
/* clang-format on */

const soft_span_function soft_samplers[SOFT_SOURCES][2] = {
	SOFT_EACH_FORMAT(ROWS, )};

const soft_span_function soft_second_samplers[2][2] = {
	{nearest_second, nearest_second_inside},
	{linear_second, linear_second_inside}};
