#include "app/compare/export/export_bake.h"

#include <errno.h>
#include <stdlib.h>

/* Adds a part's vectors at one key frame minus those at the first. */
static int add_delta(struct glb *glb, const float (*from)[3],
	const float (*base)[3], int count)
{
	float(*delta)[3] = malloc((size_t)count * sizeof(*delta));
	int accessor;

	if (!delta) {
		glb->error = -ENOMEM;
		return -1;
	}
	for (int v = 0; v < count; v++) {
		for (int axis = 0; axis < 3; axis++) {
			delta[v][axis] = from[v][axis] - base[v][axis];
		}
	}
	accessor = glb_add_array(glb, delta, count, 3, GLB_FLOAT);
	free(delta);
	return accessor;
}

static json_t *targets_json(struct glb *glb, const struct reference *reference,
	const struct reference_part *part, const int *key, int key_count)
{
	json_t *targets = json_array();
	int first = part->first_vertex, count = part->vertex_count;

	for (int k = 1; k < key_count; k++) {
		json_t *target = json_object();

		export_attribute(target, "POSITION",
			add_delta(glb,
				reference_position(reference, key[k]) + first,
				reference_position(reference, key[0]) + first,
				count));
		if (part->normals) {
			export_attribute(target, "NORMAL",
				add_delta(glb,
					reference_normal(reference, key[k]) +
						first,
					reference_normal(reference, key[0]) +
						first,
					count));
		}
		json_array_append_new(targets, target);
	}
	return targets;
}

static json_t *primitive_json(struct glb *glb, const struct reference *reference,
	const struct reference_part *part, const int *key, int key_count)
{
	const struct model_primitive *primitive =
		reference->instance->drawable[part->drawable].primitive;
	json_t *attributes = json_object();
	int first = part->first_vertex;

	export_attribute(attributes, "POSITION",
		glb_add_array(glb, reference_position(reference, key[0]) + first,
			part->vertex_count, 3, GLB_FLOAT));
	if (part->normals) {
		export_attribute(attributes, "NORMAL",
			glb_add_array(glb,
				reference_normal(reference, key[0]) + first,
				part->vertex_count, 3, GLB_FLOAT));
	}
	export_attributes(glb, attributes, primitive, part->vertex_count, NULL);
	return json_pack("{s:o, s:i, s:i, s:o}", "attributes", attributes,
		"indices",
		glb_add_array(glb, primitive->index, primitive->index_count, 1,
			GLB_UINT),
		"material", primitive->material, "targets",
		targets_json(glb, reference, part, key, key_count));
}

/* At each key after the first, its own weight is 1 and all others are 0. */
static int add_weights(struct glb *glb, int key_count)
{
	size_t width = (size_t)key_count - 1;
	float *weight = calloc((size_t)key_count * width, sizeof(*weight));
	int accessor;

	if (!weight) {
		glb->error = -ENOMEM;
		return -1;
	}
	for (size_t k = 1; k <= width; k++) {
		weight[k * width + k - 1] = 1.0f;
	}
	accessor = glb_add_array(
		glb, weight, key_count * (key_count - 1), 1, GLB_FLOAT);
	free(weight);
	return accessor;
}

static int add_times(struct glb *glb, const struct reference *reference,
	const int *key, int count)
{
	float *time_s = malloc((size_t)count * sizeof(*time_s));
	int accessor;

	if (!time_s) {
		glb->error = -ENOMEM;
		return -1;
	}
	for (int i = 0; i < count; i++) {
		time_s[i] = reference->time_s[key[i]];
	}
	accessor = glb_add_array(glb, time_s, count, 1, GLB_FLOAT);
	free(time_s);
	return accessor;
}

void export_morph(struct glb *glb, const struct reference *reference,
	const int *key, int key_count)
{
	json_t *primitives = json_array();

	for (int i = 0; i < reference->part_count; i++) {
		json_array_append_new(primitives,
			primitive_json(glb, reference, &reference->part[i], key,
				key_count));
	}
	export_materials(glb, reference->model);
	glb_set(glb, "meshes", json_pack("[{s:o}]", "primitives", primitives));
	glb_set(glb, "nodes", json_pack("[{s:i}]", "mesh", 0));
	glb_set(glb, "scenes", json_pack("[{s:[i]}]", "nodes", 0));
	glb_set(glb, "scene", json_integer(0));
	glb_set(glb, "animations",
		json_pack("[{s:s, s:[{s:i, s:i}], s:[{s:i, s:{s:i, s:s}}]}]",
			"name", reference->clip->name, "samplers", "input",
			add_times(glb, reference, key, key_count), "output",
			add_weights(glb, key_count), "channels", "sampler", 0,
			"target", "node", 0, "path", "weights"));
}
