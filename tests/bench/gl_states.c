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
#include "tests/support/random.h"

enum {
	WIDTH = 480,
	HEIGHT = 640,
	SIDE_MOST = 1024,
	CELLS = 500,
	VERTICES_MOST = CELLS * 3,
	INTERPOLATE = 0x8575,
	SRC2_RGB = 0x8582,
};

enum shape {
	QUAD,     /* S1, S2 */
	TURNED,   /* S1 turned about Y as well */
	CUBE,     /* S4 */
	SMALL,    /* S5: w differs by 5 % at most */
	SMALL_W,  /* S5s: by 0.15 of depth 4 */
	LAYERS,   /* 60 triangles of 120 x 120 */
	BACKDROP, /* a quad that faces the eye, all of the screen */
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
	ADDITIVE = 131072, /* blended */
};

struct scene {
	const char *name;
	enum shape shape;
	unsigned state;
	int side;
};

static const struct scene scenes[] = {
	{"S1a", QUAD, TEXTURED, 256},
	{"S1b", QUAD, TEXTURED | LINEAR, 256},
	{"S1ya", TURNED, TEXTURED, 256},
	{"S1yb", TURNED, TEXTURED | LINEAR, 256},
	{"S1c", QUAD, TEXTURED | LINEAR | CLAMPED, 256},
	{"S1r", QUAD, TEXTURED | LINEAR | REPLACED | PLAIN, 256},
	{"S1e", QUAD, TEXTURED | LINEAR | LEQUAL, 256},
	{"S2", QUAD, 0, 256},
	{"S2y", TURNED, 0, 256},
	{"blend-a", QUAD, TEXTURED | BLENDED | RGBA, 256},
	{"blend-b", QUAD, TEXTURED | LINEAR | BLENDED | RGBA, 256},
	{"blend4-a", QUAD, TEXTURED | BLENDED | RGBA_4444, 256},
	{"blend4-b", QUAD, TEXTURED | LINEAR | BLENDED | RGBA_4444, 256},
	{"S4a", CUBE, TEXTURED, 256},
	{"S4b", CUBE, TEXTURED | LINEAR, 256},
	{"S5a", SMALL, TEXTURED, 256},
	{"S5b", SMALL, TEXTURED | LINEAR, 256},
	{"S5s", SMALL_W, TEXTURED | LINEAR, 256},
	{"test-a", SMALL, TEXTURED | TESTED | RGBA, 256},
	{"test-b", SMALL, TEXTURED | LINEAR | TESTED | RGBA, 256},
	{"fog-a", SMALL, TEXTURED | FOGGED, 256},
	{"fog-b", SMALL, TEXTURED | LINEAR | FOGGED, 256},
	{"mip", LAYERS, TEXTURED | LINEAR | MIPMAPS, 256},
	{"mip2", LAYERS, TEXTURED | LINEAR | MIPMAPS | TRILINEAR, 256},
	{"two-a", QUAD, TEXTURED | SECOND, 256},
	{"two-b", QUAD, TEXTURED | LINEAR | SECOND, 256},
	{"inter-a", QUAD, TEXTURED | SECOND | INTERPOLATED, 256},
	{"inter-b", QUAD, TEXTURED | LINEAR | SECOND | INTERPOLATED, 256},
	{"add-b", QUAD, TEXTURED | LINEAR | ADDED, 256},
	{"decal-b", QUAD, TEXTURED | LINEAR | DECALED | RGBA, 256},
	{"glow-b", QUAD, TEXTURED | LINEAR | BLENDED | ADDITIVE, 256},
	{"still", BACKDROP, TEXTURED | LINEAR | PLAIN, 256},
};

struct vertex {
	float position[3], normal[3], texcoord[2];
	uint8_t color[4];
};

struct mesh {
	struct vertex vertex[VERTICES_MOST];
	int count;
};

static uint8_t to_byte(double value)
{
	return (uint8_t)(value * 255.0 + 0.5);
}

static void set_color(struct vertex *v, const double color[3])
{
	for (int i = 0; i < 3; i++) {
		v->color[i] = to_byte(color[i]);
	}
	v->color[3] = 255;
}

static const double turn_x = 40.0 * 3.14159265358979 / 180.0;
static const double turn_y = 20.0 * 3.14159265358979 / 180.0;

