/*
 * A film: a file of the pictures that are shown, at an even rate.
 *
 * Each moment of the film shows the picture that was on the screen then, so
 * frames that take longer are repeated and faster ones left out.
 */
#ifndef APP_CMD_SHOW_FILM_H
#define APP_CMD_SHOW_FILM_H

#include "platform/display/display.h"

/* All zero: there is no film. */
struct film {
	const struct display_driver *driver;
	struct display *display; /* the file, or NULL */
	struct log log;
	double rate_hz;
	double next_s; /* the next moment; negative before the first picture */
	int width, height;
	bool resized; /* logged that pictures of another size are left out */
};

/*
 * Begins a .gif, .y4m or .png file of pictures with size's width, height and
 * format, rate_hz a second; frames is how many there will be, 0 if unknown.
 * Returns 0, or -errno after logging an error.
 */
int film_open(struct film *film, const char *path, const struct pixels *size,
	double rate_hz, int frames, const struct log *log);

/*
 * Adds the picture that is on the screen from now_s (seconds, which never
 * decreases). Without a film it does nothing. Returns 0, or -errno after
 * logging an error.
 */
int film_add(struct film *film, const struct pixels *picture, double now_s);

/*
 * Completes and closes the file. A film without pictures leaves what stood at
 * its path before. Without a film it does nothing. Returns 0, or -errno after
 * logging an error.
 */
int film_close(struct film *film);

#endif
