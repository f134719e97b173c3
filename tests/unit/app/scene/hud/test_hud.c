#include "app/scene/hud/hud.h"
#include "platform/base/fixed.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <string.h>

static const struct hud_color orange = {255, 128, 0, 255};

/* A hud without GL, for what happens before hud_end(). */
static struct hud *hud_of_size(int width, int height)
{
	static struct hud hud;

	memset(&hud, 0, sizeof(hud));
	hud.font = &font_default;
	hud_begin(&hud, width, height);
	return &hud;
}

static void test_widths_of_pieces_add_up(void **state)
{
	struct hud *hud = hud_of_size(480, 640);
	int walk = hud_text_width(hud, "walk "),
	    time = hud_text_width(hud, "1.07");

	(void)state;
	assert_int_equal(hud_text_width(hud, ""), 0);
	assert_true(walk > 0 && time > 0);
	assert_int_equal(hud_text_width(hud, "walk 1.07"), walk + time);
	assert_int_equal(hud_text_width(hud, "1.07walk "), walk + time);
	assert_int_equal(hud_text_width(hud, "3.48"), time);
	assert_int_equal(
		hud_text(hud, 40, 0, orange, "walk 1.07"), 40 + walk + time);
}

static void test_text_grows_with_the_picture(void **state)
{
	static const int sizes[][3] = {{240, 320, 12}, {480, 640, 16},
		{1280, 720, 16}, {1920, 1080, 24}, {3840, 2160, 48}, {1, 1, 12}};

	(void)state;
	for (size_t i = 0; i < sizeof(sizes) / sizeof(sizes[0]); i++) {
		struct hud *hud = hud_of_size(sizes[i][0], sizes[i][1]);

		assert_int_equal(hud_em(hud), sizes[i][2]);
		assert_in_range(
			hud_line_height(hud), hud_em(hud), hud_em(hud) * 3 / 2);
	}
}

static void test_a_picture_has_at_least_one_pixel(void **state)
{
	static const int sizes[][2] = {{0, 0}, {-5, 7}, {9, -1}, {1, 1}};

	(void)state;
	for (size_t i = 0; i < sizeof(sizes) / sizeof(sizes[0]); i++) {
		const int *size = sizes[i];
		struct hud *hud = hud_of_size(size[0], size[1]);

		assert_int_equal(hud->width, size[0] < 1 ? 1 : size[0]);
		assert_int_equal(hud->height, size[1] < 1 ? 1 : size[1]);
	}
}

static void test_long_text_is_cut_with_an_ellipsis(void **state)
{
	struct hud *hud = hud_of_size(480, 640);
	int whole = hud_text_width(hud, "walk backwards");
	const struct font_glyph *ellipsis =
		&hud->face->glyph[font_find_glyph(hud->font, 0x2026)];

	(void)state;
	assert_int_equal(
		hud_text_cut(hud, 7, 0, whole, orange, "walk backwards"),
		7 + whole);
	assert_int_equal(hud->quad_count, 13);
	for (int width = 0; width < whole; width++) {
		int end;

		hud_begin(hud, 480, 640);
		end = hud_text_cut(hud, 7, 0, width, orange, "walk backwards");
		assert_in_range(end, 7, 7 + width);
		if (hud->quad_count > 0) {
			const struct hud_vertex *last =
				&hud->vertex[hud->quad_count * 4 - 4];

			assert_int_equal(last->s, ellipsis->s);
			assert_int_equal(last->t, ellipsis->t);
		} else {
			assert_true(width < ellipsis->advance);
		}
	}
}

static void test_no_ellipsis_follows_a_space(void **state)
{
	struct hud *hud = hud_of_size(480, 640);
	int word = hud_text_width(hud, "walk");
	int more = hud_text_width(hud, " \xE2\x80\xA6");

	(void)state;
	assert_int_equal(
		hud_text_cut(hud, 0, 0, word + more, orange, "walk backwards"),
		word + hud_text_width(hud, "\xE2\x80\xA6"));
}

