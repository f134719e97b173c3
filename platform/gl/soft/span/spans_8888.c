/* The span functions of RGBA8888 pictures. */
#include "platform/gl/soft/span/instances.h"

SOFT_SPAN_FUNCTIONS(true)

const soft_span_table soft_spans_8888 = SOFT_SPAN_TABLE;
