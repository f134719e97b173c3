#include "app/scene/draw/texture.h"

#include "app/model/color.h"
#include "app/scene/draw/bump.h"
#include "platform/base/fixed.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	SIDE_MAX = 1024,
	SMALL_MAX = 128, /* a side of few texels is enlarged to this at most */
	/* without a context, a driver may return errors for ever */
	ERRORS_MAX = 16
};

/* How a texture is used. */
enum {
	LIT = 1,         /* as the colour of a surface in the light */
	SHOWN_AS_IS = 2, /* as light, without light, or as normals */
};

/* An image whose sides are powers of two. */
struct texels {
	int width, height;
	uint8_t (*rgba)[4];
};

/*
 * A side of few texels, such as a row of colours, becomes several times as
 * long: each of its texels then keeps its colour in its middle.
 */
static int power_of_two_near(int side)
{
	int power = 1;

	while (power < side && power < SIDE_MAX) {
		power *= 2;
	}
	if (power > side && power <= SMALL_MAX / 2) {
		return 4 * power < SMALL_MAX ? 4 * power : SMALL_MAX;
	}
	/* The nearer one: 300 becomes 256, 400 becomes 512. */
	return power > 1 && power - side > side - power / 2 ? power / 2 : power;
}

static int upload_side(int side, enum model_wrap wrap)
{
	int power = power_of_two_near(side);

	return wrap == MODEL_MIRROR && power < SIDE_MAX ? 2 * power : power;
}

/*
 * The memory of a texture in the GL, and as much again for the tables that a
 * driver such as soft makes of it. Mipmaps add a third.
 */
static size_t texture_bytes(const struct model_image *image,
	const struct model_texture *sampling, enum pixel_format target)
{
	size_t texels = (size_t)upload_side(image->width, sampling->wrap_s) *
		(size_t)upload_side(image->height, sampling->wrap_t);
	size_t bytes = texels * (target == PIXELS_RGB565 ? 4 : 8);

	return sampling->mipmap ? bytes + bytes / 3 : bytes;
}

/*
 * Returns the source column or row, in 1/256, at a texel's centre. If the model
 * asks for the nearest texel, it is a whole column or row, so that texels are
 * not interpolated.
 */
static int source_at(int texel, int side, int source_side, enum model_wrap wrap,
	bool nearest)
{
	int once = wrap == MODEL_MIRROR ? side / 2 : side;
	int64_t at;

	if (texel >= once) {
		texel = side - 1 - texel;
	}
	at = ((int64_t)texel * 2 + 1) * source_side * 128 / once - 128;
	at = nearest ? (at + 128) & ~255 : at;
	if (at < 0) {
		return 0;
	}
	return at > (source_side - 1) * 256 ? (source_side - 1) * 256 : (int)at;
}

static void sample(
	const struct model_image *image, int x_q8, int y_q8, uint8_t out[4])
{
	int x = x_q8 >> 8, y = y_q8 >> 8;
	int fx = x_q8 & 255, fy = y_q8 & 255;
	int x1 = x + 1 < image->width ? x + 1 : x;
	int y1 = y + 1 < image->height ? y + 1 : y;
	const uint8_t *row = image->rgba + (size_t)y * (size_t)image->width * 4;
	const uint8_t *row1 =
		image->rgba + (size_t)y1 * (size_t)image->width * 4;

	for (int i = 0; i < 4; i++) {
		int above = row[x * 4 + i] * (256 - fx) + row[x1 * 4 + i] * fx;
		int below = row1[x * 4 + i] * (256 - fx) + row1[x1 * 4 + i] * fx;

		out[i] = (uint8_t)((above * (256 - fy) + below * fy + 32768) >>
			16);
	}
}

static int resample(const struct model_image *image,
	const struct model_texture *sampling, struct texels *out)
{
	bool nearest = sampling->nearest;

	out->width = upload_side(image->width, sampling->wrap_s);
	out->height = upload_side(image->height, sampling->wrap_t);
	out->rgba = malloc((size_t)out->width * (size_t)out->height * 4);
	if (!out->rgba) {
		return -ENOMEM;
	}
	if (out->width == image->width && out->height == image->height) {
		memcpy(out->rgba, image->rgba,
			(size_t)out->width * (size_t)out->height * 4);
		return 0;
	}
	for (int y = 0; y < out->height; y++) {
		int from_y = source_at(y, out->height, image->height,
			sampling->wrap_t, nearest);

		for (int x = 0; x < out->width; x++) {
			sample(image,
				source_at(x, out->width, image->width,
					sampling->wrap_s, nearest),
				from_y, out->rgba[y * out->width + x]);
		}
	}
	return 0;
}

