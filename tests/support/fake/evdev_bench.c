#include "tests/support/fake/evdev_bench.h"

#include "platform/buttons/evdev/decode.h"
#include "platform/buttons/event_time.h"
#include "tests/support/test.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/input-event-codes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

/* The functions of struct evdev_system have no context parameter. */
static struct evdev_bench *bench_now;

static struct evdev_bench_device *device_of(int fd)
{
	for (int i = 0; i < EVDEV_BENCH_DEVICES; i++) {
		if (bench_now->device[i].theirs == fd) {
			return &bench_now->device[i];
		}
	}
	return NULL;
}

/* Closes the tests' end of a device, if it is open. */
static void close_ours(struct evdev_bench_device *device)
{
	if (device->ours >= 0) {
		close(device->ours);
	}
	device->ours = -1;
}

static int open_device(const char *path)
{
	const char *number = strrchr(path, '/') + 6;
	int pair[2];
	struct evdev_bench_device *device;

	if (access(path, F_OK) < 0) {
		return -errno;
	}
	device = &bench_now->device[atoi(number)];
	if (device->error) {
		return -device->error;
	}
	assert_int_equal(socketpair(AF_UNIX, SOCK_STREAM, 0, pair), 0);
	assert_int_equal(fcntl(pair[1], F_SETFL, O_NONBLOCK), 0);
	close_ours(device);
	/* The number may be that of a descriptor that the driver has closed. */
	for (int i = 0; i < EVDEV_BENCH_DEVICES; i++) {
		if (bench_now->device[i].theirs == pair[1]) {
			bench_now->device[i].theirs = -1;
		}
	}
	device->ours = pair[0];
	device->theirs = pair[1];
	return pair[1];
}

static int describe_device(int fd, struct evdev_description *out)
{
	*out = device_of(fd)->description;
	return 0;
}

static int keys_down(int fd, uint8_t bits[EVDEV_KEY_BYTES])
{
	memcpy(bits, device_of(fd)->down, EVDEV_KEY_BYTES);
	return 0;
}

static ssize_t read_device(int fd, void *bytes, size_t size)
{
	ssize_t count;

	if (device_of(fd)->gone) {
		return -ENODEV;
	}
	count = read(fd, bytes, size);
	return count < 0 ? -errno : count;
}

void evdev_bench_set_key(uint8_t *bits, int code, bool on)
{
	bits[code / 8] =
		(uint8_t)((bits[code / 8] & ~(1 << code % 8)) | on << code % 8);
}

void evdev_bench_plug_in(
	struct evdev_bench *bench, int number, const char *name, int key)
{
	char file[16];
	struct test_path path;
	struct evdev_bench_device *device = &bench->device[number];

	close_ours(device);
	*device = (struct evdev_bench_device){
		.ours = -1, .theirs = -1, .error = device->error};
	snprintf(device->description.name, sizeof(device->description.name),
		"%s", name);
	evdev_bench_set_key(device->description.keys, key, true);
	snprintf(file, sizeof(file), "event%d", number);
	path = path_join(&bench->folder, file);
	file_write(path.text, "", 0);
}

void evdev_bench_unplug(struct evdev_bench *bench, int number)
{
	char file[16];
	struct test_path path;

	snprintf(file, sizeof(file), "event%d", number);
	path = path_join(&bench->folder, file);
	assert_int_equal(unlink(path.text), 0);
	bench->device[number].gone = true;
	close_ours(&bench->device[number]);
}

int evdev_bench_setup(void **state)
{
	struct evdev_bench *bench = calloc(1, sizeof(*bench));

	assert_non_null(bench);
	bench->folder = temp_dir_make();
	bench->system = (struct evdev_system){
		.directory = bench->folder.text,
		.open = open_device,
		.describe = describe_device,
		.keys_down = keys_down,
		.read = read_device,
	};
	for (int i = 0; i < EVDEV_BENCH_DEVICES; i++) {
		bench->device[i].ours = bench->device[i].theirs = -1;
	}
	bench->log = log_capture_begin(&bench->logged);
	button_queue_init(&bench->queue, 8);
	bench_now = bench;
	*state = bench;
	return 0;
}

int evdev_bench_teardown(void **state)
{
	struct evdev_bench *bench = *state;

	button_driver_evdev.destroy(bench->source);
	for (int i = 0; i < EVDEV_BENCH_DEVICES; i++) {
		close_ours(&bench->device[i]);
	}
	temp_dir_remove(&bench->folder);
	free(bench);
	return 0;
}

void evdev_bench_open(struct evdev_bench *bench, const char *argument)
{
	assert_int_equal(evdev_create_on(&bench->system, argument, &bench->log,
				 &bench->source),
		0);
	button_driver_evdev.poll(bench->source, 0, &bench->queue);
}

void evdev_bench_poll(struct evdev_bench *bench)
{
	bench->now_ms += 100;
	button_driver_evdev.poll(bench->source, bench->now_ms, &bench->queue);
	button_queue_settle(&bench->queue, bench->now_ms);
}

void evdev_bench_send(
	struct evdev_bench *bench, int number, int type, int code, int value)
{
	unsigned char bytes[EVDEV_SIZE];
	int64_t stamp_ns = event_clocks_now().monotonic_ns -
		(int64_t)bench->age_ms * 1000000;
	long time[2] = {(long)(stamp_ns / 1000000000),
		(long)(stamp_ns % 1000000000 / 1000)};
	uint16_t words[2] = {(uint16_t)type, (uint16_t)code};
	int32_t number_value = value;

	memcpy(bytes, time, sizeof(time));
	memcpy(bytes + sizeof(time), words, sizeof(words));
	memcpy(bytes + sizeof(time) + 4, &number_value, 4);
	assert_int_equal(write(bench->device[number].ours, bytes, sizeof(bytes)),
		sizeof(bytes));
}

void evdev_bench_key(struct evdev_bench *bench, int number, int code, int value)
{
	evdev_bench_send(bench, number, EV_KEY, code, value);
	evdev_bench_send(bench, number, EV_SYN, SYN_REPORT, 0);
}

void evdev_bench_expect(struct evdev_bench *bench, enum button button, bool down)
{
	struct button_event event;

	assert_true(button_queue_pop(&bench->queue, &event));
	assert_int_equal(event.button, button);
	assert_int_equal(event.down, down);
}

void evdev_bench_expect_nothing(struct evdev_bench *bench)
{
	struct button_event event;

	assert_false(button_queue_pop(&bench->queue, &event));
}
