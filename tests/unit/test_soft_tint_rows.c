/* Rows of coloured textures in assembly against the same in C. */
#include "platform/gl/soft/band.h"
#include "platform/gl/soft/tint.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	SIDE = 64, /* of what the rows are drawn in */
};

/* Two sets of buffers that begin alike. */
struct twins {
	uint16_t pixel[2][SIDE * SIDE], depth[2][SIDE * SIDE];
};

static struct twins *make_twins(uint32_t *seed)
{
	struct twins *twins = calloc(1, sizeof(*twins));

	assert_non_null(twins);
	for (int i = 0; i < SIDE * SIDE; i++) {
		twins->depth[0][i] = (uint16_t)next_random(seed);
		twins->pixel[0][i] = (uint16_t)next_random(seed);
	}
	memcpy(twins->depth[1], twins->depth[0], sizeof(twins->depth[0]));
	memcpy(twins->pixel[1], twins->pixel[0], sizeof(twins->pixel[0]));
	return twins;
}

static void place(struct tint_band *band, struct twins *twins, int which)
{
	band->row.depth = (uintptr_t)(twins->depth[which] + 20 * SIDE);
	band->pixels = (uintptr_t)twins->pixel[which] -
		(uintptr_t)twins->depth[which] - 2;
}

/* Depths of which half are those of the band that follows. */
static void make_equal(struct twins *twins, uint32_t *seed)
{
	for (int i = 0; i < SIDE * SIDE; i++) {
		twins->depth[0][i] =
			(uint16_t)(0x4000 | (next_random(seed) & 1));
	}
	memcpy(twins->depth[1], twins->depth[0], sizeof(twins->depth[0]));
}

/* Up to 20 rows of up to 56 pixels; colours end between 0 and 1. */
static struct tint_band make_band(
	uint32_t *seed, const uint8_t *texels, int width_log2, int height_log2)
{
	struct tint_band band = {
		.row = {0, any_word(seed), any_word(seed), 0x40004000, 0x4000},
		.down = {2 * SIDE, any_word(seed), any_word(seed), 0, 0},
		.rows = random_between(seed, 1, 20),
		.z_right = any_word(seed) >> 6,
		.texel_right = any_word(seed),
		.texels = texels,
		.texel_mask = ((1u << height_log2) - 1) << 24 |
			((1u << width_log2) - 1) << 8,
		.texel_shift = (uint32_t)(24 - width_log2),
		.stride_bytes = 2u << width_log2,
		.next = TINT_NEXT,
		.red_blue_mask = TINT_RED_BLUE,
		.green_mask = TINT_GREEN,
	};

	for (int side = 0; side < 2; side++) {
		int from = random_between(seed, 4, 60);
		int to = random_between(seed, 4, 60);

		band.edge[side] = (uint32_t)(from * 65536 + 0x7FFF);
		band.edge_step[side] = (uint32_t)((to - from) * 65536 / 20);
	}
	band.red_blue_right = (uint32_t)random_between(seed, -200, 200) << 16;
	band.red_blue_right += (uint32_t)random_between(seed, -200, 200);
	band.green_right = (uint32_t)random_between(seed, -200, 200) - 0x10000;
	band.down.red_blue = (uint32_t)random_between(seed, -200, 200) << 16;
	band.down.red_blue += (uint32_t)random_between(seed, -200, 200);
	band.down.green = (uint32_t)random_between(seed, -200, 200);
	return band;
}

static void check_rows(void (*rows)(struct tint_band *band),
	void (*rows_c)(struct tint_band *band), uint32_t round, bool equal)
{
	uint8_t *texels = malloc(2 * 256 * 256);
	uint32_t seed = 5;

	assert_non_null(texels);
	for (int i = 0; i < 2 * 256 * 256; i++) {
		texels[i] = (uint8_t)next_random(&seed);
	}
	for (int i = 0; i < 1000; i++) {
		struct twins *twins = make_twins(&seed);
		struct tint_band band = make_band(
			&seed, texels, i % 9, random_between(&seed, 0, 8));
		struct tint_band other;

		band.round = round;
		if (equal) {
			make_equal(twins, &seed);
			band.row.z_q16 = 0x40000000 | (any_word(&seed) >> 15);
			band.z_right = 0;
			band.down.z_q16 = 0;
		}
		other = band;
		place(&band, twins, 0);
		place(&other, twins, 1);
		rows(&band);
		rows_c(&other);
		assert_int_equal(band.rows, 0);
		assert_int_equal(band.row.z_q16, other.row.z_q16);
		assert_int_equal(band.row.texel, other.row.texel);
		assert_int_equal(band.row.red_blue, other.row.red_blue);
		assert_int_equal(band.row.green, other.row.green);
		assert_memory_equal(band.edge, other.edge, sizeof(band.edge));
		assert_memory_equal(twins->depth[0], twins->depth[1],
			sizeof(twins->depth[0]));
		assert_memory_equal(twins->pixel[0], twins->pixel[1],
			sizeof(twins->pixel[0]));
		free(twins);
	}
	free(texels);
}

static void test_rows_of_mixed_texels_are_as_in_c(void **state)
{
	(void)state;
	check_rows(soft_bands.tint_linear, tint_linear_c, TINT_ROUND_LINEAR,
		false);
}

static void test_rows_of_nearest_texels_are_as_in_c(void **state)
{
	(void)state;
	check_rows(soft_bands.tint_nearest, tint_nearest_c, TINT_ROUND_NEAREST,
		false);
}

static void test_rows_of_relief_are_as_in_c(void **state)
{
	(void)state;
	check_rows(soft_bands.tint_dot, tint_dot_c, TINT_ROUND_LINEAR, false);
	check_rows(soft_bands.tint_multiply, tint_multiply_c, TINT_ROUND_LINEAR,
		true);
	check_rows(soft_bands.tint_add, tint_add_c, TINT_ROUND_LINEAR, true);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_rows_of_mixed_texels_are_as_in_c),
		cmocka_unit_test(test_rows_of_nearest_texels_are_as_in_c),
		cmocka_unit_test(test_rows_of_relief_are_as_in_c),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
