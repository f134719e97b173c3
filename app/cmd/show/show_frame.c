#include "app/cmd/show/show_state.h"
#include "app/demo/demo_overlay.h"
#include "app/scene/draw/texture.h"

#include <errno.h>

/* Writes across the middle of the picture why it shows the built-in demo. */
static void draw_notice(struct show *show, int width, int height)
{
	struct hud *hud = show->hud;
	int em = hud_em(hud), line = hud_line_height(hud);
	int top = height / 2 - line;
	char text[FAILSAFE_NAME_BYTES + 64];

	snprintf(text, sizeof(text), "%s ended limber %d times within",
		show->plan->failsafe->name, FAILSAFE_STARTS);
	hud_panel(hud, em, top - em / 2, width - 2 * em, 2 * line + em, em / 2,
		hud_color_panel);
	hud_text_cut(hud, 2 * em, top, width - 4 * em, hud_color_amber, text);
	hud_text_cut(hud, 2 * em, top + line, width - 4 * em, hud_color_amber,
		"a minute of its start, so this is a demo");
}

/*
 * Draws the notice, the labels and the graph of frame times, if there are any.
 */
static void draw_hud(struct show *show, int width, int height)
{
	const struct demo_driver *driver = show->plan->demo;
	const struct demo_facts facts = demo_get_facts(driver, show->demo);
	bool labelled = !show->options->show.no_labels;
	bool noticed = show->plan->failsafe && show->plan->failsafe->gives_way;
	struct hud_place beside;

	if (!labelled && !show->watch.shown && !noticed) {
		return;
	}
	hud_begin(show->hud, width, height);
	if (labelled) {
		demo_label(driver, show->demo, show->hud);
		governor_label(&show->governor, show->hud);
	}
	beside = demo_times_place(show->demo, show->hud);
	frame_watch_show(&show->watch, &facts, show->screen.gl->driver->name,
		labelled ? NULL : governor_text(&show->governor), &beside,
		show->hud);
	if (noticed) {
		draw_notice(show, width, height);
	}
	hud_end(show->hud, &show->screen.gl->gl);
}

/*
 * Adds the picture to the film and the snapshot. An error does not end the run.
 */
static void keep_frame(struct show *show)
{
	struct pixels picture;

	if (!show->film.display && !show->keeps_picture) {
		return;
	}
	if (show_screen_picture(&show->screen, &picture, show->log) != 0) {
		show->keeps_picture = false;
		return;
	}
	if (show->keeps_picture) {
		snapshot_take(&show->snapshot, &picture, show->log);
		show->keeps_picture = false;
	}
	if (!show->film_error) {
		show->film_error = film_add(&show->film, &picture, show->now_s);
	}
}

/*
 * Checks whether the GL had no memory for a part of the frame, such as the
 * stencil of shadows. Such a picture must not get into a file, so that returns
 * -ENOMEM; a screen may show it, so that only logs a warning. A GPU's GL is not
 * asked, because it would have to complete the frame first.
 */
static int check_memory(struct show *show)
{
	bool files = show->film.display || show->screen.driver->finish;

	if (show->screen.gl->accelerated || show->lacks_memory ||
		texture_memory_ok(&show->screen.gl->gl)) {
		return 0;
	}
	if (!files) {
		show->lacks_memory = true;
		log_warning(show->log,
			"--gl %s: there is not enough memory for all of a picture: parts of it are missing",
			show->screen.gl->driver->name);
		return 0;
	}
	log_error(show->log,
		"--gl %s: there is not enough memory for all of a picture",
		show->screen.gl->driver->name);
	return -ENOMEM;
}

int show_frame_draw(struct show *show)
{
	int width, height;
	int error = show_screen_begin_frame(&show->screen, &width, &height);

	if (error) {
		return error;
	}
	demo_update_live(show->demo, show->now_s, width, height);
	demo_draw(show->plan->demo, show->demo, width, height);
	draw_hud(show, width, height);
	error = check_memory(show);
	if (!error) {
		error = show_screen_complete_frame(&show->screen);
	}
	frame_watch_stage(&show->watch, HUD_DRAW);
	if (!error) {
		keep_frame(show);
		error = show_screen_end_frame(&show->screen);
	}
	frame_watch_stage(&show->watch, HUD_PRESENT);
	return error;
}
