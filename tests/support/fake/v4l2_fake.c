#include "tests/support/fake/v4l2_fake.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <linux/videodev2.h>

#include "tests/support/test.h"

enum {
	FAKE_FD = 0, /* a descriptor like any other */
	SIDE_MOST = 64
};

static int64_t machine_ms(void)
{
	struct timespec now;

	clock_gettime(CLOCK_MONOTONIC, &now);
	return (int64_t)now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

static int64_t clock_ms(const struct v4l2_fake *fake)
{
	return fake->real_time ? machine_ms() : fake->now_ms;
}

/* The caller does not hold the lock. */
static void pass_time(struct v4l2_fake *fake, int ms)
{
	struct timespec time = {
		.tv_sec = ms / 1000, .tv_nsec = (long)(ms % 1000) * 1000000};

	if (fake->real_time) {
		nanosleep(&time, NULL);
	} else {
		fake->now_ms += ms;
	}
}

static bool fake_exists(void *user, const char *path)
{
	(void)user;
	(void)path;
	return true;
}

static int fake_open(void *user, const char *path)
{
	struct v4l2_fake *fake = user;
	int result = FAKE_FD;

	pthread_mutex_lock(&fake->lock);
	strncpy(fake->path, path, sizeof(fake->path) - 1);
	fake->opens++;
	if (fake->open_error) {
		result = fake->open_error;
	} else if (fake->unplugged) {
		result = -ENOENT;
	} else {
		fake->used_wrongly = fake->used_wrongly || fake->open;
		fake->open = true;
	}
	pthread_mutex_unlock(&fake->lock);
	return result;
}

static void fake_close(void *user, int fd)
{
	struct v4l2_fake *fake = user;

	pthread_mutex_lock(&fake->lock);
	fake->used_wrongly = fake->used_wrongly || fd != FAKE_FD ||
		!fake->open || fake->maps != fake->unmaps;
	fake->open = fake->streaming = false;
	fake->queued = fake->buffer_count = 0;
	fake->closes++;
	pthread_mutex_unlock(&fake->lock);
}

static int query_capability(struct v4l2_capability *capability)
{
	strcpy((char *)capability->card, "Fake camera");
	strcpy((char *)capability->driver, "fake");
	capability->capabilities = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
	return 0;
}

static int list_format(const struct v4l2_fake *fake, struct v4l2_fmtdesc *offer)
{
	if (fake->vendor || offer->index >= V4L2_FAKE_FORMATS ||
		!fake->offered[offer->index]) {
		return -EINVAL;
	}
	offer->pixelformat = fake->offered[offer->index];
	return 0;
}

static bool offers(const struct v4l2_fake *fake, uint32_t fourcc)
{
	for (int i = 0; i < V4L2_FAKE_FORMATS && fake->offered[i]; i++) {
		if (fake->offered[i] == fourcc) {
			return true;
		}
	}
	return false;
}

static uint32_t side_of(
	const struct v4l2_fake *fake, uint32_t fourcc, uint32_t side)
{
	if ((fake->large_fourcc == 0 || fake->large_fourcc == fourcc) &&
		fake->large && side > fake->large_above) {
		return fake->large;
	}
	side = side > SIDE_MOST ? SIDE_MOST : side;
	return side < fake->side_least ? fake->side_least : side;
}

static int set_format(struct v4l2_fake *fake, struct v4l2_format *format)
{
	struct v4l2_pix_format *pix = &format->fmt.pix;
	uint32_t row;

	fake->dirty_priv = fake->dirty_priv || pix->priv != 0;
	if (fake->format_error &&
		(!fake->useless[0] || strcmp(fake->path, fake->useless) == 0)) {
		return fake->format_error;
	}
	if (!offers(fake, pix->pixelformat)) {
		if (fake->vendor) {
			return -EINVAL;
		}
		pix->pixelformat = fake->offered[0];
	}
	pix->width = side_of(fake, pix->pixelformat, pix->width);
	pix->height = side_of(fake, pix->pixelformat, pix->height);
	pix->width -= pix->width % (fake->vendor ? 8 : 2);
	pix->height -= pix->height % (fake->vendor ? 8 : 2);
	row = pix->pixelformat == V4L2_PIX_FMT_NV12 ||
			pix->pixelformat == V4L2_PIX_FMT_YUV420
		? pix->width
		: pix->width * 2;
	pix->bytesperline = row + (uint32_t)fake->stride_extra;
	pix->field =
		pix->field == V4L2_FIELD_NONE ? fake->field : fake->interlaced;
	pix->sizeimage = pix->bytesperline * pix->height;
	if (row == pix->width) {
		pix->sizeimage += pix->sizeimage / 2;
	}
	fake->fourcc = pix->pixelformat;
	fake->width = pix->width;
	fake->height = pix->height;
	fake->stride = pix->bytesperline;
	fake->size = pix->sizeimage;
	return 0;
}

static int request_buffers(
	struct v4l2_fake *fake, struct v4l2_requestbuffers *request)
{
	if (fake->vendor && request->count > (uint32_t)fake->buffers_most) {
		return -EINVAL;
	}
	if (request->count > (uint32_t)fake->buffers_most) {
		request->count = (uint32_t)fake->buffers_most;
	}
	fake->buffer_count = (int)request->count;
	return 0;
}

static int query_buffer(const struct v4l2_fake *fake, struct v4l2_buffer *buffer)
{
	if (buffer->index >= (uint32_t)fake->buffer_count) {
		return -EINVAL;
	}
	buffer->length = fake->size;
	buffer->m.offset = buffer->index << 12;
	return 0;
}

static int queue_buffer(struct v4l2_fake *fake, const struct v4l2_buffer *buffer)
{
	if (buffer->index >= (uint32_t)fake->buffer_count) {
		return -EINVAL;
	}
	for (int i = 0; i < fake->queued; i++) {
		if (fake->queue[i] == (int)buffer->index) {
			fake->used_wrongly = true;
			return -EINVAL;
		}
	}
	fake->queue[fake->queued++] = (int)buffer->index;
	fake->queues++;
	return 0;
}

static int stream_on(struct v4l2_fake *fake)
{
	if (fake->vendor && fake->queued < 2) {
		return -EINVAL;
	}
	fake->streaming = true;
	fake->next_due_ms = clock_ms(fake) + fake->period_ms;
	fake->starts++;
	return 0;
}

/* Adds the pictures that are due by the machine's clock. */
static void make_pictures(struct v4l2_fake *fake)
{
	while (fake->period_ms && clock_ms(fake) >= fake->next_due_ms) {
		fake->next_due_ms += fake->period_ms;
		/* A picture without a free buffer is lost. */
		if (fake->ready < fake->queued) {
			fake->ready++;
		} else {
			fake->next++;
		}
	}
}

static int take_picture(struct v4l2_fake *fake, struct v4l2_buffer *buffer)
{
	int index = fake->queue[0];

	fake->ready--;
	fake->queued--;
	memmove(fake->queue, fake->queue + 1,
		(size_t)fake->queued * sizeof(fake->queue[0]));
	memset(fake->memory[index], fake->next++ & 255, fake->size);
	buffer->index = (uint32_t)(fake->repeats ? 0 : index);
	buffer->flags = fake->damaged ? V4L2_BUF_FLAG_ERROR : 0;
	buffer->bytesused = fake->vendor ? 0
		: fake->short_of         ? fake->size - 1
		: fake->excess           ? 0x7fffffff
					 : fake->size;
	return 0;
}

/* The caller holds the lock, which is released while this waits. */
static int dequeue_buffer(struct v4l2_fake *fake, struct v4l2_buffer *buffer)
{
	int64_t until_ms = clock_ms(fake) + fake->block_ms;

	if (!fake->streaming) {
		return -EINVAL;
	}
	if (fake->dequeue_error) {
		return fake->dequeue_error;
	}
	for (;;) {
		make_pictures(fake);
		if (fake->ready > 0 && fake->queued > 0) {
			return take_picture(fake, buffer);
		}
		if (fake->unplugged) {
			return -ENODEV;
		}
		if (clock_ms(fake) >= until_ms) {
			return fake->block_ms ? -ETIME : -EAGAIN;
		}
		pthread_mutex_unlock(&fake->lock);
		pass_time(fake, fake->real_time ? 1 : fake->block_ms);
		pthread_mutex_lock(&fake->lock);
	}
}

static int answer(struct v4l2_fake *fake, unsigned long request, void *argument)
{
	switch (request) {
	case VIDIOC_QUERYCAP:
		return query_capability(argument);
	case VIDIOC_ENUM_FMT:
		return list_format(fake, argument);
	case VIDIOC_S_FMT:
		return set_format(fake, argument);
	case VIDIOC_REQBUFS:
		return request_buffers(fake, argument);
	case VIDIOC_QUERYBUF:
		return query_buffer(fake, argument);
	case VIDIOC_QBUF:
		return queue_buffer(fake, argument);
	case VIDIOC_DQBUF:
		return dequeue_buffer(fake, argument);
	case VIDIOC_STREAMON:
		return stream_on(fake);
	case VIDIOC_STREAMOFF:
		fake->streaming = false;
		fake->queued = 0;
		fake->stops++;
		return 0;
	default:
		return -EINVAL;
	}
}

static int fake_ioctl(void *user, int fd, unsigned long request, void *argument)
{
	struct v4l2_fake *fake = user;
	int result;

	pthread_mutex_lock(&fake->lock);
	fake->used_wrongly = fake->used_wrongly || fd != FAKE_FD || !fake->open;
	result = fake->unplugged ? -ENODEV : answer(fake, request, argument);
	pthread_mutex_unlock(&fake->lock);
	return result;
}

static void *fake_map(void *user, int fd, size_t length, uint32_t offset)
{
	struct v4l2_fake *fake = user;
	uint32_t index = offset >> 12;
	void *address = NULL;

	pthread_mutex_lock(&fake->lock);
	if (fd == FAKE_FD && index < V4L2_FAKE_BUFFERS && length == fake->size) {
		fake->maps++;
		/* A block of its own, so that the sanitizers see its end. */
		address = fake->memory[index] = calloc(1, length);
	}
	pthread_mutex_unlock(&fake->lock);
	return address;
}

static void fake_unmap(void *user, void *address, size_t length)
{
	struct v4l2_fake *fake = user;

	(void)length;
	pthread_mutex_lock(&fake->lock);
	fake->unmaps++;
	free(address);
	pthread_mutex_unlock(&fake->lock);
}

static int fake_wait(void *user, int fd, int timeout_ms)
{
	struct v4l2_fake *fake = user;
	int64_t until_ms = clock_ms(fake) + timeout_ms;
	bool readable;

	(void)fd;
	for (;;) {
		pthread_mutex_lock(&fake->lock);
		make_pictures(fake);
		readable = fake->vendor || fake->unplugged ||
			fake->dequeue_error || fake->ready > 0;
		pthread_mutex_unlock(&fake->lock);
		if (readable || clock_ms(fake) >= until_ms) {
			return readable;
		}
		pass_time(fake, fake->real_time ? 1 : timeout_ms);
	}
}

static int64_t fake_now_ms(void *user)
{
	return clock_ms(user);
}

struct v4l2_fake *v4l2_fake_new(void)
{
	struct v4l2_fake *fake = calloc(1, sizeof(*fake));

	if (!fake) {
		abort();
	}
	fake->calls = (struct v4l2_calls){
		.exists = fake_exists,
		.open = fake_open,
		.close = fake_close,
		.ioctl = fake_ioctl,
		.map = fake_map,
		.unmap = fake_unmap,
		.wait = fake_wait,
		.now_ms = fake_now_ms,
		.user = fake,
	};
	pthread_mutex_init(&fake->lock, NULL);
	fake->offered[0] = V4L2_PIX_FMT_YUYV;
	fake->field = V4L2_FIELD_NONE;
	fake->interlaced = V4L2_FIELD_INTERLACED;
	fake->buffers_most = 4;
	return fake;
}

void v4l2_fake_free(struct v4l2_fake *fake)
{
	pthread_mutex_destroy(&fake->lock);
	free(fake);
}

void v4l2_fake_end(struct v4l2_fake *fake)
{
	assert_false(fake->open);
	assert_false(fake->used_wrongly);
	assert_false(fake->dirty_priv);
	assert_int_equal(fake->maps, fake->unmaps);
	v4l2_fake_free(fake);
}

void v4l2_fake_set(struct v4l2_fake *fake, bool *member, bool value)
{
	pthread_mutex_lock(&fake->lock);
	*member = value;
	pthread_mutex_unlock(&fake->lock);
}

int v4l2_fake_get(struct v4l2_fake *fake, const int *member)
{
	int value;

	pthread_mutex_lock(&fake->lock);
	value = *member;
	pthread_mutex_unlock(&fake->lock);
	return value;
}
