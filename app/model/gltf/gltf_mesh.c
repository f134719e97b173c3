#include "app/model/color.h"
#include "app/model/gltf/gltf_internal.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum mode {
	MODE_TRIANGLES = 4,
	MODE_STRIP = 5,
	MODE_FAN = 6,
};

static int check_attribute(const struct gltf_at *at,
	const struct gltf_accessor *accessor, int vertex_count)
{
	if (accessor->count != vertex_count) {
		return gltf_fail(at, -EINVAL, "has %d elements, POSITION has %d",
			accessor->count, vertex_count);
	}
	if (accessor->base.component == GLTF_U32) {
		return gltf_fail(at, -EINVAL,
			"componentType %d is for indices only", GLTF_U32);
	}
	return 0;
}

int gltf_read_attribute(const struct gltf_at *at, const char *key,
	const char *type, int vertex_count, struct arena *arena,
	struct gltf_values *out)
{
	struct gltf_at member = gltf_member(at, key);
	const struct gltf_accessor *accessor;
	int error = gltf_maybe_accessor(at, key, type, &accessor);

	*out = (struct gltf_values){0};
	if (error || !accessor) {
		return error;
	}
	error = check_attribute(&member, accessor, vertex_count);
	if (error) {
		return error;
	}
	out->width = accessor->width;
	out->value = gltf_room(&member, arena,
		(size_t)accessor->count * (size_t)accessor->width,
		sizeof(float));
	if (!out->value) {
		return -ENOMEM;
	}
	return gltf_unpack_floats(&member, accessor, out->value);
}

static int keep_attribute(const struct gltf_at *at, const char *key,
	const char *type, int vertex_count, float **out)
{
	struct gltf_values values;
	int error = gltf_read_attribute(
		at, key, type, vertex_count, &at->gltf->model->arena, &values);

	*out = values.value;
	return error;
}

/* Quantised directions are a little short or long. */
static void normalize(float *direction)
{
	double x = direction[0];
	double y = direction[1];
	double z = direction[2];
	double length = sqrt(x * x + y * y + z * z);

	if (length > 0) {
		direction[0] = (float)(x / length);
		direction[1] = (float)(y / length);
		direction[2] = (float)(z / length);
	}
}

static int read_directions(const struct gltf_at *at, struct model_primitive *out)
{
	float *normal = NULL;
	float *tangent = NULL;
	int i;
	int error = keep_attribute(
		at, "NORMAL", "VEC3", out->vertex_count, &normal);

	if (!error) {
		error = keep_attribute(
			at, "TANGENT", "VEC4", out->vertex_count, &tangent);
	}
	if (error) {
		return error;
	}
	out->normal = (float(*)[3])normal;
	out->tangent = (float(*)[4])tangent;
	for (i = 0; i < out->vertex_count; i++) {
		if (normal) {
			normalize(out->normal[i]);
		}
		if (tangent) {
			normalize(out->tangent[i]);
			out->tangent[i][3] = out->tangent[i][3] < 0 ? -1 : 1;
		}
	}
	return 0;
}

static int read_texcoords(const struct gltf_at *at, struct model_primitive *out)
{
	const struct gltf_uv *uv = &at->gltf->uv[out->material];
	float *texcoord = NULL;
	char key[32];
	int error, i;

	snprintf(key, sizeof(key), "TEXCOORD_%d", uv->set);
	error = keep_attribute(at, key, "VEC2", out->vertex_count, &texcoord);
	if (error || !texcoord) {
		return error;
	}
	out->texcoord = (float(*)[2])texcoord;
	for (i = 0; uv->transformed && i < out->vertex_count; i++) {
		float u = out->texcoord[i][0];
		float v = out->texcoord[i][1];

		out->texcoord[i][0] =
			uv->row[0][0] * u + uv->row[0][1] * v + uv->row[0][2];
		out->texcoord[i][1] =
			uv->row[1][0] * u + uv->row[1][1] * v + uv->row[1][2];
	}
	return 0;
}

