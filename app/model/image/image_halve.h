/* Half-sized images. */
#ifndef APP_MODEL_IMAGE_IMAGE_HALVE_H
#define APP_MODEL_IMAGE_IMAGE_HALVE_H

#include <stdint.h>

/*
 * Averages two rows of RGBA pixels, which may be the same one, to a row of half
 * as many, rounded up: the last pixel of an odd number stands for the one that
 * lacks. out may begin where a row does, or before it.
 */
void image_halve_rows(const uint8_t (*above)[4], const uint8_t (*below)[4],
	int width, uint8_t (*out)[4]);

#endif
