/*
 * What the alpha of a primitive asks for.
 */
#ifndef APP_MODEL_MODEL_ALPHA_H
#define APP_MODEL_MODEL_ALPHA_H

#include "app/model/model.h"

/*
 * The material's way, or MODEL_OPAQUE if no alpha of the primitive's differs
 * from an opaque one's: exporters mark whole models as blended or masked.
 */
enum model_alpha model_alpha_of(
	const struct model *model, const struct model_primitive *primitive);

#endif
