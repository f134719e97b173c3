#include "app/model/gltf/gltf_internal.h"

#include <errno.h>

enum mode {
	MODE_TRIANGLES = 4,
	MODE_STRIP = 5,
	MODE_FAN = 6,
};

/*
 * Sets corner[] to the positions, in the list of vertices, of the corners of
 * triangle t (glTF 2.0, 3.7.2.1).
 */
static void triangle_corners(enum mode mode, int t, int corner[3])
{
	switch (mode) {
	case MODE_STRIP:
		corner[0] = t;
		corner[1] = t + 1 + t % 2;
		corner[2] = t + 2 - t % 2;
		break;
	case MODE_FAN:
		corner[0] = t + 1;
		corner[1] = t + 2;
		corner[2] = 0;
		break;
	default:
		corner[0] = 3 * t;
		corner[1] = 3 * t + 1;
		corner[2] = 3 * t + 2;
		break;
	}
}

/* Builds a list; drops the degenerate triangles of strips and fans. */
static int build_triangles(const struct gltf_at *at, enum mode mode,
	const uint32_t *list, int count, uint32_t **index, int *index_count)
{
	int triangles = mode == MODE_TRIANGLES ? count / 3 : count - 2;
	int corner[3];
	uint32_t *to;

	triangles = triangles < 0 ? 0 : triangles;
	_Static_assert(GLTF_ACCESSOR_BYTES_MAX / sizeof(float) < INT32_MAX / 3,
		"the corners of a strip as long as an accessor fit an int");
	*index = GLTF_KEEP(at, uint32_t, (size_t)triangles * 3);
	if (!*index) {
		return -ENOMEM;
	}
	to = *index;
	for (int t = 0; t < triangles; t++) {
		triangle_corners(mode, t, corner);
		for (int k = 0; k < 3; k++) {
			to[k] = list ? list[corner[k]] : (uint32_t)corner[k];
		}
		if (mode == MODE_TRIANGLES ||
			(to[0] != to[1] && to[1] != to[2] && to[2] != to[0])) {
			to += 3;
		}
	}
	*index_count = (int)(to - *index);
	if (mode == MODE_TRIANGLES && count % 3) {
		gltf_warn(at,
			"has %d indices, not a multiple of 3; limber ignores the last ones",
			count);
	}
	return 0;
}

static int check_indices(const struct gltf_at *at, const uint32_t *list,
	int count, int vertex_count)
{
	int i;

	for (i = 0; i < count; i++) {
		if (list[i] >= (uint32_t)vertex_count) {
			return gltf_fail(at, -EINVAL,
				"index %d refers to vertex %u, but there are only %d",
				i, list[i], vertex_count);
		}
	}
	return 0;
}

static int read_mode(const struct gltf_at *at, enum mode *out)
{
	int64_t mode = MODE_TRIANGLES;
	int error = gltf_maybe_integer(at, "mode", 0, MODE_FAN, &mode);

	*out = (enum mode)mode;
	return error;
}

int gltf_has_triangles(const struct gltf_at *at, bool *out)
{
	enum mode mode;
	int error = read_mode(at, &mode);

	*out = mode >= MODE_TRIANGLES;
	if (!error && !*out) {
		if (mode) {
			gltf_warn(at,
				"limber does not draw lines: export them as thin triangles, such as tubes");
		} else {
			gltf_warn(at,
				"limber does not draw points: export a triangle or two for each");
		}
	}
	return error;
}

int gltf_read_triangles(const struct gltf_at *at, int vertex_count,
	uint32_t **index, int *index_count)
{
	struct gltf_at member = gltf_member(at, "indices");
	const struct gltf_accessor *accessor;
	enum mode mode;
	uint32_t *list;
	int error = read_mode(at, &mode);

	if (!error) {
		error = gltf_maybe_accessor(at, "indices", "SCALAR", &accessor);
	}
	if (error) {
		return error;
	}
	if (!accessor) {
		return build_triangles(
			at, mode, NULL, vertex_count, index, index_count);
	}
	if (!gltf_is_unsigned(accessor)) {
		return gltf_fail(&member, -EINVAL,
			"accessor %d does not hold unsigned integers",
			accessor->index);
	}
	list = GLTF_BRIEF(&member, uint32_t, accessor->count);
	if (!list) {
		return -ENOMEM;
	}
	gltf_unpack_uints(accessor, list);
	error = check_indices(&member, list, accessor->count, vertex_count);
	if (!error) {
		error = build_triangles(&member, mode, list, accessor->count,
			index, index_count);
	}
	gltf_end_brief(at->gltf);
	return error;
}
