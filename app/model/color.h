/*
 * Conversion between linear colours and sRGB, for use while a model is loaded.
 *
 * Fixed-function GL multiplies colours without decoding them, so limber passes
 * sRGB-encoded factors. Outside the linear segment of the curve the product is
 * exact, because (ab)^(1/g) = a^(1/g) b^(1/g), and textures stay unchanged.
 */
#ifndef APP_MODEL_COLOR_H
#define APP_MODEL_COLOR_H

#include <stdint.h>

/*
 * Map 0..1 to 0..1 by the curve of IEC 61966-2-1. Other values are clamped; NaN
 * becomes 0.
 */
float color_encode_srgb(float linear);
float color_decode_srgb(float encoded);

/* A cache of color_encode_byte()'s results; at first set to zeros. */
struct color_bytes {
	float linear[256];
	uint8_t byte[256];
};

/*
 * Returns color_to_byte(color_encode_srgb(linear)), from the cache if possible:
 * the computation takes 1,600 instructions without hardware for double
 * precision, and most vertices share their colours with others.
 */
uint8_t color_encode_byte(struct color_bytes *known, float linear);

/*
 * Returns what a lit surface shows besides its colour, as a gray to be added to
 * each channel: by what glTF 2.0 (appendix B.2) lets materials mirror of their
 * surroundings, 4% of the light. All are sRGB-encoded. brightest is the
 * greatest of the colour's channels: black gets 0.22, the code of 4%, and
 * colours of 0.66 and more get nothing, as they would only fade. Without it
 * black plastic would be a hole without a form.
 */
float color_mirrored(float brightest);

/* Adds it to a colour of bytes. */
void color_mirror(uint8_t rgb[3]);

/* Adds it to each of count colours; alpha stays. */
void color_mirror_all(uint8_t (*rgba)[4], int count);

/* Maps 0..1 to 0..255, rounded. Other values are clamped; NaN becomes 0. */
uint8_t color_to_byte(float value);

#endif
