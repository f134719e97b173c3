#include "tests/fuzz/fuzz_device_calls.h"

#include <errno.h>
#include <stddef.h>

/* What page_flip() passed for the event. */
static void *flip_user;

/* Up to three numbers below four. */
static uint32_t *numbers(int *count)
{
	uint32_t *list;

	*count = (int)(fuzz_device_byte() % 4);
	list = fuzz_device_object(((size_t)*count + 1) * sizeof(*list));
	for (int i = 0; i < *count; i++) {
		list[i] = fuzz_device_byte() % 4;
	}
	return list;
}

static int kms_get_cap(int fd, uint64_t cap, uint64_t *value)
{
	(void)fd;
	*value = cap == DRM_CAP_DUMB_BUFFER ? 1 : fuzz_device_byte();
	return fuzz_device_failing();
}

static int kms_is_master(int fd)
{
	(void)fd;
	return fuzz_device_byte() % 4 != 3;
}

static drmModeResPtr kms_get_resources(int fd)
{
	drmModeResPtr resources;

	(void)fd;
	flip_user = NULL;
	if (fuzz_device_failing()) {
		return NULL;
	}
	resources = fuzz_device_object(sizeof(*resources));
	resources->crtcs = numbers(&resources->count_crtcs);
	resources->connectors = numbers(&resources->count_connectors);
	resources->max_width = resources->max_height = fuzz_device_word();
	return resources;
}

static void kms_free_resources(drmModeResPtr resources)
{
	if (resources) {
		fuzz_device_release(resources->crtcs);
		fuzz_device_release(resources->connectors);
		fuzz_device_release(resources);
	}
}

static drmModeConnectorPtr kms_get_connector(int fd, uint32_t id)
{
	drmModeConnectorPtr connector;

	(void)fd;
	if (fuzz_device_failing()) {
		return NULL;
	}
	connector = fuzz_device_object(sizeof(*connector));
	connector->connector_id = id;
	connector->encoder_id = fuzz_device_byte() % 4;
	connector->connector_type = fuzz_device_byte();
	connector->connection = fuzz_device_byte() % 4 == 3
		? DRM_MODE_DISCONNECTED
		: DRM_MODE_CONNECTED;
	connector->encoders = numbers(&connector->count_encoders);
	connector->count_modes = (int)(fuzz_device_byte() % 3);
	connector->modes = fuzz_device_object(
		((size_t)connector->count_modes + 1) * sizeof(drmModeModeInfo));
	for (int i = 0; i < connector->count_modes; i++) {
		drmModeModeInfoPtr mode = &connector->modes[i];

		mode->hdisplay = (uint16_t)(16 + fuzz_device_byte());
		mode->vdisplay = (uint16_t)(16 + fuzz_device_byte());
		mode->vrefresh = 60;
		fuzz_device_spoil(mode, offsetof(drmModeModeInfo, name));
	}
	return connector;
}

static void kms_free_connector(drmModeConnectorPtr connector)
{
	if (connector) {
		fuzz_device_release(connector->encoders);
		fuzz_device_release(connector->modes);
		fuzz_device_release(connector);
	}
}

static drmModeEncoderPtr kms_get_encoder(int fd, uint32_t id)
{
	drmModeEncoderPtr encoder = fuzz_device_failing()
		? NULL
		: fuzz_device_object(sizeof(*encoder));

	(void)fd;
	if (encoder) {
		encoder->encoder_id = id;
		encoder->crtc_id = fuzz_device_byte() % 4;
		encoder->possible_crtcs = fuzz_device_word();
	}
	return encoder;
}

static void kms_free_encoder(drmModeEncoderPtr encoder)
{
	fuzz_device_release(encoder);
}

static drmModeCrtcPtr kms_get_crtc(int fd, uint32_t id)
{
	drmModeCrtcPtr crtc =
		fuzz_device_failing() ? NULL : fuzz_device_object(sizeof(*crtc));

	(void)fd;
	if (crtc) {
		crtc->crtc_id = id;
		crtc->buffer_id = fuzz_device_byte();
		crtc->mode_valid = (int)(fuzz_device_byte() % 2);
	}
	return crtc;
}

static void kms_free_crtc(drmModeCrtcPtr crtc)
{
	fuzz_device_release(crtc);
}

