#include "app/anim/playback.h"

struct playback playback_begin(
	float duration_s, enum clip_repeat repeat, float speed)
{
	bool from_end = repeat == CLIP_ONCE && speed < 0;

	return (struct playback){
		.duration_s = duration_s > 0 ? duration_s : 0,
		.speed = speed,
		.repeat = repeat,
		.time_s = from_end && duration_s > 0 ? duration_s : 0,
	};
}

static double within(const struct playback *playback, double time_s)
{
	double end_s = playback->duration_s;

	return time_s > 0 ? time_s < end_s ? time_s : end_s : 0;
}

void playback_seek(struct playback *playback, double time_s)
{
	playback->time_s = within(playback, time_s);
	playback->returning = false;
	playback->finished = false;
	playback->begun = false;
}

/* The events of one step, and the output of their ids. */
struct crossing {
	const struct playback_event *event;
	int event_count;
	int *passed;
	int capacity;
	int count;
};

static void pass(struct crossing *crossing, int index)
{
	if (crossing->count < crossing->capacity) {
		crossing->passed[crossing->count] = crossing->event[index].id;
	}
	crossing->count++;
}

/* The events exactly at a time, where a pass through the clip begins. */
static void pass_at(struct crossing *crossing, double time_s)
{
	for (int i = 0; i < crossing->event_count; i++) {
		if ((double)crossing->event[i].time_s == time_s) {
			pass(crossing, i);
		}
	}
}

/* The events between two times, including those at the second one. */
static void pass_between(struct crossing *crossing, double from_s, double to_s)
{
	int last = crossing->event_count - 1;

	for (int i = 0; i <= last; i++) {
		int forward = to_s >= from_s;
		int index = forward ? i : last - i;
		double at_s = crossing->event[index].time_s;

		if (forward ? at_s > from_s && at_s <= to_s
			    : at_s < from_s && at_s >= to_s) {
			pass(crossing, index);
		}
	}
}

/* Continues at an end of the clip. */
static void turn_round(
	struct playback *playback, bool forward, struct crossing *crossing)
{
	switch (playback->repeat) {
	case CLIP_ONCE:
		playback->finished = true;
		break;
	case CLIP_LOOP:
		playback->time_s = forward ? 0 : playback->duration_s;
		pass_at(crossing, playback->time_s);
		break;
	case CLIP_PING_PONG:
		playback->returning = !playback->returning;
		break;
	}
}

/* Leaves out whole rounds, which end where they begin, but a few. */
static double drop_rounds(const struct playback *playback, double left_s)
{
	const double kept = 4;
	double round_s = 2.0 * playback->duration_s;
	double rounds = left_s / round_s;

	if (playback->repeat == CLIP_ONCE || rounds < kept) {
		return left_s;
	}
	if (!(rounds < 2147483647.0)) {
		return 0;
	}
	return left_s - ((double)(int32_t)rounds - kept + 1) * round_s;
}

/* Runs through left_s of clip time in one direction. */
static void run(struct playback *playback, double left_s, bool backwards,
	struct crossing *crossing)
{
	left_s = drop_rounds(playback, left_s);
	while (left_s > 0 && !playback->finished) {
		bool forward = playback->returning == backwards;
		double from_s = playback->time_s;
		double end_s = forward ? playback->duration_s - from_s : from_s;

		if (left_s < end_s) {
			playback->time_s = within(playback,
				from_s + (forward ? left_s : -left_s));
			pass_between(crossing, from_s, playback->time_s);
			return;
		}
		playback->time_s = forward ? playback->duration_s : 0;
		pass_between(crossing, from_s, playback->time_s);
		left_s -= end_s;
		turn_round(playback, forward, crossing);
	}
}

int playback_advance(struct playback *playback, double step_s,
	const struct playback_event *event, int event_count, int *passed,
	int capacity)
{
	struct crossing crossing = {event, event_count, passed, capacity, 0};
	double advance_s = step_s * (double)playback->speed;

	if (!playback->begun) {
		playback->begun = true;
		pass_at(&crossing, playback->time_s);
	}
	if (!(playback->duration_s > 0)) {
		playback->finished = playback->repeat == CLIP_ONCE;
		return crossing.count;
	}
	if (advance_s < 0 || advance_s > 0) {
		/* A finished playback may still run back from its end. */
		playback->finished = false;
		run(playback, advance_s < 0 ? -advance_s : advance_s,
			advance_s < 0, &crossing);
	}
	return crossing.count;
}
