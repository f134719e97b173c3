#include "app/model/examine/examine.h"

#include "platform/base/scalar.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	CLIP_NAME_BYTES = 100,
	SUBJECT_BYTES = CLIP_NAME_BYTES + 40,
	/* More clips with the same finding share a line, as 60 objects may. */
	MOST_LINES = 4
};

/* What is told about single clips. */
enum kind {
	CUBIC,
	CUBIC_WEIGHTS,
	LATE_MOTION,
	LATE_KEYS,
	LATE_CHANNELS,
	EARLY_ENDS,
	SINGLE_KEYS,
	STEPS,
	LONG_ARCS,
	LONG_SPLINES,
	KINDS
};

/* All clips are asked twice: first they are counted, then they are told. */
struct report {
	const struct examiner *examiner;
	bool is_counting;
	int count[KINDS]; /* of clips */
	int told[KINDS];
};

/* A clip and how findings call it. */
struct named_clip {
	const struct model_clip *clip;
	char name[CLIP_NAME_BYTES];
	struct report *report;
	char subject[SUBJECT_BYTES]; /* with which the finding begins */
};

/* The number stands before a name that another clip has, and for no name. */
static struct named_clip name_clip(const struct model *model, int number,
	bool is_unique, struct report *report)
{
	const struct model_clip *clip = &model->clip[number];
	struct named_clip named = {.clip = clip, .report = report};
	char digits[16];

	snprintf(digits, sizeof(digits), "%d", number);
	snprintf(named.name, sizeof(named.name), "%s%s%s",
		is_unique ? "" : digits,
		is_unique || !clip->name[0] ? "" : ", ", clip->name);
	return named;
}

/*
 * Notes that a clip has a finding. Returns true if it is now to be told, and
 * then sets its subject.
 */
static bool is_told(struct named_clip *named, enum kind kind)
{
	struct report *report = named->report;
	bool shared = report->count[kind] > MOST_LINES;

	if (report->is_counting) {
		report->count[kind]++;
		return false;
	}
	if (shared && report->told[kind] > 0) {
		return false;
	}
	report->told[kind]++;
	if (shared) {
		snprintf(named->subject, sizeof(named->subject),
			"%d clips, such as %s", report->count[kind],
			named->name);
	} else {
		snprintf(named->subject, sizeof(named->subject), "clip %s",
			named->name);
	}
	return true;
}

static void report_count(struct named_clip *named, enum kind kind, int count,
	const char *feature, const char *treatment)
{
	if (count > 0 && is_told(named, kind)) {
		examine_report(named->report->examiner, "%s: %s (%d): %s",
			named->subject, feature, count, treatment);
	}
}

static void report_cubic(struct named_clip *named)
{
	const struct model_clip *clip = named->clip;
	int cubic = 0, weights = 0;

	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];

		if (channel->interpolation == MODEL_CUBICSPLINE) {
			cubic++;
			weights += channel->path == MODEL_WEIGHTS;
		}
	}
	report_count(named, CUBIC, cubic, "CUBICSPLINE channels",
		"limber multiplies their tangents by the interval between keys, and normalises rotations afterwards");
	if (weights > 0 && is_told(named, CUBIC_WEIGHTS)) {
		examine_report(named->report->examiner,
			"%s: cubic morph weights (%d channels): each key holds all in-tangents, then all values, then all out-tangents",
			named->subject, weights);
	}
}

/* Programs whose animations begin at frame 1 write such clips. */
static void report_late_start(
	struct named_clip *named, float earliest_s, float latest_s)
{
	const struct model_clip *clip = named->clip;
	const struct examiner *examiner = named->report->examiner;
	bool leads = clip->lead_s > 0.0f;

	if (leads && is_told(named, LATE_MOTION)) {
		examine_report(examiner,
			"%s: nothing moves before %.4f s; limber holds the first pose until then when the clip begins, but later rounds of a loop begin there",
			named->subject, (double)clip->lead_s);
	}
	if (!leads && earliest_s > 0.0f && is_told(named, LATE_KEYS)) {
		examine_report(examiner,
			"%s: no key lies before %.4f s; limber holds the first pose until then, each time the clip begins again: export it from frame 0",
			named->subject, (double)earliest_s);
	}
	if (latest_s > earliest_s && latest_s > clip->lead_s &&
		is_told(named, LATE_CHANNELS)) {
		examine_report(examiner,
			"%s: some first keys lie up to %.4f s after the start; limber holds the value of such a key until then",
			named->subject, (double)latest_s);
	}
}

