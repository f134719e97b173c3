/*
 * What of a model file players are known to get wrong.
 *
 * Every sentence names a pitfall that the file holds, with figures, and what
 * limber does there: so an engineer who sees a model move wrongly elsewhere
 * knows where to look.
 */
#ifndef APP_MODEL_EXAMINE_EXAMINE_H
#define APP_MODEL_EXAMINE_EXAMINE_H

#include "app/model/model.h"

/* Who is told; sentences are valid during the call. */
struct examiner {
	void (*say)(void *context, const char *sentence);
	void *context;
};

/*
 * Loads the file and tells its pitfalls; none is a good answer. 0, or -errno
 * after one sentence, as model_load().
 */
int model_examine(const char *path, const struct examiner *examiner,
	const struct log *log);

/* For the formats: what can be seen in any loaded model. */
void examine_clips(const struct model *model, const struct examiner *examiner);
void examine_skins(const struct model *model, const struct examiner *examiner);

/* Tells a sentence put together as by printf(), of up to 400 letters. */
void examine_say(const struct examiner *examiner, const char *format, ...)
	PRINTF_LIKE(2, 3);

#endif
