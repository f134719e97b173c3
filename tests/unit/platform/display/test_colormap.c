/* The colour maps of framebuffers, entry by entry. */
#include "platform/base/compiler.h"
#include "platform/display/fbdev/colormap.h"
#include "tests/support/fake/fake_fb.h"
#include "tests/support/test.h"

#include <errno.h>
#include <string.h>

enum {
	FD = 0,
	OLD = 0x5A5A /* each entry of the device, at first */
};

/* Leaves a pattern where the functions called next have their variables. */
static NEVER_INLINE void fill_stack(void)
{
	volatile uint8_t used[16384];

	for (size_t i = 0; i < sizeof(used); i++) {
		used[i] = 0xA7;
	}
}

static bool set(struct colormap *map, uint32_t visual,
	const struct pixel_layout *layout)
{
	fake_fb_begin(8, 8, 8, 8, 32, *layout);
	fake_fb.fix.visual = visual;
	memset(fake_fb.colors, OLD & 0xFF, sizeof(fake_fb.colors));
	*map = (struct colormap){0};
	fill_stack();
	return colormap_set(map, &fake_fb_calls, FD, visual, layout);
}

static void expect_restored(const struct colormap *map)
{
	fill_stack();
	colormap_restore(map, &fake_fb_calls, FD);
	for (int i = 0; i < 3 * 256; i++) {
		assert_int_equal(fake_fb.colors[i / 256][i % 256], OLD);
	}
}

/* A colour of a table, of 0 to most, as 16 bits. */
static void expect_spread(uint16_t shown, int color, int most)
{
	assert_near(shown, 65535.0 * color / most, 1.0);
}

static void test_a_palettes_entries_have_the_colours_of_their_bits(void **state)
{
	const struct pixel_layout layout = colormap_palette_layout();
	struct colormap map;

	(void)state;
	assert_int_equal(layout.bits, 8);
	assert_true(set(&map, FB_VISUAL_PSEUDOCOLOR, &layout));
	for (int i = 0; i < 256; i++) {
		expect_spread(
			fake_fb.colors[0][i], i >> layout.red.offset & 7, 7);
		expect_spread(
			fake_fb.colors[1][i], i >> layout.green.offset & 7, 7);
		expect_spread(
			fake_fb.colors[2][i], i >> layout.blue.offset & 3, 3);
	}
	expect_restored(&map);
}

static const struct {
	struct pixel_layout layout;
	int entries;
} channels[] = {
	{{.bits = 16, .red = {11, 5}, .green = {5, 6}, .blue = {0, 5}}, 64},
	{{.bits = 16, .red = {10, 6}, .green = {5, 5}, .blue = {0, 5}}, 64},
	{{.bits = 16, .red = {11, 5}, .green = {6, 5}, .blue = {0, 6}}, 64},
	{{.bits = 15, .red = {10, 5}, .green = {5, 5}, .blue = {0, 5}}, 32},
	{{.bits = 32, .red = {16, 8}, .green = {8, 8}, .blue = {0, 8}}, 256},
	{{.bits = 8, .red = {5, 3}, .green = {2, 3}, .blue = {0, 2}}, 8},
	{{.bits = 3, .red = {2, 1}, .green = {1, 1}, .blue = {0, 1}}, 2},
};

/* All have as many entries as the longest, and end with their last colour. */
static void test_the_tables_of_channels_are_linear(void **state)
{
	struct colormap map;

	(void)state;
	for (size_t c = 0; c < ARRAY_COUNT(channels); c++) {
		const struct pixel_layout *layout = &channels[c].layout;
		const int most[3] = {(1 << layout->red.length) - 1,
			(1 << layout->green.length) - 1,
			(1 << layout->blue.length) - 1};

		assert_true(set(&map, FB_VISUAL_DIRECTCOLOR, layout));
		for (int k = 0; k < 3 * 256; k++) {
			int entry = k / 3, last = most[k % 3];
			uint16_t shown = fake_fb.colors[k % 3][entry];

			if (entry < channels[c].entries) {
				expect_spread(shown,
					entry < last ? entry : last, last);
			} else {
				assert_int_equal(shown, OLD);
			}
		}
		expect_restored(&map);
	}
}

static void test_screens_of_fixed_colours_keep_their_map(void **state)
{
	struct colormap map;

	(void)state;
	assert_true(set(&map, FB_VISUAL_TRUECOLOR, &channels[0].layout));
	assert_false(map.changed);
	expect_restored(&map);
	assert_false(set(&map, FB_VISUAL_MONO01, &channels[0].layout));
	expect_restored(&map);
}

/* Linux has tables of 256 entries. */
static void test_a_channel_of_more_than_8_bits_has_no_table(void **state)
{
	const struct pixel_layout layout = {
		.bits = 32, .red = {20, 10}, .green = {10, 10}, .blue = {0, 9}};
	struct colormap map;

	(void)state;
	assert_false(set(&map, FB_VISUAL_DIRECTCOLOR, &layout));
	expect_restored(&map);
}

/* Where the former map is unknown, there is nothing to restore. */
static void test_a_map_that_could_not_be_read_is_not_restored(void **state)
{
	const struct pixel_layout layout = colormap_palette_layout();
	struct colormap map;

	(void)state;
	assert_true(set(&map, FB_VISUAL_PSEUDOCOLOR, &layout));
	map = (struct colormap){0};
	fake_fb.fail_request = FBIOGETCMAP;
	fake_fb.fail_error = EINVAL;
	assert_true(colormap_set(
		&map, &fake_fb_calls, FD, FB_VISUAL_PSEUDOCOLOR, &layout));
	assert_false(map.changed);
	colormap_restore(&map, &fake_fb_calls, FD);
	assert_int_equal(fake_fb.colors[0][255], 0xFFFF);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_palettes_entries_have_the_colours_of_their_bits),
		cmocka_unit_test(test_the_tables_of_channels_are_linear),
		cmocka_unit_test(test_screens_of_fixed_colours_keep_their_map),
		cmocka_unit_test(test_a_channel_of_more_than_8_bits_has_no_table),
		cmocka_unit_test(
			test_a_map_that_could_not_be_read_is_not_restored),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
