/*
 * Writes single pictures to files while the run goes on.
 */
#ifndef APP_CMD_SHOW_SNAPSHOT_H
#define APP_CMD_SHOW_SNAPSHOT_H

#include "platform/display/pixels.h"
#include "platform/process/background.h"

/* The picture that is being written. All zero: there is none. */
struct snapshot {
	struct background background;
	struct pixels picture; /* a copy, owned */
	struct log log;
};

/*
 * Copies the picture and writes the copy to limber-0001.png, or the next free
 * number, in a thread of its own, which prints the file's name or logs an
 * error. Waits first until the previous picture is written.
 */
void snapshot_take(struct snapshot *snapshot, const struct pixels *picture,
	const struct log *log);

/* Waits until the last picture is written and releases it. */
void snapshot_finish(struct snapshot *snapshot);

#endif
