#include "app/character/state/entry.h"

#include "app/anim/math/vec.h"
#include "app/character/run/pending.h"

enum {
	ROUNDS_MAX = 1 << 30
};

float character_entry_duration_s(const struct character_entry *entry)
{
	return entry->of->clip ? entry->of->clip->duration_s : 0;
}

float character_entry_sole_m(const struct character_entry *entry, int pair)
{
	const float *sole_m = entry->of->sole_m[pair];
	float duration_s = character_entry_duration_s(entry), at, beyond;
	int sample;

	if (duration_s <= 0) {
		return sole_m[0];
	}
	at = entry->shown_s / duration_s * CHARACTER_SAMPLES;
	sample = scalar_to_int((double)at, 0, CHARACTER_SAMPLES - 1);
	beyond = scalar_max(at - (float)sample, 0);
	return sole_m[sample] * (1 - beyond) +
		sole_m[(sample + 1) % CHARACTER_SAMPLES] * beyond;
}

/* Returns the time from a mark to the next, which may be in the next round. */
static float interval_s(const struct character_clip *clip, int mark)
{
	if (mark + 1 < clip->mark_count) {
		return clip->mark[mark + 1] - clip->mark[mark];
	}
	return clip->clip->duration_s - clip->mark[mark] + clip->mark[0];
}

/* Returns the largest integer that is not above value, within ROUNDS_MAX. */
static int floor_to_int(double value)
{
	int cut = scalar_to_int(value, -ROUNDS_MAX, ROUNDS_MAX);

	return (double)cut > value ? cut - 1 : cut;
}

/*
 * Divides a phase into whole rounds of the clip, which it returns, a mark of
 * the clip and the way from there to the next mark, 0..1.
 */
static int split_phase(const struct character_clip *clip, double phase,
	int *mark, float *beyond)
{
	int count = clip->mark_count;
	int rounds = floor_to_int(phase / (double)count);
	double within = phase - (double)rounds * (double)count;

	*mark = scalar_to_int(within, 0, count - 1);
	*beyond = (float)(within - (double)*mark);
	return rounds;
}

float character_entry_marks_per_s(
	const struct character_entry *entry, double phase)
{
	float beyond;
	int mark;

	split_phase(entry->of, phase, &mark, &beyond);
	return 1 / interval_s(entry->of, mark);
}

void character_entry_begin(struct character_entry *entry, double time_s)
{
	entry->time_s = entry->before_s = time_s;
	entry->shown_s = -1;
}

void character_entry_move(
	struct character_entry *entry, double step_s, const double *phase)
{
	const struct character_clip *clip = entry->of;
	float beyond;
	int mark, rounds;

	entry->before_s = entry->time_s;
	if (!phase || clip->mark_count == 0) {
		entry->time_s += step_s;
		return;
	}
	rounds = split_phase(clip, *phase, &mark, &beyond);
	entry->time_s = (double)rounds * (double)clip->clip->duration_s +
		(double)(clip->mark[mark] + beyond * interval_s(clip, mark));
	/* It begins anywhere in the clip, without a way from its start. */
	if (entry->shown_s < 0) {
		entry->before_s = entry->time_s;
	}
}

/* Returns true if time_s lies after from_s on the direct way to to_s. */
static bool is_between(float time_s, float from_s, float to_s)
{
	return to_s >= from_s ? time_s > from_s && time_s <= to_s
			      : time_s >= to_s && time_s < from_s;
}

/*
 * Returns true if the last step reached time_s of a clip that turns at its
 * ends. The way there and the way back are legs, counted from the start.
 */
static bool is_passed_to_and_fro(
	const struct character_entry *entry, float time_s, float from_s)
{
	double duration_s = (double)entry->of->clip->duration_s;
	int before = floor_to_int(entry->before_s / duration_s);
	int now = floor_to_int(entry->time_s / duration_s);
	bool forwards = entry->time_s >= entry->before_s;
	bool rises = (before % 2 == 0) == forwards;
	float end_s = rises ? (float)duration_s : 0;

	if (before == now) {
		return is_between(time_s, from_s, entry->shown_s);
	}
	return is_between(time_s, from_s, end_s) ||
		is_between(time_s, end_s, entry->shown_s);
}

/* The same for a clip that begins again at its other end. */
static bool is_passed_in_loop(
	const struct character_entry *entry, float time_s, float from_s)
{
	bool forwards = entry->time_s >= entry->before_s;
	float to_s = entry->shown_s;

	if (forwards == (to_s >= from_s) || to_s == from_s) {
		return is_between(time_s, from_s, to_s);
	}
	return forwards ? time_s > from_s || time_s <= to_s
			: time_s < from_s || time_s >= to_s;
}

/* Returns true if the step from before_s to time_s reached a time of the clip. */
static bool is_passed(const struct character_entry *entry, float time_s,
	float from_s, enum clip_repeat repeat)
{
	double step_s = entry->time_s - entry->before_s;
	double duration_s = (double)entry->of->clip->duration_s;

	if (repeat == CLIP_ONCE || duration_s <= 0) {
		return is_between(time_s, from_s, entry->shown_s);
	}
	if (step_s >= duration_s || -step_s >= duration_s) {
		return true;
	}
	return repeat == CLIP_LOOP ? is_passed_in_loop(entry, time_s, from_s)
				   : is_passed_to_and_fro(entry, time_s, from_s);
}

/*
 * Adds the actions of the events on the way to the time shown, with those at
 * the start of the way if the clip begins.
 */
static void add_events(struct character *character,
	const struct character_entry *entry, enum clip_repeat repeat,
	bool begins)
{
	float from_s = clip_round_time(entry->of->clip, entry->before_s, repeat);

	for (const struct character_event *event = entry->of->event; event;
		event = event->next) {
		if ((begins && event->time_s == from_s) ||
			is_passed(entry, event->time_s, from_s, repeat)) {
			character_pending_add(character, event->action, 1);
		}
	}
}

void character_entry_show(struct character *character,
	struct character_entry *entry, enum clip_repeat repeat)
{
	bool begins = entry->shown_s < 0;

	entry->shown_s = clip_round_time(entry->of->clip, entry->time_s, repeat);
	if (entry->of->event && !entry->follows) {
		add_events(character, entry, repeat, begins);
	}
}

/* Takes the travel of the motion's root out of the pose. */
static void stay(const struct character *character,
	const struct character_entry *entry, float amount, struct pose *pose)
{
	const struct model_clip *clip = entry->of->clip;
	int root = character->motion.root;

	if (root >= 0 && clip) {
		vec_add_scaled(pose->local[root].translation, entry->of->travel,
			-clip_share(clip, entry->shown_s) * amount,
			pose->local[root].translation);
	}
}

void character_entry_sample(struct character *character,
	struct character_entry *entry, enum clip_repeat repeat,
	struct pose *pose)
{
	if (!entry->of->clip) {
		pose_copy(pose, &character->still);
		return;
	}
	character_entry_show(character, entry, repeat);
	clip_pose(entry->of->clip, entry->shown_s, character->interpolation,
		entry->cursor, pose);
	stay(character, entry, 1, pose);
}

void character_entry_mix(struct character *character,
	struct character_entry *entry, enum clip_repeat repeat, float amount,
	struct pose *pose)
{
	const float *only = entry->cursor->only;
	int root = character->motion.root;

	if (entry->of->clip) {
		character_entry_show(character, entry, repeat);
	}
	clip_mix(entry->of->clip, entry->shown_s, character->interpolation,
		amount, entry->cursor, pose);
	stay(character, entry, only && root >= 0 ? amount * only[root] : amount,
		pose);
}
