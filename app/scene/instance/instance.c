#include "app/scene/instance/instance.h"

#include "app/anim/math/matrix.h"
#include "app/scene/draw/bump.h"
#include "app/scene/instance/batch/batch.h"
#include "app/scene/instance/drawable_fixed.h"

#include <cglm/cglm.h>

#include <string.h>

static void set_weights(
	const struct instance *instance, struct drawable *drawable, float scale)
{
	const struct model_node *node = &instance->model->node[drawable->node];
	const float *weight = instance->pose.weight + node->weight_offset;
	int count = drawable_target_count(instance, drawable);

	for (int i = 0; i < count; i++) {
		drawable->term[i].weight = weight[i] * scale;
	}
}

/* Morphs tangents as normals are morphed. */
static void morph_tangents(
	const struct instance *instance, struct drawable *drawable)
{
	int count = drawable->primitive->vertex_count;
	int terms = drawable_target_count(instance, drawable);

	memcpy(drawable->tangent, drawable->base_tangent,
		(size_t)count * sizeof(*drawable->tangent));
	for (int i = 0; i < terms; i++) {
		struct morph_term term = drawable->term[i];

		term.normal = term.tangent;
		instance->kernel->morph_targets(count,
			(const float(*)[3])drawable->tangent, &term, 1, true,
			drawable->tangent);
	}
	instance->kernel->normalize(count, drawable->tangent);
}

static void morph_drawable(
	const struct instance *instance, struct drawable *drawable)
{
	const struct kernel *kernel = instance->kernel;
	int count = drawable->primitive->vertex_count;
	int terms = drawable_target_count(instance, drawable);

	set_weights(instance, drawable, drawable->vertex_scale);
	kernel->morph_targets(count, drawable->base_position, drawable->term,
		terms, false, drawable->position);
	set_weights(instance, drawable, 1.0f);
	if (drawable->normal) {
		kernel->morph_targets(count, drawable->base_normal,
			drawable->term, terms, true, drawable->normal);
		kernel->normalize(count, drawable->normal);
	}
	if (drawable->tangent && drawable->bumped) {
		morph_tangents(instance, drawable);
	}
}

static void skin_morphed_drawable(
	const struct instance *instance, struct drawable *drawable)
{
	const struct model_primitive *primitive = drawable->primitive;
	const struct morph_input input = {
		.position = drawable->base_position,
		.normal = drawable->base_normal,
		.tangent = (const float(*)[4])primitive->tangent,
		.term = drawable->term,
		.term_count = drawable_target_count(instance, drawable),
		.position_scale = 1.0f,
		.normal_palette = instance->normal_palette[drawable->skin],
	};
	const struct skin_output output = {
		.position = drawable->position,
		.normal = instance->hold_normals ? NULL : drawable->normal,
		.tangent = drawable->bumped ? drawable->tangent : NULL,
	};

	set_weights(instance, drawable, 1.0f);
	instance->kernel->skin_morphed(&drawable->stream, &input,
		(const mat4 *)instance->palette[drawable->skin],
		instance->max_influences, &output);
}

static void skin_drawable(
	const struct instance *instance, struct drawable *drawable)
{
	const struct kernel *kernel = instance->kernel;
	const struct skin_stream *stream = &drawable->stream;
	const mat4 *palette = (const mat4 *)instance->palette[drawable->skin];
	const mat4 *normal_palette = instance->normal_palette[drawable->skin];
	float(*normal)[3] = instance->hold_normals ? NULL : drawable->normal;
	int cap = instance->max_influences;

	kernel->skin(stream, palette, cap, drawable->position,
		normal_palette == palette ? normal : NULL);
	if (normal && normal_palette != palette) {
		kernel->skin_directions(stream,
			(const float(*)[4])stream->normal, normal_palette, cap,
			normal);
	}
	if (drawable->tangent && drawable->bumped) {
		kernel->skin_directions(stream,
			(const float(*)[4])stream->tangent, palette, cap,
			drawable->tangent);
	}
}

/* Returns the finest level whose vertices the drawable or its shadow needs. */
static int drawn_lod(const struct drawable *drawable)
{
	int lod = drawable->lod < drawable->shadow_lod ? drawable->lod
						       : drawable->shadow_lod;

	for (int i = 0; i < drawable->batch_count; i++) {
		const struct batch_lod *shadow =
			drawable_shadow(drawable, &drawable->batch[i]);

		if (shadow && shadow->posed_lod < lod) {
			lod = shadow->posed_lod;
		}
	}
	return lod;
}

/*
 * Returns true if the palette reverses the winding of triangles, judged by the
 * first joint whose matrix has an inverse.
 */
static bool palette_mirrors(const mat4 *palette, int joint_count)
{
	float determinant = 0.0f;

	for (int i = 0; i < joint_count && determinant == 0.0f; i++) {
		determinant = matrix_determinant(&palette[i]);
	}
	return determinant < 0.0f;
}

/*
 * A mesh below a mirroring node is inside out even where its joints do not
 * mirror, as Blender writes it: the node's matrix decides about winding (glTF
 * 2.0, section 3.7.4), although it places no vertex of a skinned mesh.
 */
static bool is_skin_mirrored(
	const struct instance *instance, const struct drawable *drawable)
{
	return matrix_determinant(
		       (const mat4 *)&instance->world[drawable->node]) < 0.0f ||
		palette_mirrors((const mat4 *)instance->palette[drawable->skin],
			instance->model->skin[drawable->skin].joint_count);
}

