#include "app/anim/playback.h"

#include "platform/base/scalar.h"

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

void playback_seek(struct playback *playback, float time_s)
{
	playback->time_s = scalar_clamp(time_s, 0, playback->duration_s);
	playback->returning = false;
	playback->finished = false;
	playback->begun = false;
}

/* The events of one step, and where their ids go. */
struct crossing {
	const struct playback_event *event;
	int event_count;
	int *passed;
	int room;
	int count;
};

static void pass(struct crossing *crossing, int index)
{
	if (crossing->count < crossing->room) {
		crossing->passed[crossing->count] = crossing->event[index].id;
	}
	crossing->count++;
}

/* Those exactly where a pass through the clip begins. */
static void pass_at(struct crossing *crossing, float time_s)
{
	for (int i = 0; i < crossing->event_count; i++) {
		if (crossing->event[i].time_s == time_s) {
			pass(crossing, i);
		}
	}
}

/* Those on the way from one time to another, the latter included. */
static void pass_between(struct crossing *crossing, float from_s, float to_s)
{
	int last = crossing->event_count - 1;

	for (int i = 0; i <= last; i++) {
		int forward = to_s >= from_s;
		int index = forward ? i : last - i;
		float at_s = crossing->event[index].time_s;

		if (forward ? at_s > from_s && at_s <= to_s
			    : at_s < from_s && at_s >= to_s) {
			pass(crossing, index);
		}
	}
}

/* What happens at the end that the playback ran into. */
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

/* Leaves whole rounds out that nobody could tell apart. */
static double drop_rounds(const struct playback *playback, double way_s)
{
	const double kept = 4;
	double round_s = 2.0 * playback->duration_s;
	double rounds = way_s / round_s;

	if (playback->repeat == CLIP_ONCE || rounds < kept) {
		return way_s;
	}
	if (!(rounds < 2147483647.0)) {
		return 0;
	}
	return way_s - ((double)(int32_t)rounds - kept + 1) * round_s;
}

/* Runs way_s of clip time in one direction, end after end. */
static void run(struct playback *playback, double way_s, bool backwards,
	struct crossing *crossing)
{
	way_s = drop_rounds(playback, way_s);
	while (way_s > 0 && !playback->finished) {
		bool forward = playback->returning == backwards;
		float from_s = playback->time_s;
		double room_s = forward ? playback->duration_s - (double)from_s
					: from_s;

		if (way_s < room_s) {
			double to_s = from_s + (forward ? way_s : -way_s);

			playback->time_s = scalar_clamp(
				(float)to_s, 0, playback->duration_s);
			pass_between(crossing, from_s, playback->time_s);
			return;
		}
		playback->time_s = forward ? playback->duration_s : 0;
		pass_between(crossing, from_s, playback->time_s);
		way_s -= room_s;
		turn_round(playback, forward, crossing);
	}
}

int playback_advance(struct playback *playback, double step_s,
	const struct playback_event *event, int event_count, int *passed,
	int room)
{
	struct crossing crossing = {event, event_count, passed, room, 0};
	double way_s = step_s * (double)playback->speed;

	if (!playback->begun) {
		playback->begun = true;
		pass_at(&crossing, playback->time_s);
	}
	if (!(playback->duration_s > 0)) {
		playback->finished = playback->repeat == CLIP_ONCE;
		return crossing.count;
	}
	if (way_s < 0 || way_s > 0) {
		/* One that stands at an end may still leave it backwards. */
		playback->finished = false;
		run(playback, way_s < 0 ? -way_s : way_s, way_s < 0, &crossing);
	}
	return crossing.count;
}
