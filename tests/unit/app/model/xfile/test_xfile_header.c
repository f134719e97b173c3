/* The header of .x files, the tokens of binary ones, and what doctor says. */
#include "app/model/model.h"
#include "app/model/xfile/xfile.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

/* Loads bytes and returns the error; logged has its sentence. */
static int load(const void *data, size_t size, struct log_capture *logged,
	struct model **out)
{
	struct log log = log_capture_begin(logged);

	*out = NULL;
	return model_load_memory(data, size, "test.x", &log, out);
}

static void expect_refused(
	const void *data, size_t size, int code, const char *sentence)
{
	struct log_capture logged;
	struct model *model;

	assert_int_equal(load(data, size, &logged, &model), code);
	assert_null(model);
	assert_int_equal(logged.count, 1);
	assert_string_equal(logged.sentence[0], sentence);
}

static void test_four_bytes_are_the_sign_of_the_format(void **state)
{
	static const uint8_t sign[] = "xof ";

	(void)state;
	assert_true(xfile_recognise(sign, 4));
	assert_false(xfile_recognise(sign, 3));
	for (int i = 0; i < 4; i++) {
		uint8_t other[4];

		memcpy(other, sign, 4);
		other[i] ^= 1;
		assert_false(xfile_recognise(other, 4));
	}
}

static void test_the_format_names_version_and_encoding(void **state)
{
	static const struct {
		const char *header, *format;
	} cases[] = {
		{"xof 0303txt 0032", "DirectX .x 03.03 (text)"},
		{"xof 0302txt 0064", "DirectX .x 03.02 (text)"},
		{"xof 0302bin 0032", "DirectX .x 03.02 (binary)"},
		{"xof 0303bin 0064", "DirectX .x 03.03 (binary)"},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct log_capture logged;
		struct model *model;

		assert_int_equal(load(cases[i].header, 16, &logged, &model), 0);
		assert_string_equal(model->format, cases[i].format);
		model_destroy(model);
	}
}

/* With the byte where it stands; what cannot be printed is a question mark. */
static void test_a_wrong_header_is_shown(void **state)
{
	(void)state;
	expect_refused("xof  ~a\x1ftxt 0032", 16, -ENOTSUP,
		"test.x: byte 4: the version, which must be 0302 or 0303, in the header is \" ~a?\"");
	expect_refused("xof 0303\x7f\x80\n\xfftxt ", 16, -EINVAL,
		"test.x: byte 8: the format, which must be txt, bin, tzip or bzip, in the header is \"????\"");
	expect_refused("xof 0303txt 0x~ ", 16, -EINVAL,
		"test.x: byte 12: the float size, which must be 0032 or 0064, in the header is \"0x~ \"");
	expect_refused("xof 0303txt 0032", 15, -EINVAL,
		"test.x: byte 15: the file ends within its header");
}

/* Any other byte makes it a file that limber does not read. */
static void test_each_byte_of_the_header_counts(void **state)
{
	static const char *const headers[] = {
		"xof 0303txt 0032", "xof 0302bin 0064"};

	(void)state;
	for (int i = 0; i < 2 * 12; i++) {
		struct log_capture logged;
		struct model *model;
		int at = 4 + i / 2;
		char header[17];

		memcpy(header, headers[i % 2], sizeof(header));
		header[at] = '!';
		assert_int_equal(load(header, 16, &logged, &model),
			at < 8 ? -ENOTSUP : -EINVAL);
		assert_null(model);
	}
}

#define BINARY  "xof 0303bin 0032"
/* An object that is skipped: template T { */
#define SKIPPED "\x1f\0\1\0\1\0\0\0T\n\0"

/* Writes a binary file that begins like this, and returns its size. */
static size_t begin(char *file, const char *rest, size_t size)
{
	memcpy(file, BINARY, 16);
	memcpy(file + 16, SKIPPED, sizeof(SKIPPED) - 1);
	memcpy(file + 16 + sizeof(SKIPPED) - 1, rest, size);
	return 16 + sizeof(SKIPPED) - 1 + size;
}

/* Parentheses to the dot, separators, words of templates; at byte 27. */
static void test_codes_of_binary_tokens_are_known(void **state)
{
	(void)state;
	for (int code = 0; code < 300; code++) {
		bool known = code == 31 || (code >= 12 && code <= 20) ||
			(code >= 40 && code <= 52);
		struct log_capture logged;
		struct model *model;
		char file[100], rest[4] = {(char)code, (char)(code >> 8), 11};
		char sentence[100];
		size_t size = begin(file, rest, 4);

		if ((code >= 1 && code <= 11) && code != 4 && code != 8 &&
			code != 9) {
			continue; /* values and braces */
		}
		snprintf(sentence, sizeof(sentence),
			"test.x: byte 27: %d is not a token of the binary format",
			code);
		if (known) {
			assert_int_equal(load(file, size, &logged, &model), 0);
			model_destroy(model);
		} else {
			expect_refused(file, size, -EINVAL, sentence);
		}
	}
}

