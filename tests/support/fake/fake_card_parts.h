/*
 * What the files of the made-up card share. Tests include fake_card.h only.
 */
#ifndef TESTS_SUPPORT_FAKE_FAKE_CARD_PARTS_H
#define TESTS_SUPPORT_FAKE_FAKE_CARD_PARTS_H

#include "tests/support/fake/fake_card.h"

enum {
	FAKE_CARD_FD = 0, /* a descriptor like any other */
	FAKE_CARD_SECOND_FD = 1,
	FAKE_CARD_CRTC = 51 /* that drives its screen */
};

/* Whether this call fails, as fake_card.fail asks. Then sets errno. */
bool fake_card_fails(enum fake_card_call call);

/* Members of fake_card_calls in fake_card_screens.c. */
drmModeResPtr fake_card_get_resources(int fd);
void fake_card_free_resources(drmModeResPtr resources);
drmModeConnectorPtr fake_card_probe_connector(int fd, uint32_t id);
drmModeConnectorPtr fake_card_get_connector(int fd, uint32_t id);
void fake_card_free_connector(drmModeConnectorPtr connector);
drmModeEncoderPtr fake_card_get_encoder(int fd, uint32_t id);
void fake_card_free_encoder(drmModeEncoderPtr encoder);
drmModeCrtcPtr fake_card_get_crtc(int fd, uint32_t id);
void fake_card_free_crtc(drmModeCrtcPtr crtc);
int fake_card_set_crtc(int fd, uint32_t crtc, uint32_t fb, uint32_t x,
	uint32_t y, uint32_t *connectors, int count, drmModeModeInfoPtr mode);

/* Members of fake_card_calls in fake_card_buffers.c. */
int fake_card_create_dumb(int fd, uint32_t width, uint32_t height, uint32_t bits,
	uint32_t flags, uint32_t *handle, uint32_t *pitch, uint64_t *size);
int fake_card_map_dumb(int fd, uint32_t handle, uint64_t *offset);
int fake_card_destroy_dumb(int fd, uint32_t handle);
int fake_card_add_fb(int fd, uint32_t width, uint32_t height, uint32_t fourcc,
	const uint32_t handles[4], const uint32_t pitches[4],
	const uint32_t offsets[4], uint32_t *id, uint32_t flags);
int fake_card_remove_fb(int fd, uint32_t id);

#endif
