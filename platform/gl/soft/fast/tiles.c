/* Makes a texture's tiles when its image is set: rarely, so it may be slow. */
#include "platform/gl/soft/fast/tiles.h"

#include "platform/gl/soft/soft.h"

#include <stdlib.h>

/* The quads of a level, among which patches are searched. */
struct grid {
	uint32_t *quads;
	struct patch *patches;
	int side;
	int shift; /* from texels to 2^32 for the whole square */
};

static uint32_t luminance(uint8_t texel)
{
	return (texel * 127u + 127) / 255;
}

static void fill_quads(struct level *level)
{
	int width = 1 << level->width_log2, height = 1 << level->height_log2;
	int side = 1 << level->tiles->side_log2;
	uint32_t low = 127, high = 0, most;
	/* of the texture, 16.16: steps of two pixels must be less than half */
	uint32_t quarter = (width < height ? (uint32_t)width : (uint32_t)height)
		<< 14;

	for (int y = 0; y < side; y++) {
		const uint8_t *row = level->texels + y % height * width;
		const uint8_t *next = level->texels + (y + 1) % height * width;

		for (int x = 0; x < side; x++) {
			int left = x % width, right = (x + 1) % width;
			uint32_t own = luminance(row[left]);

			low = own < low ? own : low;
			high = own > high ? own : high;
			level->tiles->quad[y * side + x] = own |
				luminance(row[right]) << 8 |
				luminance(next[left]) << 16 |
				luminance(next[right]) << 24;
		}
	}
	level->tiles->low = (uint8_t)(2 * low);
	level->tiles->high = (uint8_t)(2 * high);
	most = high > low ? BY_TWO_MOST / (2 * (high - low)) : UINT32_MAX;
	level->tiles->by_two_most = most < quarter ? most : quarter - 1;
}

/* Whether a quad's four texels are equal and it belongs to no patch yet. */
static bool is_even(uint32_t quad)
{
	return quad == (quad & 127) * 0x01010101u;
}

static bool is_row_of(
	const struct grid *grid, int x, int y, int width, uint32_t quad)
{
	for (int i = 0; i < width; i++) {
		if (grid->quads[y * grid->side + x + i] != quad) {
			return false;
		}
	}
	return true;
}

/* Grows a rectangle of equal quads from (x, y): first right, then down. */
static struct rectangle grow(const struct grid *grid, int x, int y)
{
	uint32_t quad = grid->quads[y * grid->side + x];
	struct rectangle r = {x, y, 1, 1};

	while (x + r.width < grid->side &&
		grid->quads[y * grid->side + x + r.width] == quad) {
		r.width++;
	}
	while (y + r.height < grid->side &&
		is_row_of(grid, x, y + r.height, r.width, quad)) {
		r.height++;
	}
	return r;
}

static int area_of(const struct rectangle *r)
{
	return r->width * r->height;
}

static struct rectangle find_largest(const struct grid *grid)
{
	struct rectangle largest = {0};

	for (int y = 0; y < grid->side; y++) {
		for (int x = 0; x < grid->side; x++) {
			struct rectangle r = {0};

			if (is_even(grid->quads[y * grid->side + x])) {
				r = grow(grid, x, y);
			}
			largest = area_of(&r) > area_of(&largest) ? r : largest;
			/* tries only the left end of each run of equal quads */
			x += r.width ? r.width - 1 : 0;
		}
	}
	return largest;
}

static void set_patch(struct grid *grid, int number, const struct rectangle *r)
{
	for (int i = 0; i < area_of(r); i++) {
		uint32_t *quad = grid->quads +
			(r->y + i / r->width) * grid->side + r->x + i % r->width;

		*quad = QUAD_PATCH | (uint32_t)number << 8 | (*quad & 127);
	}
	grid->patches[number] = (struct patch){
		.s = {((uint32_t)r->x << grid->shift) - 1,
			((uint32_t)(r->x + r->width) << grid->shift) - 1},
		.t = {((uint32_t)r->y << grid->shift) - 1,
			((uint32_t)(r->y + r->height) << grid->shift) - 1},
	};
}

static void fill_fine(const struct grid *grid, uint8_t *fine)
{
	int side = 4 * grid->side;

	for (int i = 0; i < side * side; i++) {
		int x = i % side, y = i / side;
		uint32_t quad = grid->quads[y / 4 * grid->side + x / 4];

		fine[i] = (uint8_t)(quad & QUAD_PATCH
				? FINE_PATCH
				: quad_mix(quad, (uint32_t)(x % 4) * 64 + 32,
					  (uint32_t)(y % 4) * 64 + 32));
	}
}

static void fill_patches(struct grid *grid)
{
	for (int number = 1; number <= PATCHES_MOST; number++) {
		struct rectangle r = find_largest(grid);

		if (area_of(&r) == 0) {
			return;
		}
		set_patch(grid, number, &r);
	}
}

void soft_tiles_update(struct level *level)
{
	struct tiles *tiles = level->tiles;
	struct grid grid;

	if (!tiles) {
		return;
	}
	grid = (struct grid){tiles->quad, tiles->patch, 1 << tiles->side_log2,
		32 - tiles->side_log2};
	fill_quads(level);
	fill_patches(&grid);
	if (tiles->fine) {
		fill_fine(&grid, tiles->fine);
	}
}

void soft_tiles_make(struct level *level)
{
	const int width = level->width_log2, height = level->height_log2;
	const int side = width > height ? width : height;
	const size_t quads = (size_t)1 << 2 * side;
	const size_t quads_bytes = quads * sizeof(level->tiles->quad[0]);
	const bool fine = 1 << side <= FINE_SIDE_MAX;

	/* a side of one texel would need a shift by 32 */
	if (level->format != TEXEL_L8 || 1 << side > TILE_SIDE_MAX ||
		width == 0 || height == 0) {
		return;
	}
	level->tiles = calloc(1,
		sizeof(*level->tiles) + quads_bytes + (fine ? 16 * quads : 0));
	if (!level->tiles) {
		return;
	}
	level->tiles->side_log2 = side;
	level->tiles->fine =
		fine ? (uint8_t *)level->tiles->quad + quads_bytes : NULL;
	soft_tiles_update(level);
}
