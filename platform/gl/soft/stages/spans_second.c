/* The span functions of RGB565 pictures that read a second texture's texels. */
#include "platform/gl/soft/span/instances.h"

SOFT_EACH_SHORT(SOFT_SECOND_FORMAT, SOFT_EACH_SECOND, .wide = false)
SOFT_SECOND_FORMAT(8888, TEXEL_8888, SOFT_EACH_SECOND, .wide = false)

const soft_span_table soft_spans_second = {SOFT_EACH_SHORT(SOFT_SECOND_ROWS,
	SOFT_EACH_SECOND) SOFT_SECOND_ROWS(8888, TEXEL_8888, SOFT_EACH_SECOND)};
