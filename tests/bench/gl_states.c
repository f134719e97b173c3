/*
 * Scenes in the states that programs draw their models in: textures, filters,
 * blending, alpha test, fog, mipmaps; 480x640, 16-bit depth, LESS.
 *
 *	gl_states SCENE FRAMES [DRIVER [PICTURE.ppm [rgba]]]
 *
 * SCENE is one of those below; a number behind it (S1b-64) is the texture's
 * side instead of 256. S1, S2, S4 and S5 are a quad that fills the screen, the
 * same without a texture, a cube, and 500 small triangles; make_... says how
 * they look. The picture is RGB565 unless rgba follows. For the timing model
 * (tests/arm1136) the last frame is region 1.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/fixed.h"
#include "platform/gl/gl_context.h"
#include "tests/arm1136/marker.h"
#include "tests/bench/bench_picture.h"
#include "tests/bench/states_mesh.h"
#include "tests/support/random.h"

enum {
	SIDE_MOST = 1024,
	INTERPOLATE = 0x8575,
	SRC2_RGB = 0x8582,
};

enum {
	TEXTURED = 1,
	LINEAR = 2,
	BLENDED = 4,
	TESTED = 8,
	FOGGED = 16,
	MIPMAPS = 32,   /* the nearest of them */
	TRILINEAR = 64, /* with MIPMAPS: two of them */
	RGBA = 128,
	RGBA_4444 = 256,
	CLAMPED = 512,
	PLAIN = 1024, /* one colour */
	LEQUAL = 2048,
	REPLACED = 4096,
	SECOND = 8192,        /* a second texture, modulated */
	INTERPOLATED = 16384, /* by a combiner */
	ADDED = 32768,
	DECALED = 65536,
	ADDITIVE = 131072,  /* blended */
	STENCILED = 262144, /* counts fragments in the stencil */
};

struct scene {
	const char *name;
	enum states_shape shape;
	unsigned state;
	int side;
};

static const struct scene scenes[] = {
	{"S1a", STATES_QUAD, TEXTURED, 256},
	{"S1b", STATES_QUAD, TEXTURED | LINEAR, 256},
	{"S1ya", STATES_TURNED, TEXTURED, 256},
	{"S1yb", STATES_TURNED, TEXTURED | LINEAR, 256},
	{"S1c", STATES_QUAD, TEXTURED | LINEAR | CLAMPED, 256},
	{"S1r", STATES_QUAD, TEXTURED | LINEAR | REPLACED | PLAIN, 256},
	{"S1e", STATES_QUAD, TEXTURED | LINEAR | LEQUAL, 256},
	{"S2", STATES_QUAD, 0, 256},
	{"S2y", STATES_TURNED, 0, 256},
	{"count", STATES_QUAD, STENCILED, 256},
	{"blend-a", STATES_QUAD, TEXTURED | BLENDED | RGBA, 256},
	{"blend-b", STATES_QUAD, TEXTURED | LINEAR | BLENDED | RGBA, 256},
	{"blend4-a", STATES_QUAD, TEXTURED | BLENDED | RGBA_4444, 256},
	{"blend4-b", STATES_QUAD, TEXTURED | LINEAR | BLENDED | RGBA_4444, 256},
	{"S4a", STATES_CUBE, TEXTURED, 256},
	{"S4b", STATES_CUBE, TEXTURED | LINEAR, 256},
	{"S5a", STATES_SMALL, TEXTURED, 256},
	{"S5b", STATES_SMALL, TEXTURED | LINEAR, 256},
	{"S5s", STATES_SMALL_W, TEXTURED | LINEAR, 256},
	{"test-a", STATES_SMALL, TEXTURED | TESTED | RGBA, 256},
	{"test-b", STATES_SMALL, TEXTURED | LINEAR | TESTED | RGBA, 256},
	{"fog-a", STATES_SMALL, TEXTURED | FOGGED, 256},
	{"fog-b", STATES_SMALL, TEXTURED | LINEAR | FOGGED, 256},
	{"mip", STATES_LAYERS, TEXTURED | LINEAR | MIPMAPS, 256},
	{"mip2", STATES_LAYERS, TEXTURED | LINEAR | MIPMAPS | TRILINEAR, 256},
	{"two-a", STATES_QUAD, TEXTURED | SECOND, 256},
	{"two-b", STATES_QUAD, TEXTURED | LINEAR | SECOND, 256},
	{"inter-a", STATES_QUAD, TEXTURED | SECOND | INTERPOLATED, 256},
	{"inter-b", STATES_QUAD, TEXTURED | LINEAR | SECOND | INTERPOLATED, 256},
	{"add-b", STATES_QUAD, TEXTURED | LINEAR | ADDED, 256},
	{"decal-b", STATES_QUAD, TEXTURED | LINEAR | DECALED | RGBA, 256},
	{"glow-b", STATES_QUAD, TEXTURED | LINEAR | BLENDED | ADDITIVE, 256},
	{"still", STATES_BACKDROP, TEXTURED | LINEAR | PLAIN, 256},
};

