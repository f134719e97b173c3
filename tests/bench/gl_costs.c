/*
 * What a pixel costs in a state of OpenGL ES that is put together from words:
 *
 *	gl_costs [-f8888] [-d DRIVER] [-o PICTURE.ppm] STATE...
 *
 * A STATE is one argument, such as "bilinear 4444 blend size=25": words of
 * states[] below, and NAME=NUMBER of numbers[]. For each state a picture of
 * 480x640 is filled with turned quads twice; the second drawing is a region
 * that insn_count.so counts. A line tells how many pixels the quads cover. -o
 * writes the last picture. gl_costs.py makes a table.
 */
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
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
	QUADS_MOST = 4000,
	SIDE_MOST = 1024, /* of textures, as the driver has it */
	SIZE_MOST = 359,  /* of quads, whose corners lie in the picture */
	INTERPOLATE = 0x8575,
	SRC2_RGB = 0x8582,
};

struct vertex {
	float position[3], texcoord[2];
	uint8_t color[4];
	float normal[3];
};

/* What a state's numbers are. */
struct numbers {
	int size;          /* pixels, of a quad */
	int width, height; /* texels */
	int density;       /* texels on a hundred pixels */
	int spread;        /* of w, in percent */
	int turn;          /* of the quads, in degrees */
	int line;          /* pixels, width of lines */
};

struct cost {
	const struct gl *gl;
	struct numbers number;
	bool textured, second, colored, lit, keeps_depth;
	GLenum mode; /* GL_TRIANGLES; GL_POINTS and GL_LINES draw one a quad */
	GLenum format, type, min, mag, wrap_s, wrap_t;
	int texel_bytes;
};

static const struct {
	const char *name;
	size_t offset;
	int least, most;
} numbers[] = {
	{"size", offsetof(struct numbers, size), 1, SIZE_MOST},
	{"width", offsetof(struct numbers, width), 1, SIDE_MOST},
	{"height", offsetof(struct numbers, height), 1, SIDE_MOST},
	{"density", offsetof(struct numbers, density), 0, 100000},
	{"spread", offsetof(struct numbers, spread), 0, 150},
	{"turn", offsetof(struct numbers, turn), -360, 360},
	{"line", offsetof(struct numbers, line), 1, 64},
};

static void set_format(struct cost *c, GLenum format, GLenum type, int bytes)
{
	c->format = format;
	c->type = type;
	c->texel_bytes = bytes;
	c->textured = true;
}

static void blend(struct cost *c, GLenum source, GLenum destination)
{
	c->gl->Enable(GL_BLEND);
	c->gl->BlendFunc(source, destination);
}

static void depth(struct cost *c, GLenum function)
{
	c->gl->DepthFunc(function);
}

static void light(struct cost *c, GLfixed w)
{
	const GLfixed place[4] = {FX16_ONE, FX16_ONE, 2 * FX16_ONE, w};

	c->lit = true;
	c->gl->Enable(GL_LIGHTING);
	c->gl->Enable(GL_LIGHT0);
	c->gl->Lightxv(GL_LIGHT0, GL_POSITION, place);
	c->gl->Lightx(GL_LIGHT0, GL_LINEAR_ATTENUATION, FX16_ONE / 8);
	c->gl->Enable(GL_COLOR_MATERIAL);
}

static void environment(struct cost *c, GLenum mode)
{
	c->gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, (GLfixed)mode);
}

#define WORD(name, text)                       \
	static void set_##name(struct cost *c) \
	{                                      \
		text;                          \
	}

WORD(nearest, c->min = c->mag = GL_NEAREST; c->textured = true)
WORD(bilinear, c->min = c->mag = GL_LINEAR; c->textured = true)
WORD(unlike, c->min = GL_NEAREST; c->mag = GL_LINEAR; c->textured = true)
WORD(mipmaps,
	c->min = c->mag == GL_LINEAR ? GL_LINEAR_MIPMAP_NEAREST
				     : GL_NEAREST_MIPMAP_NEAREST)
WORD(trilinear,
	c->min = c->mag == GL_LINEAR ? GL_LINEAR_MIPMAP_LINEAR
				     : GL_NEAREST_MIPMAP_LINEAR)
