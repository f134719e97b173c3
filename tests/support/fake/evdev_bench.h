/*
 * Input devices for tests of the evdev driver: files in a temporary folder
 * whose events come through sockets. Only one bench at a time.
 */
#ifndef TESTS_SUPPORT_FAKE_EVDEV_BENCH_H
#define TESTS_SUPPORT_FAKE_EVDEV_BENCH_H

#include "platform/buttons/buttons.h"
#include "platform/buttons/evdev/system.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"

extern const struct button_driver button_driver_evdev;

enum {
	EVDEV_BENCH_DEVICES = 3
};

/* One of event0 to event2; the driver reads from a socket. */
struct evdev_bench_device {
	int ours, theirs; /* the test's and the driver's end; -1: not open */
	int error;        /* errno of opening it, 0 for none */
	bool gone;        /* unplugged: reading fails */
	struct evdev_description description;
	uint8_t down[EVDEV_KEY_BYTES]; /* a bit for each key that is down */
};

struct evdev_bench {
	struct test_path folder;
	struct evdev_system system;
	struct evdev_bench_device device[EVDEV_BENCH_DEVICES];
	struct log_capture logged;
	struct log log;
	struct button_source *source;
	struct button_queue queue;
	int64_t now_ms;
	int age_ms; /* of the events that are sent */
};

/* For cmocka: *state is the bench. */
int evdev_bench_setup(void **state);
int evdev_bench_teardown(void **state);

/* Sets the bit of a key in a device's description or state. */
void evdev_bench_set_key(uint8_t *bits, int code, bool on);

/* Adds a device with one key to the folder. */
void evdev_bench_plug_in(
	struct evdev_bench *bench, int number, const char *name, int key);

/* Removes a device from the folder. */
void evdev_bench_unplug(struct evdev_bench *bench, int number);

/* Creates the driver's source with that argument and polls it once. */
void evdev_bench_open(struct evdev_bench *bench, const char *argument);

/* Polls the source 100 ms later. */
void evdev_bench_poll(struct evdev_bench *bench);

/* Sends one event of a device, stamped age_ms ago. */
void evdev_bench_send(
	struct evdev_bench *bench, int number, int type, int code, int value);

/* Sends a key event (0 released, 1 pressed, 2 repeated) and its report. */
void evdev_bench_key(struct evdev_bench *bench, int number, int code, int value);

/* Fails the test unless this is the next event in the queue. */
void evdev_bench_expect(
	struct evdev_bench *bench, enum button button, bool down);

/* Fails the test unless the queue is empty. */
void evdev_bench_expect_nothing(struct evdev_bench *bench);

#endif
