#include "app/model/color.h"
#include "app/model/image/image.h"
#include "app/model/xfile/xfile_build.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* A file's texture, looked at once however many materials have it. */
struct texture {
	const char *file; /* as written */
	int texture;      /* in the model, or -1 where it cannot be had */
};

struct textures {
	struct xfile_names names;
	struct texture *list;
	int count;
};

/* What cannot be read costs a warning only. */
static void write_warning(void *user, enum log_level level, const char *sentence)
{
	const struct log *log = user;

	log_write(log, level == LOG_ERROR ? LOG_WARNING : level, "%s", sentence);
}

/*
 * The name of a file beside the model. Exporters write backslashes, doubled
 * or not, and the paths of the machine that they ran on; of a path that leads
 * elsewhere only the last part is taken.
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

static int read_image(struct xfile_build *build, size_t place, const char *file,
	struct model_image *out)
{
	const struct log quiet = {
		.write = write_warning,
		.user = (void *)(uintptr_t)build->log,
		.threshold = LOG_NOTE,
	};
	struct model_file bytes;
	char where[512];
	int error;

	snprintf(where, sizeof(where), "%.255s: %s %zu%s: texture",
		build->where->path, build->where->binary ? "byte" : "line",
		place, build->where->unpacked ? " of the unpacked data" : "");
	error = model_file_read_beside(
		build->source, file, where, &quiet, &bytes);
	if (error) {
		return error;
	}
	snprintf(where + strlen(where), sizeof(where) - strlen(where),
		" %.120s", file);
	error = image_decode(bytes.data, bytes.size, where, &quiet,
		&build->model->arena, out);
	model_file_release(&bytes);
	return error;
}

/* An error here is short memory; anything else leaves -1. */
static int add_texture(struct xfile_build *build,
	const struct xfile_material *material, int *out)
{
	struct model *model = build->model;
	struct model_image *image = &model->image[model->image_count];
	char *file = clean_file_name(build->scratch, material->texture);
	int error;

	*out = -1;
	if (!file) {
		return xfile_no_memory(build->where);
	}
	error = read_image(build, material->texture_place, file, image);
	if (error) {
		return error == -ENOMEM ? error : 0;
	}
	image->name = xfile_clean_name(&model->arena, file);
	if (!image->name) {
		return xfile_no_memory(build->where);
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
	error = add_texture(build, material, &texture->texture);
	if (error) {
		return error;
	}
	texture->file = material->texture;
	xfile_names_add(&textures->names, texture->file, textures->count++);
	*out = texture->texture;
	return 0;
}

/*
 * The power p of a highlight says as much as a roughness of (2 / (p + 2)) to
 * the quarter: both give its half-width. Without a highlight all is rough.
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
		return xfile_no_memory(build->where);
	}
	for (int i = 0; i < 3; i++) {
		to->base_color[i] = color_decode_srgb(from->color[i]);
	}
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
		return xfile_no_memory(build->where);
	}
	for (; !error && from; from = from->next) {
		error = fill_material(
			build, &textures, from, &model->material[from->index]);
	}
	/* It counts once a face without a material needs it. */
	model->material[count] = model_plain_material;
	model->material_count = (int)count;
	return error;
}
