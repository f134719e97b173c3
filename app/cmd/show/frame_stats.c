#include "app/cmd/show/frame_stats.h"

#include "platform/process/clock.h"

static int64_t larger(int64_t a, int64_t b)
{
	return a > b ? a : b;
}

static double ms(int64_t ns)
{
	return (double)ns / 1e6;
}

void frame_stats_begin(struct frame_stats *stats)
{
	stats->begun_ns = clock_monotonic_ns();
	if (stats->frames == 0) {
		stats->first_ns = stats->begun_ns;
	}
}

void frame_stats_press(struct frame_stats *stats, int64_t pressed_ns)
{
	stats->presses++;
	if (stats->pressed_ns == 0 || pressed_ns < stats->pressed_ns) {
		stats->pressed_ns = pressed_ns;
	}
}

void frame_stats_end(struct frame_stats *stats)
{
	int64_t now = clock_monotonic_ns();
	int64_t work_ns = now - stats->begun_ns;
	int64_t work_ms = work_ns / 1000000;

	stats->work_ns += work_ns;
	stats->work_max_ns = larger(stats->work_max_ns, work_ns);
	if (stats->frames > 0) {
		stats->apart_max_ns =
			larger(stats->apart_max_ns, now - stats->ended_ns);
	}
	if (stats->pressed_ns != 0) {
		stats->latency_max_ns =
			larger(stats->latency_max_ns, now - stats->pressed_ns);
		stats->pressed_ns = 0;
	}
	stats->bucket[work_ms < FRAME_STATS_BUCKETS ? work_ms
						    : FRAME_STATS_BUCKETS - 1]++;
	stats->ended_ns = now;
	stats->frames++;
}

int frame_stats_percentile_ms(const struct frame_stats *stats, double fraction)
{
	int left = (int)(fraction * stats->frames);
	int at = 0;

	if (stats->frames == 0) {
		return 0;
	}
	left = left < stats->frames ? left : stats->frames - 1;
	while (at < FRAME_STATS_BUCKETS - 1 && left >= stats->bucket[at]) {
		left -= stats->bucket[at++];
	}
	return at + 1;
}

void frame_stats_write(const struct frame_stats *stats, FILE *out)
{
	int64_t whole_ns = stats->ended_ns - stats->first_ns;
	double frames = stats->frames > 0 ? stats->frames : 1;

	fprintf(out,
		"{\"frames\": %d, \"seconds\": %.6f, \"fps\": %.2f,\n"
		" \"work_ms\": {\"mean\": %.3f, \"p50\": %d, \"p95\": %d, "
		"\"max\": %.3f},\n"
		" \"apart_ms_max\": %.3f, \"presses\": %d, "
		"\"latency_ms_max\": %.3f}\n",
		stats->frames, (double)whole_ns / 1e9,
		whole_ns > 0 ? stats->frames * 1e9 / (double)whole_ns : 0.0,
		ms(stats->work_ns) / frames,
		frame_stats_percentile_ms(stats, 0.5),
		frame_stats_percentile_ms(stats, 0.95), ms(stats->work_max_ns),
		ms(stats->apart_max_ns), stats->presses,
		ms(stats->latency_max_ns));
}