/* The file ends after so many bytes of a token that would be complete. */
static void test_binary_values_must_be_complete(void **state)
{
	static const struct {
		char bytes[24];
		size_t size;
	} cases[] = {
		{"\1\0\3\0\0\0abc", 9}, /* a name */
		{"\1\0\0\0\0\0", 6},    /* an empty name */
		{"\2\0\3\0\0\0abc", 9}, /* a string */
		{"\3\0\1\2\3\4", 6},    /* an integer */
		{"\5\0"
		 "0123456789abcdef",
			18}, /* a GUID */
		{"\6\0\2\0\0\0"
		 "01234567",
			14}, /* two integers */
		{"\7\0\2\0\0\0"
		 "01234567",
			14}, /* two floats */
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		char file[100];

		for (size_t size = 1; size <= cases[i].size; size++) {
			size_t all = begin(file, cases[i].bytes, size);
			struct log_capture logged;
			struct model *model;

			assert_int_equal(
				load(file, all, &logged, &model), -EINVAL);
			assert_int_equal(logged.count, 1);
			assert_contains(logged.sentence[0],
				size < cases[i].size
					? "byte 27: the file ends within this token"
					: "the file ends before a closing brace");
		}
	}
}

/* A comma or a semicolon of two bytes, or of four, or none. */
static void test_binary_strings_have_separators_of_either_size(void **state)
{
	static const struct {
		char bytes[8];
		size_t size;
	} cases[] = {{"\x13", 2}, {"\x14", 2}, {"\x13\0\0", 4}, {"\x14\0\0", 4},
		{"", 0}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct log_capture logged;
		struct model *model;
		char rest[20] = "\2\0\1\0\0\0s", file[100];
		size_t size = 7 + cases[i].size;

		memcpy(rest + 7, cases[i].bytes, cases[i].size);
		assert_int_equal(
			load(file, begin(file, rest, size), &logged, &model),
			-EINVAL);
		assert_contains(logged.sentence[0],
			"the file ends before a closing brace");
		rest[size] = 11;
		assert_int_equal(
			load(file, begin(file, rest, size + 2), &logged, &model),
			0);
		model_destroy(model);
	}
}

static void keep(void *context, const char *finding)
{
	char *heard = context;

	snprintf(heard + strlen(heard), 4000 - strlen(heard), "%s\n", finding);
}

static void test_doctor_tells_what_limber_makes_of_a_file(void **state)
{
	static const char text[] =
		"xof 0303txt 0032\nFrame A { } Mesh M { 3; 0;0;0;, 1;0;0;, "
		"0;1;0;; 1; 3;0,1,2;; } AnimTicksPerSecond { 1; } "
		"AnimationSet S { Animation { { A } AnimationKey { 2; 1; "
		"0;3;1,2,3;;; } } }";
	static const char *const findings[] = {
		"DirectX .x is left-handed with row vectors; limber negates z",
		"channels with a single key (1)",
		"primitives without normals (1)",
		"clips that move nothing that limber shows (1), such as S",
	};
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "a.x");
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	char heard[4000] = "";
	const struct examiner examiner = {keep, heard};

	(void)state;
	file_write(path.text, text, sizeof(text) - 1);
	assert_int_equal(
		model_examine(path.text, MODEL_MEMORY_BYTES, &examiner, &log),
		0);
	assert_int_equal(logged.count, 0);
	for (size_t i = 0; i < ARRAY_COUNT(findings); i++) {
		assert_contains(heard, findings[i]);
	}
	file_write(path.text, text, 30);
	heard[0] = '\0';
	assert_int_equal(
		model_examine(path.text, MODEL_MEMORY_BYTES, &examiner, &log),
		-EINVAL);
	assert_string_equal(heard, "");
	assert_int_equal(logged.count, 1);
	temp_dir_remove(&folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_four_bytes_are_the_sign_of_the_format),
		cmocka_unit_test(test_the_format_names_version_and_encoding),
		cmocka_unit_test(test_a_wrong_header_is_shown),
		cmocka_unit_test(test_each_byte_of_the_header_counts),
		cmocka_unit_test(test_codes_of_binary_tokens_are_known),
		cmocka_unit_test(test_binary_values_must_be_complete),
		cmocka_unit_test(
			test_binary_strings_have_separators_of_either_size),
		cmocka_unit_test(test_doctor_tells_what_limber_makes_of_a_file),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