static void set_texel(uint8_t *t, int x, int y, int side)
{
	bool differ = (x >> 5 & 1) != (y >> 5 & 1);

	t[0] = (uint8_t)(differ ? 230 : x);
	t[1] = (uint8_t)(differ ? y : 200);
	t[2] = (uint8_t)(differ ? 60 : 255 - x);
	/* A disc with a soft border in each square of 64. */
	x = x % 64 - 32;
	y = y % 64 - 32;
	x = 900 - x * x - y * y;
	t[3] = (uint8_t)(side < 64 ? 255 : x > 255 ? 255 : x < 0 ? 0 : x);
}

static void give_level(const struct gl *gl, unsigned state, int level, int side)
{
	static uint8_t texels[SIDE_MOST * SIDE_MOST * 4];
	bool alpha = state & (RGBA | RGBA_4444);
	uint8_t *out = texels;

	for (int i = 0; i < side * side; i++) {
		uint8_t t[4];

		set_texel(t, i % side << level, i / side << level, side);
		if (state & RGBA_4444) {
			uint16_t packed = (uint16_t)(t[0] >> 4 << 12 |
				t[1] >> 4 << 8 | t[2] >> 4 << 4 | t[3] >> 4);

			memcpy(out, &packed, 2);
			out += 2;
		} else {
			memcpy(out, t, 4);
			out += alpha ? 4 : 3;
		}
	}
	gl->TexImage2D(GL_TEXTURE_2D, level, alpha ? GL_RGBA : GL_RGB, side,
		side, 0, alpha ? GL_RGBA : GL_RGB,
		state & RGBA_4444 ? GL_UNSIGNED_SHORT_4_4_4_4 : GL_UNSIGNED_BYTE,
		texels);
}

static void make_texture(const struct gl *gl, unsigned state, int side)
{
	GLenum filter = state & LINEAR ? GL_LINEAR : GL_NEAREST;
	GLenum wrap = state & CLAMPED ? GL_CLAMP_TO_EDGE : GL_REPEAT;
	GLuint name;

	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, (GLfixed)filter);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, (GLfixed)wrap);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, (GLfixed)wrap);
	if (state & MIPMAPS) {
		filter = state & TRILINEAR ? GL_LINEAR_MIPMAP_LINEAR
					   : GL_LINEAR_MIPMAP_NEAREST;
	}
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, (GLfixed)filter);
	for (int level = 0; side >> level > 0; level++) {
		give_level(gl, state, level, side >> level);
	}
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
		state & REPLACED          ? GL_REPLACE
			: state & ADDED   ? GL_ADD
			: state & DECALED ? GL_DECAL
					  : GL_MODULATE);
	gl->Enable(GL_TEXTURE_2D);
}

/* The first texture once more, or what a combiner mixes it with. */
static void make_second(const struct gl *gl, unsigned state, int side)
{
	gl->ActiveTexture(GL_TEXTURE1);
	make_texture(gl, state, side);
	if (state & INTERPOLATED) {
		gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
		gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB, INTERPOLATE);
		gl->TexEnvx(GL_TEXTURE_ENV, SRC2_RGB, GL_PRIMARY_COLOR);
	}
	gl->ActiveTexture(GL_TEXTURE0);
}

static void set_arrays(const struct gl *gl, const struct scene *scene,
	const struct states_mesh *mesh)
{
	const struct states_vertex *v = mesh->vertex;

	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, sizeof(*v), v->position);
	if (scene->state & TEXTURED) {
		gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
		gl->TexCoordPointer(2, GL_FLOAT, sizeof(*v), v->texcoord);
	}
	if (scene->state & SECOND) {
		gl->ClientActiveTexture(GL_TEXTURE1);
		gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
		gl->TexCoordPointer(2, GL_FLOAT, sizeof(*v), v->texcoord);
	}
	if (scene->shape == STATES_CUBE) {
		gl->EnableClientState(GL_NORMAL_ARRAY);
		gl->NormalPointer(GL_FLOAT, sizeof(*v), v->normal);
	} else if (!(scene->state & PLAIN)) {
		gl->EnableClientState(GL_COLOR_ARRAY);
		gl->ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(*v), v->color);
	}
}

