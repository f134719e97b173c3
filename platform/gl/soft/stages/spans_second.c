/* The span functions of RGB565 pictures that read a second texture's texels. */
#include "platform/gl/soft/span/instances.h"

SOFT_SECOND_FUNCTIONS

const soft_span_table soft_spans_second = SOFT_SECOND_TABLE;
