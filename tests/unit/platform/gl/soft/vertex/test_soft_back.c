/*
 * Back faces that are drawn alone, as the second half of a two-sided surface:
 * they look as they do where both faces are drawn, and what front faces hide of
 * them changes nothing.
 */
#include "platform/base/fixed.h"
#include "tests/support/gl/gl_checks.h"
#include "tests/support/gl/random_corners.h"

#include <stdlib.h>
#include <string.h>

enum {
	POOL = 240,
	CORNERS = 360,
	ROUNDS = 96,
	PICTURE_BYTES = 4 * GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT,
	STEP_8888 = 1,
	STEP_565 = 9, /* of 255: one step of RGB565 */
};

/* What a round draws, by bits of its number. */
struct back_case {
	enum pixel_format format;
	bool flat, textured, positional, uneven, perspective, cut;
	int reach; /* how far apart corners are, 32767 is half the picture */
	struct random_corner pool[POOL];
	uint16_t list[CORNERS];
};

static struct back_case make_case(uint32_t round)
{
	static const int reaches[] = {3000, 9000, 30000};
	struct back_case made = {
		.format = round & 1 ? PIXELS_RGBA8888 : PIXELS_RGB565,
		.textured = round & 2,
		.flat = round & 4,
		.positional = round & 8,
		.uneven = round & 16,
		.perspective = round & 32,
		.cut = round % 5 == 0,
		.reach = reaches[round % 3],
	};
	uint32_t seed = round + 1;

	random_corners_make(&seed, made.reach, made.pool, POOL);
	random_corners_list(&seed, POOL, made.list, CORNERS);
	return made;
}

