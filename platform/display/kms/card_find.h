/*
 * Part of card.h: which card, screen and mode.
 */
#ifndef PLATFORM_DISPLAY_KMS_CARD_FIND_H
#define PLATFORM_DISPLAY_KMS_CARD_FIND_H

#include "platform/display/kms/card.h"

/*
 * Opens a card and fills in path, fd, connector, crtc and mode. 0, or -errno
 * after a sentence with nothing left open.
 */
int card_find(struct card *card, const struct display_options *options);

/*
 * The next connector with a screen and modes, looked for from number *at on,
 * which moves behind it; NULL when there is no more. The caller frees it.
 */
drmModeConnectorPtr card_next_screen(
	const struct card *card, drmModeResPtr resources, int *at);

/*
 * What drives that connector of an open card: what does now, else the first
 * that can; 0 when nothing can.
 */
uint32_t card_find_crtc(const struct card *card, drmModeResPtr resources,
	drmModeConnectorPtr connector);

#endif