/* Where the ray through a corner of the screen meets the plane. */
static void cut_plane(struct vertex *v, double x, double y, bool turned)
{
	double normal[3] = {0.0, -sin(turn_x), cos(turn_x)};
	double right[3] = {1.0, 0.0, 0.0},
	       up[3] = {0.0, cos(turn_x), sin(turn_x)};
	double ray[3] = {0.375 * x, 0.5 * y, -1.0}, t, s = 0.0, r = 0.0;

	if (turned) {
		right[0] = cos(turn_y);
		right[2] = -sin(turn_y);
		normal[0] = sin(turn_y) * cos(turn_x);
		normal[2] = cos(turn_y) * cos(turn_x);
		up[0] = sin(turn_y) * sin(turn_x);
		up[2] = cos(turn_y) * sin(turn_x);
	}
	t = -3.0 * normal[2] /
		(ray[0] * normal[0] + ray[1] * normal[1] + ray[2] * normal[2]);
	for (int i = 0; i < 3; i++) {
		double at = ray[i] * t - (i == 2 ? -3.0 : 0.0);

		v->position[i] = (float)(ray[i] * t);
		s += at * right[i];
		r += at * up[i];
	}
	v->texcoord[0] = (float)(0.833 * s);
	v->texcoord[1] = (float)(0.833 * r);
}

/*
 * The quad that the corners of the screen, times 0.9995, cut from the plane
 * through (0, 0, -3) turned 40 degrees about X.
 */
