/* Sources of glTF data: .glb, data URIs, files, memory. */
#include "app/model/model.h"
#include "tests/support/files.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const float triangle[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

static void expect_triangle(struct model *model)
{
	assert_int_equal(model->mesh[0].primitive[0].vertex_count, 3);
	assert_all_near(model->mesh[0].primitive[0].position, triangle, 9, 0);
	model_destroy(model);
}

static void test_reads_a_glb_and_skips_other_chunks(void **state)
{
	(void)state;
	expect_triangle(model_fixture("gltf/container/binary.glb", NULL));
}

static void test_reads_a_buffer_beside_the_file(void **state)
{
	(void)state;
	expect_triangle(model_fixture("gltf/container/beside.gltf", NULL));
}

static void test_keeps_the_path_and_the_format(void **state)
{
	struct model *model = model_fixture("gltf/container/binary.glb", NULL);

	(void)state;
	assert_string_equal(
		model->path, fixture_path("gltf/container/binary.glb").text);
	assert_string_equal(model->format, "glTF 2.0");
	model_destroy(model);
}

static void test_accepts_a_byte_order_mark_and_spaces(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(model_from_text("\xef\xbb\xbf \t\r\n"
					 "{'asset':{'version':'2.1'}}",
				 &logged, &model),
		0);
	assert_int_equal(model->node_count, 0);
	model_destroy(model);
}

/* The zero that ends the string fills up the chunk to 28 bytes. */
static void test_accepts_zeros_behind_the_json(void **state)
{
	static const char glb[48] = "glTF\2\0\0\0\x30\0\0\0\x1c\0\0\0JSON"
				    "{\"asset\":{\"version\":\"2.0\"}}";
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct model *model;

	(void)state;
	assert_int_equal(
		model_load_memory(glb, sizeof(glb), "filled", &log, &model), 0);
	assert_int_equal(logged.count, 0);
	model_destroy(model);
}

static void test_reports_a_missing_file(void **state)
{
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct model *model;

	(void)state;
	assert_int_equal(model_load("no/such.glb", &log, &model), -ENOENT);
	assert_null(model);
	assert_int_equal(logged.count, 1);
	assert_string_equal(logged.sentence[0],
		"no/such.glb: No such file or directory: check the name and its folder");
}

/* Each copy has its exact size, so that the sanitizers see its end. */
static void test_refuses_a_glb_truncated_at_any_length(void **state)
{
	size_t size, length;
	struct test_path path = fixture_path("gltf/container/binary.glb");
	char *whole = file_read(path.text, &size);

	(void)state;
	for (length = 0; length < size; length++) {
		struct log_capture logged;
		struct log log = log_capture_begin(&logged);
		char *cut = malloc(length + 1);
		struct model *model;
		int error;

		assert_non_null(cut);
		memcpy(cut, whole, length);
		error = model_load_memory(cut, length, "cut", &log, &model);
		assert_true(error == -EINVAL || error == -ENOTSUP);
		assert_null(model);
		assert_int_equal(logged.count, 1);
		free(cut);
	}
	free(whole);
}

struct damage {
	size_t at;
	uint8_t value;
	int code;
	const char *part;
};

static void test_refuses_broken_glb_headers(void **state)
{
	static const struct damage damages[] = {
		{4, 1, -ENOTSUP, "version 1; limber reads version 2"},
		{9, 0, -EINVAL, "the chunk at byte 12 claims"},
		{11, 1, -EINVAL, "truncated: its header claims"},
		{15, 1, -EINVAL, "the chunk at byte 12 claims"},
		{16, 'X', -EINVAL, "the first chunk is not the JSON"},
		{20, '[', -EINVAL, "line 1, column"},
	};
	struct test_path path = fixture_path("gltf/container/binary.glb");
	size_t size, i;
	char *whole = file_read(path.text, &size);

	(void)state;
	for (i = 0; i < sizeof(damages) / sizeof(damages[0]); i++) {
		const struct damage *damage = &damages[i];
		struct log_capture logged;
		struct log log = log_capture_begin(&logged);
		char kept = whole[damage->at];
		struct model *model;

		whole[damage->at] = (char)damage->value;
		assert_int_equal(
			model_load_memory(whole, size, "broken", &log, &model),
			damage->code);
		assert_contains(logged.sentence[0], "broken: ");
		assert_contains(logged.sentence[0], damage->part);
		whole[damage->at] = kept;
	}
	free(whole);
}

static void test_refuses_files_beside_a_model_in_memory(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(model_from_text("{'asset':{'version':'2.0'},'buffers':[{"
					 "'byteLength':1,'uri':'Makefile'}]}",
				 &logged, &model),
		-EACCES);
	assert_contains(logged.sentence[0],
		"t.gltf: /buffers/0/uri: the model was not loaded from a folder");
}

static int load_text(const struct test_path *folder, const char *text,
	struct log_capture *logged)
{
	struct test_path path = path_join(folder, "m.gltf");
	struct log log = log_capture_begin(logged);
	struct model *model;
	int error;

	file_write(path.text, text, strlen(text));
	error = model_load(path.text, &log, &model);
	model_destroy(model);
	return error;
}

struct reference {
	const char *uri;
	int code;
	const char *part;
};