static void report_first_and_last_keys(struct named_clip *named)
{
	const struct model_clip *clip = named->clip;
	float latest_s = 0.0f, soonest_end_s = clip->duration_s;
	float earliest_s = clip->channel_count > 0 ? clip->duration_s : 0.0f;

	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];
		float begin_s = channel->time_s[0];
		float end_s = channel->time_s[channel->key_count - 1];

		latest_s = scalar_max(begin_s, latest_s);
		earliest_s = scalar_min(begin_s, earliest_s);
		if (channel->key_count > 1 && end_s < soonest_end_s) {
			soonest_end_s = end_s;
		}
	}
	report_late_start(named, earliest_s, latest_s);
	if (soonest_end_s < clip->duration_s && is_told(named, EARLY_ENDS)) {
		examine_report(named->report->examiner,
			"%s: some channels end at %.4f s of %.4f s; limber holds the value of their last key",
			named->subject, (double)soonest_end_s,
			(double)clip->duration_s);
	}
}

static void report_key_kinds(struct named_clip *named)
{
	const struct model_clip *clip = named->clip;
	int step = 0, single = 0, linear = 0;

	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];

		single += channel->key_count == 1;
		step += channel->key_count > 1 &&
			channel->interpolation == MODEL_STEP;
		linear += channel->key_count > 1 &&
			channel->interpolation == MODEL_LINEAR;
	}
	report_count(named, SINGLE_KEYS, single, "channels with a single key",
		"limber uses its value at every time");
	if (step > 0 && is_told(named, STEPS)) {
		examine_report(named->report->examiner,
			"%s: STEP channels (%d)%s: limber interpolates each channel in its own mode",
			named->subject, step,
			linear > 0 ? " beside LINEAR ones" : "");
	}
}

static float key_dot(const struct model_channel *channel, int key)
{
	int wide = channel->interpolation == MODEL_CUBICSPLINE ? 12 : 4;
	int middle = wide == 12 ? 4 : 0;
	const float *a = channel->value + key * wide + middle;
	const float *b = a + wide;

	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

static int count_long_arcs(const struct model_channel *channel)
{
	int keys = 0;

	for (int k = 0;
		channel->path == MODEL_ROTATION && k < channel->key_count - 1;
		k++) {
		keys += key_dot(channel, k) < 0.0f;
	}
	return keys;
}

/* Keys of STEP channels have no arcs between them. */
static void report_long_arcs(struct named_clip *named)
{
	const struct model_clip *clip = named->clip;
	int linear = 0, cubic = 0;

	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];

		if (channel->interpolation == MODEL_LINEAR) {
			linear += count_long_arcs(channel);
		} else if (channel->interpolation == MODEL_CUBICSPLINE) {
			cubic += count_long_arcs(channel);
		}
	}
	report_count(named, LONG_ARCS, linear,
		"rotation keys with a negative dot product to the key before",
		"limber negates them, so that the rotation takes the shorter arc");
	report_count(named, LONG_SPLINES, cubic,
		"CUBICSPLINE rotation keys with a negative dot product to the key before",
		"limber follows the spline as glTF defines it, which turns the longer way there; if this is not meant, export sampled keys");
}

enum {
	PATHS = MODEL_WEIGHTS + 1
};

/* Which clips move one path of a node. */
struct moved {
	int clips, channels; /* clips and channels that move it */
	int last_clip;       /* number of the last such clip, counted from 1 */
};

/* moved is scratch memory of zeros, [node_count]. */
static void report_unshared_channels(const struct model *model,
	struct moved (*moved)[PATHS], const struct examiner *examiner)
{
	int left = 0;

	for (int c = 0; c < model->clip_count; c++) {
		const struct model_clip *clip = &model->clip[c];

		for (int i = 0; i < clip->channel_count; i++) {
			const struct model_channel *channel = &clip->channel[i];
			struct moved *one = &moved[channel->node][channel->path];

			one->clips += one->last_clip != c + 1;
			one->last_clip = c + 1;
			one->channels++;
		}
	}
	for (int n = 0; n < model->node_count; n++) {
		for (int path = 0; path < PATHS; path++) {
			const struct moved *one = &moved[n][path];

			left += one->clips < model->clip_count ? one->channels
							       : 0;
		}
	}
	if (left > 0) {
		examine_report(examiner,
			"channels of a node that another clip does not move (%d, in %d clips): when limber changes to that clip, the node returns to its rest pose",
			left, model->clip_count);
	}
}

/* Returns 0 or -ENOMEM. */
static int report_apart(const struct model *model, struct arena *arena,
	const struct examiner *examiner)
{
	bool *moved = ARENA_ARRAY(arena, bool, (size_t)model->node_count);
	int *clip = ARENA_ARRAY(arena, int, (size_t)model->clip_count);
	int count;

	if (!moved || !clip) {
		return -ENOMEM;
	}
	count = model->clip_count > 0 ? model_clips_apart(model, 0, moved, clip)
				      : 0;
	if (count > 1) {
		examine_report(examiner,
			"clips that each move nodes of their own (%d of %d), such as a clip for each object: limber plays one at a time; limber character suggests layers that play them together",
			count, model->clip_count);
	}
	return 0;
}

