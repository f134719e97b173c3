/* The connectors, encoders and CRTCs of the made-up card. */
#include "tests/support/fake/fake_card_parts.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "tests/support/test.h"

enum {
	ENCODER = 41,
	OTHER_CRTC = 52,
	FB_BEFORE = 77
};

static void *hand_out(size_t size)
{
	fake_card.resource_count++;
	return calloc(1, size);
}

drmModeResPtr fake_card_get_resources(int fd)
{
	static uint32_t crtcs[] = {OTHER_CRTC, FAKE_CARD_CRTC};
	static uint32_t connectors[] = {
		FAKE_CARD_OTHER_CONNECTOR, FAKE_CARD_CONNECTOR};
	drmModeResPtr resources;

	if ((fd == FAKE_CARD_SECOND_FD && fake_card.second_drives_none) ||
		fake_card_fails(CALL_RESOURCES)) {
		return NULL;
	}
	resources = hand_out(sizeof(*resources));
	resources->count_crtcs = 2;
	resources->crtcs = crtcs;
	resources->count_connectors = fake_card.two_connectors ? 2 : 1;
	resources->connectors = connectors + !fake_card.two_connectors;
	return resources;
}

void fake_card_free_resources(drmModeResPtr resources)
{
	fake_card.resource_count--;
	free(resources);
}

/* The state of a connector after the card was asked. */
static drmModeConnection state_of(int fd, uint32_t id)
{
	if (fd == FAKE_CARD_SECOND_FD) {
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

drmModeConnectorPtr fake_card_probe_connector(int fd, uint32_t id)
{
	static uint32_t encoders[FAKE_CARD_ENCODERS] = {
		ENCODER, ENCODER + 1, ENCODER + 2};
	drmModeConnectorPtr connector;

	int encoder = id == FAKE_CARD_CONNECTOR ? fake_card.connected_encoder
						: fake_card.other_encoder;

	fake_card.probe_count++;
	assert_true(id == FAKE_CARD_CONNECTOR ||
		(id == FAKE_CARD_OTHER_CONNECTOR && fake_card.two_connectors));
	if (fake_card_fails(CALL_CONNECTOR)) {
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

drmModeConnectorPtr fake_card_get_connector(int fd, uint32_t id)
{
	drmModeConnectorPtr connector = fake_card_probe_connector(fd, id);

	fake_card.probe_count--;
	if (connector && fake_card.must_ask) {
		connector->connection = DRM_MODE_UNKNOWNCONNECTION;
		connector->count_modes = 0;
	}
	return connector;
}

void fake_card_free_connector(drmModeConnectorPtr connector)
{
	fake_card.resource_count--;
	free(connector);
}

drmModeEncoderPtr fake_card_get_encoder(int fd, uint32_t id)
{
	drmModeEncoderPtr encoder;

	(void)fd;
	assert_in_range(id, ENCODER, ENCODER + FAKE_CARD_ENCODERS - 1);
	if (fake_card_fails(CALL_ENCODER)) {
		return NULL;
	}
	encoder = hand_out(sizeof(*encoder));
	encoder->encoder_id = id;
	encoder->crtc_id = fake_card.encoders[id - ENCODER].crtc;
	encoder->possible_crtcs = fake_card.encoders[id - ENCODER].possible;
	return encoder;
}

void fake_card_free_encoder(drmModeEncoderPtr encoder)
{
	fake_card.resource_count--;
	free(encoder);
}

drmModeCrtcPtr fake_card_get_crtc(int fd, uint32_t id)
{
	drmModeCrtcPtr crtc;

	(void)fd;
	if (fake_card_fails(CALL_GET_CRTC)) {
		return NULL;
	}
	crtc = hand_out(sizeof(*crtc));
	crtc->crtc_id = id;
	crtc->buffer_id = FB_BEFORE;
	crtc->mode_valid = 1;
	crtc->mode = fake_card.modes[2];
	return crtc;
}

void fake_card_free_crtc(drmModeCrtcPtr crtc)
{
	fake_card.resource_count--;
	free(crtc);
}

int fake_card_set_crtc(int fd, uint32_t crtc, uint32_t fb, uint32_t x,
	uint32_t y, uint32_t *connectors, int count, drmModeModeInfoPtr mode)
{
	(void)fd;
	assert_int_equal(x + y, 0);
	assert_in_range(count, 1, 2);
	assert_null(fake_card.flip_user);
	if (fake_card.not_master) {
		errno = EACCES;
		return -EACCES;
	}
	if (fake_card_fails(CALL_SET)) {
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
