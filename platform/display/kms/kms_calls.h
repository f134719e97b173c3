/*
 * The functions of libdrm that the kms driver uses, as a table, so that tests
 * can replace a card. Each returns what libdrm's function returns.
 */
#ifndef PLATFORM_DISPLAY_KMS_KMS_CALLS_H
#define PLATFORM_DISPLAY_KMS_KMS_CALLS_H

#include <stdint.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

#include "platform/display/display.h"
#include "platform/process/device_calls.h"

struct kms_calls {
	const struct device_calls *device;
	int (*get_cap)(int fd, uint64_t cap, uint64_t *value);
	int (*is_master)(int fd);
	int (*set_master)(int fd);
	int (*drop_master)(int fd);
	drmModeResPtr (*get_resources)(int fd);
	void (*free_resources)(drmModeResPtr resources);
	/* What the kernel knows of a connector. */
	drmModeConnectorPtr (*get_connector)(int fd, uint32_t id);
	/* The same after asking its screen, which is slow. */
	drmModeConnectorPtr (*probe_connector)(int fd, uint32_t id);
	void (*free_connector)(drmModeConnectorPtr connector);
	drmModeEncoderPtr (*get_encoder)(int fd, uint32_t id);
	void (*free_encoder)(drmModeEncoderPtr encoder);
	drmModeCrtcPtr (*get_crtc)(int fd, uint32_t id);
	void (*free_crtc)(drmModeCrtcPtr crtc);
	int (*set_crtc)(int fd, uint32_t crtc, uint32_t fb, uint32_t x,
		uint32_t y, uint32_t *connectors, int count,
		drmModeModeInfoPtr mode);
	int (*create_dumb)(int fd, uint32_t width, uint32_t height,
		uint32_t bits, uint32_t flags, uint32_t *handle,
		uint32_t *pitch, uint64_t *size);
	int (*map_dumb)(int fd, uint32_t handle, uint64_t *offset);
	int (*destroy_dumb)(int fd, uint32_t handle);
	int (*add_fb)(int fd, uint32_t width, uint32_t height, uint32_t fourcc,
		const uint32_t handles[4], const uint32_t pitches[4],
		const uint32_t offsets[4], uint32_t *id, uint32_t flags);
	int (*remove_fb)(int fd, uint32_t id);
	int (*page_flip)(
		int fd, uint32_t crtc, uint32_t fb, uint32_t flags, void *user);
	int (*dirty_fb)(
		int fd, uint32_t id, drmModeClipPtr clips, uint32_t count);
	/* Waits by poll() for something to read. 1, 0 after timeout_ms, or -1. */
	int (*wait)(int fd, int timeout_ms);
	int (*handle_event)(int fd, drmEventContextPtr context);
};

/* The functions of libdrm. */
extern const struct kms_calls kms_calls_system;

/* The driver's create() with other functions, which must outlive *out. */
int kms_create_on(const struct kms_calls *calls,
	const struct display_options *options, struct display **out);

/* The driver's survey() with other functions. */
void kms_survey_on(const struct kms_calls *calls, const struct survey *survey);

#endif
