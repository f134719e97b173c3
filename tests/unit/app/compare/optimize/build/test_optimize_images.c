/* Which images an optimised file holds, and which stay where they are. */
#include "app/compare/optimize/build/optimize_build.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>

#define URI(base64) "{\"uri\":\"data:;base64," base64 "\"}"

/* Rebuilds a file of that image and of a buffer, with a view of its begin. */
static json_t *rebuild(const char *image, const char *base64, int bytes)
{
	struct log_capture logged;
	const struct log log = log_capture_begin(&logged);
	const struct optimize_plan plan = {.stated_px = -1.0f};
	const struct optimize_order order = {0};
	const struct optimize_scale scale = {.mesh = NULL};
	struct gltf_document *document;
	struct optimize_build build = {
		.order = &order, .scale = &scale, .plan = &plan};
	char text[600];
	struct model_source source = {.name = "t.gltf",
		.data = (const uint8_t *)text,
		.memory_bytes = 1 << 20};
	uint8_t *data;
	size_t size;
	json_t *root;

	source.size = (size_t)snprintf(text, sizeof(text),
		"{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":"
		"\"data:;base64,%s\",\"byteLength\":%d}],\"bufferViews\":[{"
		"\"buffer\":0,\"byteLength\":%d}],\"images\":[%s]}",
		base64, bytes, bytes, image);
	assert_int_equal(gltf_document_open(&source, &log, &document), 0);
	build.document = document;
	assert_int_equal(
		optimize_build(&build, "t.gltf", &log, &data, &size), 0);
	gltf_document_close(document);
	root = json_loadb((const char *)data + 20,
		(size_t)data[12] | (size_t)data[13] << 8, 0, NULL);
	assert_non_null(root);
	free(data);
	return root;
}

/* NULL where the image keeps its URI. */
static void expect_mime(const char *image, const char *mime, int bytes)
{
	json_t *root = rebuild(image, "Qk0A", 3);
	json_t *found = json_array_get(json_object_get(root, "images"), 0);
	json_t *view = json_array_get(json_object_get(root, "bufferViews"), 0);

	if (mime) {
		assert_string_equal(
			json_string_value(json_object_get(found, "mimeType")),
			mime);
		assert_null(json_object_get(found, "uri"));
		assert_int_equal(
			json_integer_value(json_object_get(found, "bufferView")),
			0);
		assert_int_equal(
			json_integer_value(json_object_get(view, "byteLength")),
			bytes);
	} else {
		assert_null(json_object_get(found, "mimeType"));
		assert_null(json_object_get(found, "bufferView"));
		assert_non_null(json_object_get(found, "uri"));
	}
	json_decref(root);
}

/* Signatures of 4 and of 3 bytes, with as many bytes and with more. */
static void test_png_and_jpeg_move_into_the_file(void **state)
{
	(void)state;
	expect_mime(URI("iVBORw=="), "image/png", 4);
	expect_mime(URI("iVBORw0K"), "image/png", 6);
	expect_mime(URI("/9j/"), "image/jpeg", 3);
	expect_mime(URI("/9j/4A=="), "image/jpeg", 4);
}

/* Each byte of a signature counts, and shorter images have none. */
static void test_other_formats_stay_where_they_are(void **state)
{
	static const char *const others[] = {URI("iVBO"), URI("iVBOSA=="),
		URI("iVFORw=="), URI("iFBORw=="), URI("/9g="), URI("/9gA"),
		URI("/9n/"), URI("/tj/"), URI("Qk0A"), URI("/w=="),
		"{\"uri\":\"missing.png\"}"};

	(void)state;
	for (size_t i = 0; i < sizeof(others) / sizeof(others[0]); i++) {
		expect_mime(others[i], NULL, 0);
	}
}

/* The format that is stated stays unless the bytes of the view are another. */
static void expect_copied(const char *base64, int bytes, const char *mime)
{
	json_t *root = rebuild(
		"{\"bufferView\":0,\"mimeType\":\"image/bmp\"}", base64, bytes);
	json_t *found = json_array_get(json_object_get(root, "images"), 0);
	json_t *view = json_array_get(json_object_get(root, "bufferViews"), 0);

	assert_string_equal(
		json_string_value(json_object_get(found, "mimeType")), mime);
	assert_int_equal(
		json_integer_value(json_object_get(found, "bufferView")), 0);
	assert_int_equal(
		json_integer_value(json_object_get(view, "byteLength")), bytes);
	json_decref(root);
}

/* What a buffer holds has no place of its own. */
static void test_any_image_of_a_buffer_is_copied(void **state)
{
	(void)state;
	expect_copied("Qk0A", 3, "image/bmp");
	expect_copied("/9j/", 3, "image/jpeg");
	expect_copied("iVBORw==", 4, "image/png");
}

/* The bytes of a signature behind the image's end are none of it. */
static void test_an_image_ends_with_its_view(void **state)
{
	(void)state;
	expect_copied("/9j/", 2, "image/bmp");
	expect_copied("iVBORw==", 3, "image/bmp");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_png_and_jpeg_move_into_the_file),
		cmocka_unit_test(test_other_formats_stay_where_they_are),
		cmocka_unit_test(test_any_image_of_a_buffer_is_copied),
		cmocka_unit_test(test_an_image_ends_with_its_view),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
