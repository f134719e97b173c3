/*
 * Findings of limber doctor about a model file: features that other players
 * often get wrong.
 *
 * Each finding names a feature of the file, how often it occurs, and what
 * limber does with it. An engineer who sees the model move wrongly in another
 * player learns where to look.
 */
#ifndef APP_MODEL_EXAMINE_EXAMINE_H
#define APP_MODEL_EXAMINE_EXAMINE_H

#include "app/model/model.h"

/* Receives the findings; a finding is valid during the call of report(). */
struct examiner {
	void (*report)(void *context, const char *finding);
	void *context;
};

/*
 * Loads the file and reports its findings, of which there may be none. Returns
 * 0, or -errno after one error, as model_load_within() does.
 */
int model_examine(const char *path, size_t memory_bytes,
	const struct examiner *examiner, const struct log *log);

/*
 * Report what a loaded model of any format shows. Loaders call these functions,
 * which return 0, or -ENOMEM after one error.
 */
int examine_clips(const struct model *model, const struct examiner *examiner,
	const struct log *log);
/* About clips that move nothing that is shown, as those of cameras. */
int examine_still_clips(const struct model *model,
	const struct examiner *examiner, const struct log *log);
int examine_skins(const struct model *model, const struct examiner *examiner,
	const struct log *log);
/* About levels of detail and shapes for collisions that are shown as well. */
int examine_spare(const struct model *model, const struct examiner *examiner,
	const struct log *log);

/*
 * Returns the number of primitives that some node shows with normals on the
 * other side than the front of their triangles, at rest, or -ENOMEM. Uses the
 * arena for arrays of its own.
 */
int examine_find_reversed(const struct model *model, struct arena *arena);

/*
 * Returns whether a figure with a head and a foot lies at rest, as one does
 * that was exported with +Z up, and these joints. is_joint has an element for
 * each node.
 */
bool examine_find_lying(
	const struct model *model, const bool *is_joint, int *head, int *foot);

/* Reports a finding formatted as by printf(), truncated to 400 bytes. */
void examine_report(const struct examiner *examiner, const char *format, ...)
	PRINTF_LIKE(2, 3);

/*
 * Reports "FEATURE (COUNT), such as NAME: TREATMENT", where NAME is that of the
 * clip with the number first, up to 99 bytes, or "clip FIRST" if it has none.
 */
void examine_report_clips(const struct examiner *examiner,
	const struct model *model, int count, int first, const char *feature,
	const char *treatment);

/* Reports "FEATURE (COUNT): TREATMENT", but nothing when count is 0. */
void examine_count(const struct examiner *examiner, int count,
	const char *feature, const char *treatment);

#endif
