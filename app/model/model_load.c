#include "app/model/gltf/gltf.h"
#include "app/model/model_loader.h"
#include "app/model/xfile/xfile.h"

#include <errno.h>

/* The first format that recognises a file loads it. */
static const struct model_format formats[] = {
	{"glTF", gltf_recognise, gltf_load, gltf_examine},
	{"DirectX .x", xfile_recognise, xfile_load, xfile_examine},
};

static int find_format(const struct model_source *source, const struct log *log,
	const struct model_format **out)
{
	size_t i;

	if (source->size == 0) {
		log_error(log, "%s: the file is empty", source->name);
		return -EINVAL;
	}
	for (i = 0; i < ARRAY_COUNT(formats); i++) {
		if (formats[i].recognise(source->data, source->size)) {
			*out = &formats[i];
			return 0;
		}
	}
	log_error(log,
		"%s: the format is unknown; limber reads .gltf, .glb and .x",
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
