/*
 * Compares gl.h and gl_functions.h with the Khronos header: the compiler
 * compares the calls, the tests compare the values as text.
 */
#include "tests/support/files.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#if __has_include(<GLES/gl.h>)
#include <GLES/gl.h>

static const bool has_types = true;
#define GL_FUNCTION(result, name, parameters) \
	_Generic(gl##name, result(*) parameters : 1, default : 0),
#define FUNCTION_LIST "platform/gl/gl_functions.h"
#else
static const bool has_types = false;
#define GL_FUNCTION(result, name, parameters)
#define FUNCTION_LIST "platform/gl/gl_functions.h"
#endif

static const char ours_path[] = "platform/gl/gl.h";
static const char theirs_path[] = "/usr/include/GLES/gl.h";

static const int type_is_the_same[] = {
#include FUNCTION_LIST
	-1,
};
#undef GL_FUNCTION

static const char *const function_names[] = {
#define GL_FUNCTION(result, name, parameters) #name,
#include FUNCTION_LIST
	NULL,
};
#undef GL_FUNCTION

static bool is_there(const char *path)
{
	struct stat status;

	return stat(path, &status) == 0;
}

/* The value of "#define NAME VALUE" in text, or -1. */
static long defined_value(const char *text, const char *name)
{
	size_t length = strlen(name);
	const char *at = text;

	while ((at = strstr(at, name))) {
		bool whole = at[length] == ' ' || at[length] == '\t';
		const char *define = "#define ";

		if (whole && at - text >= (long)strlen(define) &&
			strncmp(at - strlen(define), define, strlen(define)) ==
				0) {
			return strtol(at + length, NULL, 0);
		}
		at += length;
	}
	return -1;
}

static void test_values_are_those_of_khronos(void **state)
{
	char *ours, *theirs, *line, *rest;
	int count = 0;
	int wrong = 0;

	(void)state;
	if (!is_there(theirs_path)) {
		skip_because("no GLES/gl.h here: install libgles-dev");
	}
	ours = file_read(ours_path, NULL);
	theirs = file_read(theirs_path, NULL);
	for (line = strtok_r(ours, "\n", &rest); line;
		line = strtok_r(NULL, "\n", &rest)) {
		char name[64], value[64];
		long expected;

		if (sscanf(line, "#define %63s %63s", name, value) != 2 ||
			strcmp(name, "GL_FUNCTION(result,") == 0) {
			continue;
		}
		expected = defined_value(theirs, name);
		/* Values are compared, so 0x0 equals 0. */
		if (expected != strtol(value, NULL, 0)) {
			print_error("%s is %s, not %#lx\n", name, value,
				(unsigned long)expected);
			wrong++;
		}
		count++;
	}
	free(ours);
	free(theirs);
	assert_int_equal(wrong, 0);
	assert_true(count > 150);
}

static void test_calls_have_the_types_of_khronos(void **state)
{
	int count = 0;

	(void)state;
	if (!has_types) {
		skip_because("built without GLES/gl.h");
	}
	for (; function_names[count]; count++) {
		if (type_is_the_same[count] != 1) {
			fail_msg("gl%s: other parameters than in GLES/gl.h",
				function_names[count]);
		}
	}
	assert_true(count > 60);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_values_are_those_of_khronos),
		cmocka_unit_test(test_calls_have_the_types_of_khronos),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
