#include "app/scene/hud/font.h"
#include "tests/support/test.h"

#include <string.h>

static const struct font *font = &font_default;

static const struct font_glyph *glyph_of(int face, uint32_t code)
{
	return &font->face[face].glyph[font_find_glyph(font, code)];
}

static int alpha_at(int s, int t)
{
	return font->alpha[t * font->width + s];
}

static bool has_ink(const struct font_glyph *glyph)
{
	for (int i = 0; i < glyph->width * glyph->height; i++) {
		if (alpha_at(glyph->s + i % glyph->width,
			    glyph->t + i / glyph->width) > 128) {
			return true;
		}
	}
	return false;
}

static void test_every_printable_ascii_character_has_a_picture(void **state)
{
	(void)state;
	for (int face = 0; face < font->face_count; face++) {
		assert_true(has_ink(&font->face[face].glyph[FONT_UNKNOWN]));
		for (uint32_t code = '!'; code <= '~'; code++) {
			assert_int_not_equal(
				font_find_glyph(font, code), FONT_UNKNOWN);
			assert_true(has_ink(glyph_of(face, code)));
		}
	}
}

static void test_signs_of_units_and_keys_are_there(void **state)
{
	/* degree, middle dot, times, en dash, ellipsis, arrows, minus */
	static const uint32_t signs[] = {0xB0, 0xB7, 0xD7, 0x2013, 0x2026,
		0x2190, 0x2191, 0x2192, 0x2193, 0x21B5, 0x2212};

	(void)state;
	/* Latin-1, but for the blank and the soft hyphen, which show nothing. */
	for (uint32_t code = 0xA1; code <= 0xFF; code++) {
		assert_int_not_equal(font_find_glyph(font, code), FONT_UNKNOWN);
		assert_true(code == 0xAD || has_ink(glyph_of(0, code)));
	}
	for (size_t i = 0; i < sizeof(signs) / sizeof(signs[0]); i++) {
		assert_int_not_equal(
			font_find_glyph(font, signs[i]), FONT_UNKNOWN);
		assert_true(has_ink(glyph_of(0, signs[i])));
	}
}

static void test_missing_characters_are_the_box(void **state)
{
	(void)state;
	assert_int_equal(font_find_glyph(font, 0), FONT_UNKNOWN);
	assert_int_equal(font_find_glyph(font, 0x1F), FONT_UNKNOWN);
	assert_int_equal(font_find_glyph(font, 0x4E00), FONT_UNKNOWN);
	assert_int_equal(font_find_glyph(font, 0xFFFD), FONT_UNKNOWN);
	assert_int_equal(font_find_glyph(font, 0xFFFFFFFF), FONT_UNKNOWN);
}

static void test_every_code_finds_its_own_glyph(void **state)
{
	(void)state;
	assert_true(font->glyph_count > 96);
	for (int i = 1; i < font->glyph_count; i++) {
		assert_true(font->code[i] > font->code[i - 1]);
		assert_int_equal(font_find_glyph(font, font->code[i]), i);
	}
}

static void test_sizes_ascend_and_metrics_suit_them(void **state)
{
	(void)state;
	assert_true(font->face_count >= 1);
	for (int i = 0; i < font->face_count; i++) {
		const struct font_face *face = &font->face[i];

		assert_true(i == 0 || face->size > face[-1].size);
		assert_in_range(face->cap_height, face->size / 2, face->size);
		assert_in_range(face->ascent, face->cap_height, face->size);
		assert_in_range(
			face->line_height, face->size, face->size * 3 / 2);
	}
}

static void test_letters_stand_on_the_baseline_within_their_line(void **state)
{
	(void)state;
	for (int i = 0; i < font->face_count; i++) {
		const struct font_face *face = &font->face[i];
		const struct font_glyph *capital = glyph_of(i, 'H');
		const struct font_glyph *deep = glyph_of(i, 'p');

		assert_int_equal(capital->top, face->cap_height);
		assert_int_equal(capital->height, capital->top);
		assert_true(deep->height > deep->top);
		for (uint32_t code = ' '; code <= '~'; code++) {
			const struct font_glyph *glyph = glyph_of(i, code);

			assert_in_range(glyph->advance, 1, face->size * 3 / 2);
			assert_true(glyph->top <= face->ascent + 1);
			assert_true(glyph->height - glyph->top <=
				face->line_height - face->ascent + 1);
		}
		assert_int_equal(glyph_of(i, ' ')->width, 0);
	}
}

static void test_digits_are_equally_wide(void **state)
{
	(void)state;
	for (int i = 0; i < font->face_count; i++) {
		for (uint32_t digit = '1'; digit <= '9'; digit++) {
			assert_int_equal(glyph_of(i, digit)->advance,
				glyph_of(i, '0')->advance);
		}
	}
}

static void claim(uint8_t *taken, int s, int t, int width, int height)
{
	assert_true(s >= 1 && t >= 1);
	assert_true(s + width < font->width && t + height < font->height);
	/* With a border of one texel, which neighbours may share. */
	for (int i = 0; i < (width + 1) * (height + 1); i++) {
		int at = (t + i / (width + 1)) * font->width + s +
			i % (width + 1);

		assert_false(taken[at]);
		taken[at] = 1;
	}
}