/* Call it when the world matrices and palettes are up to date. */
static void pose_drawable(
	const struct instance *instance, struct drawable *drawable)
{
	drawable->bumped = drawable->light && instance->normal_mapping &&
		!drawable->bumps_hidden;
	drawable->mirrored =
		drawable->skin >= 0 && is_skin_mirrored(instance, drawable);
	if (drawable->fixed) {
		drawable_fixed_pose(instance, drawable);
	} else if (drawable->skin >= 0 && drawable->morphed) {
		skin_morphed_drawable(instance, drawable);
	} else if (drawable->skin >= 0) {
		skin_drawable(instance, drawable);
	} else if (drawable->morphed && !drawable->external) {
		morph_drawable(instance, drawable);
	}
	if (drawable->bumped) {
		bump_update(instance, drawable);
	}
	if (!instance->undrawn && (drawable->morphed || drawable->skin >= 0)) {
		batch_gather(drawable);
	}
}

void instance_use_vertices(
	struct drawable *drawable, float (*position)[3], float (*normal)[3])
{
	drawable->external = true;
	drawable->position = position;
	drawable->normal = normal;
	for (int i = 0; i < drawable->batch_count; i++) {
		struct batch *batch = &drawable->batch[i];

		if (!batch->source) {
			batch->position = (const float(*)[3])position;
			batch->normal = (const float(*)[3])normal;
		}
	}
}

void instance_update_nodes(struct instance *instance)
{
	pose_world(&instance->pose, instance->model, NULL, instance->world);
}

static void scale_palette(mat4 *palette, int joint_count, float unit)
{
	for (int i = 0; i < 4 * joint_count; i++) {
		float *column = palette[i / 4][i % 4];

		glm_vec3_scale(column, unit, column);
	}
}

/* The palettes transform vertices to scene units. */
static void update_palettes(struct instance *instance)
{
	const struct model *model = instance->model;
	struct pose_normals *normals = &instance->normals;
	bool uneven = pose_normals_find(normals, &instance->pose);

	for (int i = 0; i < model->skin_count; i++) {
		mat4 *palette = instance->palette[i];

		pose_palette(&model->skin[i], (const mat4 *)instance->world,
			palette);
		if (instance->unit_scale != 1.0f) {
			scale_palette(palette, model->skin[i].joint_count,
				instance->unit_scale);
		}
		instance->normal_palette[i] = uneven
			? pose_normals_palette(
				  normals, model, i, (const mat4 *)palette)
			: (const mat4 *)palette;
	}
}

void instance_update(struct instance *instance)
{
	instance_update_nodes(instance);
	update_palettes(instance);
	for (int i = 0; i < instance->drawable_count; i++) {
		struct drawable *drawable = &instance->drawable[i];

		drawable->posed_lod =
			instance->drawn_vertices_only ? drawn_lod(drawable) : 0;
		if (!drawable->hidden &&
			(drawable->primitive->index_count > 0 ||
				!instance->drawn_vertices_only)) {
			pose_drawable(instance, drawable);
		}
	}
}

bool instance_is_stale(const struct instance *instance)
{
	for (int i = 0;
		instance->drawn_vertices_only && i < instance->drawable_count;
		i++) {
		const struct drawable *drawable = &instance->drawable[i];

		if (drawable->posed_lod > drawn_lod(drawable)) {
			return true;
		}
	}
	return false;
}

bool instance_overflowed(const struct instance *instance)
{
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable_fixed *fixed = instance->drawable[i].fixed;

		if (fixed && fixed->overflowed) {
			return true;
		}
	}
	return false;
}

void instance_node_position(
	const struct instance *instance, int node, float out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] =
			instance->world[node][3][axis] * instance->unit_scale;
	}
}

void instance_drawable_matrix(const struct instance *instance,
	const struct drawable *drawable, mat4 out)
{
	float rotation = instance->unit_scale / drawable->vertex_scale;

	memcpy(out, instance->world[drawable->node], sizeof(mat4));
	for (int column = 0; column < 4; column++) {
		float scale = column < 3 ? rotation : instance->unit_scale;

		glm_vec3_scale(out[column], scale, out[column]);
	}
}

bool instance_is_mirrored(
	const struct instance *instance, const struct drawable *drawable)
{
	mat4 matrix;

	if (drawable->skin >= 0) {
		return drawable->mirrored;
	}
	instance_drawable_matrix(instance, drawable, matrix);
	return matrix_determinant((const mat4 *)&matrix) < 0.0f;
}

void instance_world_vertex(const struct instance *instance,
	const struct drawable *drawable, int vertex, float out[3])
{
	const vec4 *world = instance->world[drawable->node];
	float from[3];

	drawable_position(drawable, vertex, from);

	for (int axis = 0; axis < 3; axis++) {
		if (drawable->skin >= 0) {
			out[axis] = from[axis] / instance->unit_scale;
			continue;
		}
		out[axis] =
			(world[0][axis] * from[0] + world[1][axis] * from[1] +
				world[2][axis] * from[2]) /
				drawable->vertex_scale +
			world[3][axis];
	}
}

const char *instance_technique(const struct instance *instance)
{
	bool skinned = false, morphed = false;

	for (int i = 0; i < instance->drawable_count; i++) {
		skinned = skinned || instance->drawable[i].skin >= 0;
		morphed = morphed || instance->drawable[i].morphed;
	}
	return skinned && morphed ? "Skeletal + morph"
		: skinned         ? "Skeletal"
		: morphed         ? "Morphing"
				  : "Hierarchical";
}
