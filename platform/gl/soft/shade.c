#include "platform/gl/soft/shade.h"

#include "platform/base/compiler.h"
#include "platform/gl/soft/pixel.h"

static ALWAYS_INLINE uint32_t load_quad(
	const struct shade_run *run, uint32_t s, uint32_t t)
{
	return run->quads[(t >> (32 - run->height_log2) << run->width_log2) +
		(s >> (32 - run->width_log2))];
}

static ALWAYS_INLINE bool is_even(uint32_t quad)
{
	return quad == (quad >> 8 | quad << 24);
}

/*
 * The mean of four texels by 16ths. Both rows are mixed at once; what one
 * borrows from the other the sum gives back.
 */
static ALWAYS_INLINE uint32_t mix_quad(
	const struct shade_run *run, uint32_t quad, uint32_t s, uint32_t t)
{
	uint32_t left = quad & 0xFF00FF, right = quad >> 8 & 0xFF00FF;
	uint32_t across = s << run->width_log2 >> 28;
	uint32_t down = t << run->height_log2 >> 28;
	uint32_t rows = left * 16 + (right - left) * across;

	return ((rows & 0xFFFF) * (16 - down) + (rows >> 16) * down + 128) >> 8;
}

static ALWAYS_INLINE void put(
	uint16_t *pixel, uint32_t own, uint32_t alpha, bool blended)
{
	*pixel = narrow(blended ? mix_wide(widen(*pixel), own, alpha) : own);
}

static ALWAYS_INLINE void put_each(const struct shade_run *run, uint16_t *pixel,
	int count, uint32_t s, uint32_t t, uint32_t alpha, bool blended)
{
	for (int i = 0; i < count; i++) {
		uint32_t shade = mix_quad(run, load_quad(run, s, t), s, t);

		put(pixel + i, run->shade[shade], alpha, blended);
		s += (uint32_t)run->s_right;
		t += (uint32_t)run->t_right;
	}
}

static ALWAYS_INLINE void put_same(
	uint16_t *pixel, int count, uint32_t own, uint32_t alpha, bool blended)
{
	uint32_t pair = narrow(own) * 0x10001u;

	if (blended) {
		for (int i = 0; i < count; i++) {
			put(pixel + i, own, alpha, true);
		}
		return;
	}
	for (int i = 0; i < count; i += 2) {
		memcpy(pixel + i, &pair, sizeof(pair));
	}
}

static ALWAYS_INLINE void run_blocks(
	const struct shade_run *run, int block, bool blended)
{
	uint16_t *pixel = run->pixel;
	uint32_t s = run->s, t = run->t, alpha = run->alpha;
	uint32_t quad = load_quad(run, s, t);
	int left = run->count;

	for (; left >= block; left -= block, pixel += block) {
		uint32_t next_s = s + (uint32_t)run->s_right * (uint32_t)block;
		uint32_t next_t = t + (uint32_t)run->t_right * (uint32_t)block;
		uint32_t next = load_quad(run, next_s, next_t);

		if (next == quad && is_even(quad)) {
			put_same(pixel, block, run->shade[quad & 255],
				alpha >> 19, blended);
		} else {
			put_each(run, pixel, block, s, t, alpha >> 19, blended);
		}
		quad = next;
		s = next_s;
		t = next_t;
		alpha += (uint32_t)(run->alpha_right * block);
	}
	put_each(run, pixel, left, s, t, alpha >> 19, blended);
}

void shade_four_c(const struct shade_run *run)
{
	run_blocks(run, 4, false);
}

void shade_two_c(const struct shade_run *run)
{
	run_blocks(run, 2, false);
}

void shade_four_blended_c(const struct shade_run *run)
{
	run_blocks(run, 4, true);
}

void shade_two_blended_c(const struct shade_run *run)
{
	run_blocks(run, 2, true);
}
