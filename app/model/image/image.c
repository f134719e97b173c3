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
			"%s: the image has %dx%d pixels; limber reads up to %d in width and height: save it smaller, as limber shows up to %d",
			input->where, width, height, IMAGE_SIDE_MAX,
			IMAGE_SIDE_USED);
		return -EFBIG;
	}
	return 0;
}

static int measure(const struct image_codec *codec,
	const struct image_input *input, int *width, int *height)
{
	int error;

	if (!codec) {
		log_error(input->log,
			"%s: the image is neither PNG nor JPEG: convert it to one of them",
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

/* How often an image is halved while both sides stay as long as textures. */
static int count_halvings(int width, int height)
{
	int least = width < height ? width : height, count = 0;

	while (least >> count >= 2 * IMAGE_SIDE_USED) {
		count++;
	}
	return count;
}

size_t image_held_bytes(const struct model_image *image)
{
	size_t pixels = (size_t)image->file_width * (size_t)image->file_height;
	size_t bytes = (size_t)image->width * (size_t)image->height * 4;

	return pixels > bytes ? pixels - bytes : 0;
}

int image_decode(const uint8_t *data, size_t size, const char *where,
	const struct log *log, struct arena *arena, struct model_image *out)
{
	const struct image_codec *codec = find_codec(data, size);
	struct image_input input = {data, size, where, log, arena->budget};
	int error = measure(codec, &input, &out->file_width, &out->file_height);
	int halvings, step;

	if (error) {
		return error;
	}
	halvings = count_halvings(out->file_width, out->file_height);
	step = 1 << halvings;
	out->width = (out->file_width + step - 1) / step;
	out->height = (out->file_height + step - 1) / step;
	out->rgba =
		arena_alloc(arena, (size_t)out->width * (size_t)out->height, 4);
	if (!out->rgba ||
		!memory_budget_take(arena->budget, image_held_bytes(out))) {
		return memory_budget_fail(arena->budget, where, log);
	}
	error = codec->decode(
		&input, out->file_width, out->file_height, halvings, out->rgba);
	if (error) {
		memory_budget_give_back(arena->budget, image_held_bytes(out));
	} else {
		out->opaque = is_opaque(out);
	}
	return error;
}
