/* The soft driver's rows in assembly against the same in C. */
#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/raster/pixel.h"
#include "tests/support/gl/twins.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <string.h>

/* Between column 4 and 60 or, of gray, as many pixels as a row may have. */
static void make_edges(
	uint32_t *seed, int end, uint32_t edge[2], uint32_t step[2])
{
	twins_edges(seed, 4, end, edge, step);
}

/* Lets a third of the depths be equal to the band's, and others one beside. */
static void place_band(
	struct twins *twins, bool equal, struct band *band, struct band *other)
{
	if (equal) {
		band->z_right = band->down.z_q16 = 0;
		band->row.z_q16 |= 1 << 30;
		for (int i = 0; i < 2 * TWINS_PIXELS; i++) {
			twins->depth[i / TWINS_PIXELS][i % TWINS_PIXELS] =
				(uint16_t)((band->row.z_q16 >> 16) +
					(uint32_t)(i % TWINS_PIXELS % 3) - 1);
		}
	}
	*other = *band;
	twins_place(twins, 0, &band->row.depth, &band->pixels);
	twins_place(twins, 1, &other->row.depth, &other->pixels);
}

static void test_the_texture_band_is_as_in_c(void **state)
{
	uint8_t texels[2 * 64 * 32];
	uint32_t seed = 2;

	(void)state;
	twins_need_assembly();
	for (size_t i = 0; i < sizeof(texels); i++) {
		texels[i] = (uint8_t)next_random(&seed);
	}
	for (int round = 0; round < 500; round++) {
		struct twins *twins = twins_make(&seed);
		struct band band = {
			.row = {0, any_word(&seed), any_word(&seed),
				next_random(&seed) << 6},
			.down = {2 * TWINS_SIDE, any_word(&seed),
				any_word(&seed), 0},
			.z_right = any_word(&seed) >> 6,
			.texel_right = any_word(&seed),
			.texels = texels,
			.texel_mask = 31u << 24 | 63u << 8,
			.texel_shift = 24 - 6,
			.stride_bytes = WIDE_MASK,
			.more.green = WIDE_ROUND,
			.red_blue_right = next_random(&seed) & 0xFFFFF,
			.edges.rows = random_between(&seed, 1, TWINS_ROWS),
		};
		struct band other;

		make_edges(&seed, 4 + BAND_GRAY_PIXELS, band.edges.at,
			band.edges.step);
		place_band(twins, round % 2, &band, &other);
		(round % 4 == 1 ? soft_band_gray_equal : soft_band_gray)(&band);
		soft_band_gray_c(&other, round % 4 == 1);
		assert_int_equal(band.row.texel, other.row.texel);
		assert_int_equal(band.edges.at[0], other.edges.at[0]);
		assert_int_equal(band.edges.at[1], other.edges.at[1]);
		twins_check(twins);
	}
}

/* Of 64 x 32 texels; green does not run into the count above it. */
static void test_the_tinted_band_is_as_in_c(void **state)
{
	uint8_t texels[2 * (64 * 33 + 1)];
	uint32_t seed = 3;

	(void)state;
	twins_need_assembly();
	for (size_t i = 0; i < sizeof(texels); i++) {
		texels[i] = (uint8_t)next_random(&seed);
	}
	for (int round = 0; round < 500; round++) {
		struct twins *twins = twins_make(&seed);
		struct band band = {
			.row = {0, any_word(&seed), any_word(&seed),
				any_word(&seed) & 0x7FFF7FFF,
				any_word(&seed) & 0x3FFF},
			.down = {2 * TWINS_SIDE, any_word(&seed),
				any_word(&seed), any_word(&seed) & 0x7F007F,
				any_word(&seed) & 0x7F},
			.z_right = any_word(&seed) >> 6,
			.texel_right =
				any_word(&seed) >> random_between(&seed, 0, 20),
			.red_blue_right = any_word(&seed) & 0xFF00FF,
			.green_right = (any_word(&seed) & 0xFF) - 0x10000,
			.texels = texels,
			.texel_mask = 31u << 24 | 63u << 8,
			.texel_shift = 24 - 6,
			.stride_bytes = 2 * 64,
			.more = {next_random(&seed) & 0x7FFFFF,
				next_random(&seed) & 0x3FFFFF,
				next_random(&seed) & 0x3FFFFF},
			.edges.rows = random_between(&seed, 1, TWINS_ROWS),
		};
		struct band other;

		make_edges(&seed, 60, band.edges.at, band.edges.step);
		place_band(twins, round % 2, &band, &other);
		(round % 4 == 1 ? soft_band_tint_equal : soft_band_tint)(&band);
		soft_band_tint_c(&other, round % 4 == 1);
		assert_int_equal(band.row.texel, other.row.texel);
		assert_int_equal(band.row.green, other.row.green);
		assert_int_equal(band.edges.at[0], other.edges.at[0]);
		assert_int_equal(band.edges.at[1], other.edges.at[1]);
		assert_int_equal(band.edges.rows, 0);
		twins_check(twins);
	}
}

static void test_fills_end_where_they_should(void **state)
{
	(void)state;
	for (int count = 0; count < 200; count++) {
		for (int at = 4; at < 8; at++) {
			uint16_t row[220];

			memset(row, 0xA5, sizeof(row));
			soft_fill_pixels(row + at, count, 0x1234);
			for (int i = 0; i < 220; i++) {
				bool in = i >= at && i < at + count;

				assert_int_equal(row[i], in ? 0x1234 : 0xA5A5);
			}
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_texture_band_is_as_in_c),
		cmocka_unit_test(test_the_tinted_band_is_as_in_c),
		cmocka_unit_test(test_fills_end_where_they_should),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
