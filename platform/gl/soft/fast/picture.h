/*
 * Rows of upright pictures as they are: an RGB565 texture's nearest texels on a
 * level of their own, neither tinted nor tested, into RGB565.
 */
#ifndef PLATFORM_GL_SOFT_FAST_PICTURE_H
#define PLATFORM_GL_SOFT_FAST_PICTURE_H

#include "platform/gl/soft/raster/raster.h"

/*
 * A row of pixels from a row of texels, at s_q16 and steps further, which are
 * all there.
 */
void soft_picture_copy(uint16_t *pixel, const uint16_t *texels, int count,
	uint32_t s_q16, uint32_t s_right_q16);

#endif
