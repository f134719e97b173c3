/*
 * What the evdev driver asks Linux for, and what it makes of errors. The
 * function ioctl() below replaces that of the C library.
 */
#define _GNU_SOURCE /* pipe2() */
#include "platform/buttons/evdev/system.h"
#include "tests/support/test.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/input.h>
#include <stdarg.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

/* A device with this name and these keys; 0 or the error of each request. */
static struct {
	const char *name;
	uint8_t keys[EVDEV_KEY_BYTES];
	int keys_error, name_error, clock_error;
	int clock; /* that was chosen, or -1 */
} device;

static int result_of(int error)
{
	errno = error ? error : ENOENT;
	return error ? -1 : 0;
}

static int get_name(char *name, unsigned int size)
{
	if (!device.name_error) {
		strncpy(name, device.name, size);
	}
	return result_of(device.name_error);
}

int ioctl(int fd, unsigned long request, ...)
{
	unsigned int number = _IOC_NR(request), size = _IOC_SIZE(request);
	va_list list;
	void *argument;

	va_start(list, request);
	argument = va_arg(list, void *);
	va_end(list);
	assert_int_equal(fd, 7);
	assert_int_equal(_IOC_TYPE(request), 'E');
	if (number == _IOC_NR(EVIOCGNAME(0))) {
		return get_name(argument, size);
	}
	if (number == _IOC_NR(EVIOCSCLOCKID)) {
		device.clock = *(const int *)argument;
		return result_of(device.clock_error);
	}
	assert_true(number == _IOC_NR(EVIOCGBIT(EV_KEY, 0)) ||
		number == _IOC_NR(EVIOCGKEY(0)));
	assert_int_equal(size, EVDEV_KEY_BYTES);
	if (!device.keys_error) {
		memcpy(argument, device.keys, size);
	}
	return result_of(device.keys_error);
}

static void begin(const char *name)
{
	memset(&device, 0, sizeof(device));
	device.name = name;
	device.clock = -1;
	for (int i = 0; i < EVDEV_KEY_BYTES; i++) {
		device.keys[i] = (uint8_t)(7 * i + 1);
	}
}

static void test_a_device_is_described_by_its_name_and_keys(void **state)
{
	struct evdev_description out;

	(void)state;
	begin("keypad");
	memset(&out, 0x5A, sizeof(out));
	assert_int_equal(evdev_linux.describe(7, &out), 0);
	assert_string_equal(out.name, "keypad");
	assert_memory_equal(out.keys, device.keys, sizeof(out.keys));
	assert_int_equal(device.clock, CLOCK_MONOTONIC);
}

static void test_a_long_name_is_cut(void **state)
{
	struct evdev_description out;
	char name[200];

	(void)state;
	memset(name, 'x', sizeof(name));
	begin(name);
	memset(&out, 0x5A, sizeof(out));
	assert_int_equal(evdev_linux.describe(7, &out), 0);
	assert_int_equal(strlen(out.name), sizeof(out.name) - 1);
	assert_memory_equal(out.keys, device.keys, sizeof(out.keys));
}

static void test_a_device_may_lack_a_name_and_a_clock(void **state)
{
	struct evdev_description out;

	(void)state;
	begin("unused");
	device.name_error = ENOENT;
	device.clock_error = EINVAL;
	assert_int_equal(evdev_linux.describe(7, &out), 0);
	assert_string_equal(out.name, "no name");
	device.keys_error = ENOTTY;
	assert_int_equal(evdev_linux.describe(7, &out), -ENOTTY);
}

static void test_keys_that_are_down_are_read(void **state)
{
	uint8_t bits[EVDEV_KEY_BYTES];

	(void)state;
	begin("keypad");
	memset(bits, 0x5A, sizeof(bits));
	assert_int_equal(evdev_linux.keys_down(7, bits), 0);
	assert_memory_equal(bits, device.keys, sizeof(bits));
	device.keys_error = ENODEV;
	assert_int_equal(evdev_linux.keys_down(7, bits), -ENODEV);
	for (size_t i = 0; i < sizeof(bits); i++) {
		assert_int_equal(bits[i], 0);
	}
}

static void test_reading_never_waits(void **state)
{
	int pipes[2], null = evdev_linux.open("/dev/null");
	char bytes[8];

	(void)state;
	assert_int_equal(pipe2(pipes, O_NONBLOCK), 0);
	assert_int_equal(
		evdev_linux.read(pipes[0], bytes, sizeof(bytes)), -EAGAIN);
	assert_int_equal(write(pipes[1], "abc", 3), 3);
	assert_int_equal(evdev_linux.read(pipes[0], bytes, sizeof(bytes)), 3);
	assert_memory_equal(bytes, "abc", 3);
	close(pipes[0]);
	close(pipes[1]);
	assert_true(null >= 0);
	assert_int_equal(fcntl(null, F_GETFL) & (O_NONBLOCK | O_ACCMODE),
		O_NONBLOCK | O_RDONLY);
	assert_int_equal(fcntl(null, F_GETFD), FD_CLOEXEC);
	errno = EIO;
	assert_int_equal(evdev_linux.read(null, bytes, sizeof(bytes)), 0);
	close(null);
	assert_int_equal(evdev_linux.open("/nowhere/event0"), -ENOENT);
	assert_string_equal(evdev_linux.directory, "/dev/input");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_device_is_described_by_its_name_and_keys),
		cmocka_unit_test(test_a_long_name_is_cut),
		cmocka_unit_test(test_a_device_may_lack_a_name_and_a_clock),
		cmocka_unit_test(test_keys_that_are_down_are_read),
		cmocka_unit_test(test_reading_never_waits),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
