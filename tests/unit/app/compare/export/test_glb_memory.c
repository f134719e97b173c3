/* A binary glTF file in memory where the C library has none left. */
#include "app/compare/export/glb.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdlib.h>

static struct {
	int calls;     /* that succeed */
	bool no_bytes; /* the next one is closed without any */
} fake;

FILE *open_memstream(char **bytes, size_t *size)
{
	*bytes = NULL;
	*size = 0;
	if (fake.calls-- > 0) {
		return tmpfile();
	}
	errno = ENOMEM;
	return fake.no_bytes ? tmpfile() : NULL;
}

static void test_what_memory_does_not_hold_is_an_error(void **state)
{
	(void)state;
	for (int i = 0; i < 2; i++) {
		struct log_capture logged;
		struct log log = log_capture_begin(&logged);
		uint8_t other, *data = &other;
		struct glb glb;
		size_t size;

		fake.calls = 1;
		fake.no_bytes = i == 1;
		glb_begin_memory(&glb);
		assert_int_equal(glb.error, 0);
		assert_int_equal(
			glb_write_memory(&glb, "HERE", &log, &data, &size),
			-ENOMEM);
		assert_null(data);
		assert_int_equal(logged.count, 1);
		assert_contains(logged.sentence[0], "HERE: ");
		assert_contains(logged.sentence[0], "memory");
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_what_memory_does_not_hold_is_an_error),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
