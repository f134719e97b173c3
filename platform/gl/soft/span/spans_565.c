/* The span functions of RGB565 pictures. */
#include "platform/gl/soft/span/instances.h"

SOFT_SPAN_FUNCTIONS(false)

const soft_span_table soft_spans_565 = SOFT_SPAN_TABLE;
