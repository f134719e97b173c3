#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/output_file.h"
#include "platform/display/image/writer.h"

struct image_writer {
	struct output_file *output;
	int width, height;
	uint8_t *planes; /* Y, then Cb and Cr of half the size, rounded up */
	size_t size;
};

static void y4m_destroy(struct image_writer *y4m)
{
	if (y4m) {
		output_file_discard(y4m->output);
		free(y4m->planes);
		free(y4m);
	}
}

static bool is_within(double value, double wanted, double apart)
{
	return value - wanted < apart && wanted - value < apart;
}

/*
 * Writes the rate as a fraction: N/1, N*1000/1001 (NTSC) or N/1000. The
 * distance to NTSC's rate that is allowed for rounding is small beside the rate.
 */
static void write_header(const struct image_writer *y4m, double rate_hz)
{
	int whole = (int)(rate_hz + 0.5);
	double ntsc = whole * 1000.0 / 1001.0;
	int numerator = (int)(rate_hz * 1000.0 + 0.5);
	int denominator = 1000;

	if (is_within(rate_hz, whole, 1e-6)) {
		numerator = whole;
		denominator = 1;
	} else if (is_within(rate_hz, ntsc, 1e-2) &&
		is_within(rate_hz, ntsc, 4.2e-4 * ntsc)) {
		numerator = whole * 1000;
		denominator = 1001;
	}
	fprintf(output_file_stream(y4m->output),
		"YUV4MPEG2 W%d H%d F%d:%d Ip A1:1 C420jpeg XYSCSS=420JPEG XCOLORRANGE=LIMITED\n",
		y4m->width, y4m->height, numerator, denominator);
}

static int y4m_create(
	const struct image_options *options, struct image_writer **out)
{
	struct image_writer *y4m = calloc(1, sizeof(*y4m));
	size_t half = (size_t)((options->width + 1) / 2) *
		(size_t)((options->height + 1) / 2);
	int error = -ENOMEM;

	if (y4m) {
		y4m->width = options->width;
		y4m->height = options->height;
		y4m->size = (size_t)options->width * (size_t)options->height +
			2 * half;
		y4m->planes = malloc(y4m->size);
	}
	if (!y4m || !y4m->planes) {
		log_error(options->log, "%s: out of memory", options->path);
		goto fail;
	}
	error = output_file_create(options->path, options->log, &y4m->output);
	if (error) {
		goto fail;
	}
	write_header(y4m, options->rate_hz);
	*out = y4m;
	return 0;

fail:
	y4m_destroy(y4m);
	return error;
}

/* ITU-R BT.601 in limited range, 16..235, with coefficients in Q16. */
static uint8_t luma(int red, int green, int blue)
{
	return (uint8_t)((16829 * red + 33039 * green + 6416 * blue +
				 (16 << 16) + (1 << 15)) >>
		16);
}

static void write_luma(const struct pixels *frame, uint8_t *out)
{
	for (int y = 0; y < frame->height; y++) {
		const uint8_t *in = frame->data + y * frame->stride_bytes;

		for (int x = 0; x < frame->width; x++, in += 4) {
			*out++ = luma(in[0], in[1], in[2]);
		}
	}
}

/* BT.601 chroma, 16..240 around 128, from the sums of four pixels' channels. */
static void write_chroma_pair(const int sum[3], uint8_t *cb, uint8_t *cr)
{
	int middle = (128 << 18) + (1 << 17);

	*cb = (uint8_t)((-9714 * sum[0] - 19071 * sum[1] + 28785 * sum[2] +
				middle) >>
		18);
	*cr = (uint8_t)((28785 * sum[0] - 24103 * sum[1] - 4682 * sum[2] +
				middle) >>
		18);
}

/* Averages 2 x 2 pixels. At an odd edge the last pixel counts twice. */
static void write_chroma(const struct pixels *frame, uint8_t *cb, uint8_t *cr)
{
	for (int y = 0; y < frame->height; y += 2) {
		const uint8_t *upper = frame->data + y * frame->stride_bytes;
		const uint8_t *lower = y + 1 < frame->height
			? upper + frame->stride_bytes
			: upper;

		for (int x = 0; x < frame->width; x += 2) {
			int next = x + 1 < frame->width ? 4 : 0;
			int sum[3];

			for (int i = 0; i < 3; i++) {
				sum[i] = upper[i] + upper[next + i] + lower[i] +
					lower[next + i];
			}
			write_chroma_pair(sum, cb++, cr++);
			upper += 8;
			lower += 8;
		}
	}
}

static int y4m_add(struct image_writer *y4m, const struct pixels *frame)
{
	size_t full = (size_t)y4m->width * (size_t)y4m->height;
	size_t half = (y4m->size - full) / 2;
	FILE *stream = output_file_stream(y4m->output);

	write_luma(frame, y4m->planes);
	write_chroma(frame, y4m->planes + full, y4m->planes + full + half);
	if (fputs("FRAME\n", stream) < 0 ||
		fwrite(y4m->planes, y4m->size, 1, stream) != 1) {
		return output_file_failed(y4m->output, strerror(EIO));
	}
	return 0;
}

static int y4m_finish(struct image_writer *y4m)
{
	struct output_file *output = y4m->output;

	y4m->output = NULL;
	return output_file_commit(output);
}

const struct image_writer_kind image_writer_y4m = {
	.extension = ".y4m",
	.create = y4m_create,
	.add = y4m_add,
	.finish = y4m_finish,
	.destroy = y4m_destroy,
};