static uint8_t unit_to_byte(float value)
{
	if (!(value > 0)) {
		return 0;
	}
	return value >= 1 ? 255 : (uint8_t)(value * 255.0f + 0.5f);
}

/*
 * Colours are fractions; whole numbers that are not marked as normalised can
 * only be an exporter's slip.
 */
static int read_colors(const struct gltf_at *at, struct model_primitive *out)
{
	struct gltf_at member = gltf_member(at, "COLOR_0");
	const struct gltf_accessor *accessor;
	struct gltf_accessor fraction;
	float *value;
	int i, c;
	int error = gltf_maybe_accessor(at, "COLOR_0", "VEC3 VEC4", &accessor);

	if (error || !accessor) {
		return error;
	}
	error = check_attribute(&member, accessor, out->vertex_count);
	if (error) {
		return error;
	}
	fraction = *accessor;
	fraction.normalized = true;
	value = GLTF_SCRATCH(&member, float,
		(size_t)accessor->count *(size_t)accessor->width);
	out->color = gltf_room(&member, &at->gltf->model->arena,
		(size_t)accessor->count, sizeof(*out->color));
	if (!value || !out->color) {
		return -ENOMEM;
	}
	error = gltf_unpack_floats(&member, &fraction, value);
	for (i = 0; i < out->vertex_count && !error; i++) {
		const float *from = value + (size_t)i * fraction.width;

		for (c = 0; c < 3; c++) {
			out->color[i][c] =
				unit_to_byte(color_encode_srgb(from[c]));
		}
		out->color[i][3] =
			fraction.width == 4 ? unit_to_byte(from[3]) : 255;
	}
	return error;
}

/* Triangle t of the three modes (glTF 2.0, 3.7.2.1) as places in the list. */
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

/* Strips are joined by triangles without area; those are left out. */
static int build_triangles(const struct gltf_at *at, enum mode mode,
	const uint32_t *list, int count, uint32_t **index, int *index_count)
{
	int triangles = mode == MODE_TRIANGLES ? count / 3 : count - 2;
	int t, k, corner[3];
	uint32_t *to;

	triangles = triangles < 0 ? 0 : triangles;
	if (triangles > INT32_MAX / 3) {
		return gltf_fail(at, -EFBIG, "has %d triangles", triangles);
	}
	*index = GLTF_KEEP(at, uint32_t, (size_t)triangles * 3);
	if (!*index) {
		return -ENOMEM;
	}
	to = *index;
	for (t = 0; t < triangles; t++) {
		triangle_corners(mode, t, corner);
		for (k = 0; k < 3; k++) {
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
			"%d corners are no whole number of triangles; "
			"the last are left out",
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
				"index %d is vertex %u, there are %d", i,
				list[i], vertex_count);
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
			"accessor %d is not of plain unsigned integers",
			(int)(accessor - at->gltf->accessor));
	}
	list = GLTF_SCRATCH(&member, uint32_t, accessor->count);
	if (!list) {
		return -ENOMEM;
	}
	gltf_unpack_uints(accessor, list);
	error = check_indices(&member, list, accessor->count, vertex_count);
	return error ? error
		     : build_triangles(&member, mode, list, accessor->count,
			       index, index_count);
}

static int find_drawn(const struct gltf_at *at, bool *is_drawn)
{
	enum mode mode;
	int error = read_mode(at, &mode);

	*is_drawn = mode >= MODE_TRIANGLES;
	if (!error && !*is_drawn) {
		gltf_warn(at, "%s are not drawn", mode ? "lines" : "points");
	}
	return error;
}

