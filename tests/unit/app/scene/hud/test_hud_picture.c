/* Pictures of the hud by every GL driver; each test takes a driver's name. */
#include "app/scene/hud/hud.h"
#include "platform/base/compiler.h"
#include "tests/support/gl/gl_checks.h"
#include "tests/support/test.h"

#include <stdio.h>

static const struct hud_color orange = {255, 128, 0, 255};

static void check_picture(
	const char *driver, void (*check)(struct gl_canvas *, struct hud *))
{
	static struct hud hud;
	struct log log = log_to_stderr(LOG_WARNING);
	struct gl_canvas canvas = gl_canvas_open(driver, PIXELS_RGBA8888);

	assert_int_equal(hud_init(&hud, canvas.gl, &log), 0);
	hud_begin(&hud, GL_CANVAS_WIDTH, GL_CANVAS_HEIGHT);
	check(&canvas, &hud);
	hud_finish(&hud, canvas.gl);
	gl_canvas_close(&canvas);
}

static int blend(int above, int below, int alpha)
{
	return (above * alpha + below * (255 - alpha) + 127) / 255;
}

/* The alpha of a glyph at a pen position; 0 outside the glyph. */
static int glyph_alpha(const struct hud *hud, uint32_t code, int pen, int y,
	int at_x, int at_y)
{
	const struct font *font = hud->font;
	const struct font_glyph *glyph =
		&hud->face->glyph[font_find_glyph(font, code)];
	int column = at_x - pen - glyph->left;
	int row = at_y - (y + hud->face->ascent - glyph->top);

	if (column < 0 || row < 0 || column >= glyph->width ||
		row >= glyph->height) {
		return 0;
	}
	return font->alpha[(glyph->t + row) * font->width + glyph->s + column];
}

/* Expects a picture with nothing but two orange letters on black. */
static void expect_letters(const struct gl_canvas *canvas,
	const struct hud *hud, const char *two, int x, int y)
{
	char first[2] = {two[0], 0};
	int second = x + hud_text_width(hud, first);

	for (int i = 0; i < GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT; i++) {
		int at_x = i % GL_CANVAS_WIDTH, at_y = i / GL_CANVAS_WIDTH;
		int alpha = glyph_alpha(hud, (uint8_t)two[0], x, y, at_x, at_y) +
			glyph_alpha(hud, (uint8_t)two[1], second, y, at_x, at_y);

		gl_canvas_expect(
			canvas, at_x, at_y, alpha, blend(128, 0, alpha), 0, 2);
	}
}

static void check_letters(struct gl_canvas *canvas, struct hud *hud)
{
	hud_text(hud, 3, 5, orange, "1g");
	hud_end(hud, canvas->gl);
	gl_canvas_end_frame(canvas);
	expect_letters(canvas, hud, "1g", 3, 5);
}

static void test_text_lands_on_its_pixels_in_its_colour(void **state)
{
	check_picture(*state, check_letters);
}

static void check_letters_that_leave(struct gl_canvas *canvas, struct hud *hud)
{
	hud_text(hud, -3, -6, orange, "1g");
	hud_end(hud, canvas->gl);
	gl_canvas_end_frame(canvas);
	expect_letters(canvas, hud, "1g", -3, -6);
}

static void test_text_over_the_edge_is_cut_off_there(void **state)
{
	check_picture(*state, check_letters_that_leave);
}

static void check_order(struct gl_canvas *canvas, struct hud *hud)
{
	static const struct hud_color white = {255, 255, 255, 255};
	static const struct hud_color half_blue = {0, 0, 255, 128};

	hud_rectangle(hud, 4, 4, 10, 10, white);
	hud_rectangle(hud, 8, 4, 10, 10, half_blue);
	hud_rectangle(hud, 31, 23, 1, 1, orange);
	hud_end(hud, canvas->gl);
	gl_canvas_end_frame(canvas);
	gl_canvas_expect(canvas, 3, 4, 0, 0, 0, 0);
	gl_canvas_expect(canvas, 4, 4, 255, 255, 255, 0);
	gl_canvas_expect(canvas, 4, 14, 0, 0, 0, 0);
	gl_canvas_expect(canvas, 7, 13, 255, 255, 255, 0);
	gl_canvas_expect(canvas, 8, 13, 127, 127, 255, 2);
	gl_canvas_expect(canvas, 17, 13, 0, 0, 128, 2);
	gl_canvas_expect(canvas, 18, 13, 0, 0, 0, 0);
	gl_canvas_expect(canvas, 31, 23, 255, 128, 0, 2);
	gl_canvas_expect(canvas, 30, 23, 0, 0, 0, 0);
	gl_canvas_expect(canvas, 31, 22, 0, 0, 0, 0);
}

