/* glb.h: the bytes of a binary glTF file. */
#include "app/compare/export/glb.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A file in memory that was taken apart. */
struct parsed {
	uint8_t *data;
	size_t size, binary_size;
	const uint8_t *binary; /* NULL without a binary chunk */
	json_t *root;
};

static size_t u32_at(const uint8_t *at)
{
	return (size_t)at[0] | (size_t)at[1] << 8 | (size_t)at[2] << 16 |
		(size_t)at[3] << 24;
}

/* Section 4.4 of glTF 2.0: a header, a chunk of JSON, one of bytes. */
static void take_apart(struct parsed *parsed)
{
	const uint8_t *data = parsed->data;
	size_t json_size;

	assert_true(parsed->size >= 20);
	assert_memory_equal(data, "glTF\2\0\0\0", 8);
	assert_int_equal(u32_at(data + 8), parsed->size);
	json_size = u32_at(data + 12);
	assert_int_equal(json_size % 4, 0);
	assert_memory_equal(data + 16, "JSON", 4);
	assert_true(20 + json_size <= parsed->size);
	/* Blanks at the end make the size a multiple of four. */
	for (int i = 1; data[20 + json_size - (size_t)i] != '}'; i++) {
		assert_true(i <= 3);
		assert_int_equal(data[20 + json_size - (size_t)i], ' ');
	}
	parsed->root = json_loadb((const char *)data + 20, json_size, 0, NULL);
	assert_non_null(parsed->root);
	if (20 + json_size < parsed->size) {
		const uint8_t *chunk = data + 20 + json_size;

		parsed->binary_size = u32_at(chunk);
		assert_memory_equal(chunk + 4, "BIN\0", 4);
		assert_int_equal(
			28 + json_size + parsed->binary_size, parsed->size);
		parsed->binary = chunk + 8;
	}
}

static struct parsed write_and_parse(struct glb *glb)
{
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct parsed parsed = {0};

	assert_int_equal(
		glb_write_memory(glb, "HERE", &log, &parsed.data, &parsed.size),
		0);
	assert_int_equal(logged.count, 0);
	take_apart(&parsed);
	return parsed;
}

static void release(struct parsed *parsed)
{
	json_decref(parsed->root);
	free(parsed->data);
}

/* The JSON of the member, with ' for ", is that. */
static void expect_member(
	const struct parsed *parsed, const char *name, const char *wanted)
{
	json_t *member = json_object_get(parsed->root, name);
	char *text = member
		? json_dumps(member,
			  JSON_COMPACT | JSON_SORT_KEYS | JSON_ENCODE_ANY)
		: NULL;

	for (char *at = text; at && *at; at++) {
		*at = *at == '"' ? '\'' : *at;
	}
	if (!wanted) {
		assert_null(text);
	} else {
		assert_non_null(text);
		assert_string_equal(text, wanted);
	}
	free(text);
}

static void test_a_file_without_data_has_one_chunk(void **state)
{
	(void)state;
	/* The padding of the JSON is each of 0 to 3 bytes. */
	for (size_t length = 0; length < 4; length++) {
		struct parsed parsed;
		struct glb glb;

		glb_begin_memory(&glb);
		glb_set(&glb, "name", json_stringn("aaaa", length));
		parsed = write_and_parse(&glb);
		assert_null(parsed.binary);
		expect_member(&parsed, "buffers", NULL);
		expect_member(&parsed, "bufferViews", NULL);
		expect_member(&parsed, "accessors", NULL);
		expect_member(&parsed, "extensionsUsed", NULL);
		release(&parsed);
	}
}

static void test_views_begin_at_multiples_of_four(void **state)
{
	static const uint8_t wanted[] = "a\0\0\0bcde!\0\0\0fgh";
	struct parsed parsed;
	struct glb glb;

	(void)state;
	glb_begin_memory(&glb);
	assert_int_equal(glb_add_view(&glb, "a", 1), 0);
	assert_int_equal(glb_add_view(&glb, "bcde!", 5), 1);
	assert_int_equal(glb_add_view(&glb, "fgh", 4), 2);
	parsed = write_and_parse(&glb);
	expect_member(&parsed, "buffers", "[{'byteLength':16}]");
	expect_member(&parsed, "bufferViews",
		"[{'buffer':0,'byteLength':1,'byteOffset':0},"
		"{'buffer':0,'byteLength':5,'byteOffset':4},"
		"{'buffer':0,'byteLength':4,'byteOffset':12}]");
	assert_int_equal(parsed.binary_size, 16);
	assert_memory_equal(parsed.binary, wanted, 16);
	release(&parsed);
}

