#include "app/model/model.h"
#include "app/model/gltf/gltf.h"
#include "app/model/model_loader.h"
#include "app/model/xfile/xfile.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

const struct model_material model_plain_material = {
	.name = "",
	.base_color = {1, 1, 1, 1},
	.texture = -1,
	.normal_texture = -1,
	.roughness = 1,
	.alpha_cutoff = 0.5f,
};

/* The first that recognises a file loads it. */
static const struct model_format formats[] = {
	{"glTF", gltf_recognise, gltf_load, gltf_examine},
	{"DirectX .x", xfile_recognise, xfile_load, xfile_examine},
};

/* The format of the bytes, or -errno after a sentence. */
static int find_format(const struct model_source *source, const struct log *log,
	const struct model_format **out)
{
	size_t i;

	if (source->size == 0) {
		log_error(log, "%s: is empty", source->name);
		return -EINVAL;
	}
	for (i = 0; i < ARRAY_COUNT(formats); i++) {
		if (formats[i].recognise(source->data, source->size)) {
			*out = &formats[i];
			return 0;
		}
	}
	log_error(log,
		"%s: is no model that limber knows (it reads .gltf, "
		".glb and .x)",
		source->name);
	return -ENOTSUP;
}

static int load_source(const struct model_source *source, const struct log *log,
	struct model **out)
{
	const struct model_format *format;
	int error = find_format(source, log, &format);

	*out = NULL;
	if (!error) {
		error = format->load(source, log, out);
	}
	if (!error) {
		model_prepare_clips(*out);
	}
	return error;
}

int model_examine(const char *path, const struct examiner *examiner,
	const struct log *log)
{
	struct model_source source = {.name = path, .has_folder = true};
	const struct model_format *format;
	struct model_file file;
	int error = model_file_read(path, log, &file);

	if (error) {
		return error;
	}
	source.data = file.data;
	source.size = file.size;
	error = find_format(&source, log, &format);
	if (!error) {
		error = format->examine(&source, examiner, log);
	}
	model_file_release(&file);
	return error;
}

int model_load(const char *path, const struct log *log, struct model **out)
{
	struct model_source source = {.name = path, .has_folder = true};
	struct model_file file;
	int error;

	*out = NULL;
	error = model_file_read(path, log, &file);
	if (error) {
		return error;
	}
	source.data = file.data;
	source.size = file.size;
	error = load_source(&source, log, out);
	model_file_release(&file);
	return error;
}

int model_load_memory(const void *data, size_t size, const char *name,
	const struct log *log, struct model **out)
{
	struct model_source source = {.name = name, .data = data, .size = size};

	return load_source(&source, log, out);
}

struct model *model_create(const char *path, const char *format)
{
	struct arena arena = arena_empty();
	struct model *model = ARENA_NEW(&arena, struct model);

	if (model) {
		model->path = arena_strdup(&arena, path);
		model->format = arena_strdup(&arena, format);
		model->arena = arena;
		if (!model->path || !model->format) {
			model_destroy(model);
			model = NULL;
		}
	}
	return model;
}

void model_destroy(struct model *model)
{
	if (model) {
		struct arena arena = model->arena;

		arena_release(&arena);
	}
}

int model_find_node(const struct model *model, const char *name)
{
	int i;

	for (i = 0; i < model->node_count; i++) {
		if (strcmp(model->node[i].name, name) == 0) {
			return i;
		}
	}
	return -1;
}

int model_find_mesh(const struct model *model, const char *name)
{
	int i;

	for (i = 0; i < model->mesh_count; i++) {
		if (strcmp(model->mesh[i].name, name) == 0) {
			return i;
		}
	}
	return -1;
}

int model_find_clip(const struct model *model, const char *name_or_index)
{
	char *end;
	long number;
	int i;

	for (i = 0; i < model->clip_count; i++) {
		if (strcmp(model->clip[i].name, name_or_index) == 0) {
			return i;
		}
	}
	if (name_or_index[0] < '0' || name_or_index[0] > '9') {
		return -1;
	}
	number = strtol(name_or_index, &end, 10);
	if (*end || number >= model->clip_count) {
		return -1;
	}
	return (int)number;
}

int model_choose_clip(const struct model *model, const char *wanted,
	int unasked, const struct log *log, int *out)
{
	*out = wanted ? model_find_clip(model, wanted) : unasked;
	if (wanted && *out < 0) {
		log_error(log,
			"--clip %s: %s has no such clip: limber info lists "
			"them",
			wanted, model->path);
		return -ENOENT;
	}
	return 0;
}

/*
 * A vertex without any weight would collapse into the origin, so its first
 * joint carries it: that is where exporters which write a rigid vertex
 * without weights put its bone.
 */
static void normalize_vertex(uint16_t *joint, float *weight, int count)
{
	double sum = 0;
	int i;

	for (i = 0; i < count; i++) {
		weight[i] = weight[i] > 0 ? weight[i] : 0;
		sum += weight[i];
	}
	if (sum <= 0) {
		weight[0] = 1;
		sum = 1;
	}
	for (i = 0; i < count; i++) {
		weight[i] = (float)(weight[i] / sum);
		if (weight[i] <= 0) {
			joint[i] = 0;
		}
	}
}

void model_normalize_influences(struct model_primitive *primitive)
{
	int count = primitive->influences;
	int i;

	for (i = 0; count && i < primitive->vertex_count; i++) {
		normalize_vertex(primitive->joint + (size_t)i * count,
			primitive->weight + (size_t)i * count, count);
	}
}

int model_max_joint(const struct model_primitive *primitive)
{
	size_t total = (size_t)primitive->vertex_count * primitive->influences;
	int max = -1;
	size_t i;

	for (i = 0; i < total; i++) {
		if (primitive->joint[i] > max) {
			max = primitive->joint[i];
		}
	}
	return max;
}