static int read_vertices(
	const struct gltf_at *attributes, struct model_primitive *out)
{
	float *position = NULL;
	int error = keep_attribute(
		attributes, "POSITION", "VEC3", out->vertex_count, &position);

	out->position = (float(*)[3])position;
	if (!error) {
		error = read_directions(attributes, out);
	}
	if (!error) {
		error = read_texcoords(attributes, out);
	}
	if (!error) {
		error = read_colors(attributes, out);
	}
	return error ? error : gltf_read_influences(attributes, out);
}

static int read_material_index(
	const struct gltf_at *at, struct model_primitive *out)
{
	struct gltf_at materials;
	int count;
	int error = gltf_array(&at->gltf->root, "materials", &materials, &count);

	out->material = -1;
	if (!error) {
		error = gltf_maybe_index(
			at, "material", count, "material", &out->material);
	}
	if (!error && out->material < 0) {
		out->material = gltf_default_material(at->gltf);
	}
	return error;
}

static int read_primitive(const struct gltf_at *at,
	const struct model_mesh *mesh, struct model_primitive *out,
	bool *is_drawn)
{
	const struct gltf_accessor *position;
	struct gltf_at attributes;
	int error = find_drawn(at, is_drawn);

	if (error || !*is_drawn) {
		return error;
	}
	error = gltf_object(at, "attributes", &attributes);
	if (!error) {
		error = gltf_maybe_accessor(
			&attributes, "POSITION", "VEC3", &position);
	}
	if (error) {
		return error;
	}
	if (!position) {
		gltf_warn(at, "has no POSITION; it is left out");
		*is_drawn = false;
		return 0;
	}
	out->file_index = at->index;
	out->vertex_count = position->count;
	error = read_material_index(at, out);
	if (!error) {
		error = read_vertices(&attributes, out);
	}
	if (!error) {
		error = gltf_read_triangles(
			at, out->vertex_count, &out->index, &out->index_count);
	}
	return error ? error : gltf_read_targets(at, mesh, out);
}

static int read_primitives(
	const struct gltf_at *array, int count, struct model_mesh *out)
{
	struct gltf_at item;
	int error = 0;
	int i;

	out->primitive = GLTF_KEEP(array, struct model_primitive, count);
	if (!out->primitive) {
		return -ENOMEM;
	}
	for (i = 0; i < count && !error; i++) {
		struct model_primitive *primitive =
			&out->primitive[out->primitive_count];
		bool is_drawn = false;

		error = gltf_item(array, i, &item);
		if (!error) {
			error = read_primitive(&item, out, primitive, &is_drawn);
		}
		out->primitive_count += is_drawn;
	}
	return error;
}

static int read_mesh(const struct gltf_at *at, struct model_mesh *out)
{
	struct gltf_at primitives;
	int count;
	int error = gltf_name(at, &out->name);

	if (!error) {
		error = gltf_array(at, "primitives", &primitives, &count);
	}
	if (!error) {
		error = gltf_read_target_names(at, &primitives, out);
	}
	return error ? error : read_primitives(&primitives, count, out);
}

int gltf_read_meshes(struct gltf *gltf)
{
	struct model *model = gltf->model;
	struct gltf_at array, item;
	int count, i;
	int error = gltf_array(&gltf->root, "meshes", &array, &count);

	if (error) {
		return error;
	}
	model->mesh = GLTF_KEEP(&array, struct model_mesh, count);
	gltf->mesh_weights = GLTF_SCRATCH(&array, float *, count);
	if (!model->mesh || !gltf->mesh_weights) {
		return -ENOMEM;
	}
	for (i = 0; i < count && !error; i++) {
		int place = gltf->mesh_place[i];

		if (place < 0) {
			continue;
		}
		model->mesh_count = place + 1;
		error = gltf_item(&array, i, &item);
		if (!error) {
			error = read_mesh(&item, &model->mesh[place]);
		}
		if (!error) {
			error = gltf_read_weights(&item,
				model->mesh[place].target_count,
				&gltf->mesh_weights[place]);
		}
		if (!error) {
			error = gltf_read_levels(gltf, i);
		}
	}
	return error;
}