static int kms_set_crtc(int fd, uint32_t crtc, uint32_t fb, uint32_t x,
	uint32_t y, uint32_t *connectors, int count, drmModeModeInfoPtr mode)
{
	(void)fd;
	(void)crtc;
	(void)fb;
	(void)x;
	(void)y;
	(void)connectors;
	(void)count;
	(void)mode;
	return fuzz_device_failing();
}

static int kms_create_dumb(int fd, uint32_t width, uint32_t height,
	uint32_t bits, uint32_t flags, uint32_t *handle, uint32_t *pitch,
	uint64_t *size)
{
	(void)fd;
	(void)flags;
	if (fuzz_device_failing()) {
		return -1;
	}
	fuzz_device_count_objects(1);
	*handle = 1 + fuzz_device_byte();
	*pitch = width * ((bits + 7) / 8) + fuzz_device_byte() % 2 * 8;
	*size = (uint64_t)*pitch * height;
	if (fuzz_device_byte() % 4 == 3) {
		fuzz_device_spoil(pitch, sizeof(*pitch));
		fuzz_device_spoil(size, sizeof(*size));
	}
	return 0;
}

static int kms_map_dumb(int fd, uint32_t handle, uint64_t *offset)
{
	(void)fd;
	(void)handle;
	*offset = fuzz_device_word();
	return fuzz_device_failing();
}

static int kms_destroy_dumb(int fd, uint32_t handle)
{
	(void)fd;
	(void)handle;
	fuzz_device_count_objects(-1);
	return fuzz_device_failing();
}

static int kms_add_fb(int fd, uint32_t width, uint32_t height, uint32_t fourcc,
	const uint32_t handles[4], const uint32_t pitches[4],
	const uint32_t offsets[4], uint32_t *id, uint32_t flags)
{
	(void)fd;
	(void)width;
	(void)height;
	(void)fourcc;
	(void)handles;
	(void)pitches;
	(void)offsets;
	(void)flags;
	if (fuzz_device_failing()) {
		return -1;
	}
	fuzz_device_count_objects(1);
	*id = 1 + fuzz_device_byte();
	return 0;
}

static int kms_remove_fb(int fd, uint32_t id)
{
	(void)fd;
	(void)id;
	fuzz_device_count_objects(-1);
	return fuzz_device_failing();
}

static int kms_page_flip(
	int fd, uint32_t crtc, uint32_t fb, uint32_t flags, void *user)
{
	(void)fd;
	(void)crtc;
	(void)fb;
	(void)flags;
	flip_user = user;
	return fuzz_device_failing();
}

static int kms_dirty_fb(
	int fd, uint32_t id, drmModeClipPtr clips, uint32_t count)
{
	(void)fd;
	(void)id;
	(void)clips;
	(void)count;
	return fuzz_device_failing();
}

/* A wait in vain takes no time here. */
static int kms_wait(int fd, int timeout_ms)
{
	(void)fd;
	(void)timeout_ms;
	return fuzz_device_failing() ? -1 : fuzz_device_byte() % 4 != 3;
}

static int kms_handle_event(int fd, drmEventContextPtr context)
{
	if (fuzz_device_failing()) {
		return -1;
	}
	if (flip_user && fuzz_device_byte() % 4 != 3 &&
		context->page_flip_handler) {
		context->page_flip_handler(fd, fuzz_device_word(),
			fuzz_device_word(), fuzz_device_word(), flip_user);
	}
	return 0;
}

const struct kms_calls fuzz_device_kms = {
	.device = &fuzz_device_file,
	.get_cap = kms_get_cap,
	.is_master = kms_is_master,
	.get_resources = kms_get_resources,
	.free_resources = kms_free_resources,
	.get_connector = kms_get_connector,
	.probe_connector = kms_get_connector,
	.free_connector = kms_free_connector,
	.get_encoder = kms_get_encoder,
	.free_encoder = kms_free_encoder,
	.get_crtc = kms_get_crtc,
	.free_crtc = kms_free_crtc,
	.set_crtc = kms_set_crtc,
	.create_dumb = kms_create_dumb,
	.map_dumb = kms_map_dumb,
	.destroy_dumb = kms_destroy_dumb,
	.add_fb = kms_add_fb,
	.remove_fb = kms_remove_fb,
	.page_flip = kms_page_flip,
	.dirty_fb = kms_dirty_fb,
	.wait = kms_wait,
	.handle_event = kms_handle_event,
};
