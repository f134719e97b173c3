#include "app/model/gltf/gltf_internal.h"

#include <errno.h>

static int read_delta(const struct gltf_at *at, const char *key,
	int vertex_count, float (**out)[3])
{
	struct gltf_values values;
	int error = gltf_read_attribute(at, key, "VEC3", vertex_count,
		&at->gltf->model->arena, &values);

	*out = (float(*)[3])values.value;
	return error;
}

/* Ignores displacements of an attribute that the primitive lacks. */
static int read_target(const struct gltf_at *at,
	const struct model_primitive *primitive, struct model_target *out)
{
	int count = primitive->vertex_count;
	int error = read_delta(at, "POSITION", count, &out->position);

	if (!error && primitive->normal) {
		error = read_delta(at, "NORMAL", count, &out->normal);
	}
	if (!error && primitive->tangent) {
		error = read_delta(at, "TANGENT", count, &out->tangent);
	}
	return error;
}

int gltf_read_targets(const struct gltf_at *primitive,
	const struct model_mesh *mesh, struct model_primitive *out)
{
	struct gltf_at array, item;
	int count, i;
	int error = gltf_array(primitive, "targets", &array, &count);

	if (error) {
		return error;
	}
	if (count != mesh->target_count) {
		return gltf_fail(primitive, -EINVAL,
			"has %d targets, but the mesh's first primitive has %d",
			count, mesh->target_count);
	}
	out->target = GLTF_KEEP(&array, struct model_target, count);
	if (!out->target) {
		return -ENOMEM;
	}
	for (i = 0; i < count && !error; i++) {
		error = gltf_item(&array, i, &item);
		if (!error) {
			error = read_target(&item, out, &out->target[i]);
		}
	}
	return error;
}

/* extras.targetNames is a convention, so a malformed one is no error. */
static int read_names(const struct gltf_at *mesh, struct model_mesh *out)
{
	struct gltf_at extras = gltf_member(mesh, "extras");
	struct gltf_at names = gltf_member(&extras, "targetNames");
	int i;

	for (i = 0; i < out->target_count; i++) {
		const char *name = json_string_value(
			json_array_get(names.json, (size_t)i));
		int error = gltf_copy_string(
			&names, name ? name : "", &out->target_name[i]);

		if (error) {
			return error;
		}
	}
	return 0;
}

int gltf_read_target_names(const struct gltf_at *mesh,
	const struct gltf_at *primitives, struct model_mesh *out)
{
	struct gltf_at first, targets;
	int error;

	if (!json_array_size(primitives->json)) {
		return 0;
	}
	error = gltf_item(primitives, 0, &first);
	if (!error) {
		error = gltf_array(
			&first, "targets", &targets, &out->target_count);
	}
	if (error) {
		return error;
	}
	out->target_name = GLTF_KEEP(&targets, const char *, out->target_count);
	return out->target_name ? read_names(mesh, out) : -ENOMEM;
}

int gltf_read_weights(const struct gltf_at *at, int target_count, float **out)
{
	struct gltf_at member = gltf_member(at, "weights");

	*out = NULL;
	if (!member.json) {
		return 0;
	}
	*out = GLTF_SCRATCH(&member, float, target_count);
	return *out ? gltf_maybe_floats(at, "weights", *out, target_count)
		    : -ENOMEM;
}
