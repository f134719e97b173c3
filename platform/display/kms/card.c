#include "platform/display/kms/card.h"

#include <drm_fourcc.h>
#include <errno.h>
#include <string.h>
#include <sys/mman.h>

#include "platform/base/compiler.h"
#include "platform/display/kms/card_find.h"
#include "platform/display/pixels.h"

enum {
	/* Longer than a refresh of any screen. */
	FLIP_TIMEOUT_MS = 1000,
	MISSED_MAX = 100 /* pictures in a row, of up to a second each */
};

/* In the order of preference. */
static const struct card_format {
	enum pixel_format format;
	uint32_t fourcc;
	struct pixel_layout layout;
} card_formats[] = {
	{PIXELS_RGB565, DRM_FORMAT_RGB565,
		{.bits = 16, .red = {11, 5}, .green = {5, 6}, .blue = {0, 5}}},
	{PIXELS_RGBA8888, DRM_FORMAT_XBGR8888,
		{.bits = 32, .red = {0, 8}, .green = {8, 8}, .blue = {16, 8}}},
	{PIXELS_RGBA8888, DRM_FORMAT_XRGB8888,
		{.bits = 32, .red = {16, 8}, .green = {8, 8}, .blue = {0, 8}}},
};

static int failed(const struct card *card, const char *what)
{
	int error = errno ? errno : EIO;

	log_error(&card->log,
		"--display kms: %s: %s: %s: name another with --display kms:/dev/dri/cardN, or choose another --display",
		card->path, what, strerror(error));
	return -error;
}

static void release_buffer(const struct card *card, struct card_buffer *buffer)
{
	const struct kms_calls *calls = card->calls;

	if (buffer->fb) {
		calls->remove_fb(card->fd, buffer->fb);
	}
	if (buffer->map) {
		calls->device->unmap(buffer->map, (size_t)buffer->size_bytes);
	}
	if (buffer->handle) {
		calls->destroy_dumb(card->fd, buffer->handle);
	}
	*buffer = (struct card_buffer){0};
}

static bool map_buffer(const struct card *card, struct card_buffer *buffer)
{
	const struct kms_calls *calls = card->calls;
	uint64_t offset = 0;
	void *map;

	if (buffer->size_bytes > SIZE_MAX ||
		calls->map_dumb(card->fd, buffer->handle, &offset) != 0) {
		return false;
	}
	map = calls->device->map(
		card->fd, (size_t)buffer->size_bytes, (off_t)offset);
	if (map == MAP_FAILED) {
		return false;
	}
	buffer->map = map;
	memset(map, 0, (size_t)buffer->size_bytes);
	return true;
}

static bool make_buffer(const struct card *card, struct card_buffer *buffer,
	const struct card_format *format)
{
	const struct kms_calls *calls = card->calls;
	uint32_t width = card->mode.hdisplay, height = card->mode.vdisplay;
	uint32_t handles[4] = {0}, pitches[4] = {0}, offsets[4] = {0};
	bool made;

	if (calls->create_dumb(card->fd, width, height,
		    (uint32_t)format->layout.bits, 0, &buffer->handle,
		    &buffer->pitch_bytes, &buffer->size_bytes) != 0) {
		buffer->handle = 0;
		return false;
	}
	if (buffer->size_bytes < (uint64_t)buffer->pitch_bytes * height ||
		buffer->pitch_bytes > INT32_MAX / PIXELS_SIZE_MAX) {
		release_buffer(card, buffer);
		errno = EINVAL;
		return false;
	}
	handles[0] = buffer->handle;
	pitches[0] = buffer->pitch_bytes;
	made = calls->add_fb(card->fd, width, height, format->fourcc, handles,
		       pitches, offsets, &buffer->fb, 0) == 0;
	if (!made) {
		buffer->fb = 0;
	}
	made = made && map_buffer(card, buffer);
	if (!made) {
		int error = errno;

		release_buffer(card, buffer);
		errno = error;
	}
	return made;
}

static bool wants_narrow(
	const struct card *card, const struct display_options *options)
{
	uint64_t depth = 0;

	if (options->format_given) {
		return options->format == PIXELS_RGB565;
	}
	return card->calls->get_cap(
		       card->fd, DRM_CAP_DUMB_PREFERRED_DEPTH, &depth) == 0 &&
		depth == 16;
}

static int set_mode(struct card *card, uint32_t fb)
{
	return card->calls->set_crtc(card->fd, card->crtc, fb, 0, 0,
		&card->connector, 1, &card->mode);
}

/*
 * Makes the first buffer in a format and shows it. Only setting the mode tells
 * whether the screen supports the format: on some cards add_fb() accepts
 * formats that only the cursor supports.
 */
static bool show_black(struct card *card, const struct card_format *format)
{
	struct card_buffer *first = &card->buffers[0];
	int error;

	if (!make_buffer(card, first, format)) {
		return false;
	}
	if (set_mode(card, first->fb) == 0) {
		return true;
	}
	error = errno;
	release_buffer(card, first);
	errno = error;
	return false;
}

/*
 * Chooses the first format that the screen supports, preferring those of the
 * wanted width, and makes the buffers.
 */
static int make_buffers(struct card *card, const struct display_options *options)
{
	bool narrow = wants_narrow(card, options);
	int count = (int)ARRAY_COUNT(card_formats);

	for (int i = 0; i < 2 * count; i++) {
		const struct card_format *format = &card_formats[i % count];
		bool wanted = (format->format == PIXELS_RGB565) == narrow;

		if (wanted != (i < count) || !show_black(card, format)) {
			continue;
		}
		card->layout = format->layout;
		card->format = format->format;
		/* Without memory for a second buffer, one is used. */
		if (!make_buffer(card, &card->buffers[1], format)) {
			card->method = CARD_ONE_BUFFER;
		}
		return 0;
	}
	return failed(card, "it provides no buffer that limber can draw into");
}

