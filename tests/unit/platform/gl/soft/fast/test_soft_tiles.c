/* Luminance textures in patches, and the rows that are drawn with them. */
#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/fast/tiles.h"
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/raster/pixel.h"
#include "tests/support/gl/twins.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	ROW = 700,
	MARGIN = 8, /* pixels before and behind that nothing may touch */
};

struct rows {
	uint32_t aligned;
	uint16_t expected[ROW + 2 * MARGIN], drawn[ROW + 2 * MARGIN];
};

/* Tiles with joints, here and there something else; or mere noise. */
static void make_level(uint32_t *seed, int width_log2, int height_log2,
	bool noise, struct level *level)
{
	int width = 1 << width_log2, height = 1 << height_log2;

	*level = (struct level){.format = TEXEL_L8,
		.width_log2 = width_log2,
		.height_log2 = height_log2};
	level->texels = malloc((size_t)(width * height));
	assert_non_null(level->texels);
	for (int i = 0; i < width * height; i++) {
		int x = i % width, y = i / width;
		bool joint = x % 8 == 0 || y % 8 == 0;
		bool other = noise || random_between(seed, 0, 60) == 0;

		level->texels[i] = other ? (uint8_t)next_random(seed)
			: joint          ? 0
			: (x ^ y) & 8    ? 255
					 : 233;
	}
	soft_tiles_make(level);
	assert_non_null(level->tiles);
}

static void free_level(struct level *level)
{
	free(level->texels);
	free(level->tiles);
}

static uint32_t quad_at(const struct level *level, uint32_t s, uint32_t t)
{
	uint32_t x = s >> 16 & ((1u << level->width_log2) - 1);
	uint32_t y = t >> 16 & ((1u << level->height_log2) - 1);

	return level->tiles->quad[(y << level->tiles->side_log2) + x];
}

static void test_quads_are_four_texels_in_127ths(void **state)
{
	static const uint8_t texels[] = {0, 255, 128, 64, 1, 2, 253, 254};
	struct level level = {.format = TEXEL_L8,
		.width_log2 = 2,
		.height_log2 = 1,
		.texels = (uint8_t *)texels};

	(void)state;
	soft_tiles_make(&level);
	assert_non_null(level.tiles);
	assert_int_equal(
		level.tiles->quad[0], 0u | 127u << 8 | 0u << 16 | 1u << 24);
	assert_int_equal(
		level.tiles->quad[7], 127u | 0u << 8 | 32u << 16 | 0u << 24);
	free(level.tiles);
}

static void test_a_patch_is_of_quads_that_are_the_same(void **state)
{
	uint32_t seed = 5;

	(void)state;
	for (int round = 0; round < 40; round++) {
		int log2 = random_between(&seed, 1, 6), patched = 0;
		uint32_t value[PATCHES_MOST + 1];
		struct level level;

		memset(value, 255, sizeof(value));
		make_level(&seed, log2, log2, round % 4 == 0, &level);
		for (int i = 0; i < 1 << 2 * log2; i++) {
			uint32_t quad = level.tiles->quad[i];
			uint32_t s = (uint32_t)(i & ((1 << log2) - 1))
				<< (32 - log2);
			uint32_t t = (uint32_t)(i >> log2) << (32 - log2);
			const struct patch *patch =
				&level.tiles->patch[quad_patch(quad)];

			if (!(quad & QUAD_PATCH)) {
				assert_int_equal(quad & 0x80808080u, 0);
				continue;
			}
			patched++;
			/* Before the first column is the last of all. */
			assert_true(
				s > patch->s[0] || patch->s[0] == UINT32_MAX);
			assert_true(
				t > patch->t[0] || patch->t[0] == UINT32_MAX);
			assert_true(s < patch->s[1] && t < patch->t[1]);
			if (value[quad_patch(quad)] == UINT32_MAX) {
				value[quad_patch(quad)] = quad_luminance(quad);
			}
			assert_int_equal(
				quad_luminance(quad), value[quad_patch(quad)]);
		}
		assert_true(log2 < 4 || round % 4 == 0 ||
			patched > (1 << 2 * log2) / 4);
		free_level(&level);
	}
}

