/*
 * Conversion between linear colours and sRGB, for load time.
 *
 * Fixed-function GL multiplies colours without decoding them, so limber passes
 * sRGB-encoded factors. Outside the linear segment of the curve the product is
 * exact, because (ab)^(1/g) = a^(1/g) b^(1/g), and textures stay unchanged.
 */
#ifndef APP_MODEL_COLOR_H
#define APP_MODEL_COLOR_H

#include <stdint.h>

/* Both map 0..1 to 0..1 (IEC 61966-2-1). They clamp; NaN becomes 0. */
float color_encode_srgb(float linear);
float color_decode_srgb(float encoded);

/* Bytes that color_encode_byte() has computed; zeroed at first. */
struct color_bytes {
	float linear[256];
	uint8_t byte[256];
};

/*
 * color_to_byte() of color_encode_srgb(), which takes 1,600 instructions
 * without hardware for double precision. Vertices share most of their colours.
 */
uint8_t color_encode_byte(struct color_bytes *known, float linear);

/* 0..1 to 0..255, rounded. It clamps; NaN becomes 0. */
uint8_t color_to_byte(float value);

#endif