static void test_times_and_positions_have_bounds(void **state)
{
	static const float values[6] = {0.5f, -2, 7, -1, 3, 8};
	struct parsed parsed;
	struct glb glb;

	(void)state;
	glb_begin_memory(&glb);
	assert_int_equal(glb_add_array(&glb, values, 6, 1, GLB_FLOAT), 0);
	assert_int_equal(glb_add_array(&glb, values, 3, 2, GLB_FLOAT), 1);
	assert_int_equal(glb_add_array(&glb, values, 2, 3, GLB_FLOAT), 2);
	assert_int_equal(glb_add_array(&glb, values, 1, 4, GLB_FLOAT), 3);
	parsed = write_and_parse(&glb);
	expect_member(&parsed, "accessors",
		"[{'bufferView':0,'componentType':5126,'count':6,"
		"'max':[8.0],'min':[-2.0],'type':'SCALAR'},"
		"{'bufferView':1,'componentType':5126,'count':3,"
		"'type':'VEC2'},"
		"{'bufferView':2,'componentType':5126,'count':2,"
		"'max':[0.5,3.0,8.0],'min':[-1.0,-2.0,7.0],'type':'VEC3'},"
		"{'bufferView':3,'componentType':5126,'count':1,"
		"'type':'VEC4'}]");
	assert_int_equal(parsed.binary_size, 24 + 24 + 24 + 16);
	assert_memory_equal(parsed.binary + 48, values, 24);
	expect_member(&parsed, "extensionsUsed", NULL);
	release(&parsed);
}

static void test_arrays_of_integers_have_the_size_of_their_type(void **state)
{
	static const uint8_t bytes[64] = {1, 2, 3};
	struct parsed parsed;
	struct glb glb;

	(void)state;
	glb_begin_memory(&glb);
	glb_add_array(&glb, bytes, 3, 1, GLB_BYTE);
	glb_add_array(&glb, bytes, 2, 4, GLB_UBYTE);
	glb_add_array(&glb, bytes, 1, 3, GLB_SHORT);
	glb_add_array(&glb, bytes, 3, 1, GLB_USHORT);
	glb_add_array(&glb, bytes, 3, 1, GLB_UINT);
	glb_add_array(&glb, bytes, 1, 16, GLB_FLOAT);
	parsed = write_and_parse(&glb);
	expect_member(&parsed, "bufferViews",
		"[{'buffer':0,'byteLength':3,'byteOffset':0},"
		"{'buffer':0,'byteLength':8,'byteOffset':4},"
		"{'buffer':0,'byteLength':6,'byteOffset':12},"
		"{'buffer':0,'byteLength':6,'byteOffset':20},"
		"{'buffer':0,'byteLength':12,'byteOffset':28},"
		"{'buffer':0,'byteLength':64,'byteOffset':40}]");
	expect_member(&parsed, "accessors",
		"[{'bufferView':0,'componentType':5120,'count':3,"
		"'type':'SCALAR'},"
		"{'bufferView':1,'componentType':5121,'count':2,"
		"'type':'VEC4'},"
		"{'bufferView':2,'componentType':5122,'count':1,"
		"'normalized':true,'type':'VEC3'},"
		"{'bufferView':3,'componentType':5123,'count':3,"
		"'type':'SCALAR'},"
		"{'bufferView':4,'componentType':5125,'count':3,"
		"'type':'SCALAR'},"
		"{'bufferView':5,'componentType':5126,'count':1,"
		"'type':'MAT4'}]");
	release(&parsed);
}

static void test_vectors_are_aligned_and_need_quantization(void **state)
{
	static const int8_t bytes[6] = {1, -2, 3, -4, 5, -6};
	static const int16_t shorts[6] = {300, 0, -1, 299, 1, 0};
	static const uint8_t wanted[] = {1, 254, 3, 0, 252, 5, 250, 0};
	struct parsed parsed;
	struct glb glb;

	(void)state;
	glb_begin_memory(&glb);
	assert_int_equal(glb_add_vectors(&glb, bytes, 2, GLB_BYTE, true), 0);
	assert_int_equal(glb_add_vectors(&glb, shorts, 2, GLB_SHORT, false), 1);
	parsed = write_and_parse(&glb);
	expect_member(&parsed, "bufferViews",
		"[{'buffer':0,'byteLength':8,'byteOffset':0,'byteStride':4},"
		"{'buffer':0,'byteLength':16,'byteOffset':8,"
		"'byteStride':8}]");
	expect_member(&parsed, "accessors",
		"[{'bufferView':0,'componentType':5120,'count':2,"
		"'max':[1,5,3],'min':[-4,-2,-6],'normalized':true,"
		"'type':'VEC3'},"
		"{'bufferView':1,'componentType':5122,'count':2,"
		"'max':[300,1,0],'min':[299,0,-1],'type':'VEC3'}]");
	expect_member(&parsed, "extensionsUsed", "['KHR_mesh_quantization']");
	expect_member(
		&parsed, "extensionsRequired", "['KHR_mesh_quantization']");
	assert_memory_equal(parsed.binary, wanted, 8);
	assert_memory_equal(parsed.binary + 8, shorts, 6);
	assert_memory_equal(parsed.binary + 14, "\0\0", 2);
	assert_memory_equal(parsed.binary + 16, shorts + 3, 6);
	release(&parsed);
}