static void test_even_textures_are_one_patch(void **state)
{
	static uint8_t texels[64 * 64];
	struct level level = {.format = TEXEL_L8,
		.width_log2 = 6,
		.height_log2 = 6,
		.texels = texels};

	(void)state;
	memset(texels, 77, sizeof(texels));
	soft_tiles_make(&level);
	assert_non_null(level.tiles);
	assert_int_equal(level.tiles->patch[1].s[0], UINT32_MAX);
	assert_int_equal(level.tiles->patch[1].s[1], UINT32_MAX);
	assert_int_equal(level.tiles->patch[1].t[1], UINT32_MAX);
	for (int i = 0; i < 64 * 64; i++) {
		assert_int_equal(
			level.tiles->quad[i], QUAD_PATCH | 1u << 8 | 38);
	}
	free(level.tiles);
}

static void test_what_is_too_small_or_large_has_none(void **state)
{
	static uint8_t texels[256 * 256];
	struct level narrow = {
		.format = TEXEL_L8, .height_log2 = 3, .texels = texels};
	struct level wide = {.format = TEXEL_L8,
		.width_log2 = 8,
		.height_log2 = 2,
		.texels = texels};
	struct level alpha = {.format = TEXEL_A8,
		.width_log2 = 3,
		.height_log2 = 3,
		.texels = texels};

	(void)state;
	soft_tiles_make(&narrow);
	soft_tiles_make(&wide);
	soft_tiles_make(&alpha);
	soft_tiles_update(&alpha);
	assert_null(narrow.tiles);
	assert_null(wide.tiles);
	assert_null(alpha.tiles);
}

/* By 2^32 over the step, never more pixels than there are. */
static void test_no_more_pixels_are_promised_than_fit(void **state)
{
	uint32_t seed = 9;

	(void)state;
	for (int round = 0; round < 20000; round++) {
		int log2 = random_between(&seed, 1, 7);
		int32_t step = (int32_t)any_word(&seed) >>
			random_between(&seed, 0, 31);
		uint32_t size = (uint32_t)(step < 0 ? -(int64_t)step : step)
			<< (16 - log2);
		uint32_t room = any_word(&seed) >> random_between(&seed, 0, 31);
		uint64_t promised =
			(uint64_t)room * soft_tile_pixels(step, log2) >> 32;

		assert_true(promised * size <= room);
		/* Nor many fewer. */
		if (size > 1 && size < 1 << 22) {
			assert_true(promised + 2 + room / size / 512 >=
				room / size);
		}
	}
}

static void make_rows(uint32_t *seed, struct rows *rows)
{
	for (int i = 0; i < ROW + 2 * MARGIN; i++) {
		rows->expected[i] = rows->drawn[i] = (uint16_t)next_random(seed);
	}
}

static void make_shades(uint32_t *seed, uint32_t shade[255])
{
	for (int i = 0; i < 255; i++) {
		shade[i] = twice_565(next_random(seed) & 0xFFFF);
	}
}

static void set_ends(struct tile_run *run, const struct level *level)
{
	run->s_end = &level->tiles->patch->s[run->s_right >= 0];
	run->t_end = &level->tiles->patch->t[run->t_right >= 0];
	run->s_pixels = soft_tile_pixels(run->s_right, run->side_log2);
	run->t_pixels = soft_tile_pixels(run->t_right, run->side_log2);
}

static struct tile_run random_run(
	uint32_t *seed, const struct level *level, const uint32_t *shade)
{
	struct tile_run run = {
		.count = random_between(seed, 1, random_between(seed, 1, ROW)),
		.quads = level->tiles->quad,
		.s = any_word(seed),
		.t = any_word(seed),
		.s_right =
			(int32_t)any_word(seed) >> random_between(seed, 0, 31),
		.t_right =
			(int32_t)any_word(seed) >> random_between(seed, 0, 31),
		.shade = shade,
		.side_log2 = level->tiles->side_log2,
		.fine = level->tiles->fine,
	};

	/* Also quite still, and along one axis. */
	run.s_right = random_between(seed, 0, 9) ? run.s_right : 0;
	run.t_right = random_between(seed, 0, 9) ? run.t_right : 0;
	set_ends(&run, level);
	return run;
}

/*
 * So many pixels a step, the mean in double of rows that are cut to 8 bits.
 */
static void draw_each(const struct tile_run *run, const struct level *level,
	bool fine, int each)
{
	uint32_t s = run->s, t = run->t;

	for (int i = 0; i < run->count; i++) {
		uint32_t quad = quad_at(level, s, t);
		/* The middle of the 16th of a quad that it is in. */
		uint32_t at_s = fine ? (s >> 14 & 3) * 64 + 32 : s >> 8 & 255;
		uint32_t at_t = fine ? (t >> 14 & 3) * 64 + 32 : t >> 8 & 255;
		double across = at_s / 256.0, down = at_t / 256.0;
		uint32_t v = quad & 127;
		double mean = v;

		if (!(quad & QUAD_PATCH)) {
			double above =
				v + across * ((quad >> 8 & 127) - (double)v);
			double left = quad >> 16 & 127;
			double below = left + across * ((quad >> 24) - left);

			mean = above + down * (below - above);
		}
		run->pixel[i] = (uint16_t)run->shade[(int)(mean * 2.0)];
		if (i % each == each - 1) {
			s += (uint32_t)run->s_right;
			t += (uint32_t)run->t_right;
		}
	}
}

