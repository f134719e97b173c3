#include "tests/support/gl/gl_checks.h"

int main(void)
{
	const struct CMUnitTest tests[] = {GL_CHECKS("soft")};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
