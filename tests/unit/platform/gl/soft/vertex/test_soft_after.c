/*
 * The soft driver keeps what it finds for a draw until the next one, and finds
 * it anew only if a call came between that may change the state: a picture is the
 * same, whatever was drawn before it, and whether calls are prepared anew or not.
 */
#include "platform/base/compiler.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"
#include "platform/gl/soft/soft.h"
#include "tests/support/gl/gl_checks.h"
#include "tests/support/random.h"

#include <string.h>

enum {
	CORNERS = 90,
	PICTURE_BYTES = 4 * GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT,
};

struct corner {
	float position[3], normal[3], texcoord[2];
	uint8_t color[4];
};

static void enable(const struct gl *gl, GLenum name, bool on)
{
	if (on) {
		gl->Enable(name);
	} else {
		gl->Disable(name);
	}
}

static void set_no_light(const struct gl *gl, bool on)
{
	enable(gl, GL_LIGHTING, !on);
}

static void set_near_light(const struct gl *gl, bool on)
{
	static const GLfixed near[] = {20000, -30000, 90000, FX16_ONE};
	static const GLfixed blue[] = {9000, 9000, FX16_ONE, FX16_ONE};

	gl->Lightxv(GL_LIGHT1, GL_POSITION, near);
	gl->Lightxv(GL_LIGHT1, GL_DIFFUSE, blue);
	enable(gl, GL_LIGHT1, on);
}

static void set_bright_light(const struct gl *gl, bool on)
{
	const GLfixed bright[] = {on ? 20 * FX16_ONE : 0, 0, 0, FX16_ONE};

	gl->LightModelxv(GL_LIGHT_MODEL_AMBIENT, bright);
}

static void set_gloss(const struct gl *gl, bool on)
{
	const GLfixed white = on ? FX16_ONE : 0;
	const GLfixed color[] = {white, white, white, FX16_ONE};

	gl->Lightxv(GL_LIGHT0, GL_SPECULAR, color);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_SPECULAR, color);
	gl->Materialx(GL_FRONT_AND_BACK, GL_SHININESS, on ? 9 * FX16_ONE : 0);
}

static void set_two_sides(const struct gl *gl, bool on)
{
	gl->LightModelx(GL_LIGHT_MODEL_TWO_SIDE, on ? FX16_ONE : 0);
}

static void set_color_material(const struct gl *gl, bool on)
{
	enable(gl, GL_COLOR_MATERIAL, on);
}

static void set_normalize(const struct gl *gl, bool on)
{
	enable(gl, GL_NORMALIZE, on);
}

static void set_stretch(const struct gl *gl, bool on)
{
	gl->MatrixMode(GL_MODELVIEW);
	gl->LoadIdentity();
	if (on) {
		gl->Scalex(FX16_ONE, FX16_ONE / 3, 2 * FX16_ONE);
	}
}

static void set_perspective(const struct gl *gl, bool on)
{
	gl->MatrixMode(GL_PROJECTION);
	gl->LoadIdentity();
	if (on) {
		gl->Frustumx(-FX16_ONE, FX16_ONE, -FX16_ONE, FX16_ONE, FX16_ONE,
			6 * FX16_ONE);
		gl->Translatex(0, 0, -2 * FX16_ONE);
	}
}

static void set_fog(const struct gl *gl, bool on)
{
	enable(gl, GL_FOG, on);
}

static void set_texture(const struct gl *gl, bool on)
{
	enable(gl, GL_TEXTURE_2D, on);
}

static void set_offset(const struct gl *gl, bool on)
{
	gl->PolygonOffsetx(3 * FX16_ONE, 90 * FX16_ONE);
	enable(gl, GL_POLYGON_OFFSET_FILL, on);
}

static void set_flat(const struct gl *gl, bool on)
{
	gl->ShadeModel(on ? GL_FLAT : GL_SMOOTH);
}

static void set_culled(const struct gl *gl, bool on)
{
	enable(gl, GL_CULL_FACE, on);
}

static void set_blended(const struct gl *gl, bool on)
{
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	enable(gl, GL_BLEND, on);
}

static void set_alpha_test(const struct gl *gl, bool on)
{
	gl->AlphaFuncx(GL_GREATER, FX16_ONE / 2);
	enable(gl, GL_ALPHA_TEST, on);
}

static void set_no_depth(const struct gl *gl, bool on)
{
	enable(gl, GL_DEPTH_TEST, !on);
}

static void set_mask(const struct gl *gl, bool on)
{
	gl->ColorMask(GL_TRUE, !on, GL_TRUE, GL_TRUE);
}

static void set_viewport(const struct gl *gl, bool on)
{
	gl->Viewport(on ? 5 : 0, on ? 3 : 0, GL_CANVAS_WIDTH - (on ? 9 : 0),
		GL_CANVAS_HEIGHT);
}

static void set_scissor(const struct gl *gl, bool on)
{
	gl->Scissor(4, 5, 20, 9);
	enable(gl, GL_SCISSOR_TEST, on);
}

static const struct {
	const char *name;
	void (*set)(const struct gl *gl, bool on);
} states[] = {
	{"no light", set_no_light},
	{"a near light", set_near_light},
	{"a bright light", set_bright_light},
	{"gloss", set_gloss},
	{"two sides", set_two_sides},
	{"colours as material", set_color_material},
	{"normals of length 1", set_normalize},
	{"a stretched model", set_stretch},
	{"a perspective", set_perspective},
	{"fog", set_fog},
	{"a texture", set_texture},
	{"an offset", set_offset},
	{"flat shading", set_flat},
	{"no backs", set_culled},
	{"blending", set_blended},
	{"an alpha test", set_alpha_test},
	{"no depth test", set_no_depth},
	{"a mask", set_mask},
	{"a viewport", set_viewport},
	{"scissors", set_scissor},
};

