/* Makes a texture's tiles when its image is set: rarely, so it may be slow. */
#include "platform/gl/soft/fast/tiles.h"

#include "platform/gl/soft/soft.h"

#include <stdlib.h>

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

/* Grows a rectangle of equal quads from (x, y): first right, then down. */
static struct rectangle grow(const struct tiles *tiles, int x, int y)
{
	const int side = 1 << tiles->side_log2;
	const uint32_t *row = tiles->quad + y * side + x, quad = *row;
	struct rectangle r = {x, y, 1, 0};
	int equal;

	while (x + r.width < side && row[r.width] == quad) {
		r.width++;
	}
	do {
		r.height++;
		row += side;
		equal = 0;
		while (y + r.height < side && equal < r.width &&
			row[equal] == quad) {
			equal++;
		}
	} while (equal == r.width);
	return r;
}

static int area_of(const struct rectangle *r)
{
	return r->width * r->height;
}

/* The largest rectangle in row y of equal quads, of equal texels, but patches. */
static struct rectangle find_in_row(const struct tiles *tiles, int y)
{
	const int side = 1 << tiles->side_log2;
	struct rectangle largest = {0};

	for (int x = 0; x < side; x++) {
		const uint32_t quad = tiles->quad[(y << tiles->side_log2) + x];
		struct rectangle r;

		if (quad == (quad & 127) * 0x01010101u) {
			r = grow(tiles, x, y);
			/* the left end of equal quads stands for all */
			x += r.width - 1;
			largest = area_of(&r) > area_of(&largest) ? r : largest;
		}
	}
	return largest;
}

/* Sets the two coordinates of a patch, one way. */
static void set_range(uint32_t range[2], int from, int size, int side_log2)
{
	range[0] = ((uint32_t)from << (32 - side_log2)) - 1;
	range[1] = ((uint32_t)(from + size) << (32 - side_log2)) - 1;
}

static void make_patch(
	struct tiles *tiles, const struct rectangle *r, uint32_t number)
{
	for (int y = r->y; y < r->y + r->height; y++) {
		uint32_t *quad = &tiles->quad[y << tiles->side_log2];

		for (int x = r->x; x < r->x + r->width; x++) {
			quad[x] = QUAD_PATCH | number << 8 | (quad[x] & 127);
		}
	}
	set_range(tiles->patch[number].s, r->x, r->width, tiles->side_log2);
	set_range(tiles->patch[number].t, r->y, r->height, tiles->side_log2);
}

static bool overlap(const struct rectangle *a, const struct rectangle *b)
{
	return a->x < b->x + b->width && b->x < a->x + a->width &&
		a->y < b->y + b->height && b->y < a->y + a->height;
}

/*
 * Makes patches of the largest rectangles. One changes those of the rows that
 * it covers, and those that it overlaps.
 */
static void fill_patches(struct tiles *tiles)
{
	const int side = 1 << tiles->side_log2;
	struct rectangle row[TILE_SIDE_MAX];

	for (int y = 0; y < side; y++) {
		row[y] = find_in_row(tiles, y);
	}
	for (uint32_t number = 1; number <= PATCHES_MOST; number++) {
		struct rectangle largest = row[0];

		for (int y = 1; y < side; y++) {
			largest = area_of(&row[y]) > area_of(&largest) ? row[y]
								       : largest;
		}
		if (area_of(&largest) == 0) {
			return;
		}
		make_patch(tiles, &largest, number);
		for (int y = 0; y < largest.y + largest.height; y++) {
			if (y >= largest.y || overlap(&row[y], &largest)) {
				row[y] = find_in_row(tiles, y);
			}
		}
	}
}

static void fill_fine(struct tiles *tiles)
{
	const uint32_t side_log2 = (uint32_t)tiles->side_log2 + 2;

	for (uint32_t i = 0; i < 1u << 2 * side_log2; i++) {
		uint32_t x = i & ((1u << side_log2) - 1), y = i >> side_log2;
		uint32_t quad = tiles->quad[(y / 4 << tiles->side_log2) + x / 4];

		tiles->fine[i] = (uint8_t)(quad & QUAD_PATCH
				? FINE_PATCH
				: quad_mix(quad, x % 4 * 64 + 32,
					  y % 4 * 64 + 32));
	}
}

void soft_tiles_update(struct level *level)
{
	if (!level->tiles) {
		return;
	}
	fill_quads(level);
	fill_patches(level->tiles);
	if (level->tiles->fine) {
		fill_fine(level->tiles);
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