/* Adds more than fits. */
static void overfill(struct hud *hud)
{
	for (int i = 0; i < HUD_QUADS_MAX; i++) {
		hud_text(hud, i, i, orange, "no longer fits");
		hud_bar(hud, i, i, 100, 10, 0.5f, orange);
	}
}

static void test_elements_beyond_the_capacity_are_dropped(void **state)
{
	struct hud *hud = hud_of_size(480, 640);

	(void)state;
	memset(hud->index, 0xA5, sizeof(hud->index));
	overfill(hud);
	assert_int_equal(hud->quad_count, HUD_QUADS_MAX);
	for (int i = 0; i < HUD_QUADS_MAX * 6; i++) {
		assert_int_equal(hud->index[i], 0xA5A5);
	}
	hud_begin(hud, 480, 640);
	assert_int_equal(hud->quad_count, 0);
}

static void test_absurd_positions_and_sizes_are_harmless(void **state)
{
	struct hud *hud = hud_of_size(480, 640);

	(void)state;
	hud_panel(hud, 10, 10, 0, 20, 5, orange);
	hud_panel(hud, 10, 10, -5, -5, 5, orange);
	hud_bar(hud, 10, 10, 0, 4, 1.0f, orange);
	hud_rectangle(hud, 0, 0, -1, 5, orange);
	assert_int_equal(hud->quad_count, 0);
	hud_text(hud, 1 << 24, -(1 << 24), orange, "far away");
	hud_panel(hud, 0, 0, 50, 50, 1 << 20, orange);
	hud_panel(hud, 0, 0, 50, 50, -1, orange);
	hud_move(hud, 0, 30000, -30000);
	hud_move(hud, 0, 30000, -30000);
}

/* The filled width of a bar of 100 pixels: the right edge of its last quad. */
static int filled_width(float fraction)
{
	struct hud *hud = hud_of_size(480, 640);
	int track, right = 0;

	hud_panel(hud, 0, 0, 100, 4, 2, orange);
	track = hud->quad_count;
	hud_begin(hud, 480, 640);
	hud_bar(hud, 0, 0, 100, 4, fraction, orange);
	for (int i = track * 4; i < hud->quad_count * 4; i++) {
		right = hud->vertex[i].x > right ? hud->vertex[i].x : right;
	}
	return right;
}

static void test_bars_fill_by_their_fraction(void **state)
{
	(void)state;
	assert_int_equal(filled_width(0.5f), 50);
	assert_int_equal(filled_width(0.254f), 25);
	assert_int_equal(filled_width(1.0f), 100);
	assert_int_equal(filled_width(7.0f), 100);
	assert_int_equal(filled_width(0.0f), 0);
	assert_int_equal(filled_width(-1.0f), 0);
	assert_int_equal(filled_width(NAN), 0);
	/* The smallest fraction is visible as a dot. */
	assert_int_equal(filled_width(0.001f), 4);
}

/* A recorder that also accepts textures and records what is enabled. */
enum {
	CAPABILITIES_MAX = 64
};

static struct {
	GLenum name[CAPABILITIES_MAX];
	bool on[CAPABILITIES_MAX];
	int count;
} capabilities;

static void set_capability(GLenum name, bool on)
{
	int i = 0;

	while (i < capabilities.count && capabilities.name[i] != name) {
		i++;
	}
	assert_true(i < CAPABILITIES_MAX);
	capabilities.name[i] = name;
	capabilities.on[i] = on;
	capabilities.count += i == capabilities.count;
}

static bool is_on(GLenum name)
{
	for (int i = 0; i < capabilities.count; i++) {
		if (capabilities.name[i] == name) {
			return capabilities.on[i];
		}
	}
	fail_msg("capability %#x was never set", name);
	return false;
}

static void enable(GLenum name)
{
	set_capability(name, true);
}

static void disable(GLenum name)
{
	set_capability(name, false);
}

static void gen_textures(GLsizei count, GLuint *textures)
{
	for (int i = 0; i < count; i++) {
		textures[i] = (GLuint)i + 1;
	}
}

