#include "app/scene/instance/instance_play.h"

enum {
	DENSE_VERTICES = 8192
};

bool instance_is_dense(const struct model *model)
{
	for (int m = 0; m < model->mesh_count; m++) {
		const struct model_mesh *mesh = &model->mesh[m];

		for (int p = 0; p < mesh->primitive_count; p++) {
			const struct model_primitive *primitive =
				&mesh->primitive[p];

			if (primitive->influences > 0 &&
				primitive->vertex_count > DENSE_VERTICES) {
				return true;
			}
		}
	}
	return false;
}

int instance_create_to_play(const struct model *model,
	const struct kernel *kernel, const struct log *log,
	struct instance **out)
{
	return (instance_is_dense(model)
			? instance_create_for_drawing
			: instance_create)(model, kernel, log, out);
}
