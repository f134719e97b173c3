#include <errno.h>
#include <png.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/output_file.h"
#include "platform/display/image/writer.h"

struct image_writer {
	struct log log;
	char *path; /* of the current frame */
	int stem;   /* length of path before "-0001.png" */
	bool numbered;
	int frame;    /* frames begun */
	uint8_t *rgb; /* one frame */
};

/* Room for "-", the digits of an int, ".png" and the terminating zero. */
enum {
	SUFFIX_BYTES = 24
};

static void png_destroy(struct image_writer *png)
{
	if (png) {
		free(png->rgb);
		free(png->path);
		free(png);
	}
}

static int png_create(
	const struct image_options *options, struct image_writer **out)
{
	struct image_writer *png = calloc(1, sizeof(*png));
	size_t length = strlen(options->path);

	if (!png) {
		goto out_of_memory;
	}
	png->log = *options->log;
	png->path = malloc(length + SUFFIX_BYTES);
	png->rgb = malloc((size_t)options->width * (size_t)options->height * 3);
	if (!png->path || !png->rgb) {
		goto out_of_memory;
	}
	memcpy(png->path, options->path, length + 1);
	png->stem = (int)(length - strlen(image_writer_png.extension));
	png->numbered = options->frame_count != 1;
	*out = png;
	return 0;

out_of_memory:
	log_error(options->log, "%s: out of memory", options->path);
	png_destroy(png);
	return -ENOMEM;
}

static void drop_alpha(uint8_t *rgb, const struct pixels *frame)
{
	for (int y = 0; y < frame->height; y++) {
		const uint8_t *in = frame->data + y * frame->stride_bytes;

		for (int x = 0; x < frame->width; x++) {
			*rgb++ = *in++;
			*rgb++ = *in++;
			*rgb++ = *in++;
			in++;
		}
	}
}

static int write_frame(struct image_writer *png, const struct pixels *frame,
	struct output_file *output)
{
	png_image header = {
		.version = PNG_IMAGE_VERSION,
		.width = (png_uint_32)frame->width,
		.height = (png_uint_32)frame->height,
		.format = PNG_FORMAT_RGB,
	};
	int error;

	drop_alpha(png->rgb, frame);
	if (!png_image_write_to_stdio(&header, output_file_stream(output), 0,
		    png->rgb, 0, NULL)) {
		error = output_file_failed(output, header.message);
		output_file_discard(output);
		return error;
	}
	return output_file_commit(output);
}

static int png_add(struct image_writer *png, const struct pixels *frame)
{
	struct output_file *output;
	int error;

	png->frame++;
	if (png->numbered) {
		snprintf(png->path + png->stem, SUFFIX_BYTES, "-%04d%s",
			png->frame, image_writer_png.extension);
	}
	error = output_file_create(png->path, &png->log, &output);
	return error ? error : write_frame(png, frame, output);
}

static int png_finish(struct image_writer *png)
{
	(void)png;
	return 0;
}

const struct image_writer_kind image_writer_png = {
	.extension = ".png",
	.create = png_create,
	.add = png_add,
	.finish = png_finish,
	.destroy = png_destroy,
};
