/* The soft driver's rows in assembly against the same in C. */
#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/raster/pixel.h"
#include "tests/support/gl/twins.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <string.h>

/* Between columns 4 and 60. */
static void make_edges(uint32_t *seed, uint32_t edge[2], uint32_t step[2])
{
	twins_edges(seed, 4, 60, edge, step);
}

static void test_the_color_band_is_as_in_c(void **state)
{
	uint32_t seed = 1;

	(void)state;
	for (int round = 0; round < 500; round++) {
		struct twins *twins = twins_make(&seed);
		struct band band = {
			.row = {0, any_word(&seed), any_word(&seed),
				any_word(&seed)},
			.down = {2 * TWINS_SIDE, any_word(&seed),
				any_word(&seed), any_word(&seed)},
			.z_right = any_word(&seed) >> 6,
			.packed_right = any_word(&seed),
			.red_blue_right = any_word(&seed),
			.green_right = any_word(&seed),
			.wide_mask = WIDE_MASK,
			.rows = random_between(&seed, 1, TWINS_ROWS),
			.from = 0,
			.to = TWINS_SIDE,
		};
		struct band other;

		make_edges(&seed, band.edge, band.edge_step);
		other = band;
		twins_place(twins, 0, &band.row.depth, &band.pixels);
		twins_place(twins, 1, &other.row.depth, &other.pixels);
		soft_bands.color(&band);
		soft_band_color_c(&other);
		assert_int_equal(band.row.z_q16, other.row.z_q16);
		assert_int_equal(band.row.green_q26, other.row.green_q26);
		assert_int_equal(band.edge[0], other.edge[0]);
		assert_int_equal(band.edge[1], other.edge[1]);
		twins_check(twins);
	}
}

static void test_the_texture_band_is_as_in_c(void **state)
{
	uint8_t texels[2 * 64 * 32];
	uint32_t seed = 2;

	(void)state;
	for (size_t i = 0; i < sizeof(texels); i++) {
		texels[i] = (uint8_t)next_random(&seed);
	}
	for (int round = 0; round < 500; round++) {
		struct twins *twins = twins_make(&seed);
		struct texture_band band = {
			.row = {0, any_word(&seed), any_word(&seed),
				next_random(&seed) << 6},
			.down = {2 * TWINS_SIDE, any_word(&seed),
				any_word(&seed), 0},
			.z_right = any_word(&seed) >> 6,
			.texel_right = any_word(&seed),
			.texels = texels,
			.texel_mask = 31u << 24 | 63u << 8,
			.texel_shift = 24 - 6,
			.wide_mask = WIDE_MASK,
			.wide_round = WIDE_ROUND,
			.share_right = next_random(&seed) & 0xFFFFF,
			.rows = random_between(&seed, 1, TWINS_ROWS),
		};
		struct texture_band other;

		make_edges(&seed, band.edge, band.edge_step);
		other = band;
		twins_place(twins, 0, &band.row.depth, &band.pixels);
		twins_place(twins, 1, &other.row.depth, &other.pixels);
		soft_bands.texture(&band);
		soft_band_texture_c(&other);
		assert_int_equal(band.row.texel, other.row.texel);
		assert_int_equal(band.edge[0], other.edge[0]);
		assert_int_equal(band.edge[1], other.edge[1]);
		twins_check(twins);
	}
}

static struct flat_band make_flat_band(
	struct twins *twins, int which, const struct flat_band *like)
{
	struct flat_band band = *like;

	band.pixels = (uint8_t *)(twins->pixel[which] + TWINS_ROW * TWINS_SIDE);
	band.stencil = like->stencil
		? (uint8_t *)twins->depth[which] + TWINS_ROW * TWINS_SIDE
		: NULL;
	return band;
}

static void test_the_flat_band_is_as_in_c(void **state)
{
	uint32_t seed = 4;

	(void)state;
	for (int round = 0; round < 500; round++) {
		struct twins *twins = twins_make(&seed);
		struct flat_band like = {
			.stencil = round % 3 ? (uint8_t *)twins : NULL,
			.stride_bytes = 2 * TWINS_SIDE,
			.stencil_stride = TWINS_SIDE,
			.rows = random_between(&seed, 1, TWINS_ROWS),
			.from = random_between(&seed, 0, 40),
			.to = random_between(&seed, 30, TWINS_SIDE),
			.reference = (uint8_t)random_between(&seed, 0, 3),
			.next = (uint8_t)random_between(&seed, 0, 255),
			.keep = (uint32_t)random_between(&seed, 0, 32),
			.opaque = (uint16_t)next_random(&seed),
		};
		struct flat_band band, other;

		/* Half of the stencil has the reference. */
		for (int i = 0; i < TWINS_PIXELS; i++) {
			if (next_random(&seed) & 1) {
				memset((uint8_t *)twins->depth[0] + i,
					like.reference, 1);
			}
		}
		memcpy(twins->depth[1], twins->depth[0],
			sizeof(twins->depth[0]));
		like.own = widen(like.opaque) * (32 - like.keep) + WIDE_ROUND;
		make_edges(&seed, like.edge, like.edge_step);
		band = make_flat_band(twins, 0, &like);
		other = make_flat_band(twins, 1, &like);
		soft_bands.flat(&band);
		soft_band_flat_c(&other);
		assert_int_equal(band.edge[0], other.edge[0]);
		assert_int_equal(band.edge[1], other.edge[1]);
		assert_int_equal(band.pixels - (uint8_t *)twins->pixel[0],
			other.pixels - (uint8_t *)twins->pixel[1]);
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
			soft_bands.fill(row + at, count, 0x1234);
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
		cmocka_unit_test(test_the_color_band_is_as_in_c),
		cmocka_unit_test(test_the_texture_band_is_as_in_c),
		cmocka_unit_test(test_the_flat_band_is_as_in_c),
		cmocka_unit_test(test_fills_end_where_they_should),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
