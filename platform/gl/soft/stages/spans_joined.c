/*
 * The span functions that read two textures with the same coordinates: in
 * RGB565 pictures, and RGBA8888 texels in pictures of these.
 */
#include "platform/gl/soft/span/instances.h"

SOFT_EACH_SHORT(SOFT_FORMAT_FUNCTIONS, SOFT_EACH_SECOND, .joined = true)
SOFT_FORMAT_FUNCTIONS(
	8888, TEXEL_8888, SOFT_EACH_SCALED, .joined = true, .wide = true)

const soft_span_table soft_spans_joined = {SOFT_EACH_SHORT(SOFT_FORMAT_ROWS,
	SOFT_EACH_SECOND) SOFT_FORMAT_ROWS(8888, TEXEL_8888, SOFT_EACH_SCALED)};
