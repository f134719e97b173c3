#include "tests/support/fake/fake_card_parts.h"

#include <drm_fourcc.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>

#include "tests/support/fake/fake_fb.h"
#include "tests/support/test.h"

struct fake_card fake_card;

bool fake_card_fails(enum fake_card_call call)
{
	if (fake_card.fail != call || fake_card.calls++ < fake_card.fail_from) {
		return false;
	}
	if (fake_card.fail_once) {
		fake_card.fail = CALL_NONE;
	}
	errno = fake_card.fail_error;
	return true;
}

static int card_open_file(const char *path, int flags)
{
	char own[32], second[32];

	snprintf(own, sizeof(own), "/dev/dri/card%d", fake_card.number);
	snprintf(second, sizeof(second), "/dev/dri/card%d",
		fake_card.second_number);
	if (strncmp(path, "/dev/dri/", 9) != 0) {
		return fake_fb_calls.open(path, flags);
	}
	if (strcmp(path, second) == 0) {
		errno = fake_card.second_error;
		fake_card.open_count += !fake_card.second_error;
		return fake_card.second_error ? -1 : FAKE_CARD_SECOND_FD;
	}
	if (strcmp(path, own) != 0 || fake_card.open_error) {
		errno = fake_card.open_error ? fake_card.open_error : ENOENT;
		return -1;
	}
	fake_card.open_count++;
	return FAKE_CARD_FD;
}

static int card_close_file(int fd)
{
	if (fd != FAKE_CARD_FD && fd != FAKE_CARD_SECOND_FD) {
		return fake_fb_calls.close(fd);
	}
	fake_card.open_count--;
	return 0;
}

static int card_control(int fd, unsigned long request, void *argument)
{
	assert_int_not_equal(fd, FAKE_CARD_FD);
	return fake_fb_calls.ioctl(fd, request, argument);
}

static void *card_map(int fd, size_t size, off_t offset)
{
	assert_true(fd == FAKE_CARD_FD || fd == FAKE_CARD_SECOND_FD);
	assert_in_range(offset / 4096, 1, 2);
	assert_true(size <= FAKE_CARD_BUFFER_BYTES);
	if (fake_card_fails(CALL_MAP)) {
		return MAP_FAILED;
	}
	fake_card.map_count++;
	return fake_card.buffers[offset / 4096 - 1].memory;
}

static int card_unmap(void *address, size_t size)
{
	(void)address;
	(void)size;
	fake_card.map_count--;
	return 0;
}

static const struct device_calls device = {
	.open = card_open_file,
	.close = card_close_file,
	.ioctl = card_control,
	.map = card_map,
	.unmap = card_unmap,
};

static int get_cap(int fd, uint64_t cap, uint64_t *value)
{
	assert_true(fd == FAKE_CARD_FD || fd == FAKE_CARD_SECOND_FD);
	switch (cap) {
	case DRM_CAP_DUMB_BUFFER:
		*value = !fake_card.no_dumb;
		return 0;
	case DRM_CAP_DUMB_PREFERRED_DEPTH:
		*value = fake_card.preferred_depth;
		return 0;
	default:
		errno = EINVAL;
		return -EINVAL;
	}
}

static int is_master(int fd)
{
	return fd == FAKE_CARD_FD ? !fake_card.not_master
				  : !fake_card.second_in_use;
}

static int set_master(int fd)
{
	assert_int_equal(fd, FAKE_CARD_FD);
	errno = EBUSY;
	fake_card.not_master = fake_card.held;
	return fake_card.held ? -1 : 0;
}

static int drop_master(int fd)
{
	assert_int_equal(fd, FAKE_CARD_FD);
	assert_null(fake_card.flip_user);
	if (fake_card_fails(CALL_DROP)) {
		errno = fake_card.fail_error;
		return -1;
	}
	fake_card.not_master = true;
	return 0;
}

static int page_flip(
	int fd, uint32_t crtc, uint32_t fb, uint32_t flags, void *user)
{
	(void)fd;
	assert_int_equal(crtc, fake_card.shown_crtc);
	assert_int_equal(flags, DRM_MODE_PAGE_FLIP_EVENT);
	assert_true(fake_card.buffers[fb - 1].added);
	assert_null(fake_card.flip_user);
	if (fake_card_fails(CALL_FLIP)) {
		return -fake_card.fail_error;
	}
	fake_card.flip_count++;
	fake_card.flip_user = user;
	fake_card.flip_fb = fb;
	return 0;
}

