#include "app/cmd/info/info_report.h"

#include "app/scene/instance/instance.h"

#include <errno.h>

/* Returns the size of a drawable's posed positions and normals. */
static size_t posed_bytes(const struct drawable *drawable)
{
	size_t vectors = drawable->normal ? 2 : 1;

	return (size_t)drawable->primitive->vertex_count * vectors *
		sizeof(float[3]);
}

int info_measure(const struct model *model, const struct log *log,
	struct info_report *out)
{
	struct instance *instance;
	int error = instance_create(model, &kernel_float, log, &instance);

	if (error) {
		return error;
	}
	*out = (struct info_report){.model = model};
	model_measure(model, &out->stats);
	out->hierarchical_bytes = (size_t)model->node_count *
		(sizeof(struct transform) + sizeof(mat4));
	out->morphing_bytes = out->stats.target_bytes;
	for (int i = 0; i < model->skin_count; i++) {
		out->joint_count += model->skin[i].joint_count;
	}
	if (model->skin_count > 0) {
		out->skeletal_bytes = (size_t)out->joint_count * sizeof(mat4);
	}
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		if (drawable->morphed) {
			out->morphing_bytes += posed_bytes(drawable);
		}
		if (drawable->skin >= 0) {
			out->skeletal_bytes += posed_bytes(drawable) +
				skin_stream_bytes(&drawable->stream);
		}
	}
	instance_destroy(instance);
	return 0;
}
