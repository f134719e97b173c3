/* What dark surfaces mirror of their surroundings. */
#include "app/model/color.h"
#include "app/model/model.h"
#include "tests/support/test.h"

#include <math.h>

/* glTF 2.0, appendix B.2: 4% of the light, which is 0.22 in sRGB. */
static void test_black_mirrors_4_percent_and_bright_colours_nothing(void **state)
{
	(void)state;
	assert_near(color_mirrored(0.0f), 0.22, 1e-6);
	assert_near(color_mirrored(0.0f), color_encode_srgb(0.04f), 0.002);
	assert_near(color_mirrored(0.33f), 0.22 / 4, 1e-6);
	assert_near(color_mirrored(0.66f), 0.0, 1e-6);
	assert_near(color_mirrored(1.0f), 0.0, 1e-6);
}

static void test_a_darker_gray_stays_darker(void **state)
{
	(void)state;
	for (int i = 1; i <= 255; i++) {
		uint8_t darker[3], gray[3];

		for (int k = 0; k < 3; k++) {
			darker[k] = (uint8_t)(i - 1);
			gray[k] = (uint8_t)i;
		}
		color_mirror(darker);
		color_mirror(gray);
		assert_true(darker[0] <= gray[0]);
		assert_true(gray[0] - i <= 56 && gray[0] >= i);
		assert_true(i < 155 || gray[0] == i);
		assert_near(gray[0] - i,
			255 * color_mirrored((float)i / 255.0f), 0.5001);
	}
}

static void test_a_picture_mirrors_as_its_colours_do(void **state)
{
	uint8_t picture[256][4], alone[4];

	(void)state;
	for (int i = 0; i < 256; i++) {
		for (int k = 0; k < 4; k++) {
			picture[i][k] = (uint8_t)(k == i % 3 ? i : i / 2);
		}
	}
	color_mirror_all(picture, 255);
	for (int i = 0; i < 256; i++) {
		for (int k = 0; k < 4; k++) {
			alone[k] = (uint8_t)(k == i % 3 ? i : i / 2);
		}
		if (i < 255) {
			color_mirror(alone);
		}
		assert_memory_equal(picture[i], alone, 4);
	}
}

static void test_the_brightest_channel_says_what_all_get(void **state)
{
	uint8_t colors[4][3] = {
		{40, 0, 10}, {0, 40, 10}, {10, 0, 40}, {0, 0, 170}};

	(void)state;
	for (int i = 0; i < 3; i++) {
		color_mirror(colors[i]);
	}
	color_mirror(colors[3]);
	assert_memory_equal(colors[0], ((uint8_t[3]){73, 33, 43}), 3);
	assert_memory_equal(colors[1], ((uint8_t[3]){33, 73, 43}), 3);
	assert_memory_equal(colors[2], ((uint8_t[3]){43, 33, 73}), 3);
	assert_memory_equal(colors[3], ((uint8_t[3]){0, 0, 170}), 3);
}

static void test_lit_materials_mirror_but_those_that_shine_do_not(void **state)
{
	struct model_material m = model_plain_material;
	float shown[3];

	(void)state;
	model_material_shown(&m, shown);
	assert_all_near(shown, ((float[3]){1, 1, 1}), 3, 1e-6);
	m.base_color[0] = m.base_color[1] = 0.0f;
	m.base_color[2] = 0.2140411f / 4; /* encoded: 0.257 */
	model_material_shown(&m, shown);
	assert_near(
		shown[0], 0.22 * (1 - 0.257 / 0.66) * (1 - 0.257 / 0.66), 1e-3);
	assert_near(shown[2] - shown[0], 0.257, 1e-3);
	m.emissive[1] = 0.5f;
	model_material_shown(&m, shown);
	assert_near(shown[0], 0.0, 1e-6);
	m.emissive_texture = 0; /* shines in parts */
	model_material_shown(&m, shown);
	assert_true(shown[0] > 0.05f);
	m.unlit = true;
	model_material_shown(&m, shown);
	assert_near(shown[0], 0.0, 1e-6);
	assert_near(shown[2], 0.257, 1e-3);
}

/* Half a step is rounded up. */
static void test_bytes_are_rounded_and_clamped(void **state)
{
	(void)state;
	for (int i = 0; i < 256; i++) {
		assert_int_equal(color_to_byte((float)i / 255.0f), i);
		assert_int_equal(color_to_byte(((float)i + 0.49f) / 255.0f), i);
		assert_int_equal(color_to_byte(((float)i - 0.49f) / 255.0f), i);
	}
	assert_int_equal(color_to_byte(-3.0f), 0);
	assert_int_equal(color_to_byte(3.0f), 255);
	assert_int_equal(color_to_byte(NAN), 0);
}

/* The curve of IEC 61966-2-1: a line at first, then a power. */
static void test_the_curve_is_that_of_srgb(void **state)
{
	static const float pairs[][2] = {{0, 0}, {0.001f, 0.01292f},
		{0.0031308f, 0.04045f}, {0.2140411f, 0.5f}, {0.5f, 0.7353569f},
		{1, 1}};

	(void)state;
	for (size_t i = 0; i < sizeof(pairs) / sizeof(pairs[0]); i++) {
		assert_near(color_encode_srgb(pairs[i][0]), pairs[i][1], 1e-6);
		assert_near(color_decode_srgb(pairs[i][1]), pairs[i][0], 1e-6);
	}
	assert_near(color_encode_srgb(-1), 0, 0);
	assert_near(color_encode_srgb(2), 1, 1e-6);
	assert_near(color_decode_srgb(-1), 0, 0);
	assert_near(color_decode_srgb(2), 1, 1e-6);
}

/* More colours than the cache has room for, and each of them again. */
static void test_a_cache_gives_the_bytes_of_the_curve(void **state)
{
	struct color_bytes known = {{0}, {0}};

	(void)state;
	for (int i = -1; i < 1200; i++) {
		float linear = (float)(i * 7 % 1000) / 999.0f;

		for (int again = 0; again < 2; again++) {
			assert_int_equal(color_encode_byte(&known, linear),
				color_to_byte(color_encode_srgb(linear)));
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_black_mirrors_4_percent_and_bright_colours_nothing),
		cmocka_unit_test(test_bytes_are_rounded_and_clamped),
		cmocka_unit_test(test_the_curve_is_that_of_srgb),
		cmocka_unit_test(test_a_cache_gives_the_bytes_of_the_curve),
		cmocka_unit_test(test_a_darker_gray_stays_darker),
		cmocka_unit_test(test_a_picture_mirrors_as_its_colours_do),
		cmocka_unit_test(test_the_brightest_channel_says_what_all_get),
		cmocka_unit_test(
			test_lit_materials_mirror_but_those_that_shine_do_not),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
