/*
 * Pictures kept in files while they are shown: a film, and single ones.
 *
 * A film has an even rate: each moment of it is the picture that was on the
 * screen then, however long frames take. Pictures are copied as the driver
 * drew them, or read back where it draws on a surface.
 */
#ifndef APP_CMD_SHOW_FILM_H
#define APP_CMD_SHOW_FILM_H

#include "platform/display/display.h"
#include "platform/gl/gl.h"
#include "platform/process/background.h"

/* All zero: nothing is kept. */
struct film {
	const struct display_driver *driver;
	struct display *display; /* the file; NULL: none */
	struct log log;
	double rate_hz;
	double next_s; /* of the next moment; below 0: none yet */
	int width, height;
	bool resized; /* said that another size is left out */
};

/*
 * Begins FILE.gif or FILE.y4m for pictures of size's width, height and format,
 * rate_hz a second. 0, or -errno after a sentence.
 */
int film_open(struct film *film, const char *path, const struct pixels *size,
	double rate_hz, const struct log *log);

/* A picture that is on the screen at now_s. 0, or -errno after a sentence. */
int film_add(struct film *film, const struct pixels *picture, double now_s);

/*
 * Completes the file; without a picture there is none, and the one that stood
 * there before stays. 0, or -errno after a sentence. Closed is fine.
 */
int film_close(struct film *film);

/* A picture on its way into a file. All zero: none. */
struct snapshot {
	struct background background;
	struct pixels picture;
	struct log log;
};

/*
 * Writes a copy of the picture to the first of limber-0001.png and so on that
 * is free, and says which, or what is in the way. That takes a while on a small
 * machine, and goes on beside the caller; the picture taken before is waited
 * for.
 */
void snapshot_take(struct snapshot *snapshot, const struct pixels *picture,
	const struct log *log);

/* Until the last picture is in its file. None is fine. */
void snapshot_finish(struct snapshot *snapshot);

/*
 * The picture drawn last as pixels: on is what it was drawn into, NULL for a
 * surface of that size, which is read into room. 0 or -errno.
 */
int film_look(const struct pixels *on, const struct gl *gl, int width,
	int height, struct pixels *room, struct pixels *out,
	const struct log *log);

#endif
