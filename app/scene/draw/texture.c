#include "app/scene/draw/texture.h"

#include "app/model/color.h"
#include "app/scene/draw/bump.h"
#include "app/scene/draw/texels.h"
#include "platform/base/fixed.h"
#include "platform/base/interrupt.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	/* without a context, a driver may return errors for ever */
	ERRORS_MAX = 16
};

/* How a texture is used. */
enum {
	LIT = 1,         /* as the colour of a surface in the light */
	SHOWN_AS_IS = 2, /* as light, without light, or as normals */
};

/*
 * The memory of a texture in the GL, and as much again for the tables that a
 * driver such as soft makes of it. Mipmaps add a third.
 */
static size_t texture_bytes(const struct model_image *image,
	const struct model_texture *sampling, enum pixel_format target)
{
	size_t texels = (size_t)texels_side(image->width, sampling->wrap_s) *
		(size_t)texels_side(image->height, sampling->wrap_t);
	size_t bytes = texels * (target == PIXELS_RGB565 ? 4 : 8);

	return sampling->mipmap ? bytes + bytes / 3 : bytes;
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
	if (opaque && texels_are_gray(texels)) {
		return PACK_GRAY;
	}
	return target != PIXELS_RGB565 ? PACK_RGBA
		: opaque               ? PACK_565
				       : PACK_4444;
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
		texels_pack_gray(texels, (uint8_t *)packed);
	} else if (packing == PACK_565) {
		texels_pack_565(texels, packed);
	} else {
		texels_pack_4444(texels, packed);
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

	if (texels_resample(image, sampling, &texels) != 0) {
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
		texels_halve(&texels);
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

		if (interrupt_pending()) {
			return -EINTR;
		}
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
