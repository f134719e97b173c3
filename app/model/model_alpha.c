#include "app/model/model_alpha.h"

/* Half a step of a picture's colours. */
static const float least_seen = 0.5f / 255.0f;

/*
 * Returns the least alpha of the primitive's surface, 0..1; 0 if a texture has
 * alpha.
 */
static float find_least(
	const struct model *model, const struct model_primitive *primitive)
{
	const struct model_material *material =
		&model->material[primitive->material];
	int least = 255;

	if (material->texture >= 0 && primitive->texcoord) {
		int image = model->texture[material->texture].image;

		if (!model->image[image].opaque) {
			return 0.0f;
		}
	}
	for (int v = 0; primitive->color && v < primitive->vertex_count; v++) {
		int alpha = primitive->color[v][3];

		least = alpha < least ? alpha : least;
	}
	return material->base_color[3] * (float)least / 255.0f;
}

enum model_alpha model_alpha_of(
	const struct model *model, const struct model_primitive *primitive)
{
	const struct model_material *material =
		&model->material[primitive->material];
	float opaque =
		material->alpha == MODEL_MASK ? material->alpha_cutoff : 1.0f;

	return material->alpha != MODEL_OPAQUE &&
			find_least(model, primitive) >= opaque
		? MODEL_OPAQUE
		: material->alpha;
}

bool model_alpha_is_seen(
	const struct model *model, const struct model_primitive *primitive)
{
	const struct model_material *material =
		&model->material[primitive->material];
	int most = primitive->color ? 0 : 255;
	float needed = material->alpha == MODEL_MASK ? material->alpha_cutoff
		: material->alpha == MODEL_BLEND     ? least_seen
						     : 0.0f;

	for (int v = 0; primitive->color && v < primitive->vertex_count; v++) {
		int alpha = primitive->color[v][3];

		most = alpha > most ? alpha : most;
	}
	return material->base_color[3] * (float)most / 255.0f >= needed;
}

float model_alpha_mean(
	const struct model *model, const struct model_primitive *primitive)
{
	float alpha = model->material[primitive->material].base_color[3];
	int64_t sum = 0;

	if (!primitive->color || primitive->vertex_count == 0) {
		return alpha;
	}
	for (int v = 0; v < primitive->vertex_count; v++) {
		sum += primitive->color[v][3];
	}
	return alpha * (float)sum / (255.0f * (float)primitive->vertex_count);
}
