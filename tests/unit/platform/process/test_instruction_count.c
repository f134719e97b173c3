#include "platform/process/instruction_count.h"
#include "tests/support/test.h"

enum {
	STEPS = 1000000
};

/* The instructions of that many steps of a loop, or -errno. */
static int64_t count_steps(int steps)
{
	struct instruction_count count;
	volatile int sum = 0;
	int error = instruction_count_begin(&count);

	if (error) {
		assert_true(error < 0);
		return error;
	}
	for (int i = 0; i < steps; i++) {
		sum += i;
	}
	return instruction_count_end(&count);
}

static void test_a_longer_loop_takes_more_instructions(void **state)
{
	int64_t few, many;

	(void)state;
	few = count_steps(STEPS);
	if (few < 0) {
		skip_because("this machine counts no instructions");
	}
	many = count_steps(2 * STEPS);
	assert_in_range(few, 3 * STEPS, 30 * STEPS);
	assert_in_range(many * 100 / few, 190, 210);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_longer_loop_takes_more_instructions),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
