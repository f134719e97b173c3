/*
 * A made-up graphics card with one screen, behind struct kms_calls. Its console
 * is that of fake_fb.h. There may be a second card, of which a test says little.
 */
#ifndef TESTS_SUPPORT_FAKE_FAKE_CARD_H
#define TESTS_SUPPORT_FAKE_FAKE_CARD_H

#include "platform/display/kms/kms_calls.h"

enum {
	FAKE_CARD_CONNECTOR = 31, /* of its screen */
	FAKE_CARD_OTHER_CONNECTOR = 30,
	FAKE_CARD_ENCODERS = 3,
	FAKE_CARD_MODES = 3,
	FAKE_CARD_BUFFER_BYTES = 64 * 1024
};

/* The calls that can be made to fail. */
enum fake_card_call {
	CALL_NONE,
	CALL_RESOURCES,
	CALL_CONNECTOR,
	CALL_ENCODER,
	CALL_CREATE,
	CALL_ADD,
	CALL_MAP_DUMB,
	CALL_MAP,
	CALL_SET,
	CALL_FLIP,
	CALL_WAIT,
	CALL_EVENT,
	CALL_GET_CRTC,
	CALL_DROP
};

struct fake_card {
	int number; /* of /dev/dri/cardN */
	int open_error;
	bool held; /* another program is its master and stays it */
	bool no_dumb, not_master, not_connected;
	bool unsure;         /* it cannot tell whether it has a screen */
	bool must_ask;       /* it knows of no screen until it is asked */
	bool two_connectors; /* the one before its screen's is like it */
	drmModeConnection other_state;
	int other_encoder; /* that drives the other connector; -1: none */
	/* The second card, /dev/dri/cardN with this number; -1: none. */
	int second_number;
	bool second_unsure, second_drives_none, second_in_use;
	int second_error; /* of opening it */
	uint64_t preferred_depth;
	uint32_t fourccs[3]; /* formats that it can show */
	/* The CRTC that drives the encoder, or 0; a bit for each that could. */
	struct {
		uint32_t crtc, possible;
	} encoders[FAKE_CARD_ENCODERS];
	int encoder_count, connected_encoder;
	drmModeModeInfo modes[FAKE_CARD_MODES];
	int mode_count;

	enum fake_card_call fail;
	int fail_from; /* the first call that fails, counted from 0 */
	int fail_error;
	bool fail_once;
	int calls; /* how often the call of fail was made so far */

	/* Two buffers. The handle and the fb of buffer i are i + 1. */
	struct {
		bool used, added;
		uint32_t pitch, fourcc;
		uint8_t memory[FAKE_CARD_BUFFER_BYTES];
	} buffers[2];
	int open_count, map_count, resource_count; /* not released yet */
	uint32_t shown_fb;
	drmModeModeInfo shown_mode;
	uint32_t shown_crtc;
	uint32_t shown_connectors[2]; /* by the last mode that was set */
	int shown_count;
	int probe_count;
	void *flip_user; /* of the pending page flip, or NULL */
	uint32_t flip_fb;
	int flip_count, set_count, dirty_count, wait_count;
};

extern struct fake_card fake_card;
extern const struct kms_calls fake_card_calls;

/* Makes a card whose screen offers 20x12 (preferred), 24x14 and 10x8. */
void fake_card_begin(void);

/* The value of the pixel that the screen shows at (x, y). */
uint32_t fake_card_seen(int x, int y);

#endif