/* There is a file x.bin beside the model and one in the parent folder. */
static void test_reads_no_file_outside_the_folder(void **state)
{
	static const struct reference references[] = {
		{"x.bin", 0, ""},
		{"./x.bin", 0, ""},
		{"%78.bin", 0, ""},
		{"../x.bin", -EACCES, "the path contains \"..\""},
		{"%2e%2e/x.bin", -EACCES, "the path contains \"..\""},
		{"..%2Fx.bin", -EACCES, "the path contains \"..\""},
		{"..%5cx.bin", -EACCES, "backslash"},
		{"/etc/hostname", -EACCES, "the path is absolute"},
		{"%2Fetc/hostname", -EACCES, "the path is absolute"},
		{"file:x.bin", -EACCES,
			"does not name a file in the model's folder"},
		{"http://a/x.bin", -EACCES,
			"does not name a file in the model's"},
		{"x%00.bin", -EINVAL, "malformed % escape"},
		{"x.bi%6", -EINVAL, "malformed % escape"},
		{"", -EACCES, "the path is empty"},
		{"y.bin", -ENOENT, "/buffers/0/uri: y.bin: No such file"},
		{"data:,xx", -EINVAL, "data URI that is not in base64"},
		{"data:;base64,A", -EINVAL, "not valid base64"},
		{"data:;base64,AAAA", 0, ""},
	};
	struct test_path top = temp_dir_make();
	struct test_path folder = path_join(&top, "models");
	size_t i;

	(void)state;
	assert_int_equal(mkdir(folder.text, 0755), 0);
	file_write(path_join(&top, "x.bin").text, "xx", 2);
	file_write(path_join(&folder, "x.bin").text, "xx", 2);
	for (i = 0; i < sizeof(references) / sizeof(references[0]); i++) {
		struct log_capture logged;
		char text[256];

		snprintf(text, sizeof(text),
			"{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{"
			"\"byteLength\":2,\"uri\":\"%s\"}]}",
			references[i].uri);
		assert_int_equal(
			load_text(&folder, text, &logged), references[i].code);
		assert_int_equal(logged.count, references[i].code != 0);
		if (references[i].code) {
			assert_contains(logged.sentence[0], "/buffers/0/uri: ");
			assert_contains(logged.sentence[0], references[i].part);
		}
	}
	temp_dir_remove(&top);
}

static void test_refuses_a_buffer_shorter_than_its_byte_length(void **state)
{
	struct test_path folder = temp_dir_make();
	struct log_capture logged;

	(void)state;
	file_write(path_join(&folder, "x.bin").text, "xx", 2);
	assert_int_equal(load_text(&folder,
				 "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{"
				 "\"byteLength\":3,\"uri\":\"x.bin\"}]}",
				 &logged),
		-EINVAL);
	assert_contains(logged.sentence[0],
		"/buffers/0: byteLength is 3, but the data has only 2 bytes");
	temp_dir_remove(&folder);
}

static void test_accepts_null_in_model_destroy(void **state)
{
	(void)state;
	model_destroy(NULL);
}

/* A sparse file, which takes no space on the disk. */
static void make_large_file(const struct test_path *folder, off_t mebibytes)
{
	struct test_path path = path_join(folder, "large.bin");

	file_write(path.text, "", 0);
	assert_int_equal(truncate(path.text, mebibytes << 20), 0);
}

#define LARGE "{\"byteLength\":1,\"uri\":\"large.bin\"}"

static void test_limits_the_files_beside_a_model(void **state)
{
	struct test_path folder = temp_dir_make();
	struct log_capture logged;

	(void)state;
	make_large_file(&folder, 129);
	assert_int_equal(
		load_text(&folder,
			"{\"asset\":{\"version\":\"2.0\"},\"buffers\":[" LARGE
			"," LARGE "]}",
			&logged),
		-ENOMEM);
	assert_contains(logged.sentence[0],
		"/buffers/1/uri: large.bin: the model needs more than 256 MiB of memory");
	temp_dir_remove(&folder);
}

/* A header that claims 4096 x 2047 pixels, 32 MiB, without their data. */
#define HUGE_PNG                                   \
	"data:;base64,"                            \
	"iVBORw0KGgoAAAANSUhEUgAAEAAAAAf/CAIAAAA7" \
	"fLrMAAAAAUlEQVQ="

static void test_checks_the_budget_before_decoding_an_image(void **state)
{
	struct test_path folder = temp_dir_make();
	struct log_capture logged;

	(void)state;
	make_large_file(&folder, 230);
	assert_int_equal(
		load_text(&folder,
			"{\"asset\":{\"version\":\"2.0\"},\"buffers\":[" LARGE
			"],\"images\":[{\"uri\":\"" HUGE_PNG "\"}],"
			"\"textures\":[{\"source\":0}],\"materials\":[{"
			"\"normalTexture\":{\"index\":0}}]}",
			&logged),
		-ENOMEM);
	assert_contains(logged.sentence[0],
		"/images/0: the model needs more than 256 MiB of memory");
	temp_dir_remove(&folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_reads_a_glb_and_skips_other_chunks),
		cmocka_unit_test(test_reads_a_buffer_beside_the_file),
		cmocka_unit_test(test_keeps_the_path_and_the_format),
		cmocka_unit_test(test_accepts_a_byte_order_mark_and_spaces),
		cmocka_unit_test(test_accepts_zeros_behind_the_json),
		cmocka_unit_test(test_reports_a_missing_file),
		cmocka_unit_test(test_refuses_a_glb_truncated_at_any_length),
		cmocka_unit_test(test_refuses_broken_glb_headers),
		cmocka_unit_test(test_refuses_files_beside_a_model_in_memory),
		cmocka_unit_test(test_reads_no_file_outside_the_folder),
		cmocka_unit_test(
			test_refuses_a_buffer_shorter_than_its_byte_length),
		cmocka_unit_test(test_accepts_null_in_model_destroy),
		cmocka_unit_test(test_limits_the_files_beside_a_model),
		cmocka_unit_test(test_checks_the_budget_before_decoding_an_image),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