static void gen_no_textures(GLsizei count, GLuint *textures)
{
	memset(textures, 0, (size_t)count * sizeof(*textures));
}

/* What GL knows of the font's texture. */
static struct {
	GLuint bound;
	GLfixed magnify, minify, wrap_s, wrap_t;
	GLint row_bytes;
	int images;
} texture;

static void bind_texture(GLenum target, GLuint name)
{
	assert_int_equal(target, GL_TEXTURE_2D);
	texture.bound = name;
}

static void set_parameter(GLenum target, GLenum name, GLfixed value)
{
	assert_int_equal(target, GL_TEXTURE_2D);
	*(name == GL_TEXTURE_MAG_FILTER                 ? &texture.magnify
			: name == GL_TEXTURE_MIN_FILTER ? &texture.minify
			: name == GL_TEXTURE_WRAP_S     ? &texture.wrap_s
						    : &texture.wrap_t) = value;
}

static void store(GLenum name, GLint value)
{
	assert_int_equal(name, GL_UNPACK_ALIGNMENT);
	texture.row_bytes = value;
}

static void tex_image(GLenum target, GLint level, GLint internal_format,
	GLsizei width, GLsizei height, GLint border, GLenum format, GLenum type,
	const void *pixels)
{
	assert_int_equal(target, GL_TEXTURE_2D);
	assert_int_equal(level, 0);
	assert_int_equal(border, 0);
	assert_int_equal(internal_format, GL_ALPHA);
	assert_int_equal(format, GL_ALPHA);
	assert_int_equal(type, GL_UNSIGNED_BYTE);
	assert_int_equal(width, font_default.width);
	assert_int_equal(height, font_default.height);
	assert_ptr_equal(pixels, font_default.alpha);
	texture.images++;
}

static struct gl recorder(void)
{
	struct gl gl = gl_recorder_begin();

	memset(&capabilities, 0, sizeof(capabilities));
	memset(&texture, 0, sizeof(texture));
	gl.BindTexture = bind_texture;
	gl.Disable = gl.DisableClientState = disable;
	gl.Enable = gl.EnableClientState = enable;
	gl.GenTextures = gen_textures;
	gl.PixelStorei = store;
	gl.TexImage2D = tex_image;
	gl.TexParameterx = set_parameter;
	return gl;
}

static struct hud *hud_with(const struct gl *gl)
{
	static struct hud hud;
	struct log log = log_to_nowhere();

	assert_int_equal(hud_init(&hud, gl, &log), 0);
	return &hud;
}

/* Beyond its edges and between its texels, letters would show their neighbours. */
static void test_letters_texels_are_taken_one_by_one(void **state)
{
	struct gl gl = recorder();

	(void)state;
	hud_with(&gl);
	assert_int_equal(texture.bound, 1);
	assert_int_equal(texture.images, 1);
	assert_int_equal(texture.row_bytes, 1);
	assert_int_equal(texture.magnify, GL_NEAREST);
	assert_int_equal(texture.minify, GL_NEAREST);
	assert_int_equal(texture.wrap_s, GL_CLAMP_TO_EDGE);
	assert_int_equal(texture.wrap_t, GL_CLAMP_TO_EDGE);
}

static void test_a_frame_is_one_draw_call(void **state)
{
	struct gl gl = recorder();
	struct hud *hud = hud_with(&gl);
	const struct gl_recording *recording = gl_recorder_result();
	int quads;

	(void)state;
	hud_begin(hud, 480, 640);
	hud_end(hud, &gl);
	assert_int_equal(recording->draw_count, 0);
	hud_begin(hud, 480, 640);
	hud_text(hud, 10, 10, orange, "walk");
	hud_bar(hud, 10, 30, 100, 4, 0.5f, orange);
	quads = hud->quad_count;
	assert_true(quads > 8);
	hud_end(hud, &gl);
	assert_int_equal(recording->draw_count, 1);
	assert_int_equal(recording->draw[0].count, quads * 6);
	hud_end(hud, &gl);
	assert_int_equal(recording->draw_count, 1);
}

