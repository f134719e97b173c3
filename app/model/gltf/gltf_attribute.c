#include "app/model/gltf/gltf_internal.h"

#include <errno.h>

int gltf_check_attribute(const struct gltf_at *at,
	const struct gltf_accessor *accessor, int vertex_count)
{
	if (accessor->count != vertex_count) {
		return gltf_fail(at, -EINVAL,
			"has %d elements, but POSITION has %d", accessor->count,
			vertex_count);
	}
	if (accessor->base.component == GLTF_U32) {
		return gltf_fail(at, -EINVAL,
			"componentType %d is allowed for indices only",
			GLTF_U32);
	}
	return 0;
}

int gltf_read_attribute(const struct gltf_at *at, const char *key,
	const char *type, int vertex_count, struct arena *arena, float **out)
{
	struct gltf_at member = gltf_member(at, key);
	const struct gltf_accessor *accessor;
	int error = gltf_maybe_accessor(at, key, type, &accessor);

	*out = NULL;
	if (error || !accessor) {
		return error;
	}
	error = gltf_check_attribute(&member, accessor, vertex_count);
	if (error) {
		return error;
	}
	*out = gltf_alloc(&member, arena,
		(size_t)accessor->count * (size_t)accessor->width,
		sizeof(float));
	if (!*out) {
		return -ENOMEM;
	}
	return gltf_unpack_floats(&member, accessor, *out);
}