/* Makes the next mipmap level in place: each texel averages two or four. */
static void halve(struct texels *texels)
{
	int step_x = texels->width > 1, step_y = texels->height > 1;
	int width = texels->width >> step_x, height = texels->height >> step_y;

	for (int y = 0; y < height; y++) {
		for (int x = 0; x < width; x++) {
			int at = (y << step_y) * texels->width + (x << step_x);
			int below = at + step_y * texels->width;

			for (int i = 0; i < 4; i++) {
				int sum = texels->rgba[at][i] +
					texels->rgba[at + step_x][i] +
					texels->rgba[below][i] +
					texels->rgba[below + step_x][i];

				texels->rgba[y * width + x][i] =
					(uint8_t)((sum + 2) / 4);
			}
		}
	}
	texels->width = width;
	texels->height = height;
}

static bool is_gray(const struct texels *texels)
{
	for (int i = 0; i < texels->width * texels->height; i++) {
		const uint8_t *t = texels->rgba[i];

		if (t[0] != t[1] || t[0] != t[2]) {
			return false;
		}
	}
	return true;
}

/* The formats in which texels are passed to GL. */
enum packing {
	PACK_RGBA,
	PACK_GRAY, /* opaque */
	PACK_565,
	PACK_4444,
};

static enum packing choose_packing(
	const struct texels *texels, bool opaque, enum pixel_format target)
{
	if (opaque && is_gray(texels)) {
		return PACK_GRAY;
	}
	return target != PIXELS_RGB565 ? PACK_RGBA
		: opaque               ? PACK_565
				       : PACK_4444;
}

static void pack_short(
	const struct texels *texels, enum packing packing, uint16_t *out)
{
	for (int i = 0; i < texels->width * texels->height; i++) {
		const uint8_t *t = texels->rgba[i];

		int packed = packing == PACK_565
			? (t[0] >> 3) << 11 | (t[1] >> 2) << 5 | t[2] >> 3
			: (t[0] >> 4) << 12 | (t[1] >> 4) << 8 |
				(t[2] >> 4) << 4 | t[3] >> 4;

		out[i] = (uint16_t)packed;
	}
}

/* packed is scratch memory with 16 bits for each texel. */
static void upload_level(const struct gl *gl, int level,
	const struct texels *texels, enum packing packing, uint16_t *packed)
{
	static const struct {
		GLenum format, type;
	} as[] = {
		[PACK_RGBA] = {GL_RGBA, GL_UNSIGNED_BYTE},
		[PACK_GRAY] = {GL_LUMINANCE, GL_UNSIGNED_BYTE},
		[PACK_565] = {GL_RGB, GL_UNSIGNED_SHORT_5_6_5},
		[PACK_4444] = {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4},
	};
	const void *data = packed;

	if (packing == PACK_RGBA) {
		data = texels->rgba;
	} else if (packing == PACK_GRAY) {
		for (int i = 0; i < texels->width * texels->height; i++) {
			((uint8_t *)packed)[i] = texels->rgba[i][0];
		}
	} else {
		pack_short(texels, packing, packed);
	}
	gl->TexImage2D(GL_TEXTURE_2D, level, (GLint)as[packing].format,
		texels->width, texels->height, 0, as[packing].format,
		as[packing].type, data);
}

static void set_sampling(
	const struct gl *gl, const struct model_texture *sampling)
{
	GLint magnify = sampling->nearest ? GL_NEAREST : GL_LINEAR;
	GLint minify = sampling->mipmap ? GL_LINEAR_MIPMAP_NEAREST : magnify;

	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magnify);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minify);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S,
		sampling->wrap_s == MODEL_CLAMP ? GL_CLAMP_TO_EDGE : GL_REPEAT);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T,
		sampling->wrap_t == MODEL_CLAMP ? GL_CLAMP_TO_EDGE : GL_REPEAT);
}

bool texture_memory_ok(const struct gl *gl)
{
	bool fine = true;

	for (int i = 0; i < ERRORS_MAX; i++) {
		GLenum error = gl->GetError();

		if (error == GL_NO_ERROR) {
			break;
		}
		fine = fine && error != GL_OUT_OF_MEMORY;
	}
	return fine;
}

