#include "app/model/image/image_codec.h"

#include <errno.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdio.h>

#include <jpeglib.h>

enum {
	/* An encoder needs about ten; hostile files have thousands. */
	SCANS_MAX = 100,
};

struct reading {
	struct jpeg_decompress_struct jpeg;
	struct jpeg_error_mgr errors;
	struct jpeg_progress_mgr progress;
	jmp_buf leave;
	const struct image_input *input;
	char problem[JMSG_LENGTH_MAX];
};

static void keep_error(j_common_ptr jpeg)
{
	struct reading *reading = jpeg->client_data;

	jpeg->err->format_message(jpeg, reading->problem);
	longjmp(reading->leave, 1);
}

/* Negative levels are warnings: the data is damaged from there on. */
static void keep_warning(j_common_ptr jpeg, int level)
{
	struct reading *reading = jpeg->client_data;

	if (level < 0 && jpeg->err->num_warnings++ == 0) {
		jpeg->err->format_message(jpeg, reading->problem);
	}
}

static void drop_message(j_common_ptr jpeg)
{
	(void)jpeg;
}

static void limit_scans(j_common_ptr jpeg)
{
	struct reading *reading = jpeg->client_data;

	if (reading->jpeg.input_scan_number > SCANS_MAX) {
		snprintf(reading->problem, sizeof(reading->problem),
			"more than %d scans", SCANS_MAX);
		longjmp(reading->leave, 1);
	}
}

static void begin(struct reading *reading, const struct image_input *input)
{
	*reading = (struct reading){.input = input};
	reading->jpeg.err = jpeg_std_error(&reading->errors);
	reading->jpeg.client_data = reading;
	reading->errors.error_exit = keep_error;
	reading->errors.emit_message = keep_warning;
	reading->errors.output_message = drop_message;
	reading->progress.progress_monitor = limit_scans;
}

static int end(struct reading *reading, bool fine)
{
	const struct image_input *input = reading->input;

	jpeg_destroy_decompress(&reading->jpeg);
	if (!fine) {
		log_error(input->log, "%s: is a broken JPEG: %s", input->where,
			reading->problem);
		return -EINVAL;
	}
	if (reading->errors.num_warnings > 0) {
		log_warning(input->log, "%s: is a damaged JPEG: %s",
			input->where, reading->problem);
	}
	return 0;
}

static bool read_header(struct reading *reading)
{
	const struct image_input *input = reading->input;

	if (setjmp(reading->leave)) {
		return false;
	}
	jpeg_create_decompress(&reading->jpeg);
	reading->jpeg.progress = &reading->progress;
	jpeg_mem_src(&reading->jpeg, input->data, (unsigned long)input->size);
	jpeg_read_header(&reading->jpeg, TRUE);
	return true;
}

static bool read_pixels(struct reading *reading, uint8_t *rgba)
{
	struct jpeg_decompress_struct *jpeg = &reading->jpeg;

	if (setjmp(reading->leave)) {
		return false;
	}
	jpeg->out_color_space = JCS_EXT_RGBA;
	jpeg_start_decompress(jpeg);
	while (jpeg->output_scanline < jpeg->output_height) {
		JSAMPROW row = rgba +
			(size_t)jpeg->output_scanline * jpeg->output_width * 4;

		jpeg_read_scanlines(jpeg, &row, 1);
	}
	jpeg_finish_decompress(jpeg);
	return true;
}

static int measure(const struct image_input *input, int *width, int *height)
{
	struct reading reading;
	bool fine;

	begin(&reading, input);
	fine = read_header(&reading);
	if (fine) {
		*width = (int)reading.jpeg.image_width;
		*height = (int)reading.jpeg.image_height;
	}
	reading.errors.num_warnings = 0;
	return end(&reading, fine);
}

static int decode(
	const struct image_input *input, int width, int height, uint8_t *rgba)
{
	struct reading reading;
	bool fine;

	(void)width;
	(void)height;
	begin(&reading, input);
	fine = read_header(&reading);
	fine = fine && read_pixels(&reading, rgba);
	return end(&reading, fine);
}

const struct image_codec image_codec_jpeg = {
	.magic = "\xff\xd8\xff",
	.magic_bytes = 3,
	.measure = measure,
	.decode = decode,
};
