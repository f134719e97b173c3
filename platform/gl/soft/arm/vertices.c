/* What vertex.S and light.S know of the structures. */
#include "platform/gl/soft/draw.h"

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
_Static_assert(POSITION_SHORTS == 0 && POSITION_FLOATS == 1, "by KIND");
_Static_assert(offsetof(struct vertex, outcode) == 1, "");
_Static_assert(offsetof(struct vertex, shaded) == 2, "");
_Static_assert(offsetof(struct vertex, x) == 4, "");
_Static_assert(offsetof(struct vertex, attribute) == 16, "");
_Static_assert(offsetof(struct vertex, inverse_w_q30) == 52, "");
_Static_assert(offsetof(struct vertex, index) == 56, "");
_Static_assert(offsetof(struct vertex, clip) == 64, "");

/* light.S */
_Static_assert(offsetof(struct beams, floats) == 28, "eight words");
_Static_assert(offsetof(struct beams, square_least) == 32, "");
_Static_assert(offsetof(struct beams, ambient_q24) == 40, "SUMS");
_Static_assert(offsetof(struct beams, emission_q16) == 52, "");
_Static_assert(offsetof(struct beams, beam) == 64, "behind the sums");
_Static_assert(sizeof(struct beam) == 64, "");
_Static_assert(offsetof(struct beam, gleams) == 24, "");
_Static_assert(offsetof(struct beam, half_q30) == 28, "");
_Static_assert(offsetof(struct beam, specular_q20) == 52, "");
_Static_assert(sizeof(struct gleam_step) == 8, "by LDRD");
_Static_assert(offsetof(struct vertex, back) == 80, "VERTEX_BACK");