static void check_rows(const struct rows *rows)
{
	assert_memory_equal(rows->drawn, rows->expected, sizeof(rows->drawn));
}

static void test_rows_are_pixel_by_pixel_what_bilinear_means(void **state)
{
	static struct rows rows;
	uint32_t seed = 3, shade[255];

	(void)state;
	make_shades(&seed, shade);
	for (int round = 0; round < 1500; round++) {
		struct level level;
		struct tile_run run;

		make_level(&seed, random_between(&seed, 1, 7),
			random_between(&seed, 1, 7), round % 5 == 0, &level);
		make_rows(&seed, &rows);
		run = random_run(&seed, &level, shade);
		run.pixel = rows.expected + MARGIN;
		draw_each(&run, &level, false, 1);
		run.pixel = rows.drawn + MARGIN;
		soft_tile_row_c(&run, 0);
		check_rows(&rows);
		for (int each = 1; each <= 2 && run.fine; each++) {
			run.pixel = rows.expected + MARGIN;
			draw_each(&run, &level, true, each);
			run.pixel = rows.drawn + MARGIN;
			soft_tile_row_c(&run, each);
			check_rows(&rows);
		}
		free_level(&level);
	}
}

static void test_rows_are_as_in_c(void **state)
{
	static struct rows rows;
	uint32_t seed = 4, shade[255];

	(void)state;
	twins_need_assembly();
	make_shades(&seed, shade);
	for (int round = 0; round < 3000; round++) {
		int log2 = random_between(&seed, 1, 7);
		int other = random_between(&seed, 1, log2);
		int at = random_between(&seed, MARGIN - 3, MARGIN);
		struct level level;
		struct tile_run run;

		make_level(&seed, round % 2 ? log2 : other,
			round % 2 ? other : log2, round % 5 == 0, &level);
		make_rows(&seed, &rows);
		run = random_run(&seed, &level, shade);
		run.pixel = rows.expected + at;
		soft_tile_row_c(&run, 0);
		run.pixel = rows.drawn + at;
		soft_tile_row(&run, 0);
		check_rows(&rows);
		run.s_right >>= 16 - log2;
		run.t_right >>= 16 - log2;
		set_ends(&run, &level);
		for (int each = 1; each <= 2 && run.fine; each++) {
			run.pixel = rows.expected + at;
			soft_tile_row_c(&run, each);
			run.pixel = rows.drawn + at;
			soft_tile_row(&run, each);
			check_rows(&rows);
		}
		free_level(&level);
	}
}

static void test_blends_are_mixed_pixel_by_pixel(void **state)
{
	static struct rows rows;
	uint16_t own[80];
	uint32_t seed = 6;

	(void)state;
	for (int round = 0; round < 4000; round++) {
		/* Words lie in one as they do in the other. */
		int odd = round % 2, count = random_between(&seed, 0, 70);
		uint32_t share = (uint32_t)random_between(&seed, 0, 32);

		make_rows(&seed, &rows);
		for (int i = 0; i < 80; i++) {
			own[i] = random_between(&seed, 0, 3)
				? (uint16_t)next_random(&seed)
				: 0xFFFF;
		}
		for (int i = 0; i < count; i++) {
			uint16_t *pixel = rows.expected + MARGIN + odd + i;

			*pixel = narrow(mix_wide(
				widen(*pixel), widen(own[odd + i]), share));
		}
		soft_mix_pixels(
			rows.drawn + MARGIN + odd, own + odd, count, share);
		check_rows(&rows);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_quads_are_four_texels_in_127ths),
		cmocka_unit_test(test_a_patch_is_of_quads_that_are_the_same),
		cmocka_unit_test(test_even_textures_are_one_patch),
		cmocka_unit_test(test_what_is_too_small_or_large_has_none),
		cmocka_unit_test(test_no_more_pixels_are_promised_than_fit),
		cmocka_unit_test(
			test_rows_are_pixel_by_pixel_what_bilinear_means),
		cmocka_unit_test(test_rows_are_as_in_c),
		cmocka_unit_test(test_blends_are_mixed_pixel_by_pixel),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
