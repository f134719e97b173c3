/* What the labels tell GL, and in which state they leave it. */
#include "app/scene/hud/hud.h"
#include "platform/base/fixed.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <string.h>

static const struct hud_color orange = {255, 128, 0, 255};

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
	int images, deleted;
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

static void delete_textures(GLsizei count, const GLuint *textures)
{
	assert_int_equal(count, 1);
	assert_int_equal(*textures, 1);
	texture.deleted++;
}

static struct gl recorder(void)
{
	struct gl gl = gl_recorder_begin();

	memset(&capabilities, 0, sizeof(capabilities));
	memset(&texture, 0, sizeof(texture));
	gl.BindTexture = bind_texture;
	gl.DeleteTextures = delete_textures;
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

/* What GL was told before it drew, whatever it knew before. */
static struct {
	struct gl recorder;
	GLenum mode, source, target;
	bool modulates, reset_texture, reset_projection, reset_view;
	int draws;
} told;

static void set_mode(GLenum mode)
{
	told.mode = mode;
	told.recorder.MatrixMode(mode);
}

static void load_identity(void)
{
	told.reset_texture |= told.mode == GL_TEXTURE;
	told.reset_projection |= told.mode == GL_PROJECTION;
	told.reset_view |= told.mode == GL_MODELVIEW;
	told.recorder.LoadIdentity();
}

static void set_blending(GLenum source, GLenum target)
{
	told.source = source;
	told.target = target;
}

static void set_environment(GLenum target, GLenum name, GLfixed value)
{
	assert_int_equal(target, GL_TEXTURE_ENV);
	told.modulates = name == GL_TEXTURE_ENV_MODE && value == GL_MODULATE;
}

static void see_state(
	GLenum mode, GLsizei count, GLenum type, const void *indices)
{
	static const GLenum on[] = {GL_BLEND, GL_TEXTURE_2D, GL_VERTEX_ARRAY,
		GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY};
	static const GLenum off[] = {GL_LIGHTING, GL_CULL_FACE, GL_ALPHA_TEST,
		GL_DEPTH_TEST, GL_NORMAL_ARRAY};

	for (int i = 0; i < 5; i++) {
		assert_true(is_on(on[i]));
		assert_false(is_on(off[i]));
	}
	assert_int_equal(told.source, GL_SRC_ALPHA);
	assert_int_equal(told.target, GL_ONE_MINUS_SRC_ALPHA);
	assert_true(told.modulates);
	assert_true(
		told.reset_texture && told.reset_projection && told.reset_view);
	assert_int_equal(texture.bound, 1);
	told.draws++;
	told.recorder.DrawElements(mode, count, type, indices);
}

/* At scale 1 each texel lies on one pixel; others are blended. */
static void test_the_state_of_a_frame_does_not_depend_on_what_was_before(
	void **state)
{
	static const struct {
		int height;
		GLfixed filter;
	} rows[] = {{640, GL_NEAREST}, {16000, GL_LINEAR}, {640, GL_NEAREST}};
	struct gl gl = recorder();
	struct hud *hud = hud_with(&gl);

	(void)state;
	told.recorder = gl;
	told.draws = 0;
	gl.MatrixMode = set_mode;
	gl.LoadIdentity = load_identity;
	gl.BlendFunc = set_blending;
	gl.TexEnvx = set_environment;
	gl.DrawElements = see_state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		gl.Enable(GL_LIGHTING);
		gl.Enable(GL_CULL_FACE);
		gl.Enable(GL_ALPHA_TEST);
		gl.Enable(GL_DEPTH_TEST);
		gl.EnableClientState(GL_NORMAL_ARRAY);
		gl.DisableClientState(GL_VERTEX_ARRAY);
		gl.DisableClientState(GL_COLOR_ARRAY);
		gl.BindTexture(GL_TEXTURE_2D, 99);
		told.source = told.target = 0;
		told.modulates = told.reset_texture = false;
		told.reset_projection = told.reset_view = false;
		hud_begin(hud, 480, rows[i].height);
		hud_text(hud, 10, 10, orange, "walk");
		hud_end(hud, &gl);
		assert_int_equal(told.draws, i + 1);
		assert_int_equal(texture.magnify, rows[i].filter);
		assert_int_equal(texture.minify, rows[i].filter);
	}
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
	static struct hud hud;

	(void)state;
	gl.GenTextures = gen_no_textures;
	assert_int_equal(hud_init(&hud, &gl, &log), -ENOMEM);
	assert_int_equal(capture.count, 1);
	assert_contains(capture.sentence[0], "texture");
	hud_finish(&hud, &gl);
	assert_int_equal(texture.deleted, 0);
}

static void test_the_texture_is_given_back_once(void **state)
{
	struct gl gl = recorder();
	struct hud *hud = hud_with(&gl);

	(void)state;
	hud_finish(hud, &gl);
	hud_finish(hud, &gl);
	assert_int_equal(texture.deleted, 1);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_letters_texels_are_taken_one_by_one),
		cmocka_unit_test(test_a_frame_is_one_draw_call),
		cmocka_unit_test(
			test_the_state_of_a_frame_does_not_depend_on_what_was_before),
		cmocka_unit_test(test_drivers_of_fixed_point_get_exact_matrices),
		cmocka_unit_test(test_leaves_the_state_it_promises),
		cmocka_unit_test(test_a_missing_texture_is_reported),
		cmocka_unit_test(test_the_texture_is_given_back_once),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
