#include "tests/support/gl/gl_checks.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/fixed.h"

#define ONE FX16_ONE

#ifdef __arm__
static const bool library_may_lack = true;
#else
static const bool library_may_lack = false;
#endif

static void fail_or_skip(const char *driver, int error)
{
	static char reason[64];

	if (library_may_lack && (error == -ENOENT || error == -ENODEV)) {
		snprintf(reason, sizeof(reason), "--gl %s does not open here",
			driver);
		skip_because(reason);
	}
	fail_msg("--gl %s: does not open: %s", driver, strerror(-error));
}

struct gl_canvas gl_canvas_open(const char *driver, enum pixel_format format)
{
	struct log log = log_to_stderr(LOG_WARNING);
	struct gl_canvas canvas;
	int error;

	error = gl_open(driver,
		&(struct gl_request){.format = format, .log = &log},
		&canvas.context);
	if (error) {
		fail_or_skip(driver, error);
	}
	canvas.gl = &canvas.context->gl;
	assert_int_equal(pixels_alloc(&canvas.pixels, GL_CANVAS_WIDTH,
				 GL_CANVAS_HEIGHT, format, &log),
		0);
	assert_int_equal(canvas.context->driver->begin_frame(
				 canvas.context, &canvas.pixels),
		0);
	canvas.gl->ClearColorx(0, 0, 0, FX16_ONE);
	canvas.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT |
		GL_STENCIL_BUFFER_BIT);
	return canvas;
}

void gl_canvas_end_frame(struct gl_canvas *canvas)
{
	assert_int_equal(canvas->gl->GetError(), GL_NO_ERROR);
	assert_int_equal(canvas->context->driver->end_frame(canvas->context), 0);
	assert_int_equal(canvas->gl->GetError(), GL_NO_ERROR);
}

void gl_canvas_close(struct gl_canvas *canvas)
{
	canvas->context->driver->destroy(canvas->context);
	free(canvas->pixels.data);
}

void gl_canvas_end_and_close(struct gl_canvas *canvas)
{
	gl_canvas_end_frame(canvas);
	gl_canvas_close(canvas);
}

static void read_pixel(const struct pixels *pixels, int x, int y, int rgb[3])
{
	const uint8_t *data = pixels->data + y * pixels->stride_bytes +
		x * pixel_bytes(pixels->format);
	uint16_t packed;

	if (pixels->format == PIXELS_RGBA8888) {
		for (int i = 0; i < 3; i++) {
			rgb[i] = data[i];
		}
		return;
	}
	memcpy(&packed, data, sizeof(packed));
	rgb[0] = (packed >> 11) * 255 / 31;
	rgb[1] = (packed >> 5 & 63) * 255 / 63;
	rgb[2] = (packed & 31) * 255 / 31;
}

void gl_canvas_expect(const struct gl_canvas *canvas, int x, int y, int red,
	int green, int blue, int tolerance)
{
	int rgb[3];

	read_pixel(&canvas->pixels, x, y, rgb);
	if (abs(rgb[0] - red) > tolerance || abs(rgb[1] - green) > tolerance ||
		abs(rgb[2] - blue) > tolerance) {
		fail_msg("pixel (%d, %d) is (%d, %d, %d), not (%d, %d, %d) "
			 "within %d",
			x, y, rgb[0], rgb[1], rgb[2], red, green, blue,
			tolerance);
	}
}

void gl_canvas_draw_rectangle(struct gl *gl, float left, float bottom,
	float right, float top, float z)
{
	const float vertices[] = {
		left, bottom, z, right, bottom, z, left, top, z, right, top, z};

	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, 0, vertices);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void gl_canvas_draw_all(struct gl *gl)
{
	gl_canvas_draw_rectangle(gl, -1, -1, 1, 1, 0);
}

GLuint gl_canvas_make_texture(struct gl *gl)
{
	static const GLubyte texels[] = {
		255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
	GLuint texture = 0;

	gl->GenTextures(1, &texture);
	assert_int_not_equal(texture, 0);
	gl->BindTexture(GL_TEXTURE_2D, texture);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB,
		GL_UNSIGNED_BYTE, texels);
	gl->Enable(GL_TEXTURE_2D);
	return texture;
}

