/*
 * Choosing the card, its screen and the mode.
 */
#ifndef PLATFORM_DISPLAY_KMS_CARD_FIND_H
#define PLATFORM_DISPLAY_KMS_CARD_FIND_H

#include "platform/display/kms/card.h"

/*
 * Opens the card that options name, or the best one, and fills in path, fd,
 * connector, crtc, mode and before_connectors. A connected screen is better
 * than a connector that cannot tell, and either than one whose only CRTC drives
 * another screen. Returns 0, or -errno after logging an error, with nothing
 * left open.
 */
int card_find(struct card *card, const struct display_options *options);

/*
 * Returns the next connector with a screen and modes, and NULL behind the last
 * one. *at is 0 for the first call and keeps the place between calls.
 * Connectors that cannot tell whether they have a screen come last. The caller
 * frees the connector.
 */
drmModeConnectorPtr card_next_screen(
	const struct card *card, drmModeResPtr resources, int *at);

/*
 * The id of a CRTC for a connector: the CRTC that drives it now, else one that
 * can drive it and drives no other connector, else the first that can drive it
 * (*taken), or 0.
 */
uint32_t card_find_crtc(const struct card *card, drmModeResPtr resources,
	drmModeConnectorPtr connector, bool *taken);

/*
 * The mode of a connector that limber sets: the preferred one or, if options
 * give a size, the one nearest to it. NULL if pictures of no mode are possible.
 */
const drmModeModeInfo *card_best_mode(
	drmModeConnectorPtr connector, const struct display_options *options);

#endif
