#include "app/character/state/entry.h"

#include "app/anim/math/vec.h"
#include "app/character/run/pending.h"

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

/* The time between a mark and the next one, which may be in the next round. */
static float interval_s(const struct character_clip *clip, int mark)
{
	if (mark + 1 < clip->mark_count) {
		return clip->mark[mark + 1] - clip->mark[mark];
	}
	return clip->clip->duration_s - clip->mark[mark] + clip->mark[0];
}

/* The phase in one round, 0..mark_count, as a mark and what is beyond it. */
static int split_phase(
	const struct character_clip *clip, double phase, float *beyond)
{
	double rounds = phase / (double)clip->mark_count;
	double within =
		(rounds - (double)(int64_t)rounds) * (double)clip->mark_count;
	int mark;

	if (within < 0) {
		within += (double)clip->mark_count;
	}
	mark = (int)within;
	mark = mark < clip->mark_count ? mark : clip->mark_count - 1;
	*beyond = (float)(within - (double)mark);
	return mark;
}

float character_entry_marks_per_s(
	const struct character_entry *entry, double phase)
{
	float beyond;
	int mark = split_phase(entry->of, phase, &beyond);

	return 1 / interval_s(entry->of, mark);
}

void character_entry_move(
	struct character_entry *entry, double step_s, double phase)
{
	const struct character_clip *clip = entry->of;
	float beyond;
	int mark;

	if (phase < 0 || clip->mark_count == 0) {
		entry->time_s += step_s;
		return;
	}
	mark = split_phase(clip, phase, &beyond);
	entry->time_s = (double)(int64_t)(phase / (double)clip->mark_count) *
			(double)clip->clip->duration_s +
		(double)(clip->mark[mark] + beyond * interval_s(clip, mark));
}

/* Whether time_s was passed on the way from one time of a clip to another. */
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

void character_entry_sample(struct character *character,
	struct character_entry *entry, enum clip_repeat repeat, double phase,
	struct pose *pose)
{
	const struct character_clip *of = entry->of;
	bool in_phase = phase >= 0 && of->mark_count > 0;
	float before_s = entry->shown_s;
	float duration_s = character_entry_duration_s(entry);
	int root = character->motion.root;

	if (!of->clip) {
		pose_copy(pose, &character->still);
		return;
	}
	entry->shown_s = clip_time(
		entry->time_s, duration_s, in_phase ? CLIP_LOOP : repeat);
	clip_pose(of->clip, entry->shown_s, character->interpolation,
		&entry->cursor, pose);
	if (root >= 0 && duration_s > 0) {
		vec_add_scaled(pose->local[root].translation, of->travel,
			-entry->shown_s / duration_s,
			pose->local[root].translation);
	}
	/* Of two clips in a blend, the one with more weight is heard. */
	if (entry->weight <= 0.5f || (in_phase && before_s < 0)) {
		return;
	}
	for (const struct character_event *event = of->event; event;
		event = event->next) {
		if (is_passed(event->time_s, before_s, entry->shown_s, repeat)) {
			character_pending_add(character, event->action, 1);
		}
	}
}
