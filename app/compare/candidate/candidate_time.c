#include "app/compare/candidate/candidate_time.h"

#include "app/compare/measure/sampling.h"
#include "platform/process/clock.h"
#include "platform/process/instruction_count.h"

#include <stdlib.h>

enum {
	REPEATS = 5 /* of each frame; the fastest counts */
};

/* Evenly spaced frames, which do not coincide with keys. */
static float frame_time_s(
	const struct candidate *candidate, int frame, int frames)
{
	return candidate->reference->clip->duration_s * ((float)frame + 0.37f) /
		(float)frames;
}

static int compare_times(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

static double pose_s(struct candidate *candidate, float time_s)
{
	double least_s = 1e9;

	for (int i = 0; i < REPEATS; i++) {
		double begin_s = clock_thread_s(), took_s;

		candidate->pose(candidate, time_s);
		took_s = clock_thread_s() - begin_s;
		least_s = took_s < least_s ? took_s : least_s;
	}
	return least_s;
}

static double median_s(struct candidate *candidate, int frames)
{
	double frame_s[SAMPLING_TIMED_MAX];

	for (int i = 0; i < frames; i++) {
		float time_s = frame_time_s(candidate, i, frames);

		candidate_pose(candidate, time_s);
		frame_s[i] = pose_s(candidate, time_s);
	}
	qsort(frame_s, (size_t)frames, sizeof(*frame_s), compare_times);
	return frame_s[frames / 2];
}

/* Counts one frame at a time, so that seek() is not counted. */
static double count_instructions(struct candidate *candidate, int frames)
{
	double sum = 0.0;

	for (int i = 0; i < frames; i++) {
		float time_s = frame_time_s(candidate, i, frames);
		struct instruction_count count;
		double counted;

		if (candidate->seek) {
			candidate->seek(candidate, time_s);
		}
		if (instruction_count_begin(&count) != 0) {
			return -1.0;
		}
		candidate->pose(candidate, time_s);
		counted = (double)instruction_count_end(&count);
		if (counted < 0.0) {
			return -1.0;
		}
		sum += counted;
	}
	return sum / frames;
}

struct candidate_time candidate_time_measure(
	struct candidate *candidate, int frames)
{
	return (struct candidate_time){
		.frame_us = median_s(candidate, frames) * 1e6,
		.instructions = count_instructions(candidate, frames),
	};
}
