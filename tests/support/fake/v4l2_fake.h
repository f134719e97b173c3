/*
 * A V4L2 device that is played: what a driver answers, what it refuses, when
 * it has a picture. The byte of every picture is its number.
 *
 *	struct v4l2_fake *fake = v4l2_fake_new();
 *
 *	fake->vendor = true;
 *	v4l2_session_init(&session, &fake->calls, &request);
 *
 * With a clock of its own, time passes where a call waits. On the machine's
 * clock it can be used from several threads, members through v4l2_fake_set().
 */
#ifndef TESTS_SUPPORT_FAKE_V4L2_FAKE_H
#define TESTS_SUPPORT_FAKE_V4L2_FAKE_H

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

#include "platform/camera/v4l2/v4l2_calls.h"

enum {
	V4L2_FAKE_FORMATS = 8,
	V4L2_FAKE_BUFFERS = 8
};

struct v4l2_fake {
	struct v4l2_calls calls;
	pthread_mutex_t lock;

	/* What kind of driver it is. */
	bool vendor;                         /* the i.MX31's: see device.h */
	uint32_t offered[V4L2_FAKE_FORMATS]; /* 0 ends them */
	int buffers_most;
	int stride_extra; /* bytes after each row */
	bool real_time;   /* the machine's clock */
	int block_ms;     /* DQBUF waits so long for a picture, then ETIME */

	/* What goes wrong now. */
	int open_error; /* -errno */
	int format_error;
	int dequeue_error;
	bool unplugged;
	bool damaged;  /* pictures come with an error */
	bool short_of; /* pictures lack their end */

	/* Pictures: number of the next, how many may be taken. */
	int next, ready;
	int period_ms; /* on the machine's clock: one so often; 0: none */

	/* What was done to it. */
	int opens, closes, starts, stops, maps, unmaps, queues;
	bool dirty_priv; /* S_FMT came with something in priv */
	bool used_wrongly;
	char path[128]; /* last opened */

	/* The driver's own. */
	int64_t now_ms, next_due_ms;
	bool open, streaming;
	uint32_t fourcc, width, height, stride, size;
	int buffer_count;
	uint8_t *memory[V4L2_FAKE_BUFFERS];
	int queue[V4L2_FAKE_BUFFERS], queued;
};

/* A usual driver on a clock of its own: YUYV, four buffers, no picture. */
struct v4l2_fake *v4l2_fake_new(void);

void v4l2_fake_free(struct v4l2_fake *fake);

/* Another thread may be in a call: takes the lock. */
void v4l2_fake_set(struct v4l2_fake *fake, bool *member, bool value);
int v4l2_fake_get(struct v4l2_fake *fake, const int *member);

#endif
