#include "app/compare/candidate.h"

#include "platform/process/clock.h"
#include "platform/process/instruction_count.h"

#include <stdlib.h>

enum {
	TIMED_FRAMES = 48,
	PASSES_MIN = 5,
	PASSES_MAX = 101
};

static const double timed_s = 0.06; /* at least, over all passes */

static struct candidate_error measure_error(struct candidate *candidate,
	const struct reference *reference, const struct screen_view *screen)
{
	struct candidate_error error = {0};
	double sum = 0.0;

	for (int frame = 0; frame < reference->frame_count; frame++) {
		const float(*wanted)[3] = reference_position(reference, frame);

		candidate->pose(candidate, reference->time_s[frame]);
		for (int v = 0; v < candidate->vertex_count; v++) {
			int source =
				candidate->source ? candidate->source[v] : v;
			float shown[3], px;

			candidate->vertex(candidate, v, shown);
			px = screen_view_distance_px(
				screen, shown, wanted[source]);
			sum += (double)px;
			if (px > error.peak_px) {
				error.peak_px = px;
				error.peak_frame = frame;
			}
		}
	}
	error.mean_px = (float)(sum /
		((double)reference->frame_count * candidate->vertex_count));
	return error;
}

/* Frames at even distances, which do not coincide with keys. */
static void run_pass(struct candidate *candidate, float duration_s)
{
	for (int i = 0; i < TIMED_FRAMES; i++) {
		float at = ((float)i + 0.37f) / (float)TIMED_FRAMES;

		candidate->pose(candidate, duration_s * at);
	}
}

static int compare_times(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

static double median_pass_s(struct candidate *candidate, float duration_s)
{
	double pass_s[PASSES_MAX];
	double begin_s = clock_thread_s(), before_s = begin_s;
	int count = 0;

	while (count < PASSES_MAX &&
		(count < PASSES_MIN || before_s - begin_s < timed_s)) {
		double now_s;

		run_pass(candidate, duration_s);
		now_s = clock_thread_s();
		pass_s[count++] = now_s - before_s;
		before_s = now_s;
	}
	qsort(pass_s, (size_t)count, sizeof(*pass_s), compare_times);
	return pass_s[count / 2];
}

static double count_instructions(struct candidate *candidate, float duration_s)
{
	struct instruction_count count;
	double counted;

	if (instruction_count_begin(&count) != 0) {
		return -1.0;
	}
	run_pass(candidate, duration_s);
	counted = (double)instruction_count_end(&count);
	return counted < 0.0 ? -1.0 : counted / TIMED_FRAMES;
}

void candidate_measure(struct candidate *candidate,
	const struct reference *reference, const struct screen_view *screen)
{
	float duration_s = reference->clip->duration_s;

	candidate->error = measure_error(candidate, reference, screen);
	candidate->frame_us =
		median_pass_s(candidate, duration_s) * 1e6 / TIMED_FRAMES;
	candidate->instructions = count_instructions(candidate, duration_s);
}

void candidate_destroy(struct candidate *candidate)
{
	if (candidate->destroy) {
		candidate->destroy(candidate);
	}
	*candidate = (struct candidate){0};
}
