#include "app/model/gltf/gltf_internal.h"
#include "app/model/image/image.h"

#include <errno.h>
#include <math.h>
#include <string.h>

enum {
	UNKNOWN = -1, /* not asked for yet */
	MISSING = -2, /* asked for, cannot be had */
};

enum {
	GL_NEAREST = 9728,
	GL_LINEAR = 9729,
	GL_NEAREST_MIPMAP_NEAREST = 9984,
	GL_LINEAR_MIPMAP_LINEAR = 9987,
	GL_REPEAT = 10497,
	GL_CLAMP_TO_EDGE = 33071,
	GL_MIRRORED_REPEAT = 33648,
};

static int read_wrap(
	const struct gltf_at *at, const char *key, enum model_wrap *out)
{
	struct gltf_at member = gltf_member(at, key);
	int64_t value = GL_REPEAT;
	int error = gltf_maybe_integer(at, key, 0, INT32_MAX, &value);

	if (error) {
		return error;
	}
	switch (value) {
	case GL_REPEAT:
		*out = MODEL_REPEAT;
		return 0;
	case GL_CLAMP_TO_EDGE:
		*out = MODEL_CLAMP;
		return 0;
	case GL_MIRRORED_REPEAT:
		*out = MODEL_MIRROR;
		return 0;
	default:
		return gltf_fail(&member, -EINVAL, "wrap mode %lld is unknown",
			(long long)value);
	}
}

static int read_filters(const struct gltf_at *at, struct model_texture *out)
{
	int64_t magnify = GL_LINEAR;
	int64_t minify = GL_LINEAR_MIPMAP_LINEAR;
	int error = gltf_maybe_integer(
		at, "magFilter", GL_NEAREST, GL_LINEAR, &magnify);

	if (!error) {
		error = gltf_maybe_integer(at, "minFilter", GL_NEAREST,
			GL_LINEAR_MIPMAP_LINEAR, &minify);
	}
	out->nearest = magnify == GL_NEAREST;
	out->mipmap = minify >= GL_NEAREST_MIPMAP_NEAREST;
	return error;
}

static int read_sampler(const struct gltf_at *texture, struct model_texture *out)
{
	struct gltf *gltf = texture->gltf;
	struct gltf_at array, sampler;
	int count;
	int index = -1;
	int error = gltf_array(&gltf->root, "samplers", &array, &count);

	out->mipmap = true;
	if (!error) {
		error = gltf_maybe_index(
			texture, "sampler", count, "sampler", &index);
	}
	if (error || index < 0) {
		return error;
	}
	error = gltf_item(&array, index, &sampler);
	if (!error) {
		error = read_wrap(&sampler, "wrapS", &out->wrap_s);
	}
	if (!error) {
		error = read_wrap(&sampler, "wrapT", &out->wrap_t);
	}
	return error ? error : read_filters(&sampler, out);
}

static int decode(const struct gltf_at *at, const uint8_t *data, size_t size,
	struct model_image *out)
{
	struct gltf *gltf = at->gltf;
	char where[256];
	int width, height;
	int error;

	gltf_where(at, where, sizeof(where));
	error = image_measure(data, size, where, gltf->log, &width, &height);
	if (error) {
		return error;
	}
	if (!gltf_has_room(at, (size_t)width * (size_t)height, 4)) {
		return -ENOMEM;
	}
	return image_decode(
		data, size, where, gltf->log, &gltf->model->arena, out);
}

static int read_image(const struct gltf_at *at, struct model_image *out)
{
	struct gltf *gltf = at->gltf;
	struct gltf_at uri_at = gltf_member(at, "uri");
	struct model_file file = {0};
	const uint8_t *data = NULL;
	const char *uri = NULL;
	size_t size = 0;
	int view = -1;
	int error = gltf_name(at, &out->name);

	if (!error) {
		error = gltf_maybe_string(at, "uri", &uri);
	}
	if (!error) {
		error = gltf_maybe_index(at, "bufferView", gltf->view_count,
			"bufferView", &view);
	}
	if (error) {
		return error;
	}
	if (view >= 0) {
		data = gltf->view[view].data;
		size = gltf->view[view].size;
	} else if (uri) {
		error = gltf_read_uri(&uri_at, uri, &file, &data, &size);
	} else {
		error = gltf_fail(at, -EINVAL, "has neither uri nor bufferView");
	}
	if (!error) {
		error = decode(at, data, size, out);
	}
	gltf->file_bytes -= file.size;
	model_file_release(&file);
	return error;
}

