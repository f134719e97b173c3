/*
 * Keys of equal time. Exporters write two such keys where a value jumps.
 * Players such as three.js show the earlier key until that time and the later
 * one from then on, and so does limber.
 */
#ifndef APP_MODEL_CLIP_KEY_TIMES_H
#define APP_MODEL_CLIP_KEY_TIMES_H

struct key_times {
	int wrong; /* a key with a smaller time than the one before it, or 0 */
	int equal; /* how many keys have the same time as the one before them */
	/*
	 * The first key that counts. Keys before it would end at the start of
	 * all clips, so no moment shows them, and their times stay equal.
	 */
	int first;
};

/*
 * Makes the times from first on strictly increasing: the earlier one of two
 * keys with equal times moves to the next smaller float, so that no moment lies
 * between them. count is at least 1. Leaves the times as they are if one is
 * wrong. Separated times stay as they are.
 */
struct key_times key_times_separate(float *time_s, int count);

#endif
