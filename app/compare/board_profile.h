/*
 * The memory and the frame time that a board has for one character.
 */
#ifndef APP_COMPARE_BOARD_PROFILE_H
#define APP_COMPARE_BOARD_PROFILE_H

#include <stddef.h>

struct board_profile {
	const char *name;
	const char *summary;
	size_t ram_bytes;   /* of the whole board */
	size_t taken_bytes; /* of ram_bytes: used by the system and limber */
	double frame_ms;    /* the time from one picture to the next */
	/*
	 * For the advice: the memory that is worth one percent of frame_ms. A
	 * technique that needs this much more memory must be faster by more
	 * than one percent of a frame.
	 */
	size_t bytes_per_percent;
};

/* Returns the profile of that name, or NULL; the first one if name is NULL. */
const struct board_profile *board_profile_find(const char *name);

#endif