static int use_image(struct gltf *gltf, int index, int *out)
{
	struct model *model = gltf->model;
	struct gltf_at array, item;
	int count;
	int error = gltf_array(&gltf->root, "images", &array, &count);

	if (error || gltf->image_place[index] >= 0) {
		*out = gltf->image_place[index];
		return error;
	}
	error = gltf_item(&array, index, &item);
	if (!error) {
		error = read_image(&item, &model->image[model->image_count]);
	}
	if (!error) {
		*out = model->image_count++;
		gltf->image_place[index] = *out;
	}
	return error;
}

/* Without a source the picture is in an extension's format. */
static int read_texture(const struct gltf_at *at, struct model_texture *out)
{
	struct gltf *gltf = at->gltf;
	struct gltf_at images;
	int count;
	int source = -1;
	int error = gltf_array(&gltf->root, "images", &images, &count);

	if (!error) {
		error = gltf_maybe_index(at, "source", count, "image", &source);
	}
	if (!error) {
		error = read_sampler(at, out);
	}
	out->image = MISSING;
	if (error) {
		return error;
	}
	if (source < 0) {
		gltf_warn(at,
			"has no source that limber can read; "
			"it is left out");
		return 0;
	}
	return use_image(gltf, source, &out->image);
}

/* Only textures that a material needs are read, when first asked for. */
static int use_texture(struct gltf *gltf, int index, int *out)
{
	struct model *model = gltf->model;
	struct model_texture texture = {0};
	struct gltf_at array, item;
	int count;
	int error = gltf_array(&gltf->root, "textures", &array, &count);

	if (error || gltf->texture_place[index] != UNKNOWN) {
		*out = gltf->texture_place[index];
		return error;
	}
	error = gltf_item(&array, index, &item);
	if (!error) {
		error = read_texture(&item, &texture);
	}
	if (error) {
		return error;
	}
	*out = MISSING;
	if (texture.image >= 0) {
		*out = model->texture_count++;
		model->texture[*out] = texture;
	}
	gltf->texture_place[index] = *out;
	return 0;
}

/*
 * KHR_texture_transform: scale, then a turn that runs counter-clockwise as
 * one sees the picture (v runs down), then the offset.
 */
static int read_uv_transform(const struct gltf_at *at, struct gltf_uv *out)
{
	float offset[2] = {0, 0};
	float scale[2] = {1, 1};
	float angle_rad = 0;
	int64_t set = out->set;
	int error = gltf_maybe_floats(at, "offset", offset, 2);

	if (!error) {
		error = gltf_maybe_floats(at, "scale", scale, 2);
	}
	if (!error) {
		error = gltf_maybe_number(at, "rotation", &angle_rad);
	}
	if (!error) {
		error = gltf_maybe_integer(at, "texCoord", 0, INT32_MAX, &set);
	}
	if (error) {
		return error;
	}
	*out = (struct gltf_uv){
		.set = (int)set,
		.transformed = true,
		.row = {{cosf(angle_rad) * scale[0], sinf(angle_rad) * scale[1],
				offset[0]},
			{-sinf(angle_rad) * scale[0],
				cosf(angle_rad) * scale[1], offset[1]}},
	};
	return 0;
}

/* A textureInfo: which texture, and how coordinates become its own. */
static int read_texture_info(const struct gltf_at *parent, const char *key,
	int *texture, struct gltf_uv *uv)
{
	struct gltf *gltf = parent->gltf;
	struct gltf_at at, textures, extensions, transform;
	int count;
	int index = 0;
	int64_t set = 0;
	int error = gltf_object(parent, key, &at);

	*texture = -1;
	if (error || !at.json) {
		return error;
	}
	error = gltf_need(&at, "index");
	if (!error) {
		error = gltf_array(&gltf->root, "textures", &textures, &count);
	}
	if (!error) {
		error = gltf_maybe_index(&at, "index", count, "texture", &index);
	}
	if (!error) {
		error = gltf_maybe_integer(&at, "texCoord", 0, INT32_MAX, &set);
	}
	if (!error) {
		error = gltf_object(&at, "extensions", &extensions);
	}
	if (!error) {
		error = gltf_object(
			&extensions, "KHR_texture_transform", &transform);
	}
	if (!error) {
		error = use_texture(gltf, index, texture);
	}
	*texture = *texture < 0 ? -1 : *texture;
	uv->set = (int)set;
	return error || !transform.json ? error
					: read_uv_transform(&transform, uv);
}