/*
 * A vector that is listed takes its bytes and four of its number; one that is
 * not takes its bytes in steps of four.
 */
static void test_vectors_are_sparse_where_that_is_smaller(void **state)
{
	static const struct {
		enum glb_component component;
		int count, moved;
		bool sparse;
	} cases[] = {{GLB_BYTE, 7, 4, false}, {GLB_BYTE, 7, 3, true},
		{GLB_BYTE, 7, 1, true}, {GLB_BYTE, 7, 0, false},
		{GLB_SHORT, 5, 4, false}, {GLB_SHORT, 5, 3, true},
		{GLB_SHORT, 5, 1, true}, {GLB_SHORT, 5, 0, false}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		int8_t bytes[7 * 3] = {0};
		int16_t shorts[7 * 3] = {0};
		bool is_byte = cases[i].component == GLB_BYTE;
		struct parsed parsed;
		struct glb glb;
		json_t *accessor, *sparse;

		for (int m = 0; m < cases[i].moved; m++) {
			bytes[3 * m + m % 3] = -1;
			shorts[3 * m + m % 3] = -1;
		}
		glb_begin_memory(&glb);
		glb_add_vectors(&glb, is_byte ? (void *)bytes : shorts,
			cases[i].count, cases[i].component, false);
		parsed = write_and_parse(&glb);
		accessor = json_array_get(
			json_object_get(parsed.root, "accessors"), 0);
		sparse = json_object_get(accessor, "sparse");
		assert_int_equal(sparse != NULL, cases[i].sparse);
		assert_int_equal(json_object_get(accessor, "bufferView") == NULL,
			cases[i].sparse);
		release(&parsed);
	}
}

static void test_sparse_vectors_are_packed_with_their_numbers(void **state)
{
	static const int16_t shorts[5 * 3] = {
		0, 0, 0, 1, 2, 3, 0, 0, 0, 0, 0, -4, 0, 0, 0};
	static const int16_t moved[6] = {1, 2, 3, 0, 0, -4};
	static const uint32_t numbers[2] = {1, 3};
	struct parsed parsed;
	struct glb glb;

	(void)state;
	glb_begin_memory(&glb);
	glb_add_vectors(&glb, shorts, 5, GLB_SHORT, true);
	parsed = write_and_parse(&glb);
	expect_member(&parsed, "accessors",
		"[{'componentType':5122,'count':5,'max':[1,2,3],"
		"'min':[0,0,-4],'normalized':true,'sparse':{'count':2,"
		"'indices':{'bufferView':1,'componentType':5125},"
		"'values':{'bufferView':0}},'type':'VEC3'}]");
	assert_int_equal(parsed.binary_size, 12 + 8);
	assert_memory_equal(parsed.binary, moved, 12);
	assert_memory_equal(parsed.binary + 12, numbers, 8);
	release(&parsed);
}

static void test_a_few_ones_are_sparse(void **state)
{
	static const uint32_t at[3] = {2, 5, 900};
	struct parsed parsed;
	struct glb glb;

	(void)state;
	glb_begin_memory(&glb);
	assert_int_equal(glb_add_ones(&glb, at, 3, 1000), 0);
	parsed = write_and_parse(&glb);
	expect_member(&parsed, "accessors",
		"[{'componentType':5121,'count':1000,'normalized':true,"
		"'sparse':{'count':3,'indices':{'bufferView':1,"
		"'componentType':5125},'values':{'bufferView':0}},"
		"'type':'SCALAR'}]");
	assert_int_equal(parsed.binary_size, 4 + 12);
	assert_memory_equal(parsed.binary, "\377\377\377\0", 4);
	assert_memory_equal(parsed.binary + 4, at, 12);
	release(&parsed);
}

static void test_an_extension_is_listed_once(void **state)
{
	struct parsed parsed;
	struct glb glb;

	(void)state;
	glb_begin_memory(&glb);
	for (int i = 0; i < 4; i++) {
		glb_use_extension(&glb, i % 2 ? "B" : "A");
	}
	parsed = write_and_parse(&glb);
	expect_member(&parsed, "extensionsUsed", "['A','B']");
	release(&parsed);
}