void gl_canvas_set_up_light(struct gl *gl)
{
	static const GLfixed black[] = {0, 0, 0, ONE};
	static const GLfixed white[] = {ONE, ONE, ONE, ONE};
	static const GLfixed towards_viewer[] = {0, 0, ONE, 0};

	gl->LightModelxv(GL_LIGHT_MODEL_AMBIENT, black);
	gl->Lightxv(GL_LIGHT0, GL_AMBIENT, black);
	gl->Lightxv(GL_LIGHT0, GL_DIFFUSE, white);
	gl->Lightxv(GL_LIGHT0, GL_SPECULAR, black);
	gl->Lightxv(GL_LIGHT0, GL_POSITION, towards_viewer);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_AMBIENT, black);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_SPECULAR, black);
	gl->Enable(GL_LIGHTING);
	gl->Enable(GL_LIGHT0);
}

/* Draws the side of a cylinder with normals and texture coordinates. */
static void draw_cylinder(struct gl *gl)
{
	enum {
		SIDES = 12
	};
	float vertices[SIDES + 1][2][3];
	float normals[SIDES + 1][2][3];
	float coordinates[SIDES + 1][2][2];

	for (int i = 0; i <= SIDES; i++) {
		float angle = (float)i * 6.2831853f / SIDES;

		for (int j = 0; j < 2; j++) {
			float across = sinf(angle), near = cosf(angle);

			memcpy(normals[i][j], (float[]){across, 0, near},
				sizeof(normals[i][j]));
			memcpy(vertices[i][j],
				(float[]){across, j ? 1 : -1, near},
				sizeof(vertices[i][j]));
			memcpy(coordinates[i][j],
				(float[]){(float)i / SIDES, (float)j},
				sizeof(coordinates[i][j]));
		}
	}
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_NORMAL_ARRAY);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, 0, vertices);
	gl->NormalPointer(GL_FLOAT, 0, normals);
	gl->TexCoordPointer(2, GL_FLOAT, 0, coordinates);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (SIDES + 1));
	gl->DisableClientState(GL_NORMAL_ARRAY);
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
}

void gl_canvas_draw_scene(struct gl_canvas *canvas)
{
	static const GLfixed material[] = {ONE, 3 * ONE / 4, ONE / 2, ONE};
	static const GLfixed sky[] = {ONE / 8, ONE / 4, ONE / 2, ONE};
	struct gl *gl = canvas->gl;
	GLuint texture = gl_canvas_make_texture(gl);

	gl->ClearColorx(ONE / 8, ONE / 4, ONE / 2, ONE);
	gl->Clear(GL_COLOR_BUFFER_BIT);
	gl_canvas_set_up_light(gl);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, material);
	gl->MatrixMode(GL_PROJECTION);
	gl->Frustumx(-ONE, ONE, -ONE, ONE, 2 * ONE, 10 * ONE);
	gl->MatrixMode(GL_MODELVIEW);
	gl->Fogx(GL_FOG_MODE, GL_LINEAR);
	gl->Fogx(GL_FOG_START, 2 * ONE);
	gl->Fogx(GL_FOG_END, 8 * ONE);
	gl->Fogxv(GL_FOG_COLOR, sky);
	gl->Enable(GL_FOG);
	gl->Enable(GL_DEPTH_TEST);
	gl->Enable(GL_CULL_FACE);
	gl->CullFace(GL_FRONT);
	gl->Translatex(0, 0, -4 * ONE);
	gl->PushMatrix();
	gl->Rotatex(30 * ONE, ONE, ONE, 0);
	draw_cylinder(gl);
	gl->PopMatrix();
	gl->Disable(GL_CULL_FACE);
	gl->Disable(GL_TEXTURE_2D);
	gl->Disable(GL_LIGHTING);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->Color4x(ONE, ONE, 0, ONE / 2);
	gl_canvas_draw_rectangle(gl, -1, -1, 2, 0, 0.5f);
	gl_canvas_end_frame(canvas);
	gl->DeleteTextures(1, &texture);
}