static int read_alpha(const struct gltf_at *at, struct model_material *out)
{
	static const char *const names[] = {
		[MODEL_OPAQUE] = "OPAQUE",
		[MODEL_MASK] = "MASK",
		[MODEL_BLEND] = "BLEND",
	};
	int choice = MODEL_OPAQUE;
	int error = gltf_maybe_choice(
		at, "alphaMode", names, ARRAY_COUNT(names), &choice);

	if (error) {
		return error;
	}
	out->alpha = (enum model_alpha)choice;
	return gltf_maybe_number(at, "alphaCutoff", &out->alpha_cutoff);
}

static bool is_same_uv(const struct gltf_uv *a, const struct gltf_uv *b)
{
	return a->set == b->set && a->transformed == b->transformed &&
		memcmp(a->row, b->row, sizeof(a->row)) == 0;
}

/* A vertex has one pair of coordinates, the base colour's if it has any. */
static int read_textures(const struct gltf_at *at, const struct gltf_at *pbr,
	struct model_material *out, struct gltf_uv *uv)
{
	struct gltf_uv normal_uv = {0};
	int error =
		read_texture_info(pbr, "baseColorTexture", &out->texture, uv);

	if (!error) {
		error = read_texture_info(
			at, "normalTexture", &out->normal_texture, &normal_uv);
	}
	if (error || out->normal_texture < 0) {
		return error;
	}
	if (out->texture < 0) {
		*uv = normal_uv;
	} else if (!is_same_uv(uv, &normal_uv)) {
		gltf_warn(at,
			"normalTexture has other coordinates than "
			"baseColorTexture; it is left out");
		out->normal_texture = -1;
	}
	return 0;
}

static int read_material(const struct gltf_at *at, struct model_material *out,
	struct gltf_uv *uv)
{
	struct gltf_at pbr, extensions;
	int error;

	*out = model_plain_material;
	error = gltf_name(at, &out->name);
	if (!error) {
		error = gltf_object(at, "pbrMetallicRoughness", &pbr);
	}
	if (!error) {
		error = gltf_maybe_floats(
			&pbr, "baseColorFactor", out->base_color, 4);
	}
	if (!error) {
		error = gltf_maybe_number(
			&pbr, "roughnessFactor", &out->roughness);
	}
	if (!error) {
		error = read_alpha(at, out);
	}
	if (!error) {
		error = gltf_maybe_bool(at, "doubleSided", &out->double_sided);
	}
	if (!error) {
		error = gltf_object(at, "extensions", &extensions);
	}
	if (error) {
		return error;
	}
	out->unlit = json_object_get(extensions.json, "KHR_materials_unlit");
	return read_textures(at, &pbr, out, uv);
}

static int make_room(struct gltf *gltf, int material_count)
{
	struct model *model = gltf->model;
	struct gltf_at textures, images;
	int texture_count, image_count, i;
	int error =
		gltf_array(&gltf->root, "textures", &textures, &texture_count);

	if (!error) {
		error = gltf_array(&gltf->root, "images", &images, &image_count);
	}
	if (error) {
		return error;
	}
	model->texture =
		GLTF_KEEP(&textures, struct model_texture, texture_count);
	gltf->texture_place = GLTF_SCRATCH(&textures, int, texture_count);
	model->image = GLTF_KEEP(&images, struct model_image, image_count);
	gltf->image_place = GLTF_SCRATCH(&images, int, image_count);
	model->material = GLTF_KEEP(
		&gltf->root, struct model_material, (size_t)material_count + 1);
	gltf->uv = GLTF_SCRATCH(
		&gltf->root, struct gltf_uv, (size_t)material_count + 1);
	if (!model->texture || !gltf->texture_place || !model->image ||
		!gltf->image_place || !model->material || !gltf->uv) {
		return -ENOMEM;
	}
	for (i = 0; i < texture_count; i++) {
		gltf->texture_place[i] = UNKNOWN;
	}
	for (i = 0; i < image_count; i++) {
		gltf->image_place[i] = UNKNOWN;
	}
	return 0;
}

int gltf_read_materials(struct gltf *gltf)
{
	struct model *model = gltf->model;
	struct gltf_at array, item;
	int count, i;
	int error = gltf_array(&gltf->root, "materials", &array, &count);

	if (!error) {
		error = make_room(gltf, count);
	}
	for (i = 0; i < count && !error; i++) {
		error = gltf_item(&array, i, &item);
		if (!error) {
			error = read_material(
				&item, &model->material[i], &gltf->uv[i]);
		}
	}
	model->material_count = error ? 0 : count;
	return error;
}

int gltf_default_material(struct gltf *gltf)
{
	struct model *model = gltf->model;

	if (gltf->default_material < 0) {
		gltf->default_material = model->material_count++;
		model->material[gltf->default_material] = model_plain_material;
	}
	return gltf->default_material;
}
