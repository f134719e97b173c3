#include <errno.h>
#include <gif_lib.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/output_file.h"
#include "platform/display/image/palette.h"
#include "platform/display/image/writer.h"

enum {
	TRANSPARENT = 255, /* the index of pixels that keep their colour */
	COLORS = 256,
	DELAY_MIN_CS = 2, /* players replace shorter delays by 10 */
	DELAY_MAX_CS = 65535,
};

struct image_writer {
	struct output_file *output;
	GifFileType *gif;
	ColorMapObject *map;
	struct palette_maker *maker;
	int width, height;
	double rate_hz;
	int frame;           /* frames added so far */
	int next;            /* the number of the next frame to write */
	bool local;          /* the palette is not that of the first frame */
	float palette_error; /* of the frame that the palette was chosen for */
	uint8_t *source; /* [pixel][3]: RGB of the frame that set the pixel */
	uint8_t *index;  /* [pixel]: palette index in the current frame */
	int16_t *diffused[2]; /* error in 1/16, of this row and the next */
	/* The rectangle of changed pixels; empty if right < left. */
	int left, top, right, bottom;
};

static int write_bytes(GifFileType *gif, const GifByteType *bytes, int count)
{
	FILE *stream = output_file_stream(gif->UserData);

	return (int)fwrite(bytes, 1, (size_t)count, stream);
}

static void gif_destroy(struct image_writer *gif)
{
	int error;

	if (!gif) {
		return;
	}
	if (gif->gif) {
		EGifCloseFile(gif->gif, &error);
	}
	output_file_discard(gif->output);
	GifFreeMapObject(gif->map);
	palette_maker_destroy(gif->maker);
	free(gif->diffused[0]);
	free(gif->diffused[1]);
	free(gif->source);
	free(gif->index);
	free(gif);
}

static int failed(const struct image_writer *gif, int cause)
{
	const char *reason = GifErrorString(cause);

	return output_file_failed(gif->output,
		reason ? reason : "the GIF library gives no reason");
}

static bool allocate(struct image_writer *gif)
{
	size_t pixels = (size_t)gif->width * (size_t)gif->height;
	/* One more pixel at both ends saves a bounds check. */
	size_t row = ((size_t)gif->width + 2) * 3;

	gif->maker = palette_maker_create();
	gif->map = GifMakeMapObject(COLORS, NULL);
	gif->source = malloc(3 * pixels);
	gif->index = malloc(pixels);
	gif->diffused[0] = calloc(row, sizeof(int16_t));
	gif->diffused[1] = calloc(row, sizeof(int16_t));
	return gif->maker && gif->map && gif->source && gif->index &&
		gif->diffused[0] && gif->diffused[1];
}

static int gif_create(
	const struct image_options *options, struct image_writer **out)
{
	struct image_writer *gif = calloc(1, sizeof(*gif));
	int error = -ENOMEM;

	if (!gif) {
		log_error(options->log, "%s: out of memory", options->path);
		return error;
	}
	gif->width = options->width;
	gif->height = options->height;
	gif->rate_hz = options->rate_hz;
	if (!allocate(gif)) {
		log_error(options->log, "%s: out of memory", options->path);
		goto fail;
	}
	error = output_file_create(options->path, options->log, &gif->output);
	if (error) {
		goto fail;
	}
	gif->gif = EGifOpen(gif->output, write_bytes, NULL);
	if (!gif->gif) {
		error = -ENOMEM;
		log_error(options->log, "%s: out of memory", options->path);
		goto fail;
	}
	EGifSetGifVersion(gif->gif, true);
	*out = gif;
	return 0;

fail:
	gif_destroy(gif);
	return error;
}

/* The time at which a frame starts, in hundredths of a second. */
static int64_t start_cs(const struct image_writer *gif, int frame)
{
	return (int64_t)(frame * 100.0 / gif->rate_hz + 0.5);
}

/*
 * The duration of a frame in hundredths of a second. Also chooses the next
 * frame to write, which leaves out frames shorter than DELAY_MIN_CS.
 */
static int delay_cs(struct image_writer *gif, int frame)
{
	int64_t delay;

	gif->next = frame + 1;
	while (start_cs(gif, gif->next) - start_cs(gif, frame) < DELAY_MIN_CS) {
		gif->next++;
	}
	delay = start_cs(gif, gif->next) - start_cs(gif, frame);
	return delay < DELAY_MAX_CS ? (int)delay : DELAY_MAX_CS;
}

/* Keeps the palette while it fits, so that still pixels do not flicker. */
static void update_palette(struct image_writer *gif, const struct pixels *frame)
{
	const struct palette *palette = palette_current(gif->maker);
	bool first = palette->count == 0;

	if (!first &&
		palette_error(gif->maker, frame) <=
			1.5f * gif->palette_error + 4) {
		return;
	}
	palette_choose(gif->maker, frame, TRANSPARENT);
	gif->palette_error = palette_error(gif->maker, frame);
	gif->local = !first;
	for (int i = 0; i < palette->count; i++) {
		gif->map->Colors[i] = (GifColorType){palette->rgb[i][0],
			palette->rgb[i][1], palette->rgb[i][2]};
	}
}

static int limit_byte(int value)
{
	return value < 0 ? 0 : value > 255 ? 255 : value;
}

/*
 * Chooses the index of a pixel and diffuses its error after Floyd and
 * Steinberg: 7/16 to the next pixel, 3/16, 5/16 and 1/16 to the row below. here
 * and below point at this pixel's column; ahead is the distance to the next, 3
 * or -3. Each |error| is at most 255 and the weights that a pixel receives add
 * up to 16, so |sum| < 2^12.
 */
