#include "tests/support/fake/fake_card.h"

#include <drm_fourcc.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include "tests/support/fake/fake_fb.h"
#include "tests/support/test.h"

enum {
	CARD_FD = 0, /* a descriptor like any other */
	SECOND_FD = 1,
	ENCODER = 41,
	CRTC = 51,
	OTHER_CRTC = 52,
	FB_BEFORE = 77,
	EXTRA_PITCH = 8
};

struct fake_card fake_card;

static bool fails(enum fake_card_call call)
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
		return fake_card.second_error ? -1 : SECOND_FD;
	}
	if (strcmp(path, own) != 0 || fake_card.open_error) {
		errno = fake_card.open_error ? fake_card.open_error : ENOENT;
		return -1;
	}
	fake_card.open_count++;
	return CARD_FD;
}

static int card_close_file(int fd)
{
	if (fd != CARD_FD && fd != SECOND_FD) {
		return fake_fb_calls.close(fd);
	}
	fake_card.open_count--;
	return 0;
}

static int card_control(int fd, unsigned long request, void *argument)
{
	assert_int_not_equal(fd, CARD_FD);
	return fake_fb_calls.ioctl(fd, request, argument);
}

static void *card_map(int fd, size_t size, off_t offset)
{
	assert_true(fd == CARD_FD || fd == SECOND_FD);
	assert_in_range(offset / 4096, 1, 2);
	assert_true(size <= FAKE_CARD_BUFFER_BYTES);
	if (fails(CALL_MAP)) {
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
	assert_true(fd == CARD_FD || fd == SECOND_FD);
	switch (cap) {
	case DRM_CAP_DUMB_BUFFER:
		*value = !fake_card.no_dumb;
		return 0;
	case DRM_CAP_DUMB_PREFERRED_DEPTH:
		*value = fake_card.preferred_depth;
		return 0;
	case DRM_CAP_DUMB_PREFER_SHADOW:
		*value = fake_card.prefers_shadow;
		return 0;
	default:
		errno = EINVAL;
		return -EINVAL;
	}
}

static int is_master(int fd)
{
	return fd == CARD_FD ? !fake_card.not_master : !fake_card.second_in_use;
}

static int set_master(int fd)
{
	assert_int_equal(fd, CARD_FD);
	errno = EBUSY;
	fake_card.not_master = fake_card.held;
	return fake_card.held ? -1 : 0;
}

static int drop_master(int fd)
{
	assert_int_equal(fd, CARD_FD);
	assert_null(fake_card.flip_user);
	if (fails(CALL_DROP)) {
		errno = fake_card.fail_error;
		return -1;
	}
	fake_card.not_master = true;
	return 0;
}

static void *hand_out(size_t size)
{
	fake_card.resource_count++;
	return calloc(1, size);
}

static drmModeResPtr get_resources(int fd)
{
	static uint32_t crtcs[] = {OTHER_CRTC, CRTC};
	static uint32_t connectors[] = {
		FAKE_CARD_OTHER_CONNECTOR, FAKE_CARD_CONNECTOR};
	drmModeResPtr resources;

	if ((fd == SECOND_FD && fake_card.second_drives_none) ||
		fails(CALL_RESOURCES)) {
		return NULL;
	}
	resources = hand_out(sizeof(*resources));
	resources->count_crtcs = 2;
	resources->crtcs = crtcs;
	resources->count_connectors = fake_card.two_connectors ? 2 : 1;
	resources->connectors = connectors + !fake_card.two_connectors;
	return resources;
}

static void free_resources(drmModeResPtr resources)
{
	fake_card.resource_count--;
	free(resources);
}

/* The state of a connector after the card was asked. */
static drmModeConnection state_of(int fd, uint32_t id)
{
	if (fd == SECOND_FD) {
		return fake_card.second_unsure ? DRM_MODE_UNKNOWNCONNECTION
					       : DRM_MODE_CONNECTED;
	}
	if (id == FAKE_CARD_OTHER_CONNECTOR) {
		return fake_card.other_state;
	}
	return fake_card.unsure           ? DRM_MODE_UNKNOWNCONNECTION
		: fake_card.not_connected ? DRM_MODE_DISCONNECTED
					  : DRM_MODE_CONNECTED;
}

static drmModeConnectorPtr probe_connector(int fd, uint32_t id)
{
	static uint32_t encoders[FAKE_CARD_ENCODERS] = {
		ENCODER, ENCODER + 1, ENCODER + 2};
	drmModeConnectorPtr connector;

	int encoder = id == FAKE_CARD_CONNECTOR ? fake_card.connected_encoder
						: fake_card.other_encoder;

	fake_card.probe_count++;
	assert_true(id == FAKE_CARD_CONNECTOR ||
		(id == FAKE_CARD_OTHER_CONNECTOR && fake_card.two_connectors));
	if (fails(CALL_CONNECTOR)) {
		return NULL;
	}
	connector = hand_out(sizeof(*connector));
	connector->connector_id = id;
	connector->encoder_id = encoder < 0 ? 0 : ENCODER + (uint32_t)encoder;
	connector->connection = state_of(fd, id);
	connector->count_modes = fake_card.mode_count;
	connector->modes = fake_card.modes;
	connector->count_encoders = fake_card.encoder_count;
	connector->encoders = encoders;
	return connector;
}

static drmModeConnectorPtr get_connector(int fd, uint32_t id)
{
	drmModeConnectorPtr connector = probe_connector(fd, id);

	fake_card.probe_count--;
	if (connector && fake_card.must_ask) {
		connector->connection = DRM_MODE_UNKNOWNCONNECTION;
		connector->count_modes = 0;
	}
	return connector;
}

static void free_connector(drmModeConnectorPtr connector)
{
	fake_card.resource_count--;
	free(connector);
}

static drmModeEncoderPtr get_encoder(int fd, uint32_t id)
{
	drmModeEncoderPtr encoder;

	(void)fd;
	assert_in_range(id, ENCODER, ENCODER + FAKE_CARD_ENCODERS - 1);
	if (fails(CALL_ENCODER)) {
		return NULL;
	}
	encoder = hand_out(sizeof(*encoder));
	encoder->encoder_id = id;
	encoder->crtc_id = fake_card.encoders[id - ENCODER].crtc;
	encoder->possible_crtcs = fake_card.encoders[id - ENCODER].possible;
	return encoder;
}

static void free_encoder(drmModeEncoderPtr encoder)
{
	fake_card.resource_count--;
	free(encoder);
}

static drmModeCrtcPtr get_crtc(int fd, uint32_t id)
{
	drmModeCrtcPtr crtc;

	(void)fd;
	if (fails(CALL_GET_CRTC)) {
		return NULL;
	}
	crtc = hand_out(sizeof(*crtc));
	crtc->crtc_id = id;
	crtc->buffer_id = FB_BEFORE;
	crtc->mode_valid = 1;
	crtc->mode = fake_card.modes[2];
	return crtc;
}

static void free_crtc(drmModeCrtcPtr crtc)
{
	fake_card.resource_count--;
	free(crtc);
}

static int set_crtc(int fd, uint32_t crtc, uint32_t fb, uint32_t x, uint32_t y,
	uint32_t *connectors, int count, drmModeModeInfoPtr mode)
{
	(void)fd;
	assert_int_equal(x + y, 0);
	assert_in_range(count, 1, 2);
	assert_null(fake_card.flip_user);
	if (fake_card.not_master) {
		errno = EACCES;
		return -EACCES;
	}
	if (fails(CALL_SET)) {
		return -fake_card.fail_error;
	}
	assert_true(fb == FB_BEFORE || fake_card.buffers[fb - 1].added);
	fake_card.set_count++;
	fake_card.shown_fb = fb;
	fake_card.shown_mode = *mode;
	fake_card.shown_crtc = crtc;
	memcpy(fake_card.shown_connectors, connectors,
		(size_t)count * sizeof(*connectors));
	fake_card.shown_count = count;
	return 0;
}

static int create_dumb(int fd, uint32_t width, uint32_t height, uint32_t bits,
	uint32_t flags, uint32_t *handle, uint32_t *pitch, uint64_t *size)
{
	int i = fake_card.buffers[0].used;

	(void)fd;
	assert_int_equal(flags, 0);
	if (fails(CALL_CREATE)) {
		return -fake_card.fail_error;
	}
	assert_false(fake_card.buffers[i].used);
	fake_card.buffers[i].used = true;
	fake_card.buffers[i].pitch = width * bits / 8 + EXTRA_PITCH;
	*handle = (uint32_t)i + 1;
	*pitch = fake_card.buffers[i].pitch;
	*size = (uint64_t)*pitch * height;
	return 0;
}

static int map_dumb(int fd, uint32_t handle, uint64_t *offset)
{
	(void)fd;
	if (fails(CALL_MAP_DUMB)) {
		return -fake_card.fail_error;
	}
	*offset = handle * 4096;
	return 0;
}

static int destroy_dumb(int fd, uint32_t handle)
{
	(void)fd;
	assert_true(fake_card.buffers[handle - 1].used);
	fake_card.buffers[handle - 1].used = false;
	return 0;
}

static int add_fb(int fd, uint32_t width, uint32_t height, uint32_t fourcc,
	const uint32_t handles[4], const uint32_t pitches[4],
	const uint32_t offsets[4], uint32_t *id, uint32_t flags)
{
	(void)fd;
	assert_int_equal(flags + offsets[0] + handles[1], 0);
	assert_true(pitches[0] >= width && height > 0);
	if (fails(CALL_ADD)) {
		return -fake_card.fail_error;
	}
	for (int i = 0; i < 3; i++) {
		if (fake_card.fourccs[i] == fourcc) {
			fake_card.buffers[handles[0] - 1].added = true;
			fake_card.buffers[handles[0] - 1].fourcc = fourcc;
			*id = handles[0];
			return 0;
		}
	}
	errno = EINVAL;
	return -EINVAL;
}

static int remove_fb(int fd, uint32_t id)
{
	(void)fd;
	assert_true(fake_card.buffers[id - 1].added);
	assert_int_not_equal(fake_card.flip_fb, id);
	fake_card.buffers[id - 1].added = false;
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
	if (fails(CALL_FLIP)) {
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
	if (fails(CALL_WAIT)) {
		errno = EINTR; /* of an earlier call: a timeout leaves errno */
		return 0;
	}
	return 1;
}

static int handle_event(int fd, drmEventContextPtr context)
{
	void *user = fake_card.flip_user;

	if (fails(CALL_EVENT)) {
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
	.get_resources = get_resources,
	.free_resources = free_resources,
	.get_connector = get_connector,
	.probe_connector = probe_connector,
	.free_connector = free_connector,
	.get_encoder = get_encoder,
	.free_encoder = free_encoder,
	.get_crtc = get_crtc,
	.free_crtc = free_crtc,
	.set_crtc = set_crtc,
	.create_dumb = create_dumb,
	.map_dumb = map_dumb,
	.destroy_dumb = destroy_dumb,
	.add_fb = add_fb,
	.remove_fb = remove_fb,
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
	fake_card.encoders[0].crtc = CRTC;
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
