#include "app/model/gltf/gltf_internal.h"
#include "app/model/image/image.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

enum {
	NOT_READ = -2, /* no material has used the texture or image so far */
	MISSING = -1,  /* limber cannot read the texture's image */
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
		return gltf_fail(&member, -EINVAL,
			"wrap mode %lld is not defined by glTF 2.0",
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
	struct gltf_at array = gltf_member(&texture->gltf->root, "samplers");
	struct gltf_at sampler;
	int index = -1;
	int error = gltf_maybe_root_index(
		texture, "sampler", "samplers", "sampler", &index);

	out->mipmap = true;
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

/* Its messages name the image's file or, of one in the model, its name. */
static int decode(const struct gltf_at *at, const char *uri,
	const uint8_t *data, size_t size, struct model_image *out)
{
	bool has_file = uri && strncmp(uri, "data:", 5) != 0;
	const char *name = has_file ? uri : out->name;
	struct gltf *gltf = at->gltf;
	char where[256];
	size_t length;

	gltf_path(at, where, sizeof(where));
	length = strlen(where);
	if (name[0]) {
		snprintf(where + length, sizeof(where) - length, " (%.80s)",
			name);
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
		error = gltf_fail(
			at, -EINVAL, "has neither a uri nor a bufferView");
	}
	if (!error) {
		error = decode(at, uri, data, size, out);
	}
	model_file_release(&file);
	return error;
}

static int use_image(struct gltf *gltf, int index, int *out)
{
	struct model *model = gltf->model;
	struct gltf_at array = gltf_member(&gltf->root, "images");
	struct gltf_at item;
	int error;

	if (gltf->image_index[index] >= 0) {
		*out = gltf->image_index[index];
		return 0;
	}
	error = gltf_item(&array, index, &item);
	if (!error) {
		error = read_image(&item, &model->image[model->image_count]);
	}
	if (!error) {
		*out = model->image_count++;
		gltf->image_index[index] = *out;
	}
	return error;
}

/*
 * Reads a texture. If it has no source, only an extension defines its image,
 * and out->image becomes MISSING.
 */
static int read_texture(const struct gltf_at *at, struct model_texture *out)
{
	int source = -1;
	int error =
		gltf_maybe_root_index(at, "source", "images", "image", &source);

	if (!error) {
		error = read_sampler(at, out);
	}
	out->image = MISSING;
	if (error) {
		return error;
	}
	if (source < 0) {
		gltf_warn(at,
			"has no source that limber can read; limber ignores this texture");
		return 0;
	}
	return use_image(at->gltf, source, &out->image);
}

int gltf_use_texture(struct gltf *gltf, int file_index, int *out)
{
	struct model *model = gltf->model;
	struct model_texture texture = {0};
	struct gltf_at array = gltf_member(&gltf->root, "textures");
	struct gltf_at item;
	int error;

	if (gltf->texture_index[file_index] != NOT_READ) {
		*out = gltf->texture_index[file_index];
		return 0;
	}
	error = gltf_item(&array, file_index, &item);
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
	gltf->texture_index[file_index] = *out;
	return 0;
}

/* An array of count indices that are NOT_READ. */
static int *make_indices(const struct gltf_at *at, int count)
{
	int *index = GLTF_SCRATCH(at, int, count);
	int i;

	for (i = 0; index && i < count; i++) {
		index[i] = NOT_READ;
	}
	return index;
}

int gltf_prepare_textures(struct gltf *gltf)
{
	struct model *model = gltf->model;
	struct gltf_at textures, images;
	int texture_count, image_count;
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
	model->image = GLTF_KEEP(&images, struct model_image, image_count);
	gltf->texture_index = make_indices(&textures, texture_count);
	gltf->image_index = make_indices(&images, image_count);
	return model->texture && model->image && gltf->texture_index &&
			gltf->image_index
		? 0
		: -ENOMEM;
}