static void set_state(struct gl *gl, const struct back_case *given)
{
	const GLfixed light[4] = {FX16_ONE, FX16_ONE / 2, FX16_ONE,
		given->positional ? FX16_ONE : 0};
	/* positions of 32768 become 1 */
	const GLfixed wide = FX16_ONE / 32768;

	gl->Lightxv(GL_LIGHT0, GL_POSITION, light);
	if (given->perspective) {
		gl->MatrixMode(GL_PROJECTION);
		gl->Frustumx(-FX16_ONE / 2, FX16_ONE / 2, -FX16_ONE / 2,
			FX16_ONE / 2, FX16_ONE, 4 * FX16_ONE);
		gl->MatrixMode(GL_MODELVIEW);
		gl->Translatex(0, 0, -FX16_ONE * 2);
	}
	gl->Scalex(wide, wide, given->uneven ? wide / 2 : wide);
	gl->Enable(GL_DEPTH_TEST);
	gl->Enable(GL_LIGHTING);
	gl->Enable(GL_LIGHT0);
	gl->Enable(GL_NORMALIZE);
	gl->Enable(GL_COLOR_MATERIAL);
	gl->LightModelx(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
	gl->ShadeModel(given->flat ? GL_FLAT : GL_SMOOTH);
	if (given->cut) {
		gl->Enable(GL_SCISSOR_TEST);
		gl->Scissor(GL_CANVAS_WIDTH / 4, GL_CANVAS_HEIGHT / 4,
			GL_CANVAS_WIDTH / 2, GL_CANVAS_HEIGHT / 2);
		gl->Viewport(-GL_CANVAS_WIDTH, -GL_CANVAS_HEIGHT,
			3 * GL_CANVAS_WIDTH, 3 * GL_CANVAS_HEIGHT);
	}
	if (given->textured) {
		gl_canvas_make_texture(gl);
	}
}

static void set_arrays(const struct gl *gl, const struct back_case *given)
{
	random_corners_set(gl, given->pool);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_NORMAL_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	if (given->textured) {
		gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	}
}

/* What is drawn after the front faces. */
enum second {
	NOTHING,
	BACK,
	/* The front faces lie at their own depths by then and change nothing. */
	BOTH,
};

static void draw_case(const struct back_case *given, enum second second,
	uint8_t picture[PICTURE_BYTES])
{
	struct gl_canvas canvas = gl_canvas_open("soft", given->format);
	struct gl *gl = canvas.gl;

	set_state(gl, given);
	set_arrays(gl, given);
	gl->Enable(GL_CULL_FACE);
	gl->CullFace(GL_BACK);
	gl->DrawElements(GL_TRIANGLES, CORNERS, GL_UNSIGNED_SHORT, given->list);
	gl->CullFace(GL_FRONT);
	(second == BACK ? gl->Enable : gl->Disable)(GL_CULL_FACE);
	gl->DrawElements(GL_TRIANGLES, second == NOTHING ? 0 : CORNERS,
		GL_UNSIGNED_SHORT, given->list);
	gl->ReadPixels(0, 0, GL_CANVAS_WIDTH, GL_CANVAS_HEIGHT, GL_RGBA,
		GL_UNSIGNED_BYTE, picture);
	gl_canvas_close(&canvas);
}

static void test_back_faces_alone_look_as_with_front_faces(void **state)
{
	static uint8_t alone[PICTURE_BYTES], both[PICTURE_BYTES];

	uint32_t seen = 0;

	(void)state;
	for (uint32_t round = 0; round < ROUNDS; round++) {
		const struct back_case given = make_case(round);
		const int most =
			given.format == PIXELS_RGB565 ? STEP_565 : STEP_8888;

		draw_case(&given, NOTHING, both);
		draw_case(&given, BACK, alone);
		seen += memcmp(alone, both, PICTURE_BYTES) != 0;
		draw_case(&given, BOTH, both);
		for (int i = 0; i < PICTURE_BYTES; i++) {
			if (abs(alone[i] - both[i]) > most) {
				fail_msg("round %u: %d, not %d, at %d,%d",
					round, alone[i], both[i],
					i / 4 % GL_CANVAS_WIDTH,
					i / 4 / GL_CANVAS_WIDTH);
			}
		}
	}
	assert_in_range(seen, ROUNDS * 3 / 4, ROUNDS);
}

/* A square of so many pixels around the middle, from its back. */
static void draw_back(struct gl *gl, int pixels)
{
	const float x = (float)pixels / GL_CANVAS_WIDTH;
	const float y = (float)pixels / GL_CANVAS_HEIGHT;
	const float corner[4][2] = {{-x, -y}, {-x, y}, {x, -y}, {x, y}};

	gl->CullFace(GL_FRONT);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(2, GL_FLOAT, 0, corner);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

/* Of equal depths LESS hides the later one, and LEQUAL shows it. */
static void test_back_faces_at_the_same_depth_follow_the_test(void **state)
{
	/* The largest ones leave the picture. */
	static const int sizes[] = {
		4, 12, GL_CANVAS_WIDTH / 2, 2 * GL_CANVAS_WIDTH};

	(void)state;
	for (int i = 0; i < 16; i++) {
		struct gl_canvas canvas = gl_canvas_open(
			"soft", i & 1 ? PIXELS_RGBA8888 : PIXELS_RGB565);
		struct gl *gl = canvas.gl;
		const bool equal = i & 2;

		gl->Enable(GL_DEPTH_TEST);
		gl->Enable(GL_CULL_FACE);
		gl->DepthFunc(equal ? GL_LEQUAL : GL_LESS);
		gl->Color4x(FX16_ONE, 0, 0, FX16_ONE);
		draw_back(gl, sizes[i / 4]);
		gl->Color4x(0, 0, FX16_ONE, FX16_ONE);
		draw_back(gl, sizes[i / 4]);
		gl_canvas_end_frame(&canvas);
		gl_canvas_expect(&canvas, GL_CANVAS_WIDTH / 2,
			GL_CANVAS_HEIGHT / 2, equal ? 0 : 255, 0,
			equal ? 255 : 0, 0);
		gl_canvas_close(&canvas);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_back_faces_alone_look_as_with_front_faces),
		cmocka_unit_test(
			test_back_faces_at_the_same_depth_follow_the_test),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