static void test_later_things_cover_earlier_ones(void **state)
{
	check_picture(*state, check_order);
}

/* Expects the disc's quarters in the corners and solid colour elsewhere. */
static void check_panel(struct gl_canvas *canvas, struct hud *hud)
{
	const uint16_t *disc = hud->font->disc[4];

	hud_panel(hud, 2, 3, 20, 15, 4, orange);
	hud_end(hud, canvas->gl);
	gl_canvas_end_frame(canvas);
	for (int i = 0; i < 20 * 15; i++) {
		int x = i % 20, y = i / 20;
		int s = x < 4 ? x : x >= 16 ? x - 12 : -1;
		int t = y < 4 ? y : y >= 11 ? y - 7 : -1;
		int alpha = s < 0 || t < 0
			? 255
			: hud->font->alpha[(disc[1] + t) * hud->font->width +
				  disc[0] + s];

		gl_canvas_expect(canvas, 2 + x, 3 + y, alpha,
			blend(128, 0, alpha), 0, 2);
	}
	gl_canvas_expect(canvas, 1, 10, 0, 0, 0, 0);
	gl_canvas_expect(canvas, 22, 10, 0, 0, 0, 0);
	gl_canvas_expect(canvas, 10, 2, 0, 0, 0, 0);
	gl_canvas_expect(canvas, 10, 18, 0, 0, 0, 0);
}

static void test_panels_are_whole_and_round(void **state)
{
	check_picture(*state, check_panel);
}

/* State that a scene may have left must not affect the hud. */
static void check_after_a_scene(struct gl_canvas *canvas, struct hud *hud)
{
	struct gl *gl = canvas->gl;

	gl->Enable(GL_DEPTH_TEST);
	gl->Enable(GL_LIGHTING);
	gl->Enable(GL_CULL_FACE);
	gl->CullFace(GL_FRONT_AND_BACK);
	gl->Enable(GL_ALPHA_TEST);
	gl->AlphaFuncx(GL_NEVER, 0);
	gl->DepthFunc(GL_NEVER);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
	gl->MatrixMode(GL_TEXTURE);
	gl->Scalex(0, 0, 0);
	gl->MatrixMode(GL_PROJECTION);
	gl->Scalex(0, 0, 0);
	gl->BlendFunc(GL_ZERO, GL_ONE);
	check_order(canvas, hud);
}

static void test_state_of_the_scene_does_not_matter(void **state)
{
	check_picture(*state, check_after_a_scene);
}

static const struct CMUnitTest picture_tests[] = {
	cmocka_unit_test(test_text_lands_on_its_pixels_in_its_colour),
	cmocka_unit_test(test_text_over_the_edge_is_cut_off_there),
	cmocka_unit_test(test_later_things_cover_earlier_ones),
	cmocka_unit_test(test_panels_are_whole_and_round),
	cmocka_unit_test(test_state_of_the_scene_does_not_matter),
};

enum {
	PICTURE_COUNT = ARRAY_COUNT(picture_tests),
	DRIVERS_MAX = 8
};

int main(void)
{
	/* cmocka skips entries that are all zero. */
	static struct CMUnitTest tests[PICTURE_COUNT * DRIVERS_MAX];
	static char name[PICTURE_COUNT * DRIVERS_MAX][96];

	for (int i = 0; gl_registry[i / PICTURE_COUNT]; i++) {
		const char *driver = gl_registry[i / PICTURE_COUNT]->name;
		struct CMUnitTest *test = &tests[i];

		*test = picture_tests[i % PICTURE_COUNT];
		snprintf(name[i], sizeof(name[i]), "%s_%s", test->name, driver);
		test->name = name[i];
		test->initial_state = (void *)(uintptr_t)driver;
	}
	return cmocka_run_group_tests(tests, NULL, NULL);
}