static void test_pictures_lie_apart_in_the_atlas(void **state)
{
	static uint8_t taken[512 * 512];

	(void)state;
	assert_int_equal(font->width & (font->width - 1), 0);
	assert_int_equal(font->height & (font->height - 1), 0);
	/* ASCII takes half of it, Latin-1 the other half. */
	assert_in_range(font->width * font->height, 1, 128 * 1024);
	memset(taken, 0, sizeof(taken));
	for (int i = 0; i < font->face_count; i++) {
		for (int k = 0; k < font->glyph_count; k++) {
			const struct font_glyph *glyph = &font->face[i].glyph[k];

			if (glyph->width) {
				claim(taken, glyph->s, glyph->t, glyph->width,
					glyph->height);
			}
		}
	}
	for (int radius = 1; radius <= FONT_DISC_RADIUS_MAX; radius++) {
		claim(taken, font->disc[radius][0], font->disc[radius][1],
			2 * radius, 2 * radius);
	}
}

static void test_the_solid_patch_covers_fully_also_beside(void **state)
{
	(void)state;
	for (int i = 0; i < 4; i++) {
		assert_int_equal(
			alpha_at(font->solid_s - i % 2, font->solid_t - i / 2),
			255);
	}
}

static void test_discs_are_round(void **state)
{
	(void)state;
	for (int radius = 1; radius <= FONT_DISC_RADIUS_MAX; radius++) {
		int s = font->disc[radius][0], t = font->disc[radius][1];
		int side = 2 * radius, sum = 0;

		for (int i = 0; i < side * side; i++) {
			int x = i % side, y = i / side;
			int alpha = alpha_at(s + x, t + y);

			sum += alpha;
			assert_int_equal(alpha, alpha_at(s + y, t + x));
			assert_int_equal(
				alpha, alpha_at(s + side - 1 - x, t + y));
		}
		assert_near(sum / 255.0, 3.14159 * radius * radius,
			0.02 * side * side);
		if (radius > 1) {
			assert_int_equal(alpha_at(s + radius, t + radius), 255);
		}
	}
}

static void expect_codes(const char *text, const uint32_t *codes, int count)
{
	const char *end = text + strlen(text);

	for (int i = 0; i < count; i++) {
		assert_int_equal(font_next_code(&text), codes[i]);
	}
	assert_ptr_equal(text, end);
	assert_int_equal(font_next_code(&text), 0);
	assert_ptr_equal(text, end);
}

static void test_utf8_of_every_length_is_decoded(void **state)
{
	(void)state;
	expect_codes("a\xC2\xB0\xE2\x80\xA6\xF0\x9F\x98\x80",
		(uint32_t[]){'a', 0xB0, 0x2026, 0x1F600}, 4);
	expect_codes("\x7F\xC2\x80\xDF\xBF\xE0\xA0\x80\xEF\xBF\xBF",
		(uint32_t[]){0x7F, 0x80, 0x7FF, 0x800, 0xFFFF}, 5);
	expect_codes("\xF0\x90\x80\x80\xF4\x8F\xBF\xBF",
		(uint32_t[]){0x10000, 0x10FFFF}, 2);
}

static void test_each_bad_byte_is_replaced(void **state)
{
	const uint32_t bad = 0xFFFD;

	(void)state;
	/* Truncated by the end of the text, and by a letter. */
	expect_codes("\xE2\x80", (uint32_t[]){bad, bad}, 2);
	expect_codes("\xC3z", (uint32_t[]){bad, 'z'}, 2);
	/* A continuation byte without a first byte. */
	expect_codes("\x80x", (uint32_t[]){bad, 'x'}, 2);
	/* Overlong encodings. */
	expect_codes("\xC0\xAF", (uint32_t[]){bad, bad}, 2);
	expect_codes("\xE0\x80\xAF", (uint32_t[]){bad, bad, bad}, 3);
	/* A surrogate, and a code beyond Unicode. */
	expect_codes("\xED\xA0\x80", (uint32_t[]){bad, bad, bad}, 3);
	expect_codes("\xF4\x90\x80\x80", (uint32_t[]){bad, bad, bad, bad}, 4);
	expect_codes("\xFF", (uint32_t[]){bad}, 1);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_every_printable_ascii_character_has_a_picture),
		cmocka_unit_test(test_signs_of_units_and_keys_are_there),
		cmocka_unit_test(test_missing_characters_are_the_box),
		cmocka_unit_test(test_every_code_finds_its_own_glyph),
		cmocka_unit_test(test_sizes_ascend_and_metrics_suit_them),
		cmocka_unit_test(
			test_letters_stand_on_the_baseline_within_their_line),
		cmocka_unit_test(test_digits_are_equally_wide),
		cmocka_unit_test(test_pictures_lie_apart_in_the_atlas),
		cmocka_unit_test(test_the_solid_patch_covers_fully_also_beside),
		cmocka_unit_test(test_discs_are_round),
		cmocka_unit_test(test_utf8_of_every_length_is_decoded),
		cmocka_unit_test(test_each_bad_byte_is_replaced),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
