/* What the loader of glTF takes from a model's memory, and gives back. */
#include "app/model/model.h"
#include "platform/base/memory_budget.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Loads a file with extras: a part that is repeated, between two others. */
static struct model *load_extras(
	const char *before, const char *part, size_t count, const char *after)
{
	static const char begin[] = "{'asset':{'version':'2.0'},'extras':";
	size_t each = strlen(part);
	char *text = malloc(sizeof(begin) + strlen(before) + strlen(after) +
		count * each + 2);
	struct log_capture logged;
	struct model *model = NULL;
	char *at = text;

	assert_non_null(text);
	at += sprintf(at, "%s%s", begin, before);
	for (size_t i = 0; i < count; i++, at += each) {
		memcpy(at, part, each);
	}
	sprintf(at, "%s}", after);
	if (model_from_text(text, &logged, &model) != 0) {
		fail_msg("%s", logged.sentence[0]);
	}
	free(text);
	return model;
}

/* Only commas and brackets count; a value takes 100 bytes of the budget. */
static void test_a_long_string_is_one_value(void **state)
{
	static const char *const parts[] = {"x", ".", "}"};

	(void)state;
	for (int i = 0; i < 3; i++) {
		model_destroy(load_extras("'", parts[i], 3000000, "'"));
	}
}

static void test_memory_of_the_json_is_given_back(void **state)
{
	struct model *small = load_extras("[", "0,", 1, "0]");
	struct model *large = load_extras("[", "0,", 20000, "0]");

	(void)state;
	assert_int_equal(large->budget->used_bytes, small->budget->used_bytes);
	assert_true(large->budget->used_bytes < 200000);
	model_destroy(small);
	model_destroy(large);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_long_string_is_one_value),
		cmocka_unit_test(test_memory_of_the_json_is_given_back),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