WORD(rgb, set_format(c, GL_RGB, GL_UNSIGNED_BYTE, 3))
WORD(565, set_format(c, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 2))
WORD(4444, set_format(c, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 2))
WORD(5551, set_format(c, GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 2))
WORD(8888, set_format(c, GL_RGBA, GL_UNSIGNED_BYTE, 4))
WORD(l8, set_format(c, GL_LUMINANCE, GL_UNSIGNED_BYTE, 1))
WORD(a8, set_format(c, GL_ALPHA, GL_UNSIGNED_BYTE, 1))
WORD(la88, set_format(c, GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 2))
WORD(clamp, c->wrap_s = c->wrap_t = GL_CLAMP_TO_EDGE)
WORD(second, c->second = c->textured = true)
WORD(white, c->colored = false)
WORD(flat, c->gl->ShadeModel(GL_FLAT))
WORD(replace, environment(c, GL_REPLACE))
WORD(add, environment(c, GL_ADD))
WORD(decal, environment(c, GL_DECAL))
WORD(blendenv, environment(c, GL_BLEND))
WORD(combine, environment(c, GL_COMBINE))
WORD(interpolate, environment(c, GL_COMBINE);
	c->gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB, INTERPOLATE);
	c->gl->TexEnvx(GL_TEXTURE_ENV, SRC2_RGB, GL_PRIMARY_COLOR))
WORD(dot3, environment(c, GL_COMBINE);
	c->gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB))
WORD(blend, blend(c, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA))
WORD(glow, blend(c, GL_SRC_ALPHA, GL_ONE))
WORD(sum, blend(c, GL_ONE, GL_ONE))
WORD(premultiplied, blend(c, GL_ONE, GL_ONE_MINUS_SRC_ALPHA))
WORD(multiply, blend(c, GL_DST_COLOR, GL_ZERO))
WORD(alphatest, c->gl->Enable(GL_ALPHA_TEST);
	c->gl->AlphaFuncx(GL_GREATER, FX16_ONE / 2))
WORD(fog, c->gl->Enable(GL_FOG))
WORD(sun, light(c, 0))
WORD(lamp, light(c, FX16_ONE))
WORD(twosided, c->gl->LightModelx(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE))
WORD(nodepth, c->gl->Disable(GL_DEPTH_TEST))
WORD(keepdepth, c->keeps_depth = true)
WORD(lequal, depth(c, GL_LEQUAL))
WORD(always, depth(c, GL_ALWAYS))
WORD(gequal, depth(c, GL_GEQUAL); c->gl->ClearDepthx(0))
WORD(equal, depth(c, GL_EQUAL))
WORD(notequal, depth(c, GL_NOTEQUAL))
WORD(stencil, c->gl->Enable(GL_STENCIL_TEST);
	c->gl->StencilFunc(GL_EQUAL, 0, 255))
WORD(count, c->gl->Enable(GL_STENCIL_TEST);
	c->gl->StencilOp(GL_KEEP, GL_KEEP, GL_INCR))
WORD(mask, c->gl->ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE))
WORD(offset, c->gl->Enable(GL_POLYGON_OFFSET_FILL);
	c->gl->PolygonOffsetx(FX16_ONE, FX16_ONE))
WORD(points, c->mode = GL_POINTS)
WORD(lines, c->mode = GL_LINES)
WORD(smooth, c->gl->Enable(GL_POINT_SMOOTH); c->gl->Enable(GL_LINE_SMOOTH))
WORD(scissor, c->gl->Enable(GL_SCISSOR_TEST);
	c->gl->Scissor(1, 1, WIDTH - 2, HEIGHT - 2))

#undef WORD

static const struct {
	const char *name;
	void (*set)(struct cost *c);
} states[] = {
#define WORD(name) {#name, set_##name},
	WORD(nearest) WORD(bilinear) WORD(unlike) WORD(mipmaps) WORD(trilinear) WORD(
		rgb) WORD(565) WORD(4444) WORD(5551) WORD(8888) WORD(l8)
		WORD(a8) WORD(la88) WORD(clamp) WORD(second) WORD(white) WORD(
			flat) WORD(replace) WORD(add) WORD(decal) WORD(blendenv)
			WORD(combine) WORD(interpolate) WORD(dot3) WORD(sun) WORD(
				lamp) WORD(twosided) WORD(blend) WORD(glow)
				WORD(sum) WORD(premultiplied) WORD(multiply) WORD(
					alphatest) WORD(fog) WORD(nodepth)
					WORD(keepdepth) WORD(lequal) WORD(
						always) WORD(gequal) WORD(equal)
						WORD(notequal) WORD(stencil) WORD(
							count) WORD(mask)
							WORD(scissor) WORD(
								offset) WORD(points)
								WORD(lines) WORD(
									smooth)
#undef WORD
};

static bool set_word(struct cost *c, const char *word)
{
	for (size_t i = 0; i < sizeof(states) / sizeof(states[0]); i++) {
		if (strcmp(word, states[i].name) == 0) {
			states[i].set(c);
			return true;
		}
	}
	for (size_t i = 0; i < sizeof(numbers) / sizeof(numbers[0]); i++) {
		size_t length = strlen(numbers[i].name);

		if (strncmp(word, numbers[i].name, length) == 0 &&
			word[length] == '=') {
			int value = atoi(word + length + 1);

			if (value < numbers[i].least || value > numbers[i].most) {
				fprintf(stderr,
					"gl_costs: %s has to be %d to %d\n",
					numbers[i].name, numbers[i].least,
					numbers[i].most);
				return false;
			}
			memcpy((char *)&c->number + numbers[i].offset, &value,
				sizeof(value));
			return true;
		}
	}
	return false;
}

