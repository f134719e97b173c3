#include "platform/display/kms/card_find.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/display/pixels.h"

enum {
	CARDS_MAX = 8
};

/* What comes of a card, the worst first: the best card is used. */
enum prospect {
	CARD_ABSENT,
	CARD_BROKEN, /* it cannot be opened */
	CARD_DRIVES_NONE,
	CARD_LACKS_BUFFERS,
	CARD_UNCONNECTED,
	CARD_DENIED,
	CARD_LACKS_CRTC,
	CARD_IN_USE,
	/*
	 * It has a screen, or a connector that cannot tell; "taken": another
	 * screen shows something through the only CRTC for it.
	 */
	CARD_UNSURE_TAKEN,
	CARD_UNSURE,
	CARD_CONNECTED_TAKEN,
	CARD_CONNECTED
};

static bool is_usable(const drmModeModeInfo *mode)
{
	return mode->hdisplay >= 1 && mode->hdisplay <= PIXELS_SIZE_MAX &&
		mode->vdisplay >= 1 && mode->vdisplay <= PIXELS_SIZE_MAX;
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

static bool holds(
	const drmModeModeInfo *mode, const struct display_options *options)
{
	return mode->hdisplay >= options->width &&
		mode->vdisplay >= options->height;
}

/*
 * Whether a is better than b. A picture of a given size should be seen whole:
 * of 800x600, neither 640x480 nor 1280x480 shows all, though they are nearer
 * than 1024x768.
 */
static bool is_better(const drmModeModeInfo *a, const drmModeModeInfo *b,
	const struct display_options *options)
{
	if (options->size_given && holds(a, options) != holds(b, options)) {
		return holds(a, options);
	}
	if (options->size_given && distance(a, options) != distance(b, options)) {
		return distance(a, options) < distance(b, options);
	}
	if (is_preferred(a) != is_preferred(b)) {
		return is_preferred(a);
	}
	return options->size_given && a->vrefresh > b->vrefresh;
}

const drmModeModeInfo *card_best_mode(
	drmModeConnectorPtr connector, const struct display_options *options)
{
	const drmModeModeInfo *best = NULL;

	for (int i = 0; i < connector->count_modes; i++) {
		const drmModeModeInfo *mode = &connector->modes[i];

		if (is_usable(mode) &&
			(!best || is_better(mode, best, options))) {
			best = mode;
		}
	}
	return best;
}

static bool has_screen(drmModeConnectorPtr connector, drmModeConnection wanted)
{
	static const struct display_options any = {.size_given = false};

	return connector->connection == wanted &&
		card_best_mode(connector, &any);
}

static drmModeConnectorPtr get_connector(const struct card *card, uint32_t id)
{
	return card->probes ? card->calls->probe_connector(card->fd, id)
			    : card->calls->get_connector(card->fd, id);
}

/* The next connector in that state, or NULL. */
static drmModeConnectorPtr next_in_state(const struct card *card,
	drmModeResPtr resources, drmModeConnection wanted, int *at)
{
	while (*at < resources->count_connectors) {
		drmModeConnectorPtr connector =
			get_connector(card, resources->connectors[(*at)++]);

		if (!connector) {
			continue;
		}
		if (has_screen(connector, wanted)) {
			return connector;
		}
		card->calls->free_connector(connector);
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

/* The CRTC that drives a connector now, or 0. */
static uint32_t crtc_of(const struct card *card, uint32_t connector_id)
{
	const struct kms_calls *calls = card->calls;
	drmModeConnectorPtr connector =
		calls->get_connector(card->fd, connector_id);
	drmModeEncoderPtr encoder = NULL;
	uint32_t crtc = 0;

	if (connector && connector->encoder_id) {
		encoder = calls->get_encoder(card->fd, connector->encoder_id);
	}
	if (encoder) {
		crtc = encoder->crtc_id;
		calls->free_encoder(encoder);
	}
	if (connector) {
		calls->free_connector(connector);
	}
	return crtc;
}

/* Fills before_connectors with those that the card's CRTC drives now. */
static void note_driven(struct card *card, drmModeResPtr resources)
{
	card->before_count = 0;
	for (int i = 0; i < resources->count_connectors &&
		card->before_count < CARD_CONNECTORS_MAX;
		i++) {
		if (crtc_of(card, resources->connectors[i]) == card->crtc) {
			card->before_connectors[card->before_count++] =
				resources->connectors[i];
		}
	}
}

static bool drives_another(const struct card *card, drmModeResPtr resources,
	uint32_t crtc, uint32_t connector_id)
{
	for (int i = 0; i < resources->count_connectors; i++) {
		uint32_t id = resources->connectors[i];

		if (id != connector_id && crtc_of(card, id) == crtc) {
			return true;
		}
	}
	return false;
}

/*
 * The first CRTC that an encoder can use, or 0. With idle, one that drives no
 * other connector.
 */
static uint32_t first_crtc(const struct card *card, drmModeResPtr resources,
	drmModeConnectorPtr connector, const drmModeEncoder *encoder, bool idle)
{
	for (int i = 0; i < resources->count_crtcs && i < 32; i++) {
		uint32_t crtc = resources->crtcs[i];

		if (encoder->possible_crtcs >> i & 1 &&
			(!idle ||
				!drives_another(card, resources, crtc,
					connector->connector_id))) {
			return crtc;
		}
	}
	return 0;
}

uint32_t card_find_crtc(const struct card *card, drmModeResPtr resources,
	drmModeConnectorPtr connector, bool *taken)
{
	const struct kms_calls *calls = card->calls;
	uint32_t current = 0, idle = 0, any = 0;

	for (int i = 0; i < connector->count_encoders; i++) {
		drmModeEncoderPtr encoder =
			calls->get_encoder(card->fd, connector->encoders[i]);

		if (!encoder) {
			continue;
		}
		if (encoder->encoder_id == connector->encoder_id) {
			current = encoder->crtc_id;
		}
		idle = idle
			? idle
			: first_crtc(card, resources, connector, encoder, true);
		any = any
			? any
			: first_crtc(card, resources, connector, encoder, false);
		calls->free_encoder(encoder);
	}
	*taken = !current && !idle && any;
	return current ? current : idle ? idle : any;
}

static enum prospect rate(drmModeConnectorPtr connector, bool taken)
{
	if (connector->connection == DRM_MODE_CONNECTED) {
		return taken ? CARD_CONNECTED_TAKEN : CARD_CONNECTED;
	}
	return taken ? CARD_UNSURE_TAKEN : CARD_UNSURE;
}

/* Fills connector, crtc and mode with those of the best screen. */
static enum prospect choose_screen(struct card *card, drmModeResPtr resources,
	const struct display_options *options)
{
	enum prospect best = CARD_UNCONNECTED;
	drmModeConnectorPtr connector;
	int at = 0;

	while ((connector = card_next_screen(card, resources, &at))) {
		bool taken;
		uint32_t crtc =
			card_find_crtc(card, resources, connector, &taken);
		enum prospect found =
			crtc ? rate(connector, taken) : CARD_LACKS_CRTC;

		if (found > best) {
			best = found;
			card->connector = connector->connector_id;
			card->crtc = crtc;
			card->mode = *card_best_mode(connector, options);
		}
		card->calls->free_connector(connector);
	}
	return best;
}

/*
 * Where no program has used the card since it started, the kernel has not looked
 * for screens yet. So it is asked to look if it knows none, which takes long.
 */
static enum prospect find_screen(
	struct card *card, const struct display_options *options)
{
	const struct kms_calls *calls = card->calls;
	uint64_t has_dumb = 0;
	drmModeResPtr resources;
	enum prospect found;

	if (calls->get_cap(card->fd, DRM_CAP_DUMB_BUFFER, &has_dumb) != 0 ||
		!has_dumb) {
		return CARD_LACKS_BUFFERS;
	}
	resources = calls->get_resources(card->fd);
	if (!resources) {
		return CARD_DRIVES_NONE;
	}
	card->probes = false;
	found = choose_screen(card, resources, options);
	if (found == CARD_UNCONNECTED) {
		card->probes = true;
		found = choose_screen(card, resources, options);
	}
	if (found > CARD_IN_USE) {
		note_driven(card, resources);
		found = calls->is_master(card->fd) ? found : CARD_IN_USE;
	}
	calls->free_resources(resources);
	return found;
}

/* Opens the card; it stays open if its prospect is better than CARD_IN_USE. */
static enum prospect try_card(
	struct card *card, const struct display_options *options)
{
	const struct device_calls *device = card->calls->device;
	enum prospect found;

	card->fd = device->open(card->path, O_RDWR | O_CLOEXEC);
	if (card->fd < 0) {
		return errno == EACCES || errno == EPERM ? CARD_DENIED
			: errno == ENOENT                ? CARD_ABSENT
							 : CARD_BROKEN;
	}
	found = find_screen(card, options);
	if (found <= CARD_IN_USE) {
		device->close(card->fd);
	}
	return found;
}

/* Logs why the card cannot be used; error is that of opening it. */
static int refuse(const struct card *card, enum prospect found, int error,
	const struct log *log)
{
	static const char *const lacks[] = {
		[CARD_DRIVES_NONE] = "it drives no screens",
		[CARD_LACKS_BUFFERS] =
			"it has no buffers that the processor can draw into",
		[CARD_UNCONNECTED] = "no screen is connected to it",
		[CARD_LACKS_CRTC] = "it has no CRTC for its screen",
		[CARD_IN_USE] = "another program uses its screen (X or Wayland)",
	};

	switch (found) {
	case CARD_DENIED:
		log_error(log,
			"--display kms: %s: no permission: run as root, or join the group that owns it (usually video)",
			card->path);
		return -EACCES;
	case CARD_ABSENT:
	case CARD_BROKEN:
		log_error(log,
			"--display kms: %s: %s: load the screen's driver, name another with --display kms:/dev/dri/cardN, or choose another --display",
			card->path, strerror(error));
		return -error;
	default:
		log_error(log,
			"--display kms: %s: %s: name another with --display kms:/dev/dri/cardN, or choose another --display",
			card->path, lacks[found]);
		return -ENODEV;
	}
}

/*
 * Opens the card with the best prospect, the first one if several have it; it
 * stays open if that is better than CARD_IN_USE. Sets *error to that of opening
 * it. Many cards have no screen, which is not worth a message.
 */
static enum prospect try_cards(
	struct card *card, const struct display_options *options, int *error)
{
	const struct device_calls *device = card->calls->device;
	struct card tried = *card;
	enum prospect best = CARD_ABSENT;

	for (int i = 0; i < CARDS_MAX && best < CARD_CONNECTED; i++) {
		enum prospect found;

		snprintf(tried.path, sizeof(tried.path), "/dev/dri/card%d", i);
		found = try_card(&tried, options);
		if (i > 0 && found <= best) {
			if (found > CARD_IN_USE) {
				device->close(tried.fd);
			}
			continue;
		}
		*error = errno;
		if (best > CARD_IN_USE) {
			device->close(card->fd);
		}
		*card = tried;
		best = found;
	}
	return best;
}

int card_find(struct card *card, const struct display_options *options)
{
	enum prospect found;
	int error = 0;

	if (!options->device) {
		found = try_cards(card, options, &error);
	} else if (snprintf(card->path, sizeof(card->path), "%s",
			   options->device) >= (int)sizeof(card->path)) {
		log_error(options->log,
			"--display kms: %s: the name is too long",
			options->device);
		return -ENAMETOOLONG;
	} else {
		found = try_card(card, options);
		error = errno;
	}
	return found > CARD_IN_USE ? 0
				   : refuse(card, found, error, options->log);
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