static void make_quad(struct mesh *mesh, bool turned)
{
	static const double at[6][2] = {
		{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
	static const double color[6][3] = {{1.0, 0.6, 0.5}, {0.5, 1.0, 0.6},
		{0.9, 0.4, 1.0}, {1.0, 0.6, 0.5}, {0.9, 0.4, 1.0},
		{0.7, 0.9, 0.3}};

	mesh->count = 6;
	for (int i = 0; i < 6; i++) {
		cut_plane(&mesh->vertex[i], at[i][0] * 0.9995,
			at[i][1] * 0.9995, turned);
		set_color(&mesh->vertex[i], color[i]);
	}
}

static void make_backdrop(struct mesh *mesh)
{
	static const float at[6][2] = {
		{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};

	mesh->count = 6;
	for (int i = 0; i < 6; i++) {
		struct vertex *v = &mesh->vertex[i];

		v->position[0] = at[i][0] * 3.0f * 0.375f;
		v->position[1] = at[i][1] * 3.0f * 0.5f;
		v->position[2] = -3.0f;
		v->texcoord[0] = at[i][0] * 0.5f + 0.5f;
		v->texcoord[1] = at[i][1] * 0.5f + 0.5f;
	}
}

/* From -1 to 1, each face all of the texture. */
static void make_cube(struct mesh *mesh)
{
	static const float corner[6][2] = {
		{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};

	mesh->count = 36;
	for (int i = 0; i < 36; i++) {
		struct vertex *v = &mesh->vertex[i];
		int axis = i / 12, side = i / 6 % 2 ? 1 : -1;
		float s = corner[i % 6][0], t = corner[i % 6][1];

		v->position[axis] = (float)side;
		v->position[(axis + 1) % 3] = s * (float)side;
		v->position[(axis + 2) % 3] = t;
		v->normal[axis] = (float)side;
		v->texcoord[0] = s * 0.5f + 0.5f;
		v->texcoord[1] = t * 0.5f + 0.5f;
	}
}

static double between(uint32_t *seed, double low, double high)
{
	return low + (high - low) * random_between(seed, 0, 10000) / 10000.0;
}

/* From pixels at a depth to eye coordinates. */
static void place(struct vertex *v, double x, double y, double depth)
{
	v->position[0] = (float)((x / (WIDTH / 2) - 1.0) * 0.375 * depth);
	v->position[1] = (float)((1.0 - y / (HEIGHT / 2)) * 0.5 * depth);
	v->position[2] = (float)-depth;
}

static void make_triangle(struct vertex *v, const double cell[4],
	const bool mirror[2], double depth, double spread, double texels,
	uint32_t *seed)
{
	static const double corner[3][2] = {{0, 0}, {0.98, 0.12}, {0.32, 1}};
	double s = between(seed, 0, 1), t = between(seed, 0, 1);

	for (int k = 0; k < 3; k++) {
		double x = mirror[0] ? 1 - corner[k][0] : corner[k][0];
		double y = mirror[1] ? 1 - corner[k][1] : corner[k][1];
		double color[3];

		place(&v[k], cell[0] + x * cell[2], cell[1] + y * cell[3],
			k == 0 ? depth : depth + between(seed, -spread, spread));
		v[k].texcoord[0] = (float)(s + corner[k][0] * texels);
		v[k].texcoord[1] = (float)(t + corner[k][1] * texels);
		for (int i = 0; i < 3; i++) {
			color[i] = between(seed, 0.4, 1);
		}
		set_color(&v[k], color);
	}
}

/* A grid of 20 x 25 cells. */
static void make_small(struct mesh *mesh, double spread)
{
	uint32_t seed = 5;

	mesh->count = CELLS * 3;
	for (int i = 0; i < CELLS; i++) {
		double depth = between(&seed, 4, 4.3);
		const double cell[4] = {i % 20 * 24.0, i / 20 * 25.6, 24, 25.6};
		const bool mirror[2] = {i % 2, i / 20 % 2};

		make_triangle(&mesh->vertex[3 * i], cell, mirror, depth,
			spread > 0 ? spread : depth * 0.05, 28.0 / 256.0, &seed);
	}
}

/* Three layers of 4 x 5 cells, the nearest last; two texels a pixel. */
static void make_layers(struct mesh *mesh)
{
	uint32_t seed = 7;

	mesh->count = 180;
	for (int i = 0; i < 60; i++) {
		double depth = 5.0 - i / 20 * 0.5;
		const double cell[4] = {
			i % 4 * 120.0, i / 4 % 5 * 126.0, 120, 120};
		const bool mirror[2] = {i % 2, i / 4 % 2};

		make_triangle(&mesh->vertex[3 * i], cell, mirror, depth, 0.1,
			240.0 / 256.0, &seed);
	}
}

static void make_mesh(struct mesh *mesh, enum shape shape)
{
	switch (shape) {
	case QUAD:
	case TURNED:
		make_quad(mesh, shape == TURNED);
		break;
	case CUBE:
		make_cube(mesh);
		break;
	case SMALL:
	case SMALL_W:
		make_small(mesh, shape == SMALL_W ? 0.15 : 0.0);
		break;
	case LAYERS:
		make_layers(mesh);
		break;
	default:
		make_backdrop(mesh);
		break;
	}
}

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

static void set_arrays(
	const struct gl *gl, const struct scene *scene, const struct mesh *mesh)
{
	const struct vertex *v = mesh->vertex;

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
	if (scene->shape == CUBE) {
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

static void set_up(
	const struct gl *gl, const struct scene *scene, const struct mesh *mesh)
{
	/* (1, 1, 2) / sqrt 6 */
	static const GLfixed towards[4] = {26755, 26755, 53510, 0};

	gl->MatrixMode(GL_PROJECTION);
	gl->LoadIdentity();
	gl->Frustumx(-FX16_ONE * 3 / 8, FX16_ONE * 3 / 8, -FX16_ONE / 2,
		FX16_ONE / 2, FX16_ONE, 10 * FX16_ONE);
	gl->MatrixMode(GL_MODELVIEW);
	gl->LoadIdentity();
	if (scene->state & TEXTURED) {
		make_texture(gl, scene->state, scene->side);
	}
	if (scene->state & SECOND) {
		make_second(gl, scene->state, scene->side);
	}
	set_arrays(gl, scene, mesh);
	set_fragments(gl, scene->state);
	if (scene->shape == CUBE) {
		gl->Enable(GL_CULL_FACE);
		gl->Enable(GL_LIGHTING);
		gl->Enable(GL_LIGHT0);
		gl->Lightxv(GL_LIGHT0, GL_POSITION, towards);
	}
	gl->ClearColorx(
		FX16_ONE / 10, FX16_ONE / 5, FX16_ONE * 3 / 10, FX16_ONE);
}

static void draw_frame(const struct gl *gl, const struct scene *scene,
	const struct mesh *mesh, int frame)
{
	gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	if (scene->shape == CUBE) {
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
	static struct mesh mesh;

	make_mesh(&mesh, scene->shape);
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
	if (pixels_alloc(&pixels, WIDTH, HEIGHT, format, &log) != 0 ||
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
