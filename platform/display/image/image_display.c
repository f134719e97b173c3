/*
 * Writes pictures to a file, whose extension chooses the format.
 */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "platform/base/name_list.h"
#include "platform/display/display.h"
#include "platform/display/image/writer.h"
#include "platform/display/packing.h"

struct display {
	struct pixels pixels;   /* the GL driver draws into it */
	struct pixels rgba;     /* the converted picture, if pixels is RGB565 */
	struct packing packing; /* from pixels to rgba */
	const struct image_writer_kind *kind;
	struct image_writer *writer;
};

static const struct image_writer_kind *const kinds[] = {
	&image_writer_png,
	&image_writer_gif,
	&image_writer_y4m,
	NULL,
};

/* Never chosen by auto, because it needs a file name. */
static bool image_probe(void)
{
	return false;
}

static const struct image_writer_kind *find_kind(
	const char *path, const struct log *log)
{
	struct name_list names = {""};
	size_t length = strlen(path);

	for (int i = 0; kinds[i]; i++) {
		size_t tail = strlen(kinds[i]->extension);

		if (length > tail &&
			strcasecmp(path + length - tail, kinds[i]->extension) ==
				0) {
			return kinds[i];
		}
		name_list_add(&names, kinds[i]->extension);
	}
	log_error(log, "%s: the name must end in one of %s", path, names.text);
	return NULL;
}

static void image_destroy(struct display *display)
{
	if (display) {
		if (display->kind) {
			display->kind->destroy(display->writer);
		}
		free(display->pixels.data);
		free(display->rgba.data);
		free(display);
	}
}

static int image_check(const struct display_options *options)
{
	if (!options->output || !options->output[0]) {
		log_error(options->log,
			"--display image: there is no file to write: add -o FILE");
		return -EINVAL;
	}
	return find_kind(options->output, options->log) ? 0 : -EINVAL;
}

static int open_writer(
	struct display *display, const struct display_options *options)
{
	struct image_options image = {
		.path = options->output,
		.width = options->width,
		.height = options->height,
		.frame_count = options->frame_count,
		.rate_hz = options->rate_hz > 0 ? options->rate_hz : 30,
		.log = options->log,
	};

	display->kind = find_kind(options->output, options->log);
	return display->kind->create(&image, &display->writer);
}

static int alloc_pictures(
	struct display *display, const struct display_options *options)
{
	const struct pixel_layout rgba = pixel_layout_of(PIXELS_RGBA8888);
	enum pixel_format format =
		options->format_given ? options->format : PIXELS_RGBA8888;
	int error = pixels_alloc(&display->pixels, options->width,
		options->height, format, options->log);

	if (!error && format != PIXELS_RGBA8888) {
		packing_init(&display->packing, format, &rgba);
		error = pixels_alloc(&display->rgba, options->width,
			options->height, PIXELS_RGBA8888, options->log);
	}
	return error;
}

static int image_create(
	const struct display_options *options, struct display **out)
{
	int error = image_check(options);
	struct display *display;

	if (error) {
		return error;
	}
	display = calloc(1, sizeof(*display));
	if (!display) {
		log_error(options->log, "%s: out of memory", options->output);
		return -ENOMEM;
	}
	error = alloc_pictures(display, options);
	if (!error) {
		error = open_writer(display, options);
	}
	if (error) {
		image_destroy(display);
		return error;
	}
	*out = display;
	return 0;
}

static void image_get_info(
	const struct display *display, struct display_info *out)
{
	*out = (struct display_info){
		.width = display->pixels.width,
		.height = display->pixels.height,
		.format = display->pixels.format,
	};
}

static int image_begin_frame(struct display *display, struct pixels *out)
{
	*out = display->pixels;
	return 0;
}

static int image_end_frame(struct display *display)
{
	if (!display->rgba.data) {
		return display->kind->add(display->writer, &display->pixels);
	}
	packing_copy(&display->packing, &display->pixels, display->rgba.data,
		display->rgba.stride_bytes);
	return display->kind->add(display->writer, &display->rgba);
}

static int image_finish(struct display *display)
{
	return display->kind->finish(display->writer);
}

const struct display_driver display_driver_image = {
	.name = "image",
	.summary = "writes a .png, .gif or .y4m file",
	.probe = image_probe,
	.check = image_check,
	.create = image_create,
	.get_info = image_get_info,
	.begin_frame = image_begin_frame,
	.end_frame = image_end_frame,
	.finish = image_finish,
	.destroy = image_destroy,
};
