#include "tests/support/soft/span_random.h"

#include "tests/support/random.h"

enum {
	SIDE_MOST = 256,
};

/* A format, and how many bytes of it a texel takes. */
static const struct texel_case {
	GLenum format, type;
	int bytes;
} texels[SPAN_TEXELS] = {
	{GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 2},
	{GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 2},
	{GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 2},
	{GL_RGBA, GL_UNSIGNED_BYTE, 4},
	{GL_LUMINANCE, GL_UNSIGNED_BYTE, 1},
	{GL_ALPHA, GL_UNSIGNED_BYTE, 1},
	{GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 2},
	{GL_RGB, GL_UNSIGNED_BYTE, 3},
};

GLenum span_one_of(uint32_t *seed, const GLenum *values, int count)
{
	return values[random_between(seed, 0, count - 1)];
}

void span_give_texels(
	const struct gl *gl, uint32_t *seed, int format, uint32_t flip)
{
	const struct texel_case *texel = &texels[format];
	static uint8_t bytes[SIDE_MOST * SIDE_MOST * 4];
	static const GLenum min[] = {GL_NEAREST, GL_LINEAR,
		GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST,
		GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR};
	static const GLenum mag[] = {GL_NEAREST, GL_LINEAR};
	static const GLenum wrap[] = {GL_REPEAT, GL_CLAMP_TO_EDGE};
	int width = 1 << random_between(seed, 0, 8);
	int height = 1 << random_between(seed, 0, 8);
	GLuint name;

	for (size_t i = 0; i < sizeof(bytes); i++) {
		bytes[i] = (uint8_t)(next_random(seed) ^ flip);
	}
	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
		(GLfixed)span_one_of(seed, min, 6));
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
		(GLfixed)span_one_of(seed, mag, 2));
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S,
		(GLfixed)span_one_of(seed, wrap, 2));
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T,
		(GLfixed)span_one_of(seed, wrap, 2));
	for (int level = 0;; level++) {
		gl->TexImage2D(GL_TEXTURE_2D, level, (GLint)texel->format,
			width, height, 0, texel->format, texel->type, bytes);
		if (width == 1 && height == 1) {
			break;
		}
		width = width > 1 ? width / 2 : 1;
		height = height > 1 ? height / 2 : 1;
	}
	gl->Enable(GL_TEXTURE_2D);
}

void span_give_texture(const struct gl *gl, uint32_t *seed)
{
	span_give_texels(gl, seed, random_between(seed, 0, SPAN_TEXELS - 1), 0);
}

const struct span_corner *span_make_triangle(uint32_t *seed)
{
	static struct span_corner corner[3];
	static const int sizes[] = {3, 8, 30, 120, 400};
	int size = sizes[random_between(seed, 0, 4)];
	int bend = random_between(seed, 0, 2) * 40;
	int texels_wide = random_between(seed, 1, 30);
	bool one_color = random_one_in(seed, 4);

	for (int i = 0; i < 3; i++) {
		struct span_corner *c = &corner[i];
		float depth = 4.0f +
			(float)random_between(seed, -bend, bend) / 100.0f;
		float x = (float)random_between(seed, -80, 80);
		float y = (float)random_between(seed, -80, 80);

		if (i % 3 != 0) {
			const float *first = corner[i / 3 * 3].position;

			x = first[0] * 50.0f +
				(float)random_between(seed, -size, size);
			y = first[1] * 50.0f +
				(float)random_between(seed, -size, size);
		}
		c->position[0] = x / 50.0f;
		c->position[1] = y / 50.0f;
		c->position[2] = -depth;
		for (int k = 0; k < 4; k++) {
			c->color[k] = (uint8_t)(one_color
					? 200
					: random_between(seed, 0, 255));
		}
		for (int k = 0; k < 4; k++) {
			c->texcoord[k / 2][k % 2] =
				(float)random_between(seed, -100, 100) /
				100.0f * (float)texels_wide / 8.0f;
		}
	}
	return corner;
}

struct span_scene *span_begin_in_perspective(
	enum pixel_format format, bool reference)
{
	struct span_scene *scene = span_scene_begin(format, reference);
	const struct gl *gl = scene->gl;

	gl->MatrixMode(GL_PROJECTION);
	gl->Frustumx(-20000, 20000, -16000, 16000, 65536, 8 * 65536);
	gl->MatrixMode(GL_MODELVIEW);
	return scene;
}
