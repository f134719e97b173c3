/*
 * One screen of a graphics card, driven through kernel mode setting, and two
 * buffers that the processor draws into.
 */
#ifndef PLATFORM_DISPLAY_KMS_CARD_H
#define PLATFORM_DISPLAY_KMS_CARD_H

#include <stdbool.h>

#include "platform/display/kms/kms_calls.h"
#include "platform/display/packing.h"

enum {
	CARD_PATH_BYTES = 64,
	CARD_CONNECTORS_MAX = 8
};

struct card_buffer {
	uint32_t handle; /* of the dumb buffer; 0 for none */
	uint32_t fb;     /* its framebuffer object; 0 for none */
	uint32_t pitch_bytes;
	uint64_t size_bytes;
	void *map; /* NULL when it is not mapped */
};

/* How card_show() shows a buffer. */
enum card_method {
	CARD_PAGE_FLIP, /* by a page flip, which reports its completion */
	CARD_MODE_SET,  /* by setting the mode again */
	CARD_ONE_BUFFER /* not at all: one buffer is always on the screen */
};

struct card {
	const struct kms_calls *calls;
	struct log log;
	char path[CARD_PATH_BYTES];
	int fd;
	bool probes; /* connectors are asked whether they have a screen */
	uint32_t connector, crtc;
	drmModeModeInfo mode;
	drmModeCrtcPtr before; /* what card_close() restores, or NULL */
	/* The connectors that the CRTC drove before. */
	uint32_t before_connectors[CARD_CONNECTORS_MAX];
	int before_count;
	struct pixel_layout layout;
	enum pixel_format format; /* the picture format closest to layout */
	struct card_buffer buffers[2];
	int shown; /* the index of the buffer on the screen */
	enum card_method method;
	bool pending; /* a page flip is not complete yet */
	int missed;   /* pictures in a row that the screen has not shown */
};

/*
 * Opens the card that options name, or the best one (card_find.h). Sets the
 * screen's preferred mode or, if a size is given, the smallest that holds it,
 * else the one nearest to it. Shows black. Returns 0, or -errno after logging
 * an error, with nothing left open.
 */
int card_open(struct card *card, const struct kms_calls *calls,
	const struct display_options *options);

/* Whether card_open() could find a screen. Logs nothing. */
bool card_is_available(const struct kms_calls *calls);

/* The buffer that is not shown, or the only one. */
const struct card_buffer *card_back(const struct card *card);

/*
 * Waits until the back buffer is not on the screen any more. Returns 0, or
 * -errno after logging an error. A screen that is off for a moment is none: up
 * to 99 pictures in a row may be left out.
 */
int card_wait(struct card *card);

/* Shows the back buffer. Returns 0, or -errno after logging an error, as above. */
int card_show(struct card *card);

/*
 * Gives the screen to another program, such as the text console, until it comes
 * back. Returns 0, or -errno if the kernel does not allow that.
 */
int card_leave(struct card *card);

/*
 * Takes the screen again and shows the last picture. Returns -EBUSY while
 * another program holds the card, 0, or -errno after logging an error.
 */
int card_return(struct card *card);

/*
 * Restores the former picture and mode of all screens that the CRTC drove, and
 * closes the card.
 */
void card_close(struct card *card);

#endif
