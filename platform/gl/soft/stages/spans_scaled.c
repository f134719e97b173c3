/* The span functions of RGBA8888 pictures that read a second texture's texels. */
#include "platform/gl/soft/span/instances.h"

SOFT_SECOND_FORMAT(8888, TEXEL_8888, SOFT_EACH_SCALED, .wide = true)

const soft_span_table soft_spans_scaled = {
	SOFT_SECOND_ROWS(8888, TEXEL_8888, SOFT_EACH_SCALED)};
