/* Rows of coloured textures in assembly against the same in C. */
#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/fast/tint.h"
#include "tests/support/gl/twins.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

/* Depths of which half are those of the band that follows. */
static void make_equal(struct twins *twins, uint32_t *seed)
{
	for (int i = 0; i < TWINS_PIXELS; i++) {
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
		.down = {2 * TWINS_SIDE, any_word(seed), any_word(seed), 0, 0},
		.rows = random_between(seed, 1, TWINS_ROWS),
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

	twins_edges(seed, 4, 60, band.edge, band.edge_step);
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
		struct twins *twins = twins_make(&seed);
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
		twins_place(twins, 0, &band.row.depth, &band.pixels);
		twins_place(twins, 1, &other.row.depth, &other.pixels);
		rows(&band);
		rows_c(&other);
		assert_int_equal(band.rows, 0);
		assert_int_equal(band.row.z_q16, other.row.z_q16);
		assert_int_equal(band.row.texel, other.row.texel);
		assert_int_equal(band.row.red_blue, other.row.red_blue);
		assert_int_equal(band.row.green, other.row.green);
		assert_memory_equal(band.edge, other.edge, sizeof(band.edge));
		twins_check(twins);
	}
	free(texels);
}

static void test_rows_of_mixed_texels_are_as_in_c(void **state)
{
	(void)state;
	check_rows(soft_bands.tint_linear, soft_tint_linear_c,
		TINT_ROUND_LINEAR, false);
}

static void test_rows_of_nearest_texels_are_as_in_c(void **state)
{
	(void)state;
	check_rows(soft_bands.tint_nearest, soft_tint_nearest_c,
		TINT_ROUND_NEAREST, false);
}

static void test_rows_of_relief_are_as_in_c(void **state)
{
	(void)state;
	check_rows(
		soft_bands.tint_dot, soft_tint_dot_c, TINT_ROUND_LINEAR, false);
	check_rows(soft_bands.tint_multiply, soft_tint_multiply_c,
		TINT_ROUND_LINEAR, true);
	check_rows(
		soft_bands.tint_add, soft_tint_add_c, TINT_ROUND_LINEAR, true);
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
