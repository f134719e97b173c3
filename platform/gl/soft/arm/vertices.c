/* What vertex.S, light.S and alike.S know of the structures, and the latter. */
#include "platform/gl/soft/draw.h"

/* A list, or what is left of it; offsets are known to alike.S. */
struct alike_run {
	const uint8_t *from, *end;
	/* what an index counts from, in steps of 2^shift / inverse */
	const uint8_t *base;
	uint32_t shift, inverse;
};

/* alike.S */
const uint8_t *alike_six_tight_arm(
	struct draw *draw, struct alike *alike, const struct alike_run *run);
const uint8_t *alike_six_arm(
	struct draw *draw, struct alike *alike, const struct alike_run *run);
const uint8_t *alike_eight_arm(
	struct draw *draw, struct alike *alike, const struct alike_run *run);

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
_Static_assert(offsetof(struct vertex, outcode) == 1, "");
_Static_assert(offsetof(struct vertex, shaded) == 2, "");
_Static_assert(offsetof(struct vertex, x) == 4, "");
_Static_assert(offsetof(struct vertex, attribute) == 16, "");
_Static_assert(offsetof(struct vertex, inverse_w_q30) == 52, "");
_Static_assert(offsetof(struct vertex, index) == 56, "");
_Static_assert(offsetof(struct vertex, clip) == 64, "");

/* light.S */
_Static_assert(offsetof(struct view, beams) == 116, "BEAMS");
_Static_assert(offsetof(struct beams, texcoords) == 580, "TEXCOORDS");
_Static_assert(offsetof(struct beams, texcoord_stride) == 584, "");
_Static_assert(offsetof(struct beams, rest) == 588, "");
_Static_assert(offsetof(struct vertex, attribute[TEX_S]) == 36, "VERTEX_TEX");
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

/* alike.S */
_Static_assert(offsetof(struct alike, listed) == 2048, "LISTED");
_Static_assert(offsetof(struct alike, slots) == 2560, "SLOTS");
_Static_assert(offsetof(struct alike, nothing) == 2944, "NOTHING");
_Static_assert(ALIKE_TRIANGLES == 64, "BATCH");
_Static_assert(VERTEX_CACHE == 512, "nine bits of what is mixed");
_Static_assert(sizeof(struct vertex) == 96, "");
_Static_assert(sizeof(struct place) == 8, "");
_Static_assert(offsetof(struct draw, quick.place) == 132, "QUICK_PLACE");
_Static_assert(offsetof(struct draw, quick.cache) == 136, "QUICK_CACHE");

/* vertex.S: of aligned ones */
uint32_t largest_float_arm(const uint8_t *at, int stride_bytes, uint32_t count);

uint32_t soft_largest_float(const uint8_t *at, int stride_bytes, uint32_t count)
{
	return ((uintptr_t)at | (uintptr_t)stride_bytes) % 4 == 0
		? largest_float_arm(at, stride_bytes, count)
		: largest_float_c(at, stride_bytes, count);
}

/* Zeros belong to slot 0, and one followed by zeros does not. */
static void forget_all(struct alike *alike)
{
	alike->nothing[1][0] = 1;
	alike->source[0] = (const uint8_t *)alike->nothing[1];
	for (int i = 1; i < VERTEX_CACHE; i++) {
		alike->source[i] = (const uint8_t *)alike->nothing[0];
	}
}

bool soft_draw_alike(struct draw *draw, const uint8_t *at, size_t stride_bytes,
	int words, uint32_t first, uint32_t count)
{
	struct alike *alike = &draw->alike;
	bool tight = stride_bytes == 24;
	struct alike_run run = {
		.from = at + first * stride_bytes,
		.end = at + (first + count / 3 * 3) * stride_bytes,
		.base = at,
		.shift = tight ? 3 : 5,
		.inverse = tight ? 0xAAAAAAAB : 1, /* of 3, modulo 2^32 */
	};

	if ((uintptr_t)at % 4 != 0 || (words != 6 && words != 8) ||
		(stride_bytes != 32 && !(tight && words == 6))) {
		return false;
	}
	forget_all(alike);
	for (; run.from != run.end; run.from += 3 * stride_bytes) {
		run.from = words == 8 ? alike_eight_arm(draw, alike, &run)
			: tight       ? alike_six_tight_arm(draw, alike, &run)
				      : alike_six_arm(draw, alike, &run);
		if (run.from == run.end) {
			break;
		}
		soft_draw_apart(draw,
			(uint32_t)((size_t)(run.from - at) / stride_bytes));
	}
	return true;
}
