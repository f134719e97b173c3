/*
 * Records the pictures that are shown in a film file with a fixed frame rate.
 *
 * Each frame of the film is the picture that was on the screen at its time, so
 * pictures that were shown for long are repeated, and short ones left out.
 */
#ifndef APP_CMD_SHOW_FILM_H
#define APP_CMD_SHOW_FILM_H

#include "platform/display/display.h"

/* All zero: there is no film. */
struct film {
	const struct display_driver *driver;
	struct display *display; /* writes the file; NULL: no film */
	struct log log;
	double rate_hz;
	double next_s; /* time of the next frame; negative: no frame yet */
	int width, height;
	bool resized; /* the warning about another size was logged */
};

/*
 * Begins a .gif, .y4m or .png file with the width, height and format of *size,
 * at rate_hz frames a second. frames is their number, 0 if unknown. Returns 0,
 * or -errno after logging an error.
 */
int film_open(struct film *film, const char *path, const struct pixels *size,
	double rate_hz, int frames, const struct log *log);

/*
 * Adds the picture that is on the screen from now_s on (seconds, never
 * decreasing). Does nothing without a film. Returns 0, or -errno after logging
 * an error.
 */
int film_add(struct film *film, const struct pixels *picture, double now_s);

/*
 * Completes and closes the file. If no picture was added, a file that existed
 * at its path stays. Does nothing without a film. Returns 0, or -errno after
 * logging an error.
 */
int film_close(struct film *film);

#endif
