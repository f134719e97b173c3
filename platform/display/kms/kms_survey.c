/* The graphics cards and screens that limber doctor reports. */
#include "platform/display/kms/kms_calls.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>

#include "platform/display/console.h"
#include "platform/display/kms/card_find.h"

enum {
	CARDS_MAX = 8
};

static const char other_display[] =
	"choose another display: --display kms:/dev/dri/cardN, fbdev or window";

static void report_screen(const struct card *card, drmModeResPtr resources,
	drmModeConnectorPtr connector, const struct survey *survey)
{
	const char *kind =
		drmModeGetConnectorTypeName(connector->connector_type);
	static const struct display_options any = {.size_given = false};
	const drmModeModeInfo *mode = card_best_mode(connector, &any);
	char text[128];
	bool taken;

	snprintf(text, sizeof(text), "%s-%u: %ux%u at %u Hz, %d mode%s",
		kind ? kind : "screen", connector->connector_type_id,
		(unsigned int)mode->hdisplay, (unsigned int)mode->vdisplay,
		mode->vrefresh, connector->count_modes,
		connector->count_modes == 1 ? "" : "s");
	if (!card_find_crtc(card, resources, connector, &taken)) {
		survey_report(survey, SURVEY_BROKEN, card->path, other_display,
			"%s, but the card has no CRTC for it", text);
	} else if (!card->calls->is_master(card->fd)) {
		survey_report(survey, SURVEY_TAKEN, card->path,
			console_in_use_remedy,
			"%s, another program uses it (X or Wayland)", text);
	} else {
		survey_report(
			survey, SURVEY_WORKS, card->path, NULL, "%s", text);
	}
}

/* Reports what the kernel knows or finds; false when there is no screen. */
static bool report_known(const struct card *card, drmModeResPtr resources,
	const struct survey *survey)
{
	drmModeConnectorPtr connector;
	int at = 0;
	bool any = false;

	while ((connector = card_next_screen(card, resources, &at))) {
		report_screen(card, resources, connector, survey);
		card->calls->free_connector(connector);
		any = true;
	}
	return any;
}

static void report_screens(const struct card *card, drmModeResPtr resources,
	const struct survey *survey)
{
	struct card asking = *card;

	asking.probes = true;
	if (!report_known(card, resources, survey) &&
		!report_known(&asking, resources, survey)) {
		survey_report(survey, SURVEY_MISSING, card->path,
			"connect a screen; cat /sys/class/drm/*/status shows which are connected",
			"no screen is connected to its %d connector%s",
			resources->count_connectors,
			resources->count_connectors == 1 ? "" : "s");
	}
}

static void report_card(const struct card *card, const struct survey *survey)
{
	const struct kms_calls *calls = card->calls;
	drmModeResPtr resources;
	uint64_t has_dumb = 0;

	resources = calls->get_resources(card->fd);
	if (!resources) {
		survey_report(survey, SURVEY_UNUSED, card->path, NULL,
			"it drives no screens");
		return;
	}
	if (calls->get_cap(card->fd, DRM_CAP_DUMB_BUFFER, &has_dumb) != 0 ||
		!has_dumb) {
		survey_report(survey, SURVEY_BROKEN, card->path, other_display,
			"it has no buffers that the processor can draw into");
	} else {
		report_screens(card, resources, survey);
	}
	calls->free_resources(resources);
}

/* Reports the card of that number; false when there is none. */
static bool report_number(
	const struct kms_calls *calls, int number, const struct survey *survey)
{
	struct card card = {.calls = calls};
	char entry[64];
	int error;

	snprintf(card.path, sizeof(card.path), "/dev/dri/card%d", number);
	card.fd = calls->device->open(card.path, O_RDWR | O_CLOEXEC);
	if (card.fd >= 0) {
		report_card(&card, survey);
		calls->device->close(card.fd);
		return true;
	}
	error = -errno;
	if (error == -EACCES || error == -EPERM) {
		survey_report_denied(survey, card.path);
		return true;
	}
	snprintf(entry, sizeof(entry), "class/drm/card%d", number);
	return survey_report_no_node(survey, card.path, entry, error);
}

void kms_survey_on(const struct kms_calls *calls, const struct survey *survey)
{
	bool any = false;

	for (int i = 0; i < CARDS_MAX; i++) {
		any = report_number(calls, i, survey) || any;
	}
	if (!any) {
		survey_report(survey, SURVEY_MISSING, "/dev/dri/card*",
			"load the screen's driver: sudo modprobe DRIVER (see lspci -k or the board's device tree), or use --display fbdev",
			"there is no graphics card with a kernel driver");
	}
}