static GLuint upload(const struct gl *gl, const struct model_image *image,
	const struct model_texture *sampling, enum pixel_format target, bool lit)
{
	struct texels texels = {0};
	enum packing packing;
	uint16_t *packed;
	GLuint name = 0;
	int level = 0;

	if (resample(image, sampling, &texels) != 0) {
		return 0;
	}
	if (lit) {
		color_mirror_all(texels.rgba, texels.width * texels.height);
	}
	packing = choose_packing(&texels, image->opaque, target);
	packed = malloc(
		(size_t)texels.width * (size_t)texels.height * sizeof(*packed));
	if (!packed) {
		goto out;
	}
	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	set_sampling(gl, sampling);
	upload_level(gl, level, &texels, packing, packed);
	while (sampling->mipmap && (texels.width > 1 || texels.height > 1)) {
		halve(&texels);
		upload_level(gl, ++level, &texels, packing, packed);
	}
	if (!texture_memory_ok(gl)) {
		gl->DeleteTextures(1, &name);
		name = 0;
	}
out:
	free(packed);
	free(texels.rgba);
	return name;
}

GLuint texture_upload(const struct gl *gl, const struct model_image *image,
	const struct model_texture *sampling, enum pixel_format target)
{
	return upload(gl, image, sampling, target, false);
}

static void note_use(uint8_t use[], int texture, uint8_t of)
{
	if (texture >= 0) {
		use[texture] |= of;
	}
}

/* Notes for each texture in which ways the model's materials show it. */
static void find_uses(const struct model *model, uint8_t use[])
{
	for (int i = 0; i < model->material_count; i++) {
		const struct model_material *m = &model->material[i];

		note_use(use, m->texture, m->unlit ? SHOWN_AS_IS : LIT);
		note_use(use, m->emissive_texture, SHOWN_AS_IS);
		note_use(use, m->normal_texture, SHOWN_AS_IS);
	}
}

static bool has_two_units(const struct gl *gl)
{
	GLint units = 1;
	bool combines;

	gl->GetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
	if (units < 2) {
		return false;
	}
	/* OpenGL ES 1.0 has no GL_COMBINE. */
	(void)texture_memory_ok(gl);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
	combines = gl->GetError() == GL_NO_ERROR;
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
	return combines;
}

static int upload_all(struct texture_set *set, const struct gl *gl,
	enum pixel_format target, const uint8_t use[])
{
	const struct model *model = set->model;

	for (int i = 0; i < model->texture_count; i++) {
		const struct model_texture *texture = &model->texture[i];
		const struct model_image *image = &model->image[texture->image];
		size_t bytes = texture_bytes(image, texture, target);

		if (!memory_budget_take(model->budget, bytes)) {
			return -ENOMEM;
		}
		set->taken_bytes += bytes;
		set->name[i] = upload(gl, image, texture, target, use[i] == LIT);
		if (!set->name[i]) {
			return -ENOMEM;
		}
		set->count++;
	}
	return 0;
}

int texture_set_create(struct texture_set *set, const struct model *model,
	const struct gl *gl, enum pixel_format target, const struct log *log)
{
	size_t count = (size_t)model->texture_count;
	int error = -ENOMEM;
	uint8_t *use;

	*set = (struct texture_set){.model = model};
	if (count == 0) {
		return 0;
	}
	set->name = calloc(count, sizeof(*set->name));
	use = calloc(count, sizeof(*use));
	if (set->name && use) {
		find_uses(model, use);
		error = upload_all(set, gl, target, use);
	}
	free(use);
	if (error) {
		(void)memory_budget_fail(model->budget, model->path, log);
		texture_set_destroy(set, gl);
		return error;
	}
	set->normal_mapping = bump_is_supported(model, gl, log);
	set->two_units = has_two_units(gl);
	return 0;
}

void texture_set_destroy(struct texture_set *set, const struct gl *gl)
{
	if (set->count) {
		gl->DeleteTextures(set->count, set->name);
	}
	free(set->name);
	if (set->taken_bytes) {
		memory_budget_give_back(set->model->budget, set->taken_bytes);
	}
	*set = (struct texture_set){0};
}

void texture_bind(
	const struct texture_set *set, const struct gl *gl, int texture)
{
	const struct model_texture *t = &set->model->texture[texture];
	bool mirror_s = t->wrap_s == MODEL_MIRROR;
	bool mirror_t = t->wrap_t == MODEL_MIRROR;

	gl->BindTexture(GL_TEXTURE_2D, set->name[texture]);
	gl->Enable(GL_TEXTURE_2D);
	gl->MatrixMode(GL_TEXTURE);
	gl->LoadIdentity();
	if (mirror_s || mirror_t) {
		gl->Scalex(mirror_s ? FX16_ONE / 2 : FX16_ONE,
			mirror_t ? FX16_ONE / 2 : FX16_ONE, FX16_ONE);
	}
	gl->MatrixMode(GL_MODELVIEW);
}
