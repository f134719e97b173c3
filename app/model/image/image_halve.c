#include "app/model/image/image_halve.h"

#include <string.h>

/* Each sum holds every second channel of four pixels, in 16 bits. */
void image_halve_rows(const uint8_t (*above)[4], const uint8_t (*below)[4],
	int width, uint8_t (*out)[4])
{
	const uint32_t even_bytes = 0x00ff00ff;
	int last = width - 1;

	for (int x = 0; x <= last; x += 2, out++) {
		int right = x < last ? x + 1 : last;
		const uint8_t *from[4] = {
			above[x], above[right], below[x], below[right]};
		uint32_t even = 0x00020002, odd = even, word;

		for (int i = 0; i < 4; i++) {
			memcpy(&word, from[i], sizeof(word));
			even += word & even_bytes;
			odd += word >> 8 & even_bytes;
		}
		word = (even >> 2 & even_bytes) | (odd >> 2 & even_bytes) << 8;
		memcpy(*out, &word, sizeof(word));
	}
}