/* A checker board whose alpha changes across a texture. */
static void fill_texels(
	const struct cost *c, uint8_t *out, int width, int height)
{
	for (int i = 0; i < width * height; i++) {
		int x = i % width, y = i / width;
		uint8_t t[4] = {(uint8_t)((x ^ y) * 8), (uint8_t)(y * 3),
			(uint8_t)(x & 8 ? 200 : 60), (uint8_t)(x * 4 + y)};

		if (c->texel_bytes == 2) {
			t[0] ^= t[1];
			t[1] ^= t[3];
		}
		memcpy(out + i * c->texel_bytes, t, (size_t)c->texel_bytes);
	}
}

static void make_texture(const struct cost *c)
{
	static uint8_t texels[SIDE_MOST * SIDE_MOST * 4];
	const struct gl *gl = c->gl;
	int width = c->number.width, height = c->number.height;
	GLuint name;

	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, (GLfixed)c->mag);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, (GLfixed)c->min);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, (GLfixed)c->wrap_s);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, (GLfixed)c->wrap_t);
	for (int level = 0;; level++) {
		fill_texels(c, texels, width, height);
		gl->TexImage2D(GL_TEXTURE_2D, level, (GLint)c->format, width,
			height, 0, c->format, c->type, texels);
		if (width == 1 && height == 1) {
			break;
		}
		width = width > 1 ? width / 2 : 1;
		height = height > 1 ? height / 2 : 1;
	}
	gl->Enable(GL_TEXTURE_2D);
}

static void make_corner(const struct cost *c, const double middle[2],
	const double at[2], uint32_t *seed, struct vertex *out)
{
	const double angle = c->number.turn * 3.14159265358979 / 180;
	const int spread = c->number.spread * 50;
	double depth = 4 + 4 * random_between(seed, -spread, spread) / 1e4;
	double half = c->number.size / 2.0;
	double x = middle[0] + half * (at[0] * cos(angle) - at[1] * sin(angle));
	double y = middle[1] + half * (at[0] * sin(angle) + at[1] * cos(angle));
	double texels = half * c->number.density / 100;

	out->position[0] = (float)((x / (WIDTH / 2) - 1) * 0.375 * depth);
	out->position[1] = (float)((1 - y / (HEIGHT / 2)) * 0.5 * depth);
	out->position[2] = (float)-depth;
	memcpy(out->normal, (const float[]){0, 0, 1}, sizeof(out->normal));
	out->texcoord[0] =
		(float)((middle[0] + at[0] * texels) / c->number.width);
	out->texcoord[1] =
		(float)((middle[1] + at[1] * texels) / c->number.height);
	for (int i = 0; i < 4; i++) {
		out->color[i] = (uint8_t)random_between(seed, 100, 255);
	}
}

/* Vertices of a quad, of its top side, or of a point. */
static int count_corners(const struct cost *c)
{
	return c->mode == GL_POINTS ? 1 : c->mode == GL_LINES ? 2 : 6;
}

/* Quads beside each other; returns how many vertices. */
static int make_quads(const struct cost *c, struct vertex *out)
{
	static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
	static const int order[6] = {0, 1, 2, 0, 2, 3};
	const int each = count_corners(c);
	const int pitch = c->number.size * 4 / 3 + 1;
	struct vertex of[4];
	uint32_t seed = 7;
	int count = 0;

	for (int y = pitch / 2; y + pitch / 2 <= HEIGHT; y += pitch) {
		for (int x = pitch / 2;
			x + pitch / 2 <= WIDTH && count < QUADS_MOST * 6;
			x += pitch) {
			/* Quads do not lie on the same places of pixels. */
			const double middle[2] = {
				x + random_between(&seed, 0, 99) / 100.0,
				y + random_between(&seed, 0, 99) / 100.0};

			for (int i = 0; i < 4; i++) {
				make_corner(c, middle, corner[i], &seed, &of[i]);
			}
			for (int i = 0; i < each; i++) {
				out[count++] = of[order[i]];
			}
		}
	}
	return count;
}

static void give_coordinates(
	const struct cost *c, GLenum unit, const struct vertex *v)
{
	c->gl->ClientActiveTexture(unit);
	c->gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	c->gl->TexCoordPointer(2, GL_FLOAT, sizeof(*v), v->texcoord);
}

