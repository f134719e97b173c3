/*
 * Screens driven through kernel mode setting, with buffers that the processor
 * writes.
 *
 * Pictures are drawn in memory and copied to the buffer that is not shown.
 * Blending reads what it draws on, which is slow in a buffer: the drivers of
 * ARM boards, and of most cards, give programs memory that the processor does
 * not cache. Few of them say so (DRM_CAP_DUMB_PREFER_SHADOW).
 */
#include <errno.h>
#include <stdlib.h>

#include "platform/display/console.h"
#include "platform/display/kms/card.h"
#include "platform/display/packing.h"
#include "platform/display/placement.h"

struct display {
	struct card card;
	struct console console;
	struct placement place; /* of the picture on the screen */
	struct pixels picture;
	struct packing packing; /* of the copy */
	int error; /* of taking the screen again, -errno; frames fail then */
};

static int prepare_picture(
	struct display *display, const struct display_options *options)
{
	const struct card *card = &display->card;
	enum pixel_format format =
		options->format_given ? options->format : card->format;

	display->place = placement_choose(
		options, card->mode.hdisplay, card->mode.vdisplay);
	packing_init(&display->packing, format, &card->layout);
	return pixels_alloc(&display->picture, display->place.width,
		display->place.height, format, options->log);
}

int kms_create_on(const struct kms_calls *calls,
	const struct display_options *options, struct display **out)
{
	struct display *display = calloc(1, sizeof(*display));
	int error;

	if (!display) {
		log_error(options->log, "--display kms: out of memory");
		return -ENOMEM;
	}
	error = card_open(&display->card, calls, options);
	if (error) {
		goto out_free;
	}
	error = prepare_picture(display, options);
	if (error) {
		goto out_card;
	}
	console_acquire(&display->console, calls->device, options->log);
	log_note(options->log, "--display kms: %s, %dx%d, %d bits, %s",
		display->card.path, display->card.mode.hdisplay,
		display->card.mode.vdisplay, display->card.layout.bits,
		display->card.method == CARD_PAGE_FLIP          ? "flipped"
			: display->card.method == CARD_MODE_SET ? "set"
								: "one buffer");
	*out = display;
	return 0;
out_card:
	card_close(&display->card);
out_free:
	free(display);
	return error;
}

static int kms_create(
	const struct display_options *options, struct display **out)
{
	return kms_create_on(&kms_calls_system, options, out);
}

static bool kms_probe(void)
{
	return card_is_available(&kms_calls_system);
}

static void kms_get_info(const struct display *display, struct display_info *out)
{
	const struct card *card = &display->card;

	*out = (struct display_info){
		.width = display->picture.width,
		.height = display->picture.height,
		.format = display->picture.format,
		.rate_hz = card->method == CARD_PAGE_FLIP ? card->mode.vrefresh
							  : 0.0,
	};
}

/* The first pixel of the next picture in the buffer. */
static uint8_t *picture_start(const struct display *display)
{
	const struct card_buffer *buffer = card_back(&display->card);

	return (uint8_t *)buffer->map +
		(size_t)display->place.top * buffer->pitch_bytes +
		(size_t)display->place.left * (size_t)display->packing.bytes;
}

static int kms_begin_frame(struct display *display, struct pixels *out)
{
	*out = display->picture;
	return display->error;
}

/* The back buffer is needed, and awaited, only here. */
static int kms_end_frame(struct display *display)
{
	struct card *card = &display->card;
	int error = card_wait(card);

	if (error) {
		return error;
	}
	packing_copy(&display->packing, &display->picture,
		picture_start(display), (int)card_back(card)->pitch_bytes);
	return card_show(card);
}

static void give_screen(struct display *display)
{
	if (card_leave(&display->card) != 0) {
		console_refuse(&display->console);
	} else if (console_leave(&display->console) != 0) {
		display->error = card_return(&display->card);
	}
}

/* Tries it again in the next frame while another program holds the card. */
static void take_screen(struct display *display)
{
	int error = card_return(&display->card);

	if (error != -EBUSY) {
		display->error = error;
		console_return(&display->console);
	}
}

static void kms_poll(struct display *display, int64_t now_ms,
	struct button_queue *queue, struct display_events *events)
{
	(void)now_ms;
	(void)queue;
	*events = (struct display_events){
		.away = console_follow(
			&display->console, give_screen, take_screen, display)};
}

static void kms_destroy(struct display *display)
{
	if (display) {
		card_close(&display->card);
		console_release(&display->console);
		free(display->picture.data);
		free(display);
	}
}

static void kms_survey(const struct survey *survey)
{
	kms_survey_on(&kms_calls_system, survey);
}

const struct display_driver display_driver_kms = {
	.name = "kms",
	.summary = "a screen through kernel mode setting, /dev/dri/card*",
	.argument = "DEVICE",
	.needs_keyboard = true,
	.probe = kms_probe,
	.create = kms_create,
	.get_info = kms_get_info,
	.begin_frame = kms_begin_frame,
	.end_frame = kms_end_frame,
	.poll = kms_poll,
	.destroy = kms_destroy,
	.survey = kms_survey,
};
