/*
 * Times a candidate on this machine.
 */
#ifndef APP_COMPARE_CANDIDATE_CANDIDATE_TIME_H
#define APP_COMPARE_CANDIDATE_CANDIDATE_TIME_H

#include "app/compare/candidate/candidate.h"

struct candidate_time {
	double frame_us;     /* the median, in processor time of the thread */
	double instructions; /* a frame; negative: there is no counter */
};

/*
 * Poses frames that are spread evenly over the clip, several times. There may
 * be up to SAMPLING_TIMED_MAX of them. Only the time of this thread counts;
 * busy other threads make it less exact.
 */
struct candidate_time candidate_time_measure(
	struct candidate *candidate, int frames);

#endif
