#include "tests/support/gl/picture.h"

#include <png.h>
#include <stdlib.h>
#include <string.h>

enum {
	BLOCK = 16,
	GAIN = 8
};

struct picture picture_new(int width, int height)
{
	return (struct picture){
		.width = width,
		.height = height,
		.rgb = calloc((size_t)width * (size_t)height, 3),
	};
}

void picture_release(struct picture *picture)
{
	free(picture->rgb);
	*picture = (struct picture){0};
}

int picture_read(const char *path, struct picture *out)
{
	png_image image = {.version = PNG_IMAGE_VERSION};

	*out = (struct picture){0};
	if (!png_image_begin_read_from_file(&image, path)) {
		return -1;
	}
	image.format = PNG_FORMAT_RGB;
	*out = picture_new((int)image.width, (int)image.height);
	if (!out->rgb ||
		!png_image_finish_read(&image, NULL, out->rgb, 0, NULL)) {
		png_image_free(&image);
		picture_release(out);
		return -1;
	}
	return 0;
}

int picture_write(const char *path, const struct picture *picture)
{
	png_image image = {
		.version = PNG_IMAGE_VERSION,
		.width = (png_uint_32)picture->width,
		.height = (png_uint_32)picture->height,
		.format = PNG_FORMAT_RGB,
	};

	return png_image_write_to_file(&image, path, 0, picture->rgb, 0, NULL)
		? 0
		: -1;
}

static const uint8_t *pixel(const struct picture *picture, int x, int y)
{
	return picture->rgb +
		3 * ((size_t)y * (size_t)picture->width + (size_t)x);
}

/* The differences of one block: sum, maximum, number of far pixels. */
struct block_sum {
	long sum;
	int count, far, worst;
};

static struct block_sum sum_block(const struct picture *a,
	const struct picture *b, int left, int top, int step)
{
	struct block_sum sum = {0};

	for (int y = top; y < top + BLOCK && y < a->height; y++) {
		for (int x = left; x < left + BLOCK && x < a->width; x++) {
			int worst = 0;

			for (int k = 0; k < 3; k++) {
				int off = abs(
					pixel(a, x, y)[k] - pixel(b, x, y)[k]);

				sum.sum += off;
				worst = off > worst ? off : worst;
			}
			sum.count++;
			sum.far += worst > step;
			sum.worst = worst > sum.worst ? worst : sum.worst;
		}
	}
	return sum;
}

/* Whether a's pixel has a colour that b does not have there (see strays). */
static bool is_alone(const struct picture *a, const struct picture *b, int x,
	int y, int step)
{
	for (int k = 0; k < 3; k++) {
		int low = 255, high = 0, value = pixel(a, x, y)[k];

		for (int i = 0; i < 9; i++) {
			int left = x + i % 3 - 1, top = y + i / 3 - 1;

			if (left >= 0 && left < b->width && top >= 0 &&
				top < b->height) {
				int other = pixel(b, left, top)[k];

				low = other < low ? other : low;
				high = other > high ? other : high;
			}
		}
		if (value < low - step || value > high + step) {
			return true;
		}
	}
	return false;
}

static bool is_far(const uint8_t *a, const uint8_t *b, int step)
{
	return abs(a[0] - b[0]) > step || abs(a[1] - b[1]) > step ||
		abs(a[2] - b[2]) > step;
}

static int count_strays(const struct picture *a, const struct picture *b,
	int left, int top, int step)
{
	int count = 0;

	for (int y = top; y < top + BLOCK && y < a->height; y++) {
		for (int x = left; x < left + BLOCK && x < a->width; x++) {
			count += is_far(pixel(a, x, y), pixel(b, x, y), step) &&
				(is_alone(a, b, x, y, step) ||
					is_alone(b, a, x, y, step));
		}
	}
	return count;
}

/* Blocks overlap by half, so that one of them holds all of a patch of 8 x 8. */
static void find_strays(const struct picture *a, const struct picture *b,
	int step, struct picture_difference *out)
{
	for (int top = 0; top < a->height; top += BLOCK / 2) {
		for (int left = 0; left < a->width; left += BLOCK / 2) {
			int count = count_strays(a, b, left, top, step);

			if (count > out->block_strays) {
				out->block_strays = count;
				out->stray_x = left;
				out->stray_y = top;
			}
		}
	}
}

struct picture_difference picture_compare(
	const struct picture *a, const struct picture *b, int step)
{
	struct picture_difference out = {0};
	double pixels = (double)a->width * a->height;
	double sum = 0;
	double far = 0;

	if (a->width != b->width || a->height != b->height) {
		return out;
	}
	out.same_size = true;
	for (int top = 0; top < a->height; top += BLOCK) {
		for (int left = 0; left < a->width; left += BLOCK) {
			struct block_sum block =
				sum_block(a, b, left, top, step);
			double mean = (double)block.sum / (3.0 * block.count);

			sum += (double)block.sum;
			far += block.far;
			if (block.worst > out.worst) {
				out.worst = block.worst;
			}
			if (mean > out.block_mean) {
				out.block_mean = mean;
				out.block_x = left;
				out.block_y = top;
			}
		}
	}
	out.mean = sum / (3 * pixels);
	out.far_percent = 100 * far / pixels;
	find_strays(a, b, step, &out);
	return out;
}

bool picture_is_near(const struct picture_difference *difference,
	const struct picture_tolerance *tolerance)
{
	return difference->same_size &&
		difference->far_percent <= tolerance->far_percent &&
		difference->mean <= tolerance->mean &&
		difference->block_mean <= tolerance->block_mean &&
		difference->block_strays <= tolerance->block_strays;
}

struct picture picture_show_difference(
	const struct picture *a, const struct picture *b)
{
	struct picture out = {0};
	size_t row = 3 * (size_t)a->width;

	if (a->width != b->width || a->height != b->height) {
		return out;
	}
	out = picture_new(3 * a->width, a->height);
	for (int y = 0; out.rgb && y < a->height; y++) {
		uint8_t *to = out.rgb + 3 * row * (size_t)y;

		memcpy(to, pixel(a, 0, y), row);
		memcpy(to + row, pixel(b, 0, y), row);
		for (size_t i = 0; i < row; i++) {
			int off = GAIN * abs(to[i] - to[row + i]);

			to[2 * row + i] = (uint8_t)(off > 255 ? 255 : off);
		}
	}
	return out;
}
