#include "app/model/color.h"
#include "app/model/gltf/gltf_internal.h"
#include "platform/base/interrupt.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static int keep_attribute(const struct gltf_at *at, const char *key,
	const char *type, int vertex_count, float **out)
{
	return gltf_read_attribute(
		at, key, type, vertex_count, &at->gltf->model->arena, out);
}

/*
 * Gives a direction unit length, which quantised normals and tangents have only
 * approximately.
 */
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

/*
 * Reads colours. They are 0..1, so integers are treated as normalised even if
 * the file does not mark them so.
 */
static int read_colors(const struct gltf_at *at, struct model_primitive *out)
{
	struct gltf_at member = gltf_member(at, "COLOR_0");
	const struct gltf_accessor *accessor;
	struct gltf_accessor normalized;
	struct color_bytes known = {0};
	float *value;
	int i, c;
	int error = gltf_maybe_accessor(at, "COLOR_0", "VEC3 VEC4", &accessor);

	if (error || !accessor) {
		return error;
	}
	error = gltf_check_attribute(&member, accessor, out->vertex_count);
	if (error) {
		return error;
	}
	normalized = *accessor;
	normalized.normalized = true;
	value = GLTF_BRIEF(&member, float,
		(size_t)accessor->count *(size_t)accessor->width);
	out->color = gltf_alloc(&member, &at->gltf->model->arena,
		(size_t)accessor->count, sizeof(*out->color));
	if (!value || !out->color) {
		return -ENOMEM;
	}
	error = gltf_unpack_floats(&member, &normalized, value);
	for (i = 0; i < out->vertex_count && !error; i++) {
		const float *from = value + (size_t)i * (size_t)normalized.width;

		for (c = 0; c < 3; c++) {
			out->color[i][c] = color_encode_byte(&known, from[c]);
		}
		out->color[i][3] =
			normalized.width == 4 ? color_to_byte(from[3]) : 255;
	}
	gltf_end_brief(at->gltf);
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
	int error;

	out->material = -1;
	error = gltf_maybe_root_index(
		at, "material", "materials", "material", &out->material);
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
	int error = gltf_has_triangles(at, is_drawn);

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
		gltf_warn(at, "has no POSITION; limber ignores this primitive");
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

		error = interrupt_pending() ? -EINTR
					    : gltf_item(array, i, &item);
		if (!error) {
			error = read_primitive(&item, out, primitive, &is_drawn);
		}
		out->primitive_count += is_drawn;
	}
	return error;
}

/* Reads a mesh with its levels of detail; skips a mesh that is such a level. */
static int read_mesh(const struct gltf_at *at)
{
	struct gltf *gltf = at->gltf;
	int index = gltf->mesh_index[at->index];
	struct model_mesh *out;
	struct gltf_at primitives;
	int count;
	int error;

	if (index < 0) {
		return 0;
	}
	out = &gltf->model->mesh[index];
	gltf->model->mesh_count = index + 1;
	error = gltf_name(at, &out->name);
	if (!error) {
		error = gltf_array(at, "primitives", &primitives, &count);
	}
	if (!error) {
		error = gltf_read_target_names(at, &primitives, out);
	}
	if (!error) {
		error = read_primitives(&primitives, count, out);
	}
	if (!error) {
		error = gltf_read_weights(
			at, out->target_count, &gltf->mesh_weights[index]);
	}
	if (!error) {
		error = gltf_read_levels(gltf, at->index);
	}
	gltf_drop_element(gltf, "meshes", at->index);
	return error;
}

int gltf_read_meshes(struct gltf *gltf)
{
	struct model *model = gltf->model;
	struct gltf_at array;
	int count;
	int error = gltf_array(&gltf->root, "meshes", &array, &count);

	if (error) {
		return error;
	}
	model->mesh = GLTF_KEEP(&array, struct model_mesh, count);
	gltf->mesh_weights = GLTF_SCRATCH(&array, float *, count);
	if (!model->mesh || !gltf->mesh_weights) {
		return -ENOMEM;
	}
	return gltf_for_each(&array, count, read_mesh);
}
