/*
 * What a board has for the character that limber compares techniques for.
 */
#ifndef APP_COMPARE_BOARD_PROFILE_H
#define APP_COMPARE_BOARD_PROFILE_H

#include <stddef.h>

struct board_profile {
	const char *name;
	const char *summary;
	size_t ram_bytes;   /* of the whole board */
	size_t taken_bytes; /* of these, by the system and by limber itself */
	double frame_ms;    /* from picture to picture */
	/*
	 * The rule of the advice: memory that is worth one hundredth of the
	 * frame's time. A technique that needs this much more memory must be
	 * faster by more than a hundredth of the frame.
	 */
	size_t bytes_per_percent;
};

/* The profile of a name, or NULL. NULL as the name gives the first one. */
const struct board_profile *board_profile_find(const char *name);

#endif