static void give_arrays(const struct cost *c, const struct vertex *v)
{
	const struct gl *gl = c->gl;

	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, sizeof(*v), v->position);
	if (c->lit) {
		gl->EnableClientState(GL_NORMAL_ARRAY);
		gl->NormalPointer(GL_FLOAT, sizeof(*v), v->normal);
	}
	if (c->colored) {
		gl->EnableClientState(GL_COLOR_ARRAY);
		gl->ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(*v), v->color);
	}
	if (c->textured) {
		give_coordinates(c, GL_TEXTURE0, v);
		make_texture(c);
	}
	if (c->second) {
		gl->ActiveTexture(GL_TEXTURE1);
		give_coordinates(c, GL_TEXTURE1, v);
		make_texture(c);
		gl->ActiveTexture(GL_TEXTURE0);
	}
}

static void set_defaults(const struct gl *gl)
{
	bench_picture_project(gl);
	gl->Enable(GL_DEPTH_TEST);
	gl->DepthFunc(GL_LESS);
	gl->Disable(GL_DITHER);
	gl->Fogx(GL_FOG_MODE, GL_LINEAR);
	gl->Fogx(GL_FOG_START, 3 * FX16_ONE);
	gl->Fogx(GL_FOG_END, 6 * FX16_ONE);
	gl->ClearColorx(
		FX16_ONE / 10, FX16_ONE / 5, FX16_ONE * 3 / 10, FX16_ONE);
}

static bool set_state(struct cost *c, const char *text)
{
	char words[256];

	*c = (struct cost){.gl = c->gl,
		.number = {60, 64, 64, 90, 0, 20, 1},
		.mode = GL_TRIANGLES,
		.colored = true,
		.format = GL_RGB,
		.type = GL_UNSIGNED_BYTE,
		.texel_bytes = 3,
		.min = GL_NEAREST,
		.mag = GL_NEAREST,
		.wrap_s = GL_REPEAT,
		.wrap_t = GL_REPEAT};
	snprintf(words, sizeof(words), "%s", text);
	for (char *word = strtok(words, " "); word; word = strtok(NULL, " ")) {
		if (!set_word(c, word)) {
			fprintf(stderr, "gl_costs: cannot set %s\n", word);
			return false;
		}
	}
	return true;
}

static NEVER_INLINE void draw(const struct gl *gl, GLenum mode, int count)
{
	MARKER_BEGIN(1);
	gl->DrawArrays(mode, 0, count);
	MARKER_END(1);
}

static bool measure(const char *driver, const char *text, struct pixels *pixels)
{
	static struct vertex vertex[QUADS_MOST * 6];
	const struct log log = log_to_stderr(LOG_WARNING);
	struct gl_context *context;
	struct cost cost;
	int count;

	if (gl_open(driver,
		    &(struct gl_request){.format = pixels->format, .log = &log},
		    &context) != 0 ||
		context->driver->begin_frame(context, pixels) != 0) {
		return false;
	}
	cost.gl = &context->gl;
	set_defaults(cost.gl);
	if (!set_state(&cost, text)) {
		return false;
	}
	give_arrays(&cost, vertex);
	count = make_quads(&cost, vertex);
	cost.gl->PointSizex(cost.number.size * FX16_ONE);
	cost.gl->LineWidthx(cost.number.line * FX16_ONE);
	for (int i = 0; i < 2; i++) {
		cost.gl->DepthMask(GL_TRUE);
		cost.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT |
			GL_STENCIL_BUFFER_BIT);
		cost.gl->DepthMask(!cost.keeps_depth);
		if (i == 0) {
			cost.gl->DrawArrays(cost.mode, 0, count);
		} else {
			draw(cost.gl, cost.mode, count);
		}
	}
	context->driver->end_frame(context);
	context->driver->destroy(context);
	printf("%d %s\n",
		count / count_corners(&cost) * cost.number.size *
			(cost.mode == GL_LINES ? cost.number.line
					       : cost.number.size),
		text);
	return true;
}

int main(int argc, char **argv)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	enum pixel_format format = PIXELS_RGB565;
	const char *driver = "soft", *picture = NULL;
	struct pixels pixels;
	int i = 1;

	for (; i < argc && argv[i][0] == '-'; i++) {
		if (strcmp(argv[i], "-f8888") == 0) {
			format = PIXELS_RGBA8888;
		} else if (strcmp(argv[i], "-d") == 0 && i + 1 < argc) {
			driver = argv[++i];
		} else if (strcmp(argv[i], "-o") == 0 && i + 1 < argc) {
			picture = argv[++i];
		}
	}
	if (pixels_alloc(&pixels, WIDTH, HEIGHT, format, &log) != 0) {
		return EXIT_FAILURE;
	}
	for (; i < argc; i++) {
		if (!measure(driver, argv[i], &pixels)) {
			return EXIT_FAILURE;
		}
	}
	if (picture) {
		bench_picture_write(picture, &pixels);
	}
	free(pixels.data);
	return EXIT_SUCCESS;
}
