/* image_halve.h: means of four pixels, rounded, at each width. */
#include "app/model/image/image_halve.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	WIDEST = 7
};

/* The channel of a pixel that the mean is taken from. */
static int sum_of(
	uint8_t (*above)[4], uint8_t (*below)[4], int width, int x, int channel)
{
	int right = x + 1 < width ? x + 1 : x;

	return above[x][channel] + above[right][channel] + below[x][channel] +
		below[right][channel];
}

static void expect_means(uint8_t (*above)[4], uint8_t (*below)[4], int width)
{
	uint8_t out[WIDEST][4];

	memset(out, 0xa5, sizeof(out));
	image_halve_rows((const uint8_t(*)[4])above, (const uint8_t(*)[4])below,
		width, out);
	for (int x = 0; x < (width + 1) / 2; x++) {
		for (int c = 0; c < 4; c++) {
			assert_int_equal(out[x][c],
				(sum_of(above, below, width, 2 * x, c) + 2) / 4);
		}
	}
	for (int x = (width + 1) / 2; x < WIDEST; x++) {
		assert_int_equal(out[x][0], 0xa5);
	}
}

/* Sums of each remainder of four, and the largest: no channel spills over. */
static void test_each_channel_is_a_rounded_mean(void **state)
{
	(void)state;
	for (int i = 0; i < 1024; i++) {
		uint8_t above[WIDEST][4], below[WIDEST][4];

		for (int x = 0; x < WIDEST; x++) {
			for (int c = 0; c < 4; c++) {
				int level = (i * (c + 1) + 37 * x) % 258;

				above[x][c] =
					(uint8_t)(level > 255 ? 255 : level);
				below[x][c] = (uint8_t)(i * 7 >> c);
			}
		}
		expect_means(above, below, 1 + i % WIDEST);
	}
}

static void test_white_stays_white_and_black_black(void **state)
{
	(void)state;
	for (int width = 1; width <= WIDEST; width++) {
		uint8_t row[WIDEST][4];

		memset(row, 255, sizeof(row));
		expect_means(row, row, width);
		memset(row, 0, sizeof(row));
		expect_means(row, row, width);
	}
}

/* An image is halved in its own memory. */
static void test_out_may_be_the_row_above(void **state)
{
	uint8_t above[4][4] = {
		{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}, {12, 13, 14, 15}};
	uint8_t below[4][4] = {{16, 16, 16, 16}, {16, 16, 16, 16},
		{16, 16, 16, 16}, {20, 20, 20, 20}};
	static const uint8_t wanted[2][4] = {{9, 10, 10, 11}, {14, 15, 15, 16}};

	(void)state;
	image_halve_rows((const uint8_t(*)[4])above, (const uint8_t(*)[4])below,
		4, above);
	assert_memory_equal(above, wanted, sizeof(wanted));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_channel_is_a_rounded_mean),
		cmocka_unit_test(test_white_stays_white_and_black_black),
		cmocka_unit_test(test_out_may_be_the_row_above),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
