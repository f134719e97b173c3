#include "platform/gl/soft/raster/mix.h"

static ALWAYS_INLINE uint32_t swap_halves(uint32_t word)
{
	return word >> 16 | word << 16;
}

/*
 * Blends two pixels with two others, to. Masking a word gives one wide pixel
 * (see pixel.h) of this pixel's red and blue and the other one's green; masking
 * it with its halves swapped gives the rest.
 */
static ALWAYS_INLINE uint32_t mix_two(uint32_t two, uint32_t to, uint32_t share)
{
	const uint32_t keep = 32 - share;
	const uint32_t own = (to & WIDE_MASK) * share + WIDE_ROUND;
	const uint32_t swapped =
		(swap_halves(to) & WIDE_MASK) * share + WIDE_ROUND;
	uint32_t a = two & WIDE_MASK, b = swap_halves(two) & WIDE_MASK;

	a = (a * keep + own) >> 5 & WIDE_MASK;
	b = (b * keep + swapped) >> 5 & WIDE_MASK;
	return a | swap_halves(b);
}

/* Blends pixels with those of own or, if NULL, with those of two. */
static ALWAYS_INLINE void mix(uint16_t *pixel, const uint16_t *own,
	uint32_t two, int count, uint32_t share)
{
	int i = 0;

	for (; i < count - 1; i += 2) {
		uint32_t mixed = mix_two(soft_load_two(pixel + i),
			own ? soft_load_two(own + i) : two, share);

		memcpy(pixel + i, &mixed, sizeof(mixed));
	}
	if (i < count) {
		pixel[i] = narrow(mix_wide(widen(pixel[i]),
			widen(own ? own[i] : two & 0xFFFF), share));
	}
}

void soft_mix_pixels(
	uint16_t *pixel, const uint16_t *own, int count, uint32_t share)
{
	mix(pixel, own, 0, count, share);
}

void soft_mix_color(uint16_t *pixel, uint16_t color, int count, uint32_t share)
{
	mix(pixel, NULL, twice_565(color), count, share);
}

bool soft_is_one_color(const uint16_t *pixel, int count)
{
	const uint16_t *end = pixel + count, *at = pixel;
	const uint64_t four = twice_565(*pixel) * (UINT64_C(1) << 32 | 1);

	at += (uintptr_t)at / sizeof(*at) % 2;
	for (; end - at >= 16; at += 16) {
		PRELOAD(at + 48);
		if (load_two_words(at) != four ||
			load_two_words(at + 4) != four ||
			load_two_words(at + 8) != four ||
			load_two_words(at + 12) != four) {
			return false;
		}
	}
	for (; end - at >= 4; at += 4) {
		if (load_two_words(at) != four) {
			return false;
		}
	}
	while (at < end && *at == *pixel) {
		at++;
	}
	return at == end;
}
