/* JPEG images of printers' inks: cyan, magenta, yellow and black. */
#include "app/model/image/image.h"
#include "platform/base/compiler.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>

#include <jpeglib.h>

/* Cyan, magenta, yellow and black of one colour, in steps from no ink to 255. */
static unsigned long make_jpeg(J_COLOR_SPACE space, const uint8_t ink[4],
	bool adobe, unsigned char **data)
{
	struct jpeg_compress_struct jpeg;
	struct jpeg_error_mgr errors;
	unsigned long size = 0;
	JSAMPLE row[8 * 4];
	JSAMPROW rows[1] = {row};

	for (int i = 0; i < 8 * 4; i++) {
		row[i] = adobe ? 255 - ink[i % 4] : ink[i % 4];
	}
	jpeg.err = jpeg_std_error(&errors);
	jpeg_create_compress(&jpeg);
	jpeg_mem_dest(&jpeg, data, &size);
	jpeg.image_width = jpeg.image_height = 8;
	jpeg.input_components = 4;
	jpeg.in_color_space = JCS_CMYK;
	jpeg_set_defaults(&jpeg);
	jpeg_set_colorspace(&jpeg, space);
	jpeg_set_quality(&jpeg, 100, TRUE);
	jpeg.write_Adobe_marker = adobe;
	jpeg_start_compress(&jpeg, TRUE);
	while (jpeg.next_scanline < jpeg.image_height) {
		jpeg_write_scanlines(&jpeg, rows, 1);
	}
	jpeg_finish_compress(&jpeg);
	jpeg_destroy_compress(&jpeg);
	return size;
}

static void test_reads_jpeg_in_inks(void **state)
{
	static const uint8_t ink[4] = {0, 128, 255, 51};
	static const struct {
		J_COLOR_SPACE space;
		bool adobe;
	} kind[] = {{JCS_CMYK, false}, {JCS_CMYK, true}, {JCS_YCCK, true}};

	(void)state;
	for (size_t k = 0; k < ARRAY_COUNT(kind); k++) {
		unsigned char *data = NULL;
		unsigned long size =
			make_jpeg(kind[k].space, ink, kind[k].adobe, &data);
		struct log_capture logged;
		struct model_image image = {.name = "inks"};
		struct arena arena = arena_empty();
		struct log log = log_capture_begin(&logged);

		assert_int_equal(
			image_decode(data, size, "HERE", &log, &arena, &image),
			0);
		assert_int_equal(logged.count, 0);
		assert_true(image.opaque);
		for (int i = 0; i < 8 * 8; i++) {
			const uint8_t *rgba = image.rgba + 4 * i;

			assert_near(rgba[0], 204, 3);
			assert_near(rgba[1], 127 * 204 / 255, 3);
			assert_near(rgba[2], 0, 3);
			assert_int_equal(rgba[3], 255);
		}
		arena_release(&arena);
		free(data);
	}
}

/* The paper's share that inks leave, rounded; libjpeg keeps flat inks exactly. */
static void test_inks_are_rounded(void **state)
{
	static const uint8_t inks[][4] = {{127, 0, 255, 254}, {126, 128, 1, 254},
		{127, 128, 64, 128}, {0, 1, 254, 0}, {0, 1, 254, 255}};

	(void)state;
	for (size_t k = 0; k < 2 * ARRAY_COUNT(inks); k++) {
		const uint8_t *ink = inks[k / 2];
		unsigned char *data = NULL;
		unsigned long size = make_jpeg(JCS_CMYK, ink, k % 2, &data);
		struct log_capture logged;
		struct model_image image = {.name = "inks"};
		struct arena arena = arena_empty();
		struct log log = log_capture_begin(&logged);

		assert_int_equal(
			image_decode(data, size, "HERE", &log, &arena, &image),
			0);
		for (int i = 0; i < 3; i++) {
			int left = (255 - ink[i]) * (255 - ink[3]);

			assert_int_equal(
				image.rgba[i], (2 * left + 255) / (2 * 255));
		}
		arena_release(&arena);
		free(data);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_reads_jpeg_in_inks),
		cmocka_unit_test(test_inks_are_rounded),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
