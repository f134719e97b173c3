/* What vertex.S knows of the structures. */
#include "platform/gl/soft/vertex/draw.h"

_Static_assert(offsetof(struct draw, view) == 0, "r0 is the view");
_Static_assert(offsetof(struct view, row_x) == 8, "");
_Static_assert(offsetof(struct view, row_z) == 32, "");
_Static_assert(offsetof(struct view, moved_z) == 56, "");
_Static_assert(offsetof(struct view, positions) == 64, "POSITIONS");
_Static_assert(offsetof(struct view, stride_bytes) == 68, "");
_Static_assert(offsetof(struct view, kind) == 72, "KIND");
_Static_assert(offsetof(struct view, scale) == 76, "SCALE");
_Static_assert(offsetof(struct view, center_x_q8) == 64 + 16, "CENTER");
_Static_assert(offsetof(struct view, depth) == 100, "");
_Static_assert(offsetof(struct view, inverse_w_q30) == 64 + 40, "INVERSE_W");
_Static_assert(offsetof(struct view, w_zeros) == 108, "");
_Static_assert(offsetof(struct view, reciprocals) == 64 + 48, "RECIPROCALS");
_Static_assert(
	POSITION_SHORTS == 0 && POSITION_FLOATS == 1 && POSITION_PAIRS == 2,
	"by KIND");
_Static_assert(offsetof(struct vertex, x) == 4, "");
_Static_assert(offsetof(struct vertex, attribute) == 16, "");
_Static_assert(offsetof(struct vertex, inverse_w_q30) == 52, "");
_Static_assert(offsetof(struct vertex, clip) == 64, "");