static int compare_names(const void *left, const void *right)
{
	return strcmp(*(const char *const *)left, *(const char *const *)right);
}

/* Sorts the names. Returns how many are equal to the one before. */
static int count_equal(const char **name, int count)
{
	int equal = 0;

	qsort(name, (size_t)count, sizeof(name[0]), compare_names);
	for (int i = 1; i < count; i++) {
		equal += strcmp(name[i - 1], name[i]) == 0;
	}
	return equal;
}

/* Returns 0 or -ENOMEM. */
static int report_equal_names(const struct model *model, struct arena *arena,
	const struct examiner *examiner)
{
	const char **clip =
		ARENA_ARRAY(arena, const char *, (size_t)model->clip_count);
	const char **node =
		ARENA_ARRAY(arena, const char *, (size_t)model->node_count);
	int clips = 0, nodes = 0;

	if (!clip || !node) {
		return -ENOMEM;
	}
	for (int i = 0; i < model->clip_count; i++) {
		if (model->clip[i].name[0]) {
			clip[clips++] = model->clip[i].name;
		}
	}
	for (int i = 0; i < model->node_count; i++) {
		if (model->node[i].name[0]) {
			node[nodes++] = model->node[i].name;
		}
	}
	examine_count(examiner, count_equal(clip, clips),
		"clips with the name of an earlier clip",
		"limber finds the earlier one by this name, and the others by their numbers, which limber info lists");
	examine_count(examiner, count_equal(node, nodes),
		"nodes with the name of an earlier node",
		"character files find the earlier one by this name; give the others names of their own if you refer to them");
	return 0;
}

/* Compares pointers to clips by their names. */
static int compare_clips(const void *left, const void *right)
{
	const struct model_clip *const *a = left, *const *b = right;

	return strcmp((*a)->name, (*b)->name);
}

/*
 * Finds which clips have a name that no other clip has; [clip_count]. Returns
 * NULL without memory.
 */
static const bool *find_unique(const struct model *model, struct arena *arena)
{
	const size_t count = (size_t)model->clip_count;
	bool *unique = ARENA_ARRAY(arena, bool, count);
	const struct model_clip **clip =
		ARENA_ARRAY(arena, const struct model_clip *, count);

	if (!unique || !clip) {
		return NULL;
	}
	for (size_t i = 0; i < count; i++) {
		clip[i] = &model->clip[i];
		unique[i] = clip[i]->name[0] != '\0';
	}
	qsort(clip, count, sizeof(clip[0]), compare_clips);
	for (size_t i = 1; i < count; i++) {
		if (compare_clips(&clip[i - 1], &clip[i]) == 0) {
			unique[clip[i - 1] - model->clip] = false;
			unique[clip[i] - model->clip] = false;
		}
	}
	return unique;
}

static void report_all(
	const struct model *model, const bool *unique, struct report *report)
{
	for (int i = 0; i < model->clip_count; i++) {
		struct named_clip named = name_clip(model, i, unique[i], report);

		report_cubic(&named);
		report_first_and_last_keys(&named);
		report_key_kinds(&named);
		report_long_arcs(&named);
	}
}

/* Returns 0 or -ENOMEM. */
static int report_each(const struct model *model, struct arena *arena,
	const struct examiner *examiner)
{
	struct report report = {.examiner = examiner, .is_counting = true};
	const bool *unique = find_unique(model, arena);

	if (!unique) {
		return -ENOMEM;
	}
	report_all(model, unique, &report);
	report.is_counting = false;
	report_all(model, unique, &report);
	return 0;
}

static void report_matrices(
	const struct model *model, const struct examiner *examiner)
{
	int nodes = 0;

	for (int i = 0; i < model->node_count; i++) {
		nodes += model->node[i].matrix != NULL;
	}
	examine_count(examiner, nodes, "nodes with a sheared matrix",
		"translation, rotation and scale cannot express shear, so limber keeps the matrix");
}

int examine_clips(const struct model *model, const struct examiner *examiner,
	const struct log *log)
{
	struct arena arena = arena_empty();
	struct moved(*moved)[PATHS] =
		arena_alloc(&arena, (size_t)model->node_count, sizeof(*moved));
	int error;

	if (!moved) {
		return memory_budget_fail(model->budget, model->path, log);
	}
	error = report_each(model, &arena, examiner);
	report_unshared_channels(model, moved, examiner);
	error = error ? error : report_apart(model, &arena, examiner);
	if (!error) {
		error = report_equal_names(model, &arena, examiner);
	}
	report_matrices(model, examiner);
	arena_release(&arena);
	return error ? memory_budget_fail(model->budget, model->path, log) : 0;
}
