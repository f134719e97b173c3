/*
 * The span functions of RGB565 pictures that read two textures with the same
 * coordinates.
 */
#include "platform/gl/soft/span/instances.h"

SOFT_JOINED_FUNCTIONS

const soft_span_table soft_spans_joined = SOFT_JOINED_TABLE;
