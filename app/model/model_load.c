#include "app/model/gltf/gltf.h"
#include "app/model/image/image.h"
#include "app/model/model_loader.h"
#include "app/model/xfile/xfile.h"

#include <errno.h>
#include <limits.h>

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
		log_error(log, "%s: the file is empty: export or copy it again",
			source->name);
		return -EINVAL;
	}
	for (i = 0; i < ARRAY_COUNT(formats); i++) {
		if (formats[i].recognise(source->data, source->size)) {
			*out = &formats[i];
			return 0;
		}
	}
	log_error(log,
		"%s: the format is unknown; limber reads .gltf, .glb and .x: export the model as .glb",
		source->name);
	return -ENOTSUP;
}

enum {
	WARNINGS_MAX = 8 /* limits the warnings about one file */
};

struct limited_log {
	const struct log *log;
	int warnings;
};

static void write_limited(void *user, enum log_level level, const char *sentence)
{
	struct limited_log *limited = user;

	if (level != LOG_WARNING || limited->warnings < WARNINGS_MAX) {
		log_write(limited->log, level, "%s", sentence);
	}
	limited->warnings += level == LOG_WARNING && limited->warnings < INT_MAX;
}

static struct log begin_limit(struct limited_log *limited, const struct log *log)
{
	*limited = (struct limited_log){.log = log};
	return (struct log){
		.write = write_limited,
		.user = limited,
		.threshold = log->threshold,
	};
}

static void end_limit(
	const struct limited_log *limited, const struct model_source *source)
{
	if (limited->warnings > WARNINGS_MAX) {
		log_warning(limited->log,
			"%s: limber leaves out %d more warnings about this file",
			source->name, limited->warnings - WARNINGS_MAX);
	}
}

enum {
	MILLION = 1000000,
	MANY_PIXELS = 50 * MILLION, /* ten seconds of the board's time */
	BOARD_PIXELS_A_S = 5 * MILLION
};

/* Says what large images cost at each start, of which little is seen. */
static void warn_of_pixels(const struct model *model, const struct log *log)
{
	size_t all = 0, used = 0;

	for (int i = 0; i < model->image_count; i++) {
		const struct model_image *image = &model->image[i];

		all += (size_t)image->file_width * (size_t)image->file_height;
		used += (size_t)image->width * (size_t)image->height;
	}
	if (all > MANY_PIXELS && used < all / 2) {
		log_warning(log,
			"%s: its images have %zu million pixels, of which limber uses %zu million: reading them takes a board about %zu s at each start: scale them to 1024x1024",
			model->path, all / MILLION, used / MILLION,
			all / BOARD_PIXELS_A_S);
	}
}

static void give_back_images(const struct model *model)
{
	for (int i = 0; i < model->image_count; i++) {
		memory_budget_give_back(
			model->budget, image_held_bytes(&model->image[i]));
	}
}

static int load_source(const struct model_source *source, const struct log *log,
	struct model **out)
{
	const struct model_format *format;
	struct limited_log limited;
	const struct log few = begin_limit(&limited, log);
	int error = find_format(source, log, &format);

	*out = NULL;
	if (!error) {
		error = format->load(source, &few, out);
		end_limit(&limited, source);
	}
	if (!error) {
		memory_budget_give_back((*out)->budget, source->size);
		give_back_images(*out);
		warn_of_pixels(*out, log);
		model_prepare_clips(*out);
	}
	return error;
}

int model_examine(const char *path, size_t memory_bytes,
	const struct examiner *examiner, const struct log *log)
{
	struct model_source source = {
		.name = path,
		.has_folder = true,
		.memory_bytes = memory_bytes,
	};
	const struct model_format *format;
	struct model_file file;
	int error = model_file_read(path, NULL, log, &file);

	if (error) {
		return error;
	}
	source.data = file.data;
	source.size = file.size;
	error = find_format(&source, log, &format);
	if (!error) {
		struct limited_log limited;
		const struct log few = begin_limit(&limited, log);

		error = format->examine(&source, examiner, &few);
		end_limit(&limited, &source);
	}
	model_file_release(&file);
	return error;
}

int model_load(const char *path, const struct log *log, struct model **out)
{
	return model_load_within(path, MODEL_MEMORY_BYTES, log, out);
}

int model_load_within(const char *path, size_t memory_bytes,
	const struct log *log, struct model **out)
{
	struct model_source source = {
		.name = path,
		.has_folder = true,
		.memory_bytes = memory_bytes,
	};
	struct memory_budget budget = {.limit_bytes = memory_bytes};
	struct model_file file;
	int error;

	*out = NULL;
	error = model_file_read(path, &budget, log, &file);
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
	struct model_source source = {
		.name = name,
		.data = data,
		.size = size,
		.memory_bytes = MODEL_MEMORY_BYTES,
	};

	return load_source(&source, log, out);
}
