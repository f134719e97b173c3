/* What vertex.S and dedup.S know of the structures, and the latter. */
#include "platform/gl/soft/vertex/draw.h"

/* A list, or what is left of it; offsets are known to dedup.S. */
struct dedup_run {
	const uint8_t *from, *end;
	/* what an index counts from, in steps of 2^shift / inverse */
	const uint8_t *base;
	uint32_t shift, inverse;
};

/* dedup.S */
const uint8_t *soft_dedup_six_tight_arm(
	struct draw *draw, struct dedup *dedup, const struct dedup_run *run);
const uint8_t *soft_dedup_six_arm(
	struct draw *draw, struct dedup *dedup, const struct dedup_run *run);
const uint8_t *soft_dedup_eight_arm(
	struct draw *draw, struct dedup *dedup, const struct dedup_run *run);

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

/* dedup.S */
_Static_assert(DEDUP_TRIANGLES == 64, "BATCH");
_Static_assert(VERTEX_CACHE == 512, "nine bits of what is mixed");
_Static_assert(sizeof(struct vertex) == 96, "");
_Static_assert(sizeof(struct cache_tag) == 8, "");

/* Zeros belong to slot 0, and one followed by zeros does not. */
static void forget_all(struct dedup *dedup)
{
	dedup->nothing[1][0] = 1;
	dedup->source[0] = (const uint8_t *)dedup->nothing[1];
	for (int i = 1; i < VERTEX_CACHE; i++) {
		dedup->source[i] = (const uint8_t *)dedup->nothing[0];
	}
}

bool soft_draw_dedup(struct draw *draw, const uint8_t *at, size_t stride_bytes,
	int words, uint32_t first, uint32_t count)
{
	struct dedup *dedup = &draw->dedup;
	bool tight = stride_bytes == 24;
	struct dedup_run run = {
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
	forget_all(dedup);
	for (; run.from != run.end; run.from += 3 * stride_bytes) {
		run.from = words == 8 ? soft_dedup_eight_arm(draw, dedup, &run)
			: tight ? soft_dedup_six_tight_arm(draw, dedup, &run)
				: soft_dedup_six_arm(draw, dedup, &run);
		if (run.from == run.end) {
			break;
		}
		soft_draw_apart(draw,
			(uint32_t)((size_t)(run.from - at) / stride_bytes));
	}
	return true;
}
