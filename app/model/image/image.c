#include "app/model/image/image.h"

#include "app/model/image/image_codec.h"

#include <errno.h>
#include <string.h>

static const struct image_codec *find_codec(const uint8_t *data, size_t size)
{
	static const struct image_codec *const codecs[] = {
		&image_codec_png,
		&image_codec_jpeg,
	};
	size_t i;

	for (i = 0; i < ARRAY_COUNT(codecs); i++) {
		if (size > codecs[i]->magic_bytes &&
			memcmp(data, codecs[i]->magic,
				codecs[i]->magic_bytes) == 0) {
			return codecs[i];
		}
	}
	return NULL;
}

static int check_size(const struct image_input *input, int width, int height)
{
	if (width < 1 || height < 1) {
		log_error(input->log, "%s: the image has no pixels",
			input->where);
		return -EINVAL;
	}
	if (width > IMAGE_SIDE_MAX || height > IMAGE_SIDE_MAX) {
		log_error(input->log,
			"%s: the image has %dx%d pixels; limber reads up to %d in width and height",
			input->where, width, height, IMAGE_SIDE_MAX);
		return -EFBIG;
	}
	return 0;
}

static int measure(const struct image_codec *codec,
	const struct image_input *input, int *width, int *height)
{
	int error;

	if (!codec) {
		log_error(input->log, "%s: the image is neither PNG nor JPEG",
			input->where);
		return -ENOTSUP;
	}
	error = codec->measure(input, width, height);
	return error ? error : check_size(input, *width, *height);
}

static bool is_opaque(const struct model_image *image)
{
	size_t total = (size_t)image->width * (size_t)image->height;
	size_t i;

	for (i = 0; i < total; i++) {
		if (image->rgba[i * 4 + 3] != 255) {
			return false;
		}
	}
	return true;
}

/*
 * Whether both sides stay as long as textures. An image is halved only once, so
 * that the memory budget bounds the time that small files can ask for.
 */
static bool is_halved(int width, int height)
{
	return width >= 2 * IMAGE_SIDE_USED && height >= 2 * IMAGE_SIDE_USED;
}

int image_decode(const uint8_t *data, size_t size, const char *where,
	const struct log *log, struct arena *arena, struct model_image *out)
{
	const struct image_codec *codec = find_codec(data, size);
	struct image_input input = {data, size, where, log, arena->budget};
	int error = measure(codec, &input, &out->file_width, &out->file_height);
	bool halve;

	if (error) {
		return error;
	}
	halve = is_halved(out->file_width, out->file_height);
	out->width = halve ? (out->file_width + 1) / 2 : out->file_width;
	out->height = halve ? (out->file_height + 1) / 2 : out->file_height;
	out->rgba =
		arena_alloc(arena, (size_t)out->width * (size_t)out->height, 4);
	if (!out->rgba) {
		return memory_budget_fail(arena->budget, where, log);
	}
	error = codec->decode(
		&input, out->file_width, out->file_height, halve, out->rgba);
	if (!error) {
		out->opaque = is_opaque(out);
	}
	return error;
}
