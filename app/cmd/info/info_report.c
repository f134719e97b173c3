#include "app/cmd/info/info_report.h"

#include "app/scene/instance/lod.h"

#include <errno.h>
#include <stdlib.h>

/* Returns the size of a drawable's posed positions and normals. */
static size_t posed_bytes(const struct drawable *drawable)
{
	size_t vectors = drawable->normal ? 2 : 1;

	return (size_t)drawable->primitive->vertex_count * vectors *
		sizeof(float[3]);
}

/* Finds unit_m of each mesh. The instance is in the rest pose. */
static void find_units(const struct instance *instance, float *unit_m)
{
	const struct model *model = instance->model;

	for (int m = 0; m < model->mesh_count; m++) {
		unit_m[m] = 1.0f;
	}
	for (int i = instance->drawable_count - 1; i >= 0; i--) {
		const struct drawable *drawable = &instance->drawable[i];

		unit_m[model->node[drawable->node].mesh] =
			lod_error_units(instance, drawable) /
			instance->unit_scale;
	}
}

int info_measure(const struct model *model, const struct log *log,
	struct info_report *out)
{
	struct instance *instance;
	int error = instance_create(model, &kernel_float, log, &instance);

	if (error) {
		return error;
	}
	*out = (struct info_report){
		.model = model,
		.unit_m = malloc((size_t)model->mesh_count * sizeof(float) + 1),
	};
	if (!out->unit_m) {
		instance_destroy(instance);
		return memory_budget_fail(NULL, model->path, log);
	}
	find_units(instance, out->unit_m);
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

void info_release(struct info_report *report)
{
	free(report->unit_m);
	report->unit_m = NULL;
}