static void make_corners(struct corner corner[CORNERS])
{
	uint32_t seed = 7;

	for (int i = 0; i < CORNERS; i++) {
		float length = 0.0f;

		for (int j = 0; j < 3; j++) {
			corner[i].position[j] =
				(float)random_within(&seed, 1000) / 1000.0f;
			corner[i].normal[j] =
				(float)random_within(&seed, 1000) / 1000.0f;
			length += corner[i].normal[j] * corner[i].normal[j];
			corner[i].color[j] = (uint8_t)next_random(&seed);
		}
		length = scalar_sqrt(length);
		for (int j = 0; j < 3; j++) {
			corner[i].normal[j] /= length;
		}
		corner[i].color[3] = (uint8_t)next_random(&seed);
		for (int j = 0; j < 2; j++) {
			corner[i].texcoord[j] =
				(float)random_within(&seed, 300) / 200.0f;
		}
	}
}

/* All states are off, but what each of them turns on is there. */
static void begin(struct gl_canvas *canvas, const struct corner *corner)
{
	const GLsizei stride = sizeof(*corner);
	struct gl *gl = canvas->gl;

	gl_canvas_set_up_light(gl);
	gl_canvas_make_texture(gl);
	for (size_t i = 0; i < ARRAY_COUNT(states); i++) {
		states[i].set(gl, false);
	}
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_NORMAL_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, stride, corner->position);
	gl->NormalPointer(GL_FLOAT, stride, corner->normal);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, stride, corner->color);
	gl->TexCoordPointer(2, GL_FLOAT, stride, corner->texcoord);
}

/* Draws each triangle by a call of its own; again: each is prepared anew. */
static void draw(struct gl_canvas *canvas, size_t state, bool again)
{
	struct soft *soft = (struct soft *)canvas->context;
	struct gl *gl = canvas->gl;

	gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	states[state].set(gl, true);
	for (int i = 0; i < CORNERS; i += 3) {
		if (again) {
			soft->changed = GROUP_ALL;
		}
		assert_true(again || i == 0 || soft->changed == 0);
		gl->DrawArrays(GL_TRIANGLES, i, 3);
	}
	states[state].set(gl, false);
}

static void check_format(enum pixel_format format)
{
	static uint8_t first[ARRAY_COUNT(states)][PICTURE_BYTES];
	struct corner corner[CORNERS];
	struct gl_canvas canvas;
	size_t bytes;

	make_corners(corner);
	for (size_t i = 0; i < ARRAY_COUNT(states); i++) {
		canvas = gl_canvas_open("soft", format);
		begin(&canvas, corner);
		draw(&canvas, i, true);
		bytes = (size_t)canvas.pixels.stride_bytes * GL_CANVAS_HEIGHT;
		memcpy(first[i], canvas.pixels.data, bytes);
		gl_canvas_end_and_close(&canvas);
		assert_true(i == 0 || memcmp(first[i], first[0], bytes) != 0);
	}
	canvas = gl_canvas_open("soft", format);
	begin(&canvas, corner);
	for (size_t i = 0; i < ARRAY_COUNT(states); i++) {
		for (size_t j = 0; j < ARRAY_COUNT(states); j++) {
			draw(&canvas, i, false);
			draw(&canvas, j, false);
			if (memcmp(canvas.pixels.data, first[j], bytes) != 0) {
				fail_msg("%s after %s", states[j].name,
					states[i].name);
			}
		}
	}
	gl_canvas_end_and_close(&canvas);
}

static void test_a_picture_is_the_same_after_any_other(void **state)
{
	(void)state;
	check_format(PIXELS_RGB565);
	check_format(PIXELS_RGBA8888);
}

/* Of triangles in two colours; again: each is prepared anew. */
static void draw_colors(unsigned state, bool again, uint8_t *picture)
{
	struct corner corner[CORNERS];
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct soft *soft = (struct soft *)canvas.context;
	struct gl *gl = canvas.gl;

	make_corners(corner);
	begin(&canvas, corner);
	gl->DisableClientState(GL_COLOR_ARRAY);
	enable(gl, GL_LIGHTING, state & 1);
	enable(gl, GL_COLOR_MATERIAL, state & 1);
	enable(gl, GL_STENCIL_TEST, state & 2);
	enable(gl, GL_DEPTH_TEST, false);
	gl->StencilFunc(GL_EQUAL, 0, 255);
	for (int i = 0; i < CORNERS; i += 3) {
		gl->Color4x(i % 2 ? FX16_ONE : 0, FX16_ONE / 2, 0, FX16_ONE);
		gl->Normal3x(0, i % 2 ? FX16_ONE : 0, FX16_ONE);
		if (again) {
			soft->changed = GROUP_ALL;
		}
		assert_true(again || i == 0 || soft->changed == GROUP_COLOR);
		gl->DrawArrays(GL_TRIANGLES, i, 3);
	}
	memcpy(picture, canvas.pixels.data, 2 * PICTURE_BYTES / 4);
	gl_canvas_end_and_close(&canvas);
}

static void test_the_current_colour_counts_in_each_call(void **unused)
{
	(void)unused;
	for (unsigned state = 0; state < 4; state++) {
		uint8_t kept[PICTURE_BYTES] = {0}, anew[PICTURE_BYTES] = {0};

		draw_colors(state, false, kept);
		draw_colors(state, true, anew);
		assert_memory_equal(kept, anew, PICTURE_BYTES);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_picture_is_the_same_after_any_other),
		cmocka_unit_test(test_the_current_colour_counts_in_each_call),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
