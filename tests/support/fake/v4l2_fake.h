/*
 * A made-up V4L2 device: a test decides what its driver answers, what it refuses
 * and when it has a picture. Every byte of a picture is the picture's number.
 *
 *	struct v4l2_fake *fake = v4l2_fake_new();
 *
 *	fake->vendor = true;
 *	v4l2_session_init(&session, &fake->calls, &request);
 *
 * With a clock of its own, time passes only where a call waits. With the
 * machine's clock, several threads may use the device; they access its members
 * through v4l2_fake_set() and v4l2_fake_get().
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

	/* The kind of driver. */
	bool vendor;                         /* as the i.MX31's: see device.h */
	uint32_t offered[V4L2_FAKE_FORMATS]; /* a 0 ends the list */
	int buffers_most;
	uint32_t side_least; /* of its pictures */
	/* Asked for more than large_above, its pictures have large sides. */
	uint32_t large, large_above;
	uint32_t large_fourcc; /* in this format only; 0: in all */
	int stride_extra;      /* unused bytes after each row */
	/* What it answers if asked for progressive and interlaced pictures. */
	uint32_t field, interlaced;
	bool real_time; /* it has the machine's clock */
	int block_ms;   /* DQBUF fails with ETIME after waiting so long */

	/* What goes wrong from now on. */
	int open_error; /* -errno */
	int format_error;
	char useless[16]; /* "" or the path of a device with format_error */
	int dequeue_error;
	bool unplugged;
	bool damaged;  /* pictures carry an error flag */
	bool short_of; /* pictures lack their last byte */
	bool excess;   /* pictures claim more bytes than their buffer has */
	bool repeats;  /* DQBUF always names the first buffer */

	int next;      /* number of the next picture */
	int ready;     /* pictures that DQBUF can take */
	int period_ms; /* with the machine's clock: between pictures; 0: none */

	/* Calls that the driver got. */
	int opens, closes, starts, stops, maps, unmaps, queues;
	bool dirty_priv;   /* S_FMT had a priv other than 0 */
	bool used_wrongly; /* a call broke the rules of V4L2 */
	char path[128];    /* that was opened last */

	/* State of the driver, not for tests. */
	int64_t now_ms, next_due_ms;
	bool open, streaming;
	uint32_t fourcc, width, height, stride, size;
	int buffer_count;
	uint8_t *memory[V4L2_FAKE_BUFFERS];
	int queue[V4L2_FAKE_BUFFERS], queued;
};

/*
 * Makes a usual driver with a clock of its own: YUYV, four buffers, no picture
 * yet. The caller ends with v4l2_fake_free().
 */
struct v4l2_fake *v4l2_fake_new(void);

void v4l2_fake_free(struct v4l2_fake *fake);

/* Frees it, after checks that it was used rightly and everything was released. */
void v4l2_fake_end(struct v4l2_fake *fake);

/* These take the lock, since another thread may be in a call. */
void v4l2_fake_set(struct v4l2_fake *fake, bool *member, bool value);
int v4l2_fake_get(struct v4l2_fake *fake, const int *member);

#endif
