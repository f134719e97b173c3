#define _GNU_SOURCE /* syscall(), MAP_ANONYMOUS */

#include "platform/process/process_memory.h"
#include "tests/support/test.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

enum {
	TOUCHED_BYTES = 64 << 20,
	SLACK_BYTES = 2 << 20
};

/* What read() does. */
static enum {
	READ_FILE,
	READ_TEXT,
	READ_NOTHING,
	READ_FAILS
} reading;

/* In place of the C library's. */
ssize_t read(int file, void *out, size_t size)
{
	if (reading == READ_FAILS) {
		errno = EIO;
		return -1;
	}
	if (reading == READ_TEXT) {
		static const char text[] = "2908 70 61 9 0 88 0\n";

		memcpy(out, text, sizeof(text) - 1);
		return sizeof(text) - 1;
	}
	return reading == READ_NOTHING ? 0 : syscall(SYS_read, file, out, size);
}

static void test_memory_counts_when_it_is_touched(void **state)
{
	const size_t page = (size_t)sysconf(_SC_PAGESIZE);
	size_t before, mapped, after;
	volatile char *memory;

	(void)state;
	memory = mmap(NULL, TOUCHED_BYTES, PROT_READ | PROT_WRITE,
		MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
	assert_ptr_not_equal(memory, MAP_FAILED);
	before = process_memory_bytes();
	assert_in_range(before, 100 << 10, (size_t)1 << 31);
	mapped = process_memory_bytes();
	assert_in_range(mapped, before - SLACK_BYTES, before + SLACK_BYTES);
	for (size_t i = 0; i < TOUCHED_BYTES; i += page) {
		memory[i] = 1;
	}
	after = process_memory_bytes();
	assert_in_range(after - before, TOUCHED_BYTES - SLACK_BYTES,
		TOUCHED_BYTES + SLACK_BYTES);
	assert_int_equal(munmap((void *)memory, TOUCHED_BYTES), 0);
	assert_in_range(process_memory_bytes(), before - SLACK_BYTES,
		before + SLACK_BYTES);
}

static void test_it_is_the_second_decimal_number_of_the_file(void **state)
{
	(void)state;
	reading = READ_TEXT;
	assert_int_equal(
		process_memory_bytes(), 70 * (size_t)sysconf(_SC_PAGESIZE));
	reading = READ_FILE;
}

static void test_asking_opens_no_file_for_long(void **state)
{
	int before = open("/dev/null", O_RDONLY), after;

	(void)state;
	for (int i = 0; i < 100; i++) {
		assert_true(process_memory_bytes() > 0);
	}
	after = open("/dev/null", O_RDONLY);
	assert_int_equal(after, before + 1);
	close(before);
	close(after);
}

static void test_the_file_may_be_descriptor_0(void **state)
{
	int kept = dup(0);

	(void)state;
	assert_int_equal(close(0), 0);
	assert_true(process_memory_bytes() > 0);
	assert_int_equal(dup2(kept, 0), 0);
	close(kept);
}

static void test_it_is_0_when_no_file_can_be_opened(void **state)
{
	struct rlimit kept, none;

	(void)state;
	assert_int_equal(getrlimit(RLIMIT_NOFILE, &kept), 0);
	none = (struct rlimit){.rlim_cur = 0, .rlim_max = kept.rlim_max};
	assert_int_equal(setrlimit(RLIMIT_NOFILE, &none), 0);
	assert_int_equal(process_memory_bytes(), 0);
	assert_int_equal(setrlimit(RLIMIT_NOFILE, &kept), 0);
	assert_true(process_memory_bytes() > 0);
}

static void test_it_is_0_when_the_file_cannot_be_read(void **state)
{
	(void)state;
	reading = READ_FAILS;
	assert_int_equal(process_memory_bytes(), 0);
	reading = READ_NOTHING;
	assert_int_equal(process_memory_bytes(), 0);
	reading = READ_FILE;
	assert_true(process_memory_bytes() > 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_memory_counts_when_it_is_touched),
		cmocka_unit_test(
			test_it_is_the_second_decimal_number_of_the_file),
		cmocka_unit_test(test_asking_opens_no_file_for_long),
		cmocka_unit_test(test_the_file_may_be_descriptor_0),
		cmocka_unit_test(test_it_is_0_when_no_file_can_be_opened),
		cmocka_unit_test(test_it_is_0_when_the_file_cannot_be_read),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
