/* Displays learn that the process will give up its rights. */
#include "app/cmd/show/show_screen.h"
#include "tests/support/test.h"

#include <errno.h>

static bool drops_rights;

/* These replace display_registry.c: no screen is opened. */
const struct display_driver *const display_registry[] = {NULL};

const struct display_driver *display_choose(
	const char *spec, const struct log *log)
{
	(void)spec;
	(void)log;
	return NULL;
}

int display_check(const char *spec, const struct display_options *options,
	const struct display_driver **driver)
{
	(void)spec;
	(void)options;
	(void)driver;
	return 0;
}

int display_open(const char *spec, const struct display_options *options,
	const struct display_driver **driver, struct display **out)
{
	(void)spec;
	(void)driver;
	(void)out;
	drops_rights = options->drops_rights;
	return -ENODEV;
}

static void test_a_display_knows_of_the_option_user(void **state)
{
	const struct log log = log_to_nowhere();
	struct options options = options_default();
	struct show_screen screen;

	(void)state;
	assert_int_equal(
		show_screen_open(&screen, &options, "kms", 0, 30.0, &log),
		-ENODEV);
	assert_false(drops_rights);
	options.show.user = "limber";
	assert_int_equal(
		show_screen_open(&screen, &options, "kms", 0, 30.0, &log),
		-ENODEV);
	assert_true(drops_rights);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_display_knows_of_the_option_user),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
