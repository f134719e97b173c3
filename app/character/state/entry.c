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

float character_entry_sole_m(const struct character_entry *entry)
{
	const float *sole_m = entry->of->sole_m;
	float duration_s = character_entry_duration_s(entry), at, beyond;
	int sample;

	if (duration_s <= 0) {
		return sole_m[0];
	}
	at = entry->shown_s / duration_s * CHARACTER_SAMPLES;
	sample = scalar_to_int((double)at, 0, CHARACTER_SAMPLES - 1);
	beyond = scalar_clamp(at - (float)sample, 0, 1);
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

/*
 * Divides a phase of at least 0 into whole rounds of the clip, which it
 * returns, a mark of the clip and the way from there to the next mark, 0..1.
 */
static int split_phase(const struct character_clip *clip, double phase,
	int *mark, float *beyond)
{
	int count = clip->mark_count;
	int rounds = scalar_to_int(phase / (double)count, 0, ROUNDS_MAX);
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

void character_entry_move(
	struct character_entry *entry, double step_s, double phase)
{
	const struct character_clip *clip = entry->of;
	float beyond;
	int mark, rounds;

	if (phase < 0 || clip->mark_count == 0) {
		entry->time_s += step_s;
		return;
	}
	rounds = split_phase(clip, phase, &mark, &beyond);
	entry->time_s = (double)rounds * (double)clip->clip->duration_s +
		(double)(clip->mark[mark] + beyond * interval_s(clip, mark));
}

/* Returns true if time_s lies on the way from one time of a clip to another. */
static bool is_passed(
	float time_s, float from_s, float to_s, enum clip_repeat repeat)
{
	if (to_s >= from_s) {
		return time_s > from_s && time_s <= to_s;
	}
	if (repeat == CLIP_LOOP) {
		return time_s > from_s || time_s <= to_s;
	}
	return time_s >= to_s && time_s < from_s;
}

/* Adds the actions of the events between before_s and the time shown. */
static void add_events(struct character *character,
	const struct character_entry *entry, enum clip_repeat repeat,
	float before_s)
{
	for (const struct character_event *event = entry->of->event; event;
		event = event->next) {
		if (is_passed(event->time_s, before_s, entry->shown_s, repeat)) {
			character_pending_add(character, event->action, 1);
		}
	}
}

/*
 * Advances the shown time to that of the entry, and adds the events on the way.
 */
static void show(struct character *character, struct character_entry *entry,
	enum clip_repeat repeat, double phase)
{
	bool in_phase = phase >= 0 && entry->of->mark_count > 0;
	float before_s = entry->shown_s;

	entry->shown_s =
		clip_time(entry->time_s, character_entry_duration_s(entry),
			in_phase ? CLIP_LOOP : repeat);
	/*
	 * Of two clips in a blend, only the one with more weight causes events.
	 */
	if (entry->weight > 0.5f && !(in_phase && before_s < 0)) {
		add_events(character, entry, repeat, before_s);
	}
}

/* Takes the travel of the motion's root out of the pose. */
static void stay(const struct character *character,
	const struct character_entry *entry, float amount, struct pose *pose)
{
	int root = character->motion.root;
	float duration_s = character_entry_duration_s(entry);

	if (root >= 0 && duration_s > 0) {
		vec_add_scaled(pose->local[root].translation, entry->of->travel,
			-entry->shown_s / duration_s * amount,
			pose->local[root].translation);
	}
}

void character_entry_sample(struct character *character,
	struct character_entry *entry, enum clip_repeat repeat, double phase,
	struct pose *pose)
{
	if (!entry->of->clip) {
		pose_copy(pose, &character->still);
		return;
	}
	show(character, entry, repeat, phase);
	clip_pose(entry->of->clip, entry->shown_s, character->interpolation,
		&entry->cursor, pose);
	stay(character, entry, 1, pose);
}

void character_entry_mix(struct character *character,
	struct character_entry *entry, enum clip_repeat repeat, double phase,
	float amount, struct pose *pose)
{
	const float *only = entry->cursor.only;
	int root = character->motion.root;

	if (entry->of->clip) {
		show(character, entry, repeat, phase);
	}
	clip_mix(entry->of->clip, entry->shown_s, character->interpolation,
		amount, &entry->cursor, pose);
	stay(character, entry, only && root >= 0 ? amount * only[root] : amount,
		pose);
}