static int dirty_fb(int fd, uint32_t id, drmModeClipPtr clips, uint32_t count)
{
	(void)fd;
	(void)clips;
	assert_int_equal(count, 0);
	assert_int_equal(id, fake_card.shown_fb);
	fake_card.dirty_count++;
	errno = ENOSYS;
	return -ENOSYS;
}

static int wait_for_event(int fd, int timeout_ms)
{
	(void)fd;
	assert_true(timeout_ms > 0);
	fake_card.wait_count++;
	/* The first wait is interrupted by a signal. */
	if (fake_card.wait_count == 1) {
		errno = EINTR;
		return -1;
	}
	if (fake_card_fails(CALL_WAIT)) {
		/* The card has lost the flip. */
		fake_card.flip_user = NULL;
		fake_card.flip_fb = 0;
		errno = EINTR; /* of an earlier call: a timeout leaves errno */
		return 0;
	}
	return 1;
}

static int handle_event(int fd, drmEventContextPtr context)
{
	void *user = fake_card.flip_user;

	if (fake_card_fails(CALL_EVENT)) {
		return -1;
	}
	assert_non_null(user);
	fake_card.flip_user = NULL;
	fake_card.shown_fb = fake_card.flip_fb;
	fake_card.flip_fb = 0;
	context->page_flip_handler(fd, 0, 0, 0, user);
	return 0;
}

const struct kms_calls fake_card_calls = {
	.device = &device,
	.get_cap = get_cap,
	.is_master = is_master,
	.set_master = set_master,
	.drop_master = drop_master,
	.get_resources = fake_card_get_resources,
	.free_resources = fake_card_free_resources,
	.get_connector = fake_card_get_connector,
	.probe_connector = fake_card_probe_connector,
	.free_connector = fake_card_free_connector,
	.get_encoder = fake_card_get_encoder,
	.free_encoder = fake_card_free_encoder,
	.get_crtc = fake_card_get_crtc,
	.free_crtc = fake_card_free_crtc,
	.set_crtc = fake_card_set_crtc,
	.create_dumb = fake_card_create_dumb,
	.map_dumb = fake_card_map_dumb,
	.destroy_dumb = fake_card_destroy_dumb,
	.add_fb = fake_card_add_fb,
	.remove_fb = fake_card_remove_fb,
	.page_flip = page_flip,
	.dirty_fb = dirty_fb,
	.wait = wait_for_event,
	.handle_event = handle_event,
};

void fake_card_begin(void)
{
	memset(&fake_card, 0, sizeof(fake_card));
	fake_card.second_number = -1;
	fake_card.other_state = DRM_MODE_UNKNOWNCONNECTION;
	fake_card.other_encoder = -1;
	fake_card.fourccs[0] = DRM_FORMAT_XRGB8888;
	fake_card.fourccs[1] = DRM_FORMAT_RGB565;
	fake_card.fourccs[2] = DRM_FORMAT_XBGR8888;
	fake_card.encoder_count = 1;
	fake_card.encoders[0].crtc = FAKE_CARD_CRTC;
	fake_card.encoders[0].possible = 2; /* the second CRTC only */
	fake_card.modes[0] = (drmModeModeInfo){
		.hdisplay = 24, .vdisplay = 14, .vrefresh = 60};
	fake_card.modes[1] = (drmModeModeInfo){.hdisplay = 20,
		.vdisplay = 12,
		.vrefresh = 50,
		.type = DRM_MODE_TYPE_PREFERRED};
	fake_card.modes[2] = (drmModeModeInfo){
		.hdisplay = 10, .vdisplay = 8, .vrefresh = 75};
	fake_card.mode_count = FAKE_CARD_MODES;
	fake_card.fail_error = EINVAL;
	for (int i = 0; i < 2; i++) {
		memset(fake_card.buffers[i].memory, 0xEE,
			FAKE_CARD_BUFFER_BYTES);
	}
}

uint32_t fake_card_seen(int x, int y)
{
	uint32_t fb = fake_card.shown_fb - 1;
	uint32_t pixel = 0;
	size_t bytes = 4;

	assert_in_range(fb, 0, 1);
	if (fake_card.buffers[fb].fourcc == DRM_FORMAT_RGB565) {
		bytes = 2;
	}
	memcpy(&pixel,
		fake_card.buffers[fb].memory +
			(size_t)y * fake_card.buffers[fb].pitch +
			(size_t)x * bytes,
		bytes);
	return pixel;
}
