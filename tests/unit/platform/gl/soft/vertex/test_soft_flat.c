/*
 * The soft driver's flat shading: primitives in any state are those that smooth
 * shading draws of corners which all have the last corner's colour and normal.
 */
#include "platform/base/fixed.h"
#include "tests/support/gl/gl_checks.h"
#include "tests/support/gl/random_corners.h"

#include <string.h>

enum {
	POOL = 600, /* more than the vertex cache has slots */
	CORNERS = 900,
	EXPANDED = 3 * CORNERS,
	ROUNDS = 96,
	PICTURE_BYTES = 4 * GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT,
};

/* What a round draws, by bits of its number and by chance. */
struct flat_case {
	enum pixel_format format;
	GLenum mode;
	bool lit, two_sided, textured, fog, colors;
	int reach; /* how far apart corners are, 32767 is half the picture */
	struct random_corner pool[POOL];
	uint16_t list[CORNERS];
};

static const GLenum modes[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN,
	GL_LINES, GL_TRIANGLES, GL_TRIANGLES};

static struct flat_case make_case(uint32_t round)
{
	struct flat_case made = {
		.format = round & 1 ? PIXELS_RGBA8888 : PIXELS_RGB565,
		.lit = round & 2,
		.textured = round & 4,
		.two_sided = round & 8,
		.fog = round % 5 == 0,
		.colors = round % 7 < 4,
		.mode = modes[round % 6],
		.reach = round % 3 == 0  ? 9000
			: round % 3 == 1 ? 1500
					 : 300,
	};
	uint32_t seed = round + 1;

	random_corners_make(&seed, made.reach, made.pool, POOL);
	random_corners_list(&seed, POOL, made.list, CORNERS);
	return made;
}

static void set_state(struct gl *gl, const struct flat_case *given)
{
	static const GLfixed aslant[4] = {FX16_ONE, FX16_ONE, FX16_ONE, 0};

	gl->Scalex(2, 2, 2);
	gl->Enable(GL_DEPTH_TEST);
	if (given->lit) {
		gl->Enable(GL_LIGHTING);
		gl->Enable(GL_LIGHT0);
		gl->Enable(GL_NORMALIZE);
		gl->Enable(GL_COLOR_MATERIAL);
		gl->Lightxv(GL_LIGHT0, GL_POSITION, aslant);
		gl->LightModelx(GL_LIGHT_MODEL_TWO_SIDE, given->two_sided);
	} else if (given->two_sided) {
		gl->Enable(GL_CULL_FACE);
	}
	if (given->textured) {
		gl_canvas_make_texture(gl);
	}
	if (given->fog) {
		gl->Enable(GL_FOG);
		gl->Fogx(GL_FOG_MODE, GL_LINEAR);
		gl->Fogx(GL_FOG_START, -FX16_ONE);
		gl->Fogx(GL_FOG_END, FX16_ONE);
	}
}

static void set_arrays(const struct gl *gl, const struct flat_case *given,
	const struct random_corner *corner)
{
	random_corners_set(gl, corner);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	if (given->lit) {
		gl->EnableClientState(GL_NORMAL_ARRAY);
	}
	if (given->colors) {
		gl->EnableClientState(GL_COLOR_ARRAY);
	}
	if (given->textured) {
		gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	}
}

/* Which of the list's corners make the mode's i-th primitive; 0: no more. */
static int primitive_of(GLenum mode, int i, int at[3])
{
	int odd = i & 1;

	switch (mode) {
	case GL_LINES:
		at[0] = 2 * i;
		at[1] = 2 * i + 1;
		return at[1] < CORNERS ? 2 : 0;
	case GL_TRIANGLES:
		at[0] = 3 * i;
		at[1] = 3 * i + 1;
		at[2] = 3 * i + 2;
		break;
	case GL_TRIANGLE_STRIP:
		at[0] = i + odd;
		at[1] = i + 1 - odd;
		at[2] = i + 2;
		break;
	default:
		at[0] = 0;
		at[1] = i + 1;
		at[2] = i + 2;
		break;
	}
	return at[2] < CORNERS ? 3 : 0;
}

/* Each primitive's corners in one colour; returns how many there are. */
static int expand(
	const struct flat_case *given, struct random_corner expanded[EXPANDED])
{
	int count = 0, at[3], size;

	for (int i = 0; (size = primitive_of(given->mode, i, at)) > 0; i++) {
		const struct random_corner *last =
			&given->pool[given->list[at[size - 1]]];

		for (int j = 0; j < size; j++) {
			struct random_corner *corner = &expanded[count++];

			*corner = given->pool[given->list[at[j]]];
			memcpy(corner->normal, last->normal,
				sizeof(last->normal));
			memcpy(corner->color, last->color, sizeof(last->color));
		}
	}
	return count;
}

static void draw_case(const struct flat_case *given, bool flat, bool indexed,
	uint8_t picture[PICTURE_BYTES])
{
	static struct random_corner expanded[EXPANDED];
	struct gl_canvas canvas = gl_canvas_open("soft", given->format);
	struct gl *gl = canvas.gl;
	bool lines = given->mode == GL_LINES;
	int count = flat ? CORNERS : expand(given, expanded);

	for (int i = 0; flat && i < CORNERS; i++) {
		expanded[i] = given->pool[given->list[i]];
	}
	set_state(gl, given);
	set_arrays(gl, given, flat && indexed ? given->pool : expanded);
	gl->ShadeModel(flat ? GL_FLAT : GL_SMOOTH);
	if (flat && indexed) {
		gl->DrawElements(
			given->mode, count, GL_UNSIGNED_SHORT, given->list);
	} else if (flat) {
		gl->DrawArrays(given->mode, 0, count);
	} else {
		gl->DrawArrays(lines ? GL_LINES : GL_TRIANGLES, 0, count);
	}
	memset(picture, 0, PICTURE_BYTES);
	memcpy(picture, canvas.pixels.data,
		(size_t)canvas.pixels.stride_bytes * GL_CANVAS_HEIGHT);
	gl_canvas_close(&canvas);
}

static void test_flat_primitives_have_their_last_corners_color(void **state)
{
	static uint8_t flat[PICTURE_BYTES], smooth[PICTURE_BYTES];
	static uint8_t empty[PICTURE_BYTES];

	(void)state;
	for (uint32_t round = 0; round < ROUNDS; round++) {
		struct flat_case given = make_case(round);

		draw_case(&given, false, false, smooth);
		memset(empty, smooth[0], sizeof(empty));
		assert_memory_not_equal(smooth, empty, PICTURE_BYTES / 2);
		for (int indexed = 0; indexed < 2; indexed++) {
			draw_case(&given, true, indexed, flat);
			if (memcmp(flat, smooth, PICTURE_BYTES) != 0) {
				fail_msg("round %u, %s", round,
					indexed ? "with indices"
						: "without indices");
			}
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_flat_primitives_have_their_last_corners_color),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
