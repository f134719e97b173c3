#include "tests/support/gl/gl_checks.h"

#include "platform/base/fixed.h"

#define ONE FX16_ONE

void gl_check_light_falls_off_with_the_angle(void **state)
{
	static const GLfixed diffuse[] = {ONE, ONE / 2, ONE / 4, ONE};
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	gl_canvas_set_up_light(gl);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
	/* The light is 60 degrees off the normal, so half of it counts. */
	gl->Normal3x(56756, 0, ONE / 2);
	gl_canvas_draw_rectangle(gl, -1, -1, 0, 1, 0);
	/* GL_NORMALIZE makes the normal, of length 2, unit length. */
	gl->Enable(GL_NORMALIZE);
	gl->Normal3x(0, 0, 2 * ONE);
	gl_canvas_draw_rectangle(gl, 0, -1, 1, 1, 0);
	gl_canvas_end_frame(&canvas);
	gl_canvas_expect(&canvas, 4, 12, 128, 64, 32, 1);
	gl_canvas_expect(&canvas, 28, 12, 255, 128, 64, 1);
	gl_canvas_close(&canvas);
}

void gl_check_shininess_and_position_light_count(void **state)
{
	static const GLfixed white[] = {ONE, ONE, ONE, ONE};
	static const GLfixed black[] = {0, 0, 0, ONE};
	static const GLfixed at[] = {0, 0, 4 * ONE, ONE};
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	gl_canvas_set_up_light(gl);
	gl->Lightxv(GL_LIGHT0, GL_SPECULAR, white);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE, black);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
	gl->Materialx(GL_FRONT_AND_BACK, GL_SHININESS, 4 * ONE);
	/* The half vector is (0, 0, 1), so the highlight is 0.8^4 = 0.4096. */
	gl->Normal3x(39322, 0, 52429);
	gl_canvas_draw_rectangle(gl, -1, -1, 0, 1, 0);
	/*
	 * The corners are d = sqrt 17 from the light: the cosine 4/d times the
	 * attenuation 1 / (1 + d/4) is 0.478.
	 */
	gl->Lightxv(GL_LIGHT0, GL_SPECULAR, black);
	gl->Lightxv(GL_LIGHT0, GL_POSITION, at);
	gl->Lightx(GL_LIGHT0, GL_LINEAR_ATTENUATION, ONE / 4);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE, white);
	gl->Normal3x(0, 0, ONE);
	gl_canvas_draw_rectangle(gl, 0, -1, 0.1f, 1, 0);
	gl_canvas_end_frame(&canvas);
	gl_canvas_expect(&canvas, 4, 12, 104, 104, 104, 2);
	gl_canvas_expect(&canvas, 16, 12, 122, 122, 122, 2);
	gl_canvas_close(&canvas);
}

void gl_check_a_spot_lights_what_it_points_at(void **state)
{
	static const GLfixed white[] = {ONE, ONE, ONE, ONE};
	static const GLfixed at[] = {0, 0, ONE, ONE};
	static const GLfixed direction[] = {0, 0, -ONE};
	static const float strip[] = {-0.1f, -1, 0.1f, -1, -0.1f, 1, 0.1f, 1};
	static const float beside[] = {0.9f, -1, 1, -1, 0.9f, 1, 1, 1};
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	gl_canvas_set_up_light(gl);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE, white);
	gl->Lightxv(GL_LIGHT0, GL_POSITION, at);
	gl->Lightxv(GL_LIGHT0, GL_SPOT_DIRECTION, direction);
	gl->Lightx(GL_LIGHT0, GL_SPOT_CUTOFF, 10 * ONE);
	gl->Normal3x(0, 0, ONE);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->Scalex(ONE, ONE / 16, ONE);
	gl->VertexPointer(2, GL_FLOAT, 0, strip);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	gl->VertexPointer(2, GL_FLOAT, 0, beside);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	gl_canvas_end_frame(&canvas);
	gl_canvas_expect(&canvas, 16, 12, 254, 254, 254, 2);
	gl_canvas_expect(&canvas, 31, 12, 0, 0, 0, 0);
	gl_canvas_close(&canvas);
}

void gl_check_fog_is_linear_between_start_and_end(void **state)
{
	static const GLfixed blue[] = {0, 0, ONE, ONE};
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	gl->MatrixMode(GL_PROJECTION);
	gl->Orthox(-ONE, ONE, -ONE, ONE, 0, 10 * ONE);
	gl->MatrixMode(GL_MODELVIEW);
	gl->Fogx(GL_FOG_MODE, GL_LINEAR);
	gl->Fogx(GL_FOG_START, 2 * ONE);
	gl->Fogx(GL_FOG_END, 6 * ONE);
	gl->Fogxv(GL_FOG_COLOR, blue);
	gl->Enable(GL_FOG);
	gl->Color4x(ONE, 0, 0, ONE);
	gl_canvas_draw_rectangle(gl, -1, -1, 0, 1, -3);
	gl_canvas_draw_rectangle(gl, 0, -1, 0.5f, 1, -1);
	gl_canvas_draw_rectangle(gl, 0.5f, -1, 1, 1, -8);
	gl_canvas_end_frame(&canvas);
	gl_canvas_expect(&canvas, 4, 12, 191, 0, 64, 2);
	gl_canvas_expect(&canvas, 20, 12, 255, 0, 0, 0);
	gl_canvas_expect(&canvas, 28, 12, 0, 0, 255, 0);
	gl_canvas_close(&canvas);
}

void gl_check_the_combiner_scales(void **state)
{
	static const GLfixed constant[] = {ONE / 4, ONE / 8, ONE, ONE};
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;
	GLuint texture = gl_canvas_make_texture(gl);

	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_REPLACE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_CONSTANT);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_RGB_SCALE, 2 * ONE);
	gl->TexEnvxv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
	gl_canvas_draw_all(gl);
	gl_canvas_end_frame(&canvas);
	gl_canvas_expect(&canvas, 16, 12, 128, 64, 255, 1);
	gl->DeleteTextures(1, &texture);
	gl_canvas_close(&canvas);
}