static void finish_flip(int fd, unsigned int sequence, unsigned int seconds,
	unsigned int microseconds, void *user)
{
	bool *pending = user;

	(void)fd;
	(void)sequence;
	(void)seconds;
	(void)microseconds;
	*pending = false;
}

/* Waits for the page flip. Returns false, with errno set, if it fails. */
static bool wait_for_flip(struct card *card)
{
	drmEventContext context = {
		.version = 2,
		.page_flip_handler = finish_flip,
	};
	bool flips = card->pending;

	while (card->pending) {
		int ready = card->calls->wait(card->fd, FLIP_TIMEOUT_MS);

		if (ready < 0 && errno == EINTR) {
			continue;
		}
		if (ready == 0) {
			errno = ETIMEDOUT;
		}
		if (ready <= 0 ||
			card->calls->handle_event(card->fd, &context) != 0) {
			card->pending = false;
			return false;
		}
	}
	card->missed = flips ? 0 : card->missed;
	return true;
}

/*
 * Whether a picture may be left out after an error, in errno, that may pass: a
 * screen is off for a moment or was unplugged, and the kernel unbinds what it
 * showed.
 */
static bool may_miss(struct card *card)
{
	return (errno == ETIMEDOUT || errno == EBUSY || errno == EAGAIN) &&
		++card->missed < MISSED_MAX;
}

int card_wait(struct card *card)
{
	return wait_for_flip(card) || may_miss(card)
		? 0
		: failed(card, "the page flip does not complete");
}

static bool flip(struct card *card)
{
	card->pending = true;
	if (card->calls->page_flip(card->fd, card->crtc,
		    card->buffers[!card->shown].fb, DRM_MODE_PAGE_FLIP_EVENT,
		    &card->pending) != 0) {
		card->pending = false;
		return false;
	}
	card->shown = !card->shown;
	return true;
}

static bool set_mode_again(struct card *card)
{
	if (set_mode(card, card->buffers[!card->shown].fb) != 0) {
		return false;
	}
	card->shown = !card->shown;
	return true;
}

/* Tries the methods while the buffers are black, before the first picture. */
static void choose_method(struct card *card)
{
	if (card->method == CARD_ONE_BUFFER) {
		return;
	}
	card->method = CARD_PAGE_FLIP;
	if (flip(card) && wait_for_flip(card)) {
		return;
	}
	card->method = set_mode_again(card) ? CARD_MODE_SET : CARD_ONE_BUFFER;
}

int card_open(struct card *card, const struct kms_calls *calls,
	const struct display_options *options)
{
	int error;

	*card = (struct card){.calls = calls, .log = *options->log};
	error = card_find(card, options);
	if (error) {
		return error;
	}
	card->before = calls->get_crtc(card->fd, card->crtc);
	error = make_buffers(card, options);
	if (error) {
		goto out_before;
	}
	choose_method(card);
	return 0;
out_before:
	if (card->before) {
		calls->free_crtc(card->before);
	}
	calls->device->close(card->fd);
	return error;
}

const struct card_buffer *card_back(const struct card *card)
{
	return &card->buffers[card->method == CARD_ONE_BUFFER ? card->shown
							      : !card->shown];
}

/* Where a flip fails for a moment, setting the mode binds the picture again. */
static int show_without_flip(struct card *card)
{
	int error = errno;

	if (error == EBUSY && set_mode_again(card)) {
		return 0;
	}
	errno = error;
	return may_miss(card) ? 0 : failed(card, "it cannot flip to a picture");
}

int card_show(struct card *card)
{
	switch (card->method) {
	case CARD_PAGE_FLIP:
		return flip(card) ? 0 : show_without_flip(card);
	case CARD_MODE_SET:
		if (set_mode_again(card)) {
			card->missed = 0;
			return 0;
		}
		return may_miss(card) ? 0
				      : failed(card, "it cannot show a picture");
	case CARD_ONE_BUFFER:
		/* Tells cards that copy the buffer to do so; others refuse. */
		(void)card->calls->dirty_fb(
			card->fd, card->buffers[card->shown].fb, NULL, 0);
		return 0;
	}
	return -EINVAL;
}

static void restore(struct card *card)
{
	drmModeCrtcPtr before = card->before;

	if (!before) {
		return;
	}
	if (before->mode_valid && before->buffer_id && card->before_count > 0) {
		(void)card->calls->set_crtc(card->fd, before->crtc_id,
			before->buffer_id, before->x, before->y,
			card->before_connectors, card->before_count,
			&before->mode);
	}
	card->calls->free_crtc(before);
}

int card_leave(struct card *card)
{
	/* A flip that fails must not keep the user from leaving. */
	(void)wait_for_flip(card);
	return card->calls->drop_master(card->fd) == 0 ? 0
		: errno                                ? -errno
						       : -EIO;
}

int card_return(struct card *card)
{
	if (!card->calls->is_master(card->fd) &&
		card->calls->set_master(card->fd) != 0) {
		return -EBUSY;
	}
	return set_mode(card, card->buffers[card->shown].fb) == 0
		? 0
		: failed(card, "it cannot show pictures again");
}

void card_close(struct card *card)
{
	(void)wait_for_flip(card);
	restore(card);
	release_buffer(card, &card->buffers[1]);
	release_buffer(card, &card->buffers[0]);
	card->calls->device->close(card->fd);
}