static int dither_pixel(struct image_writer *gif, const uint8_t *pixel,
	int16_t *here, int16_t *below, int ahead)
{
	const uint8_t *color;
	int wanted[3];
	int index;

	for (int i = 0; i < 3; i++) {
		wanted[i] = limit_byte(pixel[i] + ((here[i] + 8) >> 4));
	}
	index = palette_nearest(gif->maker, wanted[0], wanted[1], wanted[2]);
	color = palette_current(gif->maker)->rgb[index];
	for (int i = 0; i < 3; i++) {
		int error = wanted[i] - color[i];

		here[i + ahead] = (int16_t)(here[i + ahead] + 7 * error);
		below[i - ahead] = (int16_t)(below[i - ahead] + 3 * error);
		below[i] = (int16_t)(below[i] + 5 * error);
		below[i + ahead] = (int16_t)(below[i + ahead] + error);
	}
	return index;
}

static void note_change(struct image_writer *gif, int x, int y)
{
	gif->left = x < gif->left ? x : gif->left;
	gif->right = x > gif->right ? x : gif->right;
	gif->top = y < gif->top ? y : gif->top;
	gif->bottom = y;
}

/*
 * Chooses the indices of a row. Rows alternate in direction. Unless all is set,
 * pixels whose source has not changed become transparent.
 */
static void dither_row(
	struct image_writer *gif, const struct pixels *frame, int y, bool all)
{
	const uint8_t *row = frame->data + y * frame->stride_bytes;
	int16_t *here = gif->diffused[y % 2] + 3;
	int16_t *below = gif->diffused[1 - y % 2] + 3;
	int step = y % 2 ? -1 : 1;
	int x = y % 2 ? gif->width - 1 : 0;

	memset(below - 3, 0, ((size_t)gif->width + 2) * 3 * sizeof(*below));
	for (int i = 0; i < gif->width; i++, x += step) {
		size_t at = (size_t)y * (size_t)gif->width + (size_t)x;

		if (!all && memcmp(gif->source + 3 * at, row + 4 * x, 3) == 0) {
			gif->index[at] = TRANSPARENT;
			continue;
		}
		memcpy(gif->source + 3 * at, row + 4 * x, 3);
		gif->index[at] = (uint8_t)dither_pixel(gif, row + 4 * x,
			here + 3 * x, below + 3 * x, 3 * step);
		note_change(gif, x, y);
	}
}

static void dither_frame(
	struct image_writer *gif, const struct pixels *frame, bool all)
{
	gif->left = gif->width;
	gif->top = gif->height;
	gif->right = gif->bottom = -1;
	memset(gif->diffused[0], 0,
		((size_t)gif->width + 2) * 3 * sizeof(int16_t));
	for (int y = 0; y < gif->height; y++) {
		dither_row(gif, frame, y, all);
	}
	/* A frame must not be empty: it gets one transparent pixel. */
	if (gif->right < 0) {
		gif->left = gif->top = gif->right = gif->bottom = 0;
	}
}

static bool write_start(struct image_writer *gif)
{
	static const GifByteType forever[] = {1, 0, 0};

	return EGifPutScreenDesc(
		       gif->gif, gif->width, gif->height, 8, 0, gif->map) &&
		EGifPutExtensionLeader(gif->gif, APPLICATION_EXT_FUNC_CODE) &&
		EGifPutExtensionBlock(gif->gif, 11, "NETSCAPE2.0") &&
		EGifPutExtensionBlock(gif->gif, sizeof(forever), forever) &&
		EGifPutExtensionTrailer(gif->gif);
}

static bool write_picture(struct image_writer *gif, int delay)
{
	const GraphicsControlBlock control = {
		.DisposalMode = DISPOSE_DO_NOT,
		.DelayTime = delay,
		.TransparentColor = TRANSPARENT,
	};
	int width = gif->right - gif->left + 1;
	GifByteType bytes[4];
	size_t size = EGifGCBToExtension(&control, bytes);

	if (!EGifPutExtension(
		    gif->gif, GRAPHICS_EXT_FUNC_CODE, (int)size, bytes) ||
		!EGifPutImageDesc(gif->gif, gif->left, gif->top, width,
			gif->bottom - gif->top + 1, false,
			gif->local ? gif->map : NULL)) {
		return false;
	}
	for (int y = gif->top; y <= gif->bottom; y++) {
		uint8_t *row = gif->index + (size_t)y * (size_t)gif->width;

		if (!EGifPutLine(gif->gif, row + gif->left, width)) {
			return false;
		}
	}
	return true;
}

static int gif_add(struct image_writer *gif, const struct pixels *frame)
{
	int number = gif->frame++;
	int delay;
	bool written;

	if (number < gif->next) {
		return 0;
	}
	delay = delay_cs(gif, number);
	update_palette(gif, frame);
	dither_frame(gif, frame, number == 0);
	written = (number > 0 || write_start(gif)) && write_picture(gif, delay);
	return written ? 0 : failed(gif, gif->gif->Error);
}

static int gif_finish(struct image_writer *gif)
{
	struct output_file *output;
	int cause = 0;
	int closed;

	if (gif->frame == 0) {
		return output_file_failed(gif->output, "there is no frame");
	}
	closed = EGifCloseFile(gif->gif, &cause);
	gif->gif = NULL;
	if (!closed) {
		return failed(gif, cause);
	}
	output = gif->output;
	gif->output = NULL;
	return output_file_commit(output);
}

const struct image_writer_kind image_writer_gif = {
	.extension = ".gif",
	.create = gif_create,
	.add = gif_add,
	.finish = gif_finish,
	.destroy = gif_destroy,
};
