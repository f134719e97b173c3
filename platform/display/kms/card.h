/*
 * A graphics card by kernel mode setting: one screen of it, and two buffers
 * that the processor draws into. Nothing here knows of pictures.
 */
#ifndef PLATFORM_DISPLAY_KMS_CARD_H
#define PLATFORM_DISPLAY_KMS_CARD_H

#include <stdbool.h>

#include "platform/display/kms/kms_calls.h"
#include "platform/display/packing.h"

enum {
	CARD_PATH_BYTES = 64
};

struct card_buffer {
	uint32_t handle; /* 0: there is none */
	uint32_t fb;     /* 0: not known to the screen */
	uint32_t pitch_bytes;
	uint64_t size_bytes;
	void *map; /* NULL: not mapped */
};

/* How a drawn buffer comes to be seen. */
enum card_method {
	CARD_PAGE_FLIP, /* at the screen's turn, which tells */
	CARD_MODE_SET,  /* by setting the mode anew */
	CARD_ONE_BUFFER /* there is one buffer, always seen */
};

struct card {
	const struct kms_calls *calls;
	struct log log;
	char path[CARD_PATH_BYTES];
	int fd;
	uint32_t connector, crtc;
	drmModeModeInfo mode;
	drmModeCrtcPtr before; /* to be put back, or NULL */
	struct pixel_layout layout;
	enum pixel_format format; /* that layout is, or comes from */
	bool reads_slowly;        /* the buffers are not for reading back */
	struct card_buffer buffers[2];
	int shown; /* the buffer that is */
	enum card_method method;
	bool pending; /* a flip that has not happened yet */
};

/*
 * Opens the device that options name, or the first with a connected screen,
 * sets the screen's own mode, or the one nearest to a size that was given, and
 * shows black. 0, or -errno after a sentence with nothing left open.
 */
int card_open(struct card *card, const struct kms_calls *calls,
	const struct display_options *options);

/* Whether any card has a screen for us; silent. */
bool card_is_available(const struct kms_calls *calls);

/* The buffer to draw: not the one seen, if there are two. */
const struct card_buffer *card_back(const struct card *card);

/* Waits until the back buffer is not seen any more. 0, or -errno, told. */
int card_wait(struct card *card);

/* Shows the back buffer. 0, or -errno after a sentence. */
int card_show(struct card *card);

/* Puts the screen back as it was. */
void card_close(struct card *card);

#endif
