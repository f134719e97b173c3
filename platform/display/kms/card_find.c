
#include "platform/display/kms/card_find.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	CARDS_MAX = 8
};

static bool has_screen(drmModeConnectorPtr connector, drmModeConnection wanted)
{
	return connector->connection == wanted && connector->count_modes > 0;
}

/* The next connector in that state, or NULL. */
static drmModeConnectorPtr next_in_state(const struct card *card,
	drmModeResPtr resources, drmModeConnection wanted, int *at)
{
	const struct kms_calls *calls = card->calls;

	while (*at < resources->count_connectors) {
		drmModeConnectorPtr connector = calls->get_connector(
			card->fd, resources->connectors[(*at)++]);

		if (!connector) {
			continue;
		}
		if (has_screen(connector, wanted)) {
			return connector;
		}
		calls->free_connector(connector);
	}
	return NULL;
}

/*
 * Connectors that cannot tell whether they have a screen, such as VGA and
 * composite ones, count from index count_connectors on, behind all that can.
 */
drmModeConnectorPtr card_next_screen(
	const struct card *card, drmModeResPtr resources, int *at)
{
	int count = resources->count_connectors;
	drmModeConnectorPtr connector =
		next_in_state(card, resources, DRM_MODE_CONNECTED, at);
	int behind = *at - count;

	if (!connector) {
		connector = next_in_state(
			card, resources, DRM_MODE_UNKNOWNCONNECTION, &behind);
		*at = count + behind;
	}
	return connector;
}

uint32_t card_find_crtc(const struct card *card, drmModeResPtr resources,
	drmModeConnectorPtr connector)
{
	const struct kms_calls *calls = card->calls;
	uint32_t current = 0, possible = 0;

	for (int i = 0; i < connector->count_encoders; i++) {
		drmModeEncoderPtr encoder =
			calls->get_encoder(card->fd, connector->encoders[i]);

		if (!encoder) {
			continue;
		}
		if (encoder->encoder_id == connector->encoder_id) {
			current = encoder->crtc_id;
		}
		for (int j = 0; j < resources->count_crtcs && j < 32; j++) {
			if (!possible && encoder->possible_crtcs >> j & 1) {
				possible = resources->crtcs[j];
			}
		}
		calls->free_encoder(encoder);
	}
	return current ? current : possible;
}

static int distance(
	const drmModeModeInfo *mode, const struct display_options *options)
{
	return abs(mode->hdisplay - options->width) +
		abs(mode->vdisplay - options->height);
}

static bool is_preferred(const drmModeModeInfo *mode)
{
	return mode->type & DRM_MODE_TYPE_PREFERRED;
}

/* Whether a is better than b. */
static bool is_better(const drmModeModeInfo *a, const drmModeModeInfo *b,
	const struct display_options *options)
{
	if (options->size_given && distance(a, options) != distance(b, options)) {
		return distance(a, options) < distance(b, options);
	}
	if (is_preferred(a) != is_preferred(b)) {
		return is_preferred(a);
	}
	return options->size_given && a->vrefresh > b->vrefresh;
}

static void choose_mode(struct card *card, drmModeConnectorPtr connector,
	const struct display_options *options)
{
	card->mode = connector->modes[0];
	for (int i = 1; i < connector->count_modes; i++) {
		if (is_better(&connector->modes[i], &card->mode, options)) {
			card->mode = connector->modes[i];
		}
	}
}

/* Returns NULL, or why the card cannot be used. */
static const char *find_screen(
	struct card *card, const struct display_options *options)
{
	const struct kms_calls *calls = card->calls;
	uint64_t has_dumb = 0;
	drmModeResPtr resources;
	drmModeConnectorPtr connector;
	int first = 0;

	if (calls->get_cap(card->fd, DRM_CAP_DUMB_BUFFER, &has_dumb) != 0 ||
		!has_dumb) {
		return "it has no buffers that the processor can draw into";
	}
	resources = calls->get_resources(card->fd);
	if (!resources) {
		return "it drives no screens";
	}
	connector = card_next_screen(card, resources, &first);
	if (!connector) {
		calls->free_resources(resources);
		return "no screen is connected to it";
	}
	card->connector = connector->connector_id;
	card->crtc = card_find_crtc(card, resources, connector);
	choose_mode(card, connector, options);
	calls->free_connector(connector);
	calls->free_resources(resources);
	if (!card->crtc) {
		return "it has no CRTC for its screen";
	}
	if (!calls->is_master(card->fd)) {
		return "another program uses its screen (X or Wayland)";
	}
	return NULL;
}

static int log_not_open(const char *path, int error, const struct log *log)
{
	if (error == EACCES || error == EPERM) {
		log_error(log,
			"--display kms: %s: no permission: run as root, or join the group that owns it (usually video)",
			path);
		return -EACCES;
	}
	log_error(log,
		"--display kms: %s: %s: load the screen's driver, name another with --display kms:/dev/dri/cardN, or choose another --display",
		path, strerror(error));
	return -error;
}

/* Opens one card and looks for its screen. */
static int try_card(struct card *card, const char *path,
	const struct display_options *options, const struct log *log)
{
	const struct device_calls *device = card->calls->device;
	const char *missing;

	if (snprintf(card->path, sizeof(card->path), "%s", path) >=
		(int)sizeof(card->path)) {
		log_error(log, "--display kms: %s: the name is too long", path);
		return -ENAMETOOLONG;
	}
	card->fd = device->open(path, O_RDWR | O_CLOEXEC);
	if (card->fd < 0) {
		return log_not_open(path, errno, log);
	}
	missing = find_screen(card, options);
	if (missing) {
		device->close(card->fd);
		log_error(log,
			"--display kms: %s: %s: name another with --display kms:/dev/dri/cardN, or choose another --display",
			path, missing);
		return -ENODEV;
	}
	return 0;
}

/*
 * A card without a screen is common and not worth a message. Only when no card
 * has one, the first card is tried again with logging.
 */
int card_find(struct card *card, const struct display_options *options)
{
	struct log nowhere = log_to_nowhere();
	char path[CARD_PATH_BYTES];

	if (options->device) {
		return try_card(card, options->device, options, options->log);
	}
	for (int i = 0; i < CARDS_MAX; i++) {
		snprintf(path, sizeof(path), "/dev/dri/card%d", i);
		if (try_card(card, path, options, &nowhere) == 0) {
			return 0;
		}
	}
	return try_card(card, "/dev/dri/card0", options, options->log);
}

bool card_is_available(const struct kms_calls *calls)
{
	struct card card = {.calls = calls};
	struct log nowhere = log_to_nowhere();
	const struct display_options options = {.log = &nowhere};

	if (card_find(&card, &options) != 0) {
		return false;
	}
	calls->device->close(card.fd);
	return true;
}
