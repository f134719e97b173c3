/*
 * What a draw call costs by what has changed since the last one:
 *
 *	gl_calls [lit] [tinted] [textured] CHANGE...
 *
 * For each CHANGE of changes[] below quads of 3x3 pixels are drawn: the first
 * two by a call each, then both by one call, and each call comes after the
 * change. Three regions that insn_count.so counts are the first call, the one
 * of both quads, and the change itself. So a call without its quad takes twice
 * the first less the second. With "tinted" the current colour is the material's.
 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/compiler.h"
#include "platform/base/fixed.h"
#include "platform/gl/gl_context.h"
#include "tests/arm1136/marker.h"
#include "tests/bench/bench_picture.h"

enum {
	WIDTH = 480,
	HEIGHT = 640,
	CORNERS = 8, /* of two quads */
};

struct corner {
	float position[3], normal[3], texcoord[2];
	uint8_t color[4];
};

struct bench {
	const struct gl *gl;
	struct corner corner[2][CORNERS]; /* the same twice */
	GLuint texture[2];
	int turn; /* counts changes */
};

static void change_nothing(struct bench *b)
{
	(void)b;
}

static void change_matrix(struct bench *b)
{
	GLfixed m[16] = {FX16_ONE, 0, 0, 0, 0, FX16_ONE, 0, 0, 0, 0, FX16_ONE,
		0, 0, 0, 0, FX16_ONE};

	m[12] = b->turn * 16;
	b->gl->LoadMatrixx(m);
}

static void change_color(struct bench *b)
{
	b->gl->Color4x(FX16_ONE, b->turn * 999, FX16_ONE / 2, FX16_ONE);
}

static void change_material(struct bench *b)
{
	const GLfixed color[4] = {FX16_ONE, b->turn * 999, 0, FX16_ONE};

	b->gl->Materialxv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, color);
}

static void change_texture(struct bench *b)
{
	b->gl->BindTexture(GL_TEXTURE_2D, b->texture[b->turn & 1]);
}

static void change_array(struct bench *b)
{
	const struct corner *corner = b->corner[b->turn & 1];
	const GLsizei stride = sizeof(*corner);

	b->gl->VertexPointer(3, GL_FLOAT, stride, corner->position);
	b->gl->NormalPointer(GL_FLOAT, stride, corner->normal);
	b->gl->TexCoordPointer(2, GL_FLOAT, stride, corner->texcoord);
}

static void change_part(struct bench *b)
{
	change_matrix(b);
	change_array(b);
	change_color(b);
}

static void change_blending(struct bench *b)
{
	b->gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

static void change_back(struct bench *b)
{
	b->gl->MatrixMode(GL_PROJECTION);
	b->gl->PushMatrix();
	b->gl->PopMatrix();
	b->gl->MatrixMode(GL_MODELVIEW);
}

static const struct {
	const char *name;
	void (*change)(struct bench *b);
} changes[] = {
	{"nothing", change_nothing},
	{"matrix", change_matrix},
	{"color", change_color},
	{"material", change_material},
	{"texture", change_texture},
	{"array", change_array},
	{"part", change_part}, /* matrix, arrays and colour */
	{"blending", change_blending},
	{"projection", change_back},
};

static void make_corners(struct corner *out)
{
	for (int i = 0; i < CORNERS; i++) {
		const int right = i % 4 == 1 || i % 4 == 2, up = i % 4 > 1;
		const int x = 20 + 10 * (i / 4) + 3 * right, y = 20 + 3 * up;

		out[i] = (struct corner){.position = {(float)x / 240 * 1.5f,
						 (float)y / 320 * 2, -4},
			.normal = {0, 0, 1},
			.texcoord = {(float)right / 16, (float)up / 16},
			.color = {200, 100, 50, 255}};
	}
}

static void make_textures(struct bench *b)
{
	static const uint16_t texels[64 * 64] = {0xFFFF, 0x1234};
	const struct gl *gl = b->gl;

	gl->GenTextures(2, b->texture);
	for (int i = 0; i < 2; i++) {
		gl->BindTexture(GL_TEXTURE_2D, b->texture[i]);
		gl->TexParameterx(
			GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
		gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB,
			GL_UNSIGNED_SHORT_5_6_5, texels);
	}
}

static void set_up(struct bench *b)
{
	const struct gl *gl = b->gl;
	const GLfixed direction[4] = {FX16_ONE, FX16_ONE, 2 * FX16_ONE, 0};

	for (int i = 0; i < 2; i++) {
		make_corners(b->corner[i]);
	}
	bench_picture_project(gl);
	make_textures(b);
	gl->Enable(GL_DEPTH_TEST);
	gl->DepthFunc(GL_LEQUAL);
	gl->Enable(GL_CULL_FACE);
	gl->Enable(GL_LIGHT0);
	gl->Lightxv(GL_LIGHT0, GL_POSITION, direction);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	change_array(b);
}

static NEVER_INLINE void draw(struct bench *b, int quads)
{
	static const uint16_t index[12] = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};

	MARKER_BEGIN(1);
	b->gl->DrawElements(GL_TRIANGLES, 6 * quads, GL_UNSIGNED_SHORT, index);
	MARKER_END(1);
}

static NEVER_INLINE void make_change(
	struct bench *b, void (*change)(struct bench *b))
{
	MARKER_BEGIN(1);
	change(b);
	MARKER_END(1);
}

/* Three regions; others before them warm the caches of the state. */
static void measure(struct bench *b, void (*change)(struct bench *b))
{
	for (int i = 0; i < 6; i++) {
		b->turn++;
		make_change(b, change);
		draw(b, 1 + i % 2);
	}
}

static bool set_word(struct bench *b, const char *word)
{
	if (strcmp(word, "lit") == 0) {
		b->gl->Enable(GL_LIGHTING);
		b->gl->EnableClientState(GL_NORMAL_ARRAY);
		return true;
	}
	if (strcmp(word, "tinted") == 0) {
		b->gl->Enable(GL_COLOR_MATERIAL);
		return true;
	}
	if (strcmp(word, "textured") == 0) {
		b->gl->Enable(GL_TEXTURE_2D);
		b->gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
		return true;
	}
	for (size_t i = 0; i < ARRAY_COUNT(changes); i++) {
		if (strcmp(word, changes[i].name) == 0) {
			measure(b, changes[i].change);
			return true;
		}
	}
	return false;
}

int main(int argc, char **argv)
{
	static struct bench bench;
	const struct log log = log_to_stderr(LOG_WARNING);
	struct gl_context *context;
	struct pixels pixels;

	if (pixels_alloc(&pixels, WIDTH, HEIGHT, PIXELS_RGB565, &log) != 0 ||
		gl_open("soft",
			&(struct gl_request){
				.format = pixels.format, .log = &log},
			&context) != 0 ||
		context->driver->begin_frame(context, &pixels) != 0) {
		return EXIT_FAILURE;
	}
	bench.gl = &context->gl;
	set_up(&bench);
	for (int i = 1; i < argc; i++) {
		if (!set_word(&bench, argv[i])) {
			fprintf(stderr, "gl_calls: cannot set %s\n", argv[i]);
			return EXIT_FAILURE;
		}
	}
	context->driver->end_frame(context);
	context->driver->destroy(context);
	free(pixels.data);
	return EXIT_SUCCESS;
}
