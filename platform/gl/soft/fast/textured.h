/*
 * What small textured triangles of a draw call share, so that setting one up
 * looks nothing else up. fill_texture.c makes it.
 */
#ifndef PLATFORM_GL_SOFT_FAST_TEXTURED_H
#define PLATFORM_GL_SOFT_FAST_TEXTURED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "platform/gl/soft/soft.h"

/* A level as struct band has it. */
struct textured_level {
	uint32_t texel_mask, texel_shift;
	const uint8_t *texels; /* NULL where it is larger than 256 */
	uint32_t stride_bytes;
	/* from 16.16 of the base's texels to 8 bits of its own */
	int32_t s_down, t_down;
};

struct textured {
	int32_t last_level; /* of those to choose from */
	struct textured_level level[SOFT_LEVELS];
};

#endif
