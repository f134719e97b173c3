/*
 * Progressive JPEG images: a few kilobytes of scans could keep a decoder busy
 * for minutes, so their number has limits.
 */
#include "app/model/image/image.h"
#include "platform/base/compiler.h"
#include "tests/support/jpeg_size.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <jpeglib.h>

struct bytes {
	uint8_t data[4096];
	size_t size;
};

/*
 * An image of 8x8 pixels in three scans: brightness, both colours, and the
 * details of one colour, whose samples are 4 pixels wide and high.
 */
static struct bytes make_progressive(void)
{
	static const jpeg_scan_info script[] = {
		{1, {0}, 0, 0, 0, 0},
		{2, {1, 2}, 0, 0, 0, 0},
		{1, {1}, 1, 63, 0, 0},
	};
	struct jpeg_compress_struct jpeg;
	struct jpeg_error_mgr errors;
	struct bytes bytes = {.size = 0};
	unsigned char *data = NULL;
	unsigned long size = 0;
	JSAMPLE row[8 * 3];
	JSAMPROW rows[1] = {row};

	memset(row, 128, sizeof(row));
	jpeg.err = jpeg_std_error(&errors);
	jpeg_create_compress(&jpeg);
	jpeg_mem_dest(&jpeg, &data, &size);
	jpeg.image_width = jpeg.image_height = 8;
	jpeg.input_components = 3;
	jpeg.in_color_space = JCS_RGB;
	jpeg_set_defaults(&jpeg);
	jpeg.comp_info[0].h_samp_factor = jpeg.comp_info[0].v_samp_factor = 4;
	jpeg.scan_info = script;
	jpeg.num_scans = ARRAY_COUNT(script);
	jpeg_start_compress(&jpeg, TRUE);
	while (jpeg.next_scanline < jpeg.image_height) {
		jpeg_write_scanlines(&jpeg, rows, 1);
	}
	jpeg_finish_compress(&jpeg);
	jpeg_destroy_compress(&jpeg);
	assert_true(size <= sizeof(bytes.data));
	memcpy(bytes.data, data, size);
	bytes.size = size;
	free(data);
	return bytes;
}

/* Repeats the last scan of an image, from its marker to the end. */
static void repeat_scan(struct bytes *bytes, int times)
{
	size_t end = bytes->size - 2;
	size_t begin = end - 2;
	size_t length;

	while (bytes->data[begin] != 0xff || bytes->data[begin + 1] != 0xda) {
		assert_true(begin > 0);
		begin--;
	}
	length = end - begin;
	while (times-- > 0) {
		assert_true(end + length + 2 <= sizeof(bytes->data));
		memcpy(bytes->data + end, bytes->data + begin, length);
		end += length;
	}
	bytes->data[end] = 0xff;
	bytes->data[end + 1] = 0xd9;
	bytes->size = end + 2;
}

static int decode(const struct bytes *bytes, struct log_capture *logged,
	struct arena *arena, struct model_image *out)
{
	struct log log = log_capture_begin(logged);

	*arena = arena_empty();
	*out = (struct model_image){.name = "kept"};
	return image_decode(bytes->data, bytes->size, "HERE", &log, arena, out);
}

static void expect_refusal(const struct bytes *bytes, const char *sentence)
{
	struct log_capture logged;
	struct model_image image;
	struct arena arena;

	assert_int_equal(decode(bytes, &logged, &arena, &image), -EINVAL);
	assert_int_equal(log_capture_count(&logged, LOG_ERROR), 1);
	assert_string_equal(logged.sentence[0], sentence);
	arena_release(&arena);
}

static void test_reads_up_to_100_scans_of_a_small_jpeg(void **state)
{
	struct bytes bytes = make_progressive();
	struct log_capture logged;
	struct model_image image;
	struct arena arena;

	(void)state;
	assert_int_equal(decode(&bytes, &logged, &arena, &image), 0);
	assert_int_equal(logged.count, 0);
	assert_int_equal(image.rgba[0], 128);
	arena_release(&arena);
	repeat_scan(&bytes, 97);
	assert_int_equal(decode(&bytes, &logged, &arena, &image), 0);
	assert_int_equal(log_capture_count(&logged, LOG_ERROR), 0);
	assert_int_equal(image.rgba[0], 128);
	arena_release(&arena);
	repeat_scan(&bytes, 1);
	expect_refusal(&bytes,
		"HERE: the JPEG image is broken: it has more than 100 scans");
}

/* 512 million samples are as many as 32 scans of the largest image have. */
static void test_reads_fewer_scans_of_a_large_jpeg(void **state)
{
	struct bytes bytes = make_progressive();

	(void)state;
	repeat_scan(&bytes, 40);
	jpeg_size_set(bytes.data, bytes.size, IMAGE_SIDE_MAX, IMAGE_SIDE_MAX);
	expect_refusal(&bytes,
		"HERE: the JPEG image is broken: it has more than 32 scans");
}

/* libjpeg keeps 16 bits of each component of a pixel until the last scan. */
static void test_a_budget_counts_what_scans_keep(void **state)
{
	enum {
		KEPT = 8 * 8 * 3 * 2
	};
	struct bytes bytes = make_progressive();
	struct memory_budget budget = {.limit_bytes = SIZE_MAX};
	size_t pixels = 0;

	(void)state;
	for (int i = 0; i < 3; i++) {
		static const int error[] = {0, -ENOMEM, 0};
		struct arena arena = arena_within(&budget);
		struct log_capture logged;
		struct log log = log_capture_begin(&logged);
		struct model_image image = {.name = "kept"};

		assert_int_equal(image_decode(bytes.data, bytes.size, "HERE",
					 &log, &arena, &image),
			error[i]);
		pixels = budget.used_bytes;
		arena_release(&arena);
		assert_int_equal(budget.used_bytes, 0);
		budget.limit_bytes = pixels + KEPT - (i == 0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_reads_up_to_100_scans_of_a_small_jpeg),
		cmocka_unit_test(test_reads_fewer_scans_of_a_large_jpeg),
		cmocka_unit_test(test_a_budget_counts_what_scans_keep),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
