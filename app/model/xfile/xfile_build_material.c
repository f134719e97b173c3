#include "app/model/color.h"
#include "app/model/image/image.h"
#include "app/model/xfile/xfile_build.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* A texture file. Each is read once, even if several materials use it. */
struct texture {
	const char *file; /* as the model file spells it */
	int texture;      /* index in the model; -1: limber cannot read it */
};

struct textures {
	struct xfile_names names;
	struct texture *list;
	int count;
	size_t unusable_bytes; /* total size of files that are not images */
};

/*
 * A model may refer to any number of files that are not images. After so many
 * bytes of such files, limber reads no more textures.
 */
enum {
	UNUSABLE_BYTES_MAX = 64 * 1024 * 1024
};

/* Keeps an error about a texture until its level is known. */
struct kept_error {
	const struct log *log;
	char sentence[1024];
};

static void keep_error(void *user, enum log_level level, const char *sentence)
{
	struct kept_error *kept = user;

	if (level == LOG_ERROR) {
		snprintf(kept->sentence, sizeof(kept->sentence), "%s", sentence);
	} else {
		log_write(kept->log, level, "%s", sentence);
	}
}

/*
 * Converts the path of a texture to one below the model's folder. Exporters
 * write single or doubled backslashes and absolute paths of their own machine.
 * If the path leads outside the folder, only the file name is kept. Returns
 * NULL without memory.
 */
static char *clean_file_name(struct arena *arena, const char *written)
{
	char *name = arena_alloc(arena, strlen(written) + 1, 1);
	char *to = name;
	char *last;

	if (!name) {
		return NULL;
	}
	for (; *written; written++) {
		char c = *written == '\\' ? '/' : *written;

		if (c != '/' || to == name || to[-1] != '/') {
			*to++ = c;
		}
	}
	*to = '\0';
	last = strrchr(name, '/');
	if (last && (name[0] == '/' || strchr(name, ':') || strstr(name, ".."))) {
		return last + 1;
	}
	return name;
}

static int read_image(struct xfile_build *build, struct textures *textures,
	size_t location, const char *file, const struct log *log,
	struct model_image *out)
{
	struct model_file bytes;
	char where[512];
	int error;

	snprintf(where, sizeof(where), "%.255s: %s %zu%s: texture",
		build->context->path, build->context->binary ? "byte" : "line",
		location,
		build->context->unpacked ? " of the decompressed data" : "");
	if (textures->unusable_bytes > UNUSABLE_BYTES_MAX) {
		return -EFBIG;
	}
	error = model_file_read_beside(
		build->source, file, where, build->model->budget, log, &bytes);
	if (error) {
		return error;
	}
	snprintf(where + strlen(where), sizeof(where) - strlen(where),
		" %.120s", file);
	error = image_decode(
		bytes.data, bytes.size, where, log, &build->model->arena, out);
	textures->unusable_bytes += error ? bytes.size : 0;
	model_file_release(&bytes);
	return error;
}

/*
 * Reads a texture into the model. Returns an error only without memory. *out is
 * -1 if the texture cannot be read.
 */
static int add_texture(struct xfile_build *build, struct textures *textures,
	const struct xfile_material *material, int *out)
{
	struct model *model = build->model;
	struct model_image *image = &model->image[model->image_count];
	char *file = clean_file_name(build->scratch, material->texture);
	struct kept_error kept = {.log = build->log};
	const struct log log = {
		.write = keep_error,
		.user = &kept,
		.threshold = LOG_NOTE,
	};
	int error;

	*out = -1;
	if (!file) {
		return xfile_no_memory(build->context);
	}
	error = read_image(
		build, textures, material->texture_location, file, &log, image);
	if (kept.sentence[0]) {
		/* Without its textures a model loads, without memory not. */
		log_write(build->log, error == -ENOMEM ? LOG_ERROR : LOG_WARNING,
			"%s", kept.sentence);
	}
	if (error) {
		return error == -ENOMEM ? error : 0;
	}
	image->name = xfile_clean_name(&model->arena, file);
	if (!image->name) {
		return xfile_no_memory(build->context);
	}
	model->texture[model->texture_count] = (struct model_texture){
		.image = model->image_count++,
		.mipmap = true,
	};
	*out = model->texture_count++;
	return 0;
}

static int find_texture(struct xfile_build *build, struct textures *textures,
	const struct xfile_material *material, int *out)
{
	struct texture *texture;
	int known;
	int error;

	*out = -1;
	if (!material->texture || !*material->texture) {
		return 0;
	}
	known = xfile_names_find(&textures->names, material->texture);
	if (known >= 0) {
		*out = textures->list[known].texture;
		return 0;
	}
	texture = &textures->list[textures->count];
	error = add_texture(build, textures, material, &texture->texture);
	if (error) {
		return error;
	}
	texture->file = material->texture;
	xfile_names_add(&textures->names, texture->file, textures->count++);
	*out = texture->texture;
	return 0;
}

/*
 * Returns the roughness. A Blinn-Phong exponent p corresponds to the GGX alpha
 * sqrt(2 / (p + 2)), which is the square of the roughness. Without a highlight,
 * the roughness is 1.
 */
static float to_roughness(const struct xfile_material *material)
{
	const float *specular = material->specular;
	float brightest = fmaxf(specular[0], fmaxf(specular[1], specular[2]));

	if (brightest <= 0 || material->power <= 0) {
		return 1;
	}
	return powf(2 / (material->power + 2), 0.25f);
}

static int fill_material(struct xfile_build *build, struct textures *textures,
	const struct xfile_material *from, struct model_material *to)
{
	struct model *model = build->model;
	int error;

	*to = model_plain_material;
	error = find_texture(build, textures, from, &to->texture);
	if (error) {
		return error;
	}
	to->name = arena_strdup(&model->arena, from->name);
	if (!to->name) {
		return xfile_no_memory(build->context);
	}
	for (int i = 0; i < 3; i++) {
		to->base_color[i] = color_decode_srgb(from->color[i]);
		to->emissive[i] = color_decode_srgb(from->emissive[i]);
	}
	/* Direct3D multiplies all light of a surface by its texture. */
	to->emissive_texture = to->texture;
	to->base_color[3] = fminf(fmaxf(from->color[3], 0), 1);
	to->roughness = to_roughness(from);
	if (to->base_color[3] < 1) {
		to->alpha = MODEL_BLEND;
	} else if (to->texture >= 0 &&
		!model->image[model->texture[to->texture].image].opaque) {
		to->alpha = MODEL_MASK;
	}
	return 0;
}

int xfile_build_materials(struct xfile_build *build)
{
	const struct xfile_material *from = build->scene->materials;
	struct model *model = build->model;
	size_t count = (size_t)build->scene->material_count;
	struct textures textures = {0};
	int error = 0;

	model->material =
		ARENA_ARRAY(&model->arena, struct model_material, count + 1);
	model->image = ARENA_ARRAY(&model->arena, struct model_image, count);
	model->texture = ARENA_ARRAY(&model->arena, struct model_texture, count);
	textures.list = ARENA_ARRAY(build->scratch, struct texture, count);
	if (!model->material || !model->image || !model->texture ||
		!textures.list ||
		xfile_names_init(&textures.names, build->scratch, count)) {
		return xfile_no_memory(build->context);
	}
	for (; !error && from; from = from->next) {
		error = fill_material(
			build, &textures, from, &model->material[from->index]);
	}
	/* The default material comes last; it counts once a face needs it. */
	model->material[count] = model_plain_material;
	model->material_count = (int)count;
	return error;
}
