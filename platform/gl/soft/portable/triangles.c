/* Lists and rows of triangles in C, for processors that arm/ is not for. */
#include "platform/gl/soft/fast/narrow.h"
#include "platform/gl/soft/vertex/cache.h"

void soft_list(struct draw *draw, const struct source *source)
{
	for (uint32_t i = 0; i + 2 < source->count; i += 3) {
		soft_draw_triangle(draw, source, i, i + 1, i + 2);
	}
}

#define BOTH_TESTS(name)               \
	void name(void *rows)          \
	{                              \
		name##_c(rows, false); \
	}                              \
	void name##_equal(void *rows)  \
	{                              \
		name##_c(rows, true);  \
	}

BOTH_TESTS(soft_narrow_rows)
BOTH_TESTS(soft_band_gray)
BOTH_TESTS(soft_band_tint)

void soft_tile_row(const struct tile_run *run, int by_fine)
{
	soft_tile_row_c(run, by_fine);
}
