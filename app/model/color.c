#include "app/model/color.h"

#include "platform/base/scalar.h"

#include <math.h>
#include <string.h>

float color_encode_srgb(float linear)
{
	linear = scalar_clamp(linear, 0.0f, 1.0f);
	return linear <= 0.0031308f
		? 12.92f * linear
		: 1.055f * powf(linear, 1.0f / 2.4f) - 0.055f;
}

float color_decode_srgb(float encoded)
{
	encoded = scalar_clamp(encoded, 0.0f, 1.0f);
	return encoded <= 0.04045f ? encoded / 12.92f
				   : powf((encoded + 0.055f) / 1.055f, 2.4f);
}

uint8_t color_to_byte(float value)
{
	return (uint8_t)(scalar_clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

float color_mirrored(float brightest)
{
	float dark = 1.0f - scalar_clamp(brightest / 0.66f, 0.0f, 1.0f);

	return 0.22f * dark * dark;
}

/* 168.3 is 0.66 of 255, and 56.1 is 0.22 of it: the brightest that mirrors. */
enum {
	DARK_MAX = 168
};

/* Returns color_mirrored() of a byte up to DARK_MAX, as a byte. */
static uint8_t mirrored_byte(unsigned int brightest)
{
	const uint32_t all = 1683, most = 561;
	uint32_t dark = all - 10 * brightest;

	return (uint8_t)((most * dark * dark + 5 * all * all) / (10 * all * all));
}

static unsigned int brightest_of(const uint8_t rgb[3])
{
	unsigned int brightest = rgb[0] > rgb[1] ? rgb[0] : rgb[1];

	return brightest > rgb[2] ? brightest : rgb[2];
}

void color_mirror(uint8_t rgb[3])
{
	unsigned int brightest = brightest_of(rgb);

	for (int i = 0; i < 3 && brightest <= DARK_MAX; i++) {
		rgb[i] = (uint8_t)(rgb[i] + mirrored_byte(brightest));
	}
}

/* From a table, as a texture of a million texels delays the first picture. */
void color_mirror_all(uint8_t (*rgba)[4], int count)
{
	uint32_t add[256] = {0}; /* no sum of a byte exceeds 255 */

	for (unsigned int i = 0; i <= DARK_MAX; i++) {
		uint8_t gray = mirrored_byte(i), bytes[4] = {gray, gray, gray};

		memcpy(&add[i], bytes, sizeof(add[i]));
	}
	for (int i = 0; i < count; i++) {
		uint32_t word;

		memcpy(&word, rgba[i], sizeof(word));
		word += add[brightest_of(rgba[i])];
		memcpy(rgba[i], &word, sizeof(word));
	}
}

uint8_t color_encode_byte(struct color_bytes *known, float linear)
{
	uint32_t bits;
	int at;

	memcpy(&bits, &linear, sizeof(bits));
	at = (int)(bits * 2654435761u >> 24);
	/* For linear 0, a cache of zeros has the right byte already. */
	if (known->linear[at] != linear) {
		known->linear[at] = linear;
		known->byte[at] = color_to_byte(color_encode_srgb(linear));
	}
	return known->byte[at];
}