static void set_fragments(const struct gl *gl, unsigned state)
{
	static const GLfixed fog[4] = {
		FX16_ONE / 2, FX16_ONE / 2, FX16_ONE * 3 / 5, FX16_ONE};

	gl->Enable(GL_DEPTH_TEST);
	gl->DepthFunc(state & LEQUAL ? GL_LEQUAL : GL_LESS);
	gl->Disable(GL_DITHER);
	if (state & BLENDED) {
		gl->Enable(GL_BLEND);
		gl->BlendFunc(GL_SRC_ALPHA,
			state & ADDITIVE ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
	}
	if (state & STENCILED) {
		gl->Enable(GL_STENCIL_TEST);
		gl->StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
	}
	if (state & TESTED) {
		gl->Enable(GL_ALPHA_TEST);
		gl->AlphaFuncx(GL_GREATER, FX16_ONE / 2);
	}
	if (state & FOGGED) {
		gl->Enable(GL_FOG);
		gl->Fogx(GL_FOG_MODE, GL_LINEAR);
		gl->Fogx(GL_FOG_START, 3 * FX16_ONE);
		gl->Fogx(GL_FOG_END, 6 * FX16_ONE);
		gl->Fogxv(GL_FOG_COLOR, fog);
	}
}

static void set_up(const struct gl *gl, const struct scene *scene,
	const struct states_mesh *mesh)
{
	/* (1, 1, 2) / sqrt 6 */
	static const GLfixed towards[4] = {26755, 26755, 53510, 0};

	bench_picture_project(gl);
	if (scene->state & TEXTURED) {
		make_texture(gl, scene->state, scene->side);
	}
	if (scene->state & SECOND) {
		make_second(gl, scene->state, scene->side);
	}
	set_arrays(gl, scene, mesh);
	set_fragments(gl, scene->state);
	if (scene->shape == STATES_CUBE) {
		gl->Enable(GL_CULL_FACE);
		gl->Enable(GL_LIGHTING);
		gl->Enable(GL_LIGHT0);
		gl->Lightxv(GL_LIGHT0, GL_POSITION, towards);
	}
	gl->ClearColorx(
		FX16_ONE / 10, FX16_ONE / 5, FX16_ONE * 3 / 10, FX16_ONE);
}

static void draw_frame(const struct gl *gl, const struct scene *scene,
	const struct states_mesh *mesh, int frame)
{
	gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT |
		GL_STENCIL_BUFFER_BIT);
	if (scene->shape == STATES_CUBE) {
		gl->LoadIdentity();
		gl->Translatex(0, 0, fx16_from_float(-4.3f));
		gl->Rotatex(25 * FX16_ONE, FX16_ONE, 0, 0);
		gl->Rotatex((20 + 7 * frame) * FX16_ONE, 0, FX16_ONE, 0);
	}
	gl->DrawArrays(GL_TRIANGLES, 0, mesh->count);
}

static bool find_scene(const char *name, struct scene *out)
{
	size_t count = sizeof(scenes) / sizeof(scenes[0]);

	for (size_t i = 0; i < count; i++) {
		size_t length = strlen(scenes[i].name);

		if (strncmp(name, scenes[i].name, length) != 0) {
			continue;
		}
		*out = scenes[i];
		if (name[length] == '\0') {
			return true;
		}
		if (name[length] == '-' && atoi(name + length + 1) > 0) {
			out->side = atoi(name + length + 1);
			return out->side <= SIDE_MOST;
		}
	}
	return false;
}

static void draw_frames(struct gl_context *context, struct pixels *pixels,
	const struct scene *scene, int frames)
{
	static struct states_mesh mesh;

	states_mesh_make(&mesh, scene->shape);
	for (int frame = 0; frame < frames; frame++) {
		if (context->driver->begin_frame(context, pixels) != 0) {
			exit(EXIT_FAILURE);
		}
		if (frame == 0) {
			set_up(&context->gl, scene, &mesh);
		}
		if (frame == frames - 1) {
			MARKER_BEGIN(1);
		}
		draw_frame(&context->gl, scene, &mesh, frame);
		context->driver->end_frame(context);
		MARKER_END(1);
	}
}

int main(int argc, char **argv)
{
	struct log log = log_to_stderr(LOG_WARNING);
	enum pixel_format format = argc > 5 && strcmp(argv[5], "rgba") == 0
		? PIXELS_RGBA8888
		: PIXELS_RGB565;
	struct gl_context *context;
	struct pixels pixels;
	struct scene scene;

	if (argc < 3 || atoi(argv[2]) < 1 || !find_scene(argv[1], &scene)) {
		fprintf(stderr,
			"usage: %s SCENE FRAMES [DRIVER [PICTURE.ppm "
			"[rgba]]]\n",
			argv[0]);
		return 2;
	}
	if (pixels_alloc(&pixels, STATES_WIDTH, STATES_HEIGHT, format, &log) !=
			0 ||
		gl_open(argc > 3 ? argv[3] : "soft",
			&(struct gl_request){.format = format, .log = &log},
			&context) != 0) {
		return EXIT_FAILURE;
	}
	draw_frames(context, &pixels, &scene, atoi(argv[2]));
	if (argc > 4) {
		bench_picture_write(argv[4], &pixels);
	}
	context->driver->destroy(context);
	free(pixels.data);
	return EXIT_SUCCESS;
}