static void test_drivers_of_fixed_point_get_exact_matrices(void **state)
{
	struct gl gl = recorder();
	struct hud *hud = hud_with(&gl);
	const double *matrix = gl_recorder_result()->draw[0].matrix;

	(void)state;
	hud_begin(hud, 1366, 767);
	hud_rectangle(hud, 0, 0, 1366, 767, orange);
	hud_rectangle(hud, 683, 0, 1, 767, orange);
	hud_end(hud, &gl);
	assert_true(matrix[0] == 1.0 / 16384 && matrix[5] == -1.0 / 16384);
	/* Within 1/16 of a pixel of the exact positions. */
	assert_near(hud->vertex[0].x * matrix[0], -1.0, 0.125 / 1366);
	assert_near(hud->vertex[0].y * matrix[5], 1.0, 0.125 / 767);
	assert_near(hud->vertex[3].x * matrix[0], 1.0, 0.125 / 1366);
	assert_near(hud->vertex[3].y * matrix[5], -1.0, 0.125 / 767);
	assert_near(hud->vertex[4].x * matrix[0], 0.0, 0.125 / 1366);
}

static void test_leaves_the_state_it_promises(void **state)
{
	struct gl gl = recorder();
	struct hud *hud = hud_with(&gl);

	(void)state;
	hud_begin(hud, 480, 640);
	hud_text(hud, 10, 10, orange, "walk");
	hud_end(hud, &gl);
	assert_true(is_on(GL_DEPTH_TEST));
	assert_false(is_on(GL_BLEND));
	assert_false(is_on(GL_TEXTURE_2D));
	assert_false(is_on(GL_LIGHTING));
	assert_false(is_on(GL_CULL_FACE));
	assert_false(is_on(GL_ALPHA_TEST));
	assert_true(is_on(GL_VERTEX_ARRAY));
	assert_true(is_on(GL_COLOR_ARRAY));
	assert_false(is_on(GL_NORMAL_ARRAY));
	assert_false(is_on(GL_TEXTURE_COORD_ARRAY));
	/* The matrix mode is model-view, and that matrix is the identity. */
	gl.DrawArrays(GL_TRIANGLES, 0, 3);
	assert_near(gl_recorder_result()->draw[1].matrix[0], 1.0, 0);
	gl.Scalex(2 * FX16_ONE, FX16_ONE, FX16_ONE);
	gl.DrawArrays(GL_TRIANGLES, 0, 3);
	assert_near(gl_recorder_result()->draw[2].matrix[0], 2.0, 0);
}

static void test_a_missing_texture_is_reported(void **state)
{
	struct gl gl = recorder();
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct hud *hud = hud_of_size(1, 1);

	(void)state;
	gl.GenTextures = gen_no_textures;
	assert_int_equal(hud_init(hud, &gl, &log), -ENOMEM);
	assert_int_equal(capture.count, 1);
	assert_contains(capture.sentence[0], "texture");
	hud_finish(hud, &gl);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_widths_of_pieces_add_up),
		cmocka_unit_test(test_text_grows_with_the_picture),
		cmocka_unit_test(test_a_picture_has_at_least_one_pixel),
		cmocka_unit_test(test_long_text_is_cut_with_an_ellipsis),
		cmocka_unit_test(test_no_ellipsis_follows_a_space),
		cmocka_unit_test(test_elements_beyond_the_capacity_are_dropped),
		cmocka_unit_test(test_absurd_positions_and_sizes_are_harmless),
		cmocka_unit_test(test_bars_fill_by_their_fraction),
		cmocka_unit_test(test_letters_texels_are_taken_one_by_one),
		cmocka_unit_test(test_a_frame_is_one_draw_call),
		cmocka_unit_test(test_drivers_of_fixed_point_get_exact_matrices),
		cmocka_unit_test(test_leaves_the_state_it_promises),
		cmocka_unit_test(test_a_missing_texture_is_reported),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
