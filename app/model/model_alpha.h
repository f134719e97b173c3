/* Whether a primitive must be blended or masked. */
#ifndef APP_MODEL_MODEL_ALPHA_H
#define APP_MODEL_MODEL_ALPHA_H

#include "app/model/model.h"

/*
 * Returns the material's alpha mode, but MODEL_OPAQUE if all of the primitive
 * is opaque: some exporters mark whole models as blended or masked.
 */
enum model_alpha model_alpha_of(
	const struct model *model, const struct model_primitive *primitive);

/*
 * Returns false if nothing of the primitive can be seen: if it is masked or
 * blended, and its base colour and the colours of its vertices have too little
 * alpha.
 */
bool model_alpha_is_seen(
	const struct model *model, const struct model_primitive *primitive);

/*
 * Returns the mean alpha of the primitive's surface without its texture, 0..1.
 */
float model_alpha_mean(
	const struct model *model, const struct model_primitive *primitive);

#endif
