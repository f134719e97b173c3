#include "app/model/image/image_codec.h"
#include "platform/base/interrupt.h"

#include <errno.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdio.h>

#include <jpeglib.h>

#include <jerror.h>

enum {
	/* Encoders write about ten scans. A hostile file may have thousands. */
	SCANS_MAX = 100,
	/* A limit of pixels times scans: 32 scans of the largest image. */
	SCANNED_PIXELS_MAX = 512 * 1024 * 1024,
};

struct decoder {
	struct jpeg_decompress_struct jpeg;
	struct jpeg_error_mgr errors;
	struct jpeg_progress_mgr progress;
	jmp_buf leave;
	const struct image_input *input;
	char problem[JMSG_LENGTH_MAX];
};

static void keep_error(j_common_ptr jpeg)
{
	struct decoder *decoder = jpeg->client_data;

	jpeg->err->format_message(jpeg, decoder->problem);
	longjmp(decoder->leave, 1);
}

/* libjpeg gives warnings a negative level. Keeps the first one. */
static void keep_warning(j_common_ptr jpeg, int level)
{
	struct decoder *decoder = jpeg->client_data;

	if (level < 0 && jpeg->err->num_warnings++ == 0) {
		jpeg->err->format_message(jpeg, decoder->problem);
	}
}

static void drop_message(j_common_ptr jpeg)
{
	(void)jpeg;
}

/* Called for every few rows of each scan. */
static void limit_time(j_common_ptr jpeg)
{
	struct decoder *decoder = jpeg->client_data;
	int scans = decoder->jpeg.input_scan_number;
	size_t pixels = (size_t)decoder->jpeg.image_width *
		(size_t)decoder->jpeg.image_height;

	if (interrupt_pending()) {
		longjmp(decoder->leave, 1);
	}
	if (scans > SCANS_MAX ||
		(scans > 0 && pixels > SCANNED_PIXELS_MAX / (size_t)scans)) {
		snprintf(decoder->problem, sizeof(decoder->problem),
			"it has more than %d scans",
			scans > SCANS_MAX ? SCANS_MAX : scans - 1);
		longjmp(decoder->leave, 1);
	}
}

static void begin(struct decoder *decoder, const struct image_input *input)
{
	*decoder = (struct decoder){.input = input};
	decoder->jpeg.err = jpeg_std_error(&decoder->errors);
	decoder->jpeg.client_data = decoder;
	decoder->errors.error_exit = keep_error;
	decoder->errors.emit_message = keep_warning;
	decoder->errors.output_message = drop_message;
	decoder->progress.progress_monitor = limit_time;
}

static int end(struct decoder *decoder, bool fine)
{
	const struct image_input *input = decoder->input;

	jpeg_destroy_decompress(&decoder->jpeg);
	if (!fine && interrupt_pending()) {
		return -EINTR;
	}
	if (!fine && decoder->errors.msg_code == JERR_OUT_OF_MEMORY) {
		log_error(input->log, "%s: there is not enough memory",
			input->where);
		return -ENOMEM;
	}
	if (!fine) {
		log_error(input->log, "%s: the JPEG image is broken: %s",
			input->where, decoder->problem);
		return -EINVAL;
	}
	if (decoder->errors.num_warnings > 0) {
		log_warning(input->log, "%s: the JPEG image is damaged: %s",
			input->where, decoder->problem);
	}
	return 0;
}

static bool read_header(struct decoder *decoder)
{
	const struct image_input *input = decoder->input;

	if (setjmp(decoder->leave)) {
		return false;
	}
	jpeg_create_decompress(&decoder->jpeg);
	decoder->jpeg.progress = &decoder->progress;
	jpeg_mem_src(&decoder->jpeg, input->data, (unsigned long)input->size);
	jpeg_read_header(&decoder->jpeg, TRUE);
	return true;
}

static bool is_cmyk(const struct jpeg_decompress_struct *jpeg)
{
	return jpeg->jpeg_color_space == JCS_CMYK ||
		jpeg->jpeg_color_space == JCS_YCCK;
}

/*
 * Converts a row of CMYK to RGBA in place. Adobe's programs, which mark their
 * files, store inverted values: 255 is no ink.
 */
static void convert_cmyk(uint8_t *row, int width, bool inverted)
{
	for (uint8_t *p = row; p < row + (size_t)width * 4; p += 4) {
		int black = inverted ? p[3] : 255 - p[3];

		for (int i = 0; i < 3; i++) {
			int color = inverted ? p[i] : 255 - p[i];

			p[i] = (uint8_t)((color * black + 127) / 255);
		}
		p[3] = 255;
	}
}

static bool read_pixels(struct decoder *decoder, int halvings, uint8_t *rgba)
{
	struct jpeg_decompress_struct *jpeg = &decoder->jpeg;
	bool cmyk = is_cmyk(jpeg);

	if (setjmp(decoder->leave)) {
		return false;
	}
	jpeg->out_color_space = cmyk ? JCS_CMYK : JCS_EXT_RGBA;
	jpeg->scale_num = 1;
	jpeg->scale_denom = 1u << halvings;
	jpeg_start_decompress(jpeg);
	while (jpeg->output_scanline < jpeg->output_height) {
		JSAMPROW row = rgba +
			(size_t)jpeg->output_scanline * jpeg->output_width * 4;

		jpeg_read_scanlines(jpeg, &row, 1);
		if (cmyk) {
			convert_cmyk(row, (int)jpeg->output_width,
				jpeg->saw_Adobe_marker);
		}
	}
	jpeg_finish_decompress(jpeg);
	return true;
}

static int measure(const struct image_input *input, int *width, int *height)
{
	struct decoder decoder;
	bool fine;

	begin(&decoder, input);
	fine = read_header(&decoder);
	if (fine) {
		*width = (int)decoder.jpeg.image_width;
		*height = (int)decoder.jpeg.image_height;
	}
	decoder.errors.num_warnings = 0;
	return end(&decoder, fine);
}

/*
 * libjpeg keeps all coefficients of an image with several scans: 16 bits for
 * each component of a pixel.
 */
static size_t coefficient_bytes(struct decoder *decoder, int width, int height)
{
	return jpeg_has_multiple_scans(&decoder->jpeg)
		? (size_t)width * (size_t)height *
			(size_t)decoder->jpeg.num_components * sizeof(JCOEF)
		: 0;
}

static int decode(const struct image_input *input, int width, int height,
	int halvings, uint8_t *rgba)
{
	struct decoder decoder;
	size_t kept = 0;
	bool fine;
	int error;

	begin(&decoder, input);
	fine = read_header(&decoder);
	if (fine) {
		kept = coefficient_bytes(&decoder, width, height);
		if (!memory_budget_take(input->budget, kept)) {
			jpeg_destroy_decompress(&decoder.jpeg);
			return memory_budget_fail(
				input->budget, input->where, input->log);
		}
	}
	fine = fine && read_pixels(&decoder, halvings, rgba);
	error = end(&decoder, fine);
	memory_budget_give_back(input->budget, kept);
	return error;
}

const struct image_codec image_codec_jpeg = {
	.magic = "\xff\xd8\xff",
	.magic_bytes = 3,
	.measure = measure,
	.decode = decode,
};
