/* base64.h and uri.h: data URIs and escaped file names. */
#include "app/model/gltf/base64.h"
#include "app/model/gltf/uri.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static void expect_bytes(const char *text, const char *bytes)
{
	uint8_t out[32];
	size_t size = 99;

	assert_true(base64_decoded_max(strlen(text)) <= sizeof(out));
	assert_int_equal(base64_decode(text, strlen(text), out, &size), 0);
	assert_int_equal(size, strlen(bytes));
	assert_memory_equal(out, bytes, size);
}

/* The examples of RFC 4648, section 10. */
static void test_decodes_the_rfc_examples(void **state)
{
	(void)state;
	expect_bytes("", "");
	expect_bytes("Zg==", "f");
	expect_bytes("Zm8=", "fo");
	expect_bytes("Zm9v", "foo");
	expect_bytes("Zm9vYg==", "foob");
	expect_bytes("Zm9vYmE=", "fooba");
	expect_bytes("Zm9vYmFy", "foobar");
	expect_bytes("+/+/", "\xfb\xff\xbf");
}

static void test_accepts_base64_without_padding(void **state)
{
	(void)state;
	expect_bytes("Zg", "f");
	expect_bytes("Zm9vYmE", "fooba");
}

static void test_refuses_what_is_not_base64(void **state)
{
	static const char *const texts[] = {
		"Z",
		"Zm9vY",
		"Zm9 ",
		"Zm9-",
		"Zm9\n",
		"Z===",
		"=Zg=",
		"Zg=",
		"Zm=9",
		"Zm\xc3\xa9",
	};
	uint8_t out[32];
	size_t size, i;

	(void)state;
	for (i = 0; i < sizeof(texts) / sizeof(texts[0]); i++) {
		assert_int_equal(
			base64_decode(texts[i], strlen(texts[i]), out, &size),
			-EINVAL);
	}
}

static void test_recognises_data_uris(void **state)
{
	(void)state;
	assert_true(uri_is_data("data:;base64,AA=="));
	assert_true(uri_is_data("DATA:x"));
	assert_false(uri_is_data("data.bin"));
	assert_string_equal(
		uri_data_base64("data:image/png;base64,AA=="), "AA==");
	assert_string_equal(uri_data_base64("data:;base64,"), "");
	assert_string_equal(uri_data_base64(";base64,AA=="), "AA==");
	assert_null(uri_data_base64("base64,AA=="));
	assert_null(uri_data_base64("data:text/plain,AA=="));
	assert_null(uri_data_base64("data:;base64"));
	assert_null(uri_data_base64(",AA=="));
}

static void test_recognises_schemes(void **state)
{
	(void)state;
	assert_true(uri_has_scheme("http://example.org/a.bin"));
	assert_true(uri_has_scheme("file:a.bin"));
	assert_true(uri_has_scheme("C:\\a.bin"));
	assert_false(uri_has_scheme("a.bin"));
	assert_false(uri_has_scheme("folder/a:b.bin"));
	assert_false(uri_has_scheme("1:a"));
	assert_false(uri_has_scheme(""));
}

/* A scheme is a letter, followed by letters, digits, + - and dots. */
static void test_a_scheme_has_only_its_characters(void **state)
{
	static const char letters[] =
		"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
	static const char others[] = "0123456789+-.";

	(void)state;
	for (int c = 1; c < 256; c++) {
		const char first[] = {(char)c, ':', 'x', '\0'};
		const char second[] = {'x', (char)c, ':', '\0'};
		bool is_letter = strchr(letters, c) != NULL;

		assert_int_equal(uri_has_scheme(first), is_letter);
		assert_int_equal(uri_has_scheme(second),
			is_letter || strchr(others, c) != NULL || c == ':');
	}
}

static void test_decodes_percent_escapes(void **state)
{
	char out[32];

	(void)state;
	assert_int_equal(uri_unescape("a%20b%2fC%C3%A9+", out), 0);
	assert_string_equal(out, "a b/C\xc3\xa9+");
	assert_int_equal(uri_unescape("", out), 0);
	assert_string_equal(out, "");
}

static void test_an_escape_has_two_hexadecimal_digits(void **state)
{
	static const char digits[] = "0123456789abcdefABCDEF";

	(void)state;
	for (int c = 1; c < 256; c++) {
		const char first[] = {'%', (char)c, '4', '\0'};
		const char second[] = {'%', '4', (char)c, '\0'};
		int wanted = strchr(digits, c) ? 0 : -EINVAL;
		char escape[8], out[8];

		assert_int_equal(uri_unescape(first, out), wanted);
		assert_int_equal(uri_unescape(second, out), wanted);
		for (int upper = 0; upper < 2; upper++) {
			snprintf(escape, sizeof(escape),
				upper ? "%%%02Xz" : "%%%02xz", (unsigned int)c);
			assert_int_equal(uri_unescape(escape, out), 0);
			assert_int_equal((uint8_t)out[0], c);
			assert_string_equal(out + 1, "z");
		}
	}
}

static void test_refuses_broken_escapes(void **state)
{
	char out[32];

	(void)state;
	assert_int_equal(uri_unescape("a%", out), -EINVAL);
	assert_int_equal(uri_unescape("a%2", out), -EINVAL);
	assert_int_equal(uri_unescape("a%zz", out), -EINVAL);
	assert_int_equal(uri_unescape("a%00.png", out), -EINVAL);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_decodes_the_rfc_examples),
		cmocka_unit_test(test_accepts_base64_without_padding),
		cmocka_unit_test(test_refuses_what_is_not_base64),
		cmocka_unit_test(test_recognises_data_uris),
		cmocka_unit_test(test_recognises_schemes),
		cmocka_unit_test(test_a_scheme_has_only_its_characters),
		cmocka_unit_test(test_decodes_percent_escapes),
		cmocka_unit_test(test_an_escape_has_two_hexadecimal_digits),
		cmocka_unit_test(test_refuses_broken_escapes),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
