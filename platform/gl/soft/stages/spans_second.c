/* The span functions that read a second texture's texels, for both pictures. */
#include "platform/gl/soft/span/instances.h"

SOFT_EACH_SHORT(SOFT_FORMAT_FUNCTIONS, SOFT_EACH_SECOND, .wide = false)
SOFT_FORMAT_FUNCTIONS(8888, TEXEL_8888, SOFT_EACH_SECOND, .wide = false)
SOFT_MADE_FUNCTIONS(made, SOFT_EACH_SECOND, .wide = false)

const soft_span_table soft_spans_second = {SOFT_EACH_SHORT(SOFT_FORMAT_ROWS,
	SOFT_EACH_SECOND) SOFT_FORMAT_ROWS(8888, TEXEL_8888, SOFT_EACH_SECOND)
		SOFT_MADE_ROW(SOFT_MADE, made, SOFT_EACH_SECOND)};

SOFT_FORMAT_FUNCTIONS(scaled_8888, TEXEL_8888, SOFT_EACH_SCALED, .wide = true)
SOFT_MADE_FUNCTIONS(scaled_made, SOFT_EACH_SCALED, .wide = true)

const soft_span_table soft_spans_scaled = {
	SOFT_FORMAT_ROWS(scaled_8888, TEXEL_8888, SOFT_EACH_SCALED)
		SOFT_MADE_ROW(SOFT_MADE, scaled_made, SOFT_EACH_SCALED)};
