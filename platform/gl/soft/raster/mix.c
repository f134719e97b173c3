#include "platform/gl/soft/raster/mix.h"

void soft_keep_pixels(uint16_t *pixel, int count, uint32_t keep, uint32_t own)
{
	int i = 0;

	for (; i < count - 1; i += 2) {
		soft_store_two(pixel + i,
			soft_keep_two(soft_load_two(pixel + i), keep, own, own));
	}
	if (i < count) {
		pixel[i] =
			narrow((widen(pixel[i]) * keep + own) >> 5 & WIDE_MASK);
	}
}

void soft_mix_pixels(
	uint16_t *pixel, const uint16_t *own, int count, uint32_t share)
{
	int i = 0;

	for (; i < count - 1; i += 2) {
		soft_store_two(pixel + i,
			soft_mix_two(soft_load_two(pixel + i),
				soft_load_two(own + i), share));
	}
	if (i < count) {
		pixel[i] =
			narrow(mix_wide(widen(pixel[i]), widen(own[i]), share));
	}
}

bool soft_is_one_color(const uint16_t *pixel, int count)
{
	const uint16_t *end = pixel + count, *at = pixel;
	const uint64_t four = twice_565(*pixel) * (UINT64_C(1) << 32 | 1);

	at += (uintptr_t)at / sizeof(*at) % 2;
	for (; end - at >= 16; at += 16) {
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