static void test_floats_have_15_digits(void **state)
{
	static const float values[2] = {0.1f, -3};
	struct parsed parsed;
	struct glb glb;

	(void)state;
	glb_begin_memory(&glb);
	glb_set(&glb, "floats", glb_floats(values, 2));
	parsed = write_and_parse(&glb);
	assert_non_null(strstr(
		(const char *)parsed.data + 20, "[0.100000001490116,-3.0]"));
	release(&parsed);
}

static void add_much(struct glb *glb)
{
	static uint8_t much[40001];

	for (size_t i = 0; i < sizeof(much); i++) {
		much[i] = (uint8_t)(i * i >> 5);
	}
	glb_add_view(glb, much, sizeof(much));
	glb_add_view(glb, "end", 4);
}

/* Data from a temporary file are copied in several pieces. */
static void test_a_file_has_the_bytes_that_memory_has(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "large.glb");
	struct log log = log_to_nowhere();
	struct parsed parsed;
	struct glb glb;
	size_t size;
	char *content;

	(void)state;
	glb_begin(&glb);
	add_much(&glb);
	assert_int_equal(glb_write(&glb, path.text, &log), 0);
	glb_begin_memory(&glb);
	add_much(&glb);
	parsed = write_and_parse(&glb);
	content = file_read(path.text, &size);
	assert_int_equal(size, parsed.size);
	assert_memory_equal(content, parsed.data, size);
	free(content);
	release(&parsed);
	temp_dir_remove(&folder);
}

/* The temporary file has lost its bytes; the file that it was for is left out. */
static void test_vertices_that_cannot_be_read_again_leave_no_file(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "out.glb");
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct glb glb;

	(void)state;
	glb_begin(&glb);
	glb_add_view(&glb, "abcd", 4);
	assert_int_equal(fflush(glb.data), 0);
	assert_int_equal(ftruncate(fileno(glb.data), 0), 0);
	assert_int_equal(glb_write(&glb, path.text, &log), -EIO);
	assert_int_equal(logged.count, 1);
	assert_contains(logged.sentence[0], "cannot be read");
	assert_int_equal(temp_dir_count(&folder), 0);
	temp_dir_remove(&folder);
}

static void test_the_first_failure_is_kept_and_reported(void **state)
{
	static const struct {
		int error;
		const char *message;
	} cases[] = {{-ENOMEM, "there is not enough memory"},
		{-ENOSPC, "a temporary file for its vertices cannot be written"}};
	const uint32_t one = 1;

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct log_capture logged;
		struct log log = log_capture_begin(&logged);
		uint8_t *data = NULL;
		struct glb glb;
		size_t size;

		glb_begin_memory(&glb);
		glb.error = cases[i].error;
		assert_int_equal(glb_add_view(&glb, "a", 1), -1);
		assert_int_equal(
			glb_add_array(&glb, "abcd", 1, 1, GLB_FLOAT), -1);
		assert_int_equal(
			glb_add_vectors(&glb, "abc", 1, GLB_BYTE, false), -1);
		assert_int_equal(glb_add_ones(&glb, &one, 1, 2), -1);
		glb_set(&glb, "nothing", NULL);
		assert_int_equal(glb.size, 0);
		assert_int_equal(
			glb_write_memory(&glb, "HERE", &log, &data, &size),
			cases[i].error);
		assert_null(data);
		assert_int_equal(logged.count, 1);
		assert_contains(logged.sentence[0], "HERE: ");
		assert_contains(logged.sentence[0], cases[i].message);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_file_without_data_has_one_chunk),
		cmocka_unit_test(test_views_begin_at_multiples_of_four),
		cmocka_unit_test(test_times_and_positions_have_bounds),
		cmocka_unit_test(
			test_arrays_of_integers_have_the_size_of_their_type),
		cmocka_unit_test(test_vectors_are_aligned_and_need_quantization),
		cmocka_unit_test(test_vectors_are_sparse_where_that_is_smaller),
		cmocka_unit_test(
			test_sparse_vectors_are_packed_with_their_numbers),
		cmocka_unit_test(test_a_few_ones_are_sparse),
		cmocka_unit_test(test_an_extension_is_listed_once),
		cmocka_unit_test(test_floats_have_15_digits),
		cmocka_unit_test(test_a_file_has_the_bytes_that_memory_has),
		cmocka_unit_test(
			test_vertices_that_cannot_be_read_again_leave_no_file),
		cmocka_unit_test(test_the_first_failure_is_kept_and_reported),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
