#include "app/scene/instance.h"

#include "app/scene/batch.h"
#include "app/scene/bounds.h"
#include "app/scene/bump.h"
#include "app/scene/color.h"
#include "app/scene/light.h"

#include <cglm/cglm.h>

#include <errno.h>
#include <string.h>

/* The power of two that brings size into (0.5, 1], or 1 if it is near that. */
static float near_one(float size, float small, float large)
{
	float scale = 1.0f;

	if (!(size > 0.0f) || (size >= small && size <= large)) {
		return 1.0f;
	}
	while (size * scale > 1.0f) {
		scale *= 0.5f;
	}
	while (size * scale <= 0.5f) {
		scale *= 2.0f;
	}
	return scale;
}

static float largest_coordinate(const struct model_primitive *primitive)
{
	float largest = 0.0f;

	for (int v = 0; v < primitive->vertex_count; v++) {
		for (int axis = 0; axis < 3; axis++) {
			float size = primitive->position[v][axis];

			size = size < 0.0f ? -size : size;
			largest = size > largest ? size : largest;
		}
	}
	return largest;
}

static void *alloc_vectors(struct arena *arena, int count)
{
	return arena_alloc(arena, (size_t)count, sizeof(float[3]));
}

/* Base positions: the model's own array, or a scaled copy. */
static int init_base(struct drawable *drawable, struct arena *arena)
{
	const struct model_primitive *primitive = drawable->primitive;
	float(*scaled)[3];

	drawable->base_normal = (const float(*)[3])primitive->normal;
	drawable->base_position = (const float(*)[3])primitive->position;
	if (drawable->vertex_scale == 1.0f) {
		return 0;
	}
	scaled = alloc_vectors(arena, primitive->vertex_count);
	if (!scaled) {
		return -ENOMEM;
	}
	for (int v = 0; v < primitive->vertex_count; v++) {
		for (int axis = 0; axis < 3; axis++) {
			scaled[v][axis] = primitive->position[v][axis] *
				drawable->vertex_scale;
		}
	}
	drawable->base_position = (const float(*)[3])scaled;
	return 0;
}

static int init_morph(
	struct drawable *drawable, int target_count, struct arena *arena)
{
	const struct model_primitive *primitive = drawable->primitive;

	drawable->term =
		ARENA_ARRAY(arena, struct morph_term, (size_t)target_count);
	if (!drawable->term) {
		return -ENOMEM;
	}
	for (int i = 0; i < target_count; i++) {
		drawable->term[i] = (struct morph_term){
			.position =
				(const float(*)[3])primitive->target[i].position,
			.normal = (const float(*)[3])primitive->target[i].normal,
			.tangent =
				(const float(*)[3])primitive->target[i].tangent,
		};
	}
	return 0;
}

/*
 * Output arrays: a rigid drawable shows its base, a morphed or skinned one
 * arrays of its own.
 */
static int init_output(struct drawable *drawable, struct arena *arena)
{
	const struct model_primitive *primitive = drawable->primitive;

	if (drawable->skin < 0 && !drawable->morphed) {
		drawable->position = (float(*)[3])drawable->base_position;
		drawable->normal = (float(*)[3])drawable->base_normal;
		return 0;
	}
	drawable->position = alloc_vectors(arena, primitive->vertex_count);
	if (!drawable->position) {
		return -ENOMEM;
	}
	if (primitive->normal) {
		drawable->normal = alloc_vectors(arena, primitive->vertex_count);
		if (!drawable->normal) {
			return -ENOMEM;
		}
	}
	if (drawable->skin < 0) {
		return 0;
	}
	return skin_stream_init(&drawable->stream, primitive, 1.0f, arena);
}

static void init_color(
	struct drawable *drawable, const struct model_material *material)
{
	for (int i = 0; i < 3; i++) {
		drawable->color[i] = fx16_from_float(
			color_encode_srgb(material->base_color[i]));
	}
	drawable->color[3] = fx16_from_float(material->base_color[3]);
}

static int init_drawable(struct instance *instance, struct drawable *drawable,
	int node, int primitive_index)
{
	const struct model *model = instance->model;
	const struct model_node *n = &model->node[node];
	const struct model_mesh *mesh = &model->mesh[n->mesh];
	int error;

	*drawable = (struct drawable){
		.node = node,
		.primitive_index = primitive_index,
		.primitive = &mesh->primitive[primitive_index],
		.skin = n->skin,
		.morphed = mesh->target_count > 0,
		.vertex_scale = 1.0f,
	};
	if (drawable->primitive->influences == 0) {
		drawable->skin = -1;
	}
	if (drawable->skin < 0) {
		drawable->vertex_scale = near_one(
			largest_coordinate(drawable->primitive), 0.25f, 16.0f);
	}
	init_color(drawable, &model->material[drawable->primitive->material]);
	error = init_base(drawable, &instance->arena);
	if (!error && drawable->morphed) {
		error = init_morph(
			drawable, mesh->target_count, &instance->arena);
	}
	if (!error) {
		error = init_output(drawable, &instance->arena);
	}
	if (!error) {
		error = batch_make(drawable,
			model->material[drawable->primitive->material].base_color,
			&instance->arena);
	}
	if (!error) {
		batch_gather(drawable);
		error = bump_init(drawable, model, &instance->arena);
	}
	return error;
}

static int count_drawables(const struct model *model)
{
	int count = 0;

	for (int i = 0; i < model->node_count; i++) {
		if (model->node[i].in_scene && model->node[i].mesh >= 0) {
			count +=
				model->mesh[model->node[i].mesh].primitive_count;
		}
	}
	return count;
}

static int init_drawables(struct instance *instance)
{
	const struct model *model = instance->model;
	int next = 0;

	instance->drawable_count = count_drawables(model);
	instance->drawable = ARENA_ARRAY(&instance->arena, struct drawable,
		(size_t)instance->drawable_count);
	if (!instance->drawable) {
		return -ENOMEM;
	}
	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];

		if (!node->in_scene || node->mesh < 0) {
			continue;
		}
		for (int p = 0; p < model->mesh[node->mesh].primitive_count;
			p++) {
			int error = init_drawable(
				instance, &instance->drawable[next++], i, p);

			if (error) {
				return error;
			}
		}
	}
	return 0;
}

static int init_skeleton(struct instance *instance)
{
	const struct model *model = instance->model;
	struct arena *arena = &instance->arena;

	instance->world = ARENA_ARRAY(arena, mat4, (size_t)model->node_count);
	instance->palette =
		ARENA_ARRAY(arena, mat4 *, (size_t)model->skin_count);
	if (!instance->world || !instance->palette) {
		return -ENOMEM;
	}
	for (int i = 0; i < model->skin_count; i++) {
		instance->palette[i] = ARENA_ARRAY(
			arena, mat4, (size_t)model->skin[i].joint_count);
		if (!instance->palette[i]) {
			return -ENOMEM;
		}
	}
	return pose_init(&instance->pose, model, arena);
}

/* Chosen from the posed vertices: a file's units may be anything. */
static void choose_unit_scale(struct instance *instance)
{
	struct bounds bounds;

	instance->unit_scale = 1.0f;
	instance_update(instance);
	bounds = bounds_of_instance(instance);
	instance->unit_scale = near_one(bounds_extent(&bounds), 0.25f, 16.0f);
	instance_update(instance);
}

int instance_create(const struct model *model, const struct kernel *kernel,
	const struct log *log, struct instance **out)
{
	struct arena arena = arena_empty();
	struct instance *instance = ARENA_NEW(&arena, struct instance);
	int error = -ENOMEM;

	if (!instance) {
		goto fail;
	}
	instance->arena = arena;
	instance->model = model;
	instance->kernel = kernel;
	instance->relief = true;
	light_direction(instance->towards_light);
	error = init_skeleton(instance);
	if (!error) {
		error = init_drawables(instance);
	}
	arena = instance->arena;
	if (error) {
		goto fail;
	}
	choose_unit_scale(instance);
	*out = instance;
	return 0;

fail:
	log_error(log, "%s: not enough memory to show it", model->path);
	arena_release(&arena);
	return error;
}

void instance_destroy(struct instance *instance)
{
	if (instance) {
		struct arena arena = instance->arena;

		arena_release(&arena);
	}
}

static int target_count(
	const struct instance *instance, const struct drawable *drawable)
{
	const struct model *model = instance->model;

	return model->mesh[model->node[drawable->node].mesh].target_count;
}

static void set_weights(
	const struct instance *instance, struct drawable *drawable, float scale)
{
	const struct model_node *node = &instance->model->node[drawable->node];
	const float *weight = instance->pose.weight + node->weight_offset;
	int count = target_count(instance, drawable);

	for (int i = 0; i < count; i++) {
		drawable->term[i].weight = weight[i] * scale;
	}
}

/* What the morph is for normals, with tangents in their place. */
static void morph_tangents(
	const struct instance *instance, struct drawable *drawable)
{
	int count = drawable->primitive->vertex_count;
	int terms = target_count(instance, drawable);

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
	int terms = target_count(instance, drawable);

	set_weights(instance, drawable, drawable->vertex_scale);
	kernel->morph_targets(count, drawable->base_position, drawable->term,
		terms, false, drawable->position);
	set_weights(instance, drawable, 1.0f);
	if (drawable->normal) {
		kernel->morph_targets(count, drawable->base_normal,
			drawable->term, terms, true, drawable->normal);
		kernel->normalize(count, drawable->normal);
	}
	if (drawable->tangent && instance->relief) {
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
		.term_count = target_count(instance, drawable),
		.position_scale = 1.0f,
	};
	const struct skin_output output = {
		.position = drawable->position,
		.normal = drawable->normal,
		.tangent = instance->relief ? drawable->tangent : NULL,
	};

	set_weights(instance, drawable, 1.0f);
	instance->kernel->skin_morphed(&drawable->stream, &input,
		(const mat4 *)instance->palette[drawable->skin],
		instance->max_influences, &output);
}

static void skin_drawable(
	const struct instance *instance, struct drawable *drawable)
{
	const mat4 *palette = (const mat4 *)instance->palette[drawable->skin];

	instance->kernel->skin(&drawable->stream, palette,
		instance->max_influences, drawable->position, drawable->normal);
	if (drawable->tangent && instance->relief) {
		instance->kernel->skin_tangents(&drawable->stream, palette,
			instance->max_influences, drawable->tangent);
	}
}

/* Vertices for a pose whose matrices are there. */
static void pose_drawable(
	const struct instance *instance, struct drawable *drawable)
{
	if (drawable->skin >= 0 && drawable->morphed) {
		skin_morphed_drawable(instance, drawable);
	} else if (drawable->skin >= 0) {
		skin_drawable(instance, drawable);
	} else if (drawable->morphed && !drawable->shaped) {
		morph_drawable(instance, drawable);
	}
	if (drawable->tangent && instance->relief) {
		bump_update(instance, drawable);
	}
	if (drawable->morphed || drawable->skin >= 0) {
		batch_gather(drawable);
	}
}

void drawable_set_shape(
	struct drawable *drawable, float (*position)[3], float (*normal)[3])
{
	drawable->shaped = true;
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

/* Palettes carry vertices straight into scene units. */
static void update_palettes(struct instance *instance)
{
	const struct model *model = instance->model;
	float unit = instance->unit_scale;

	for (int i = 0; i < model->skin_count; i++) {
		mat4 *palette = instance->palette[i];

		pose_palette(&model->skin[i], (const mat4 *)instance->world,
			palette);
		if (unit == 1.0f) {
			continue;
		}
		for (int j = 0; j < model->skin[i].joint_count; j++) {
			for (int column = 0; column < 4; column++) {
				glm_vec3_scale(palette[j][column], unit,
					palette[j][column]);
			}
		}
	}
}

void instance_update(struct instance *instance)
{
	instance_update_nodes(instance);
	update_palettes(instance);
	for (int i = 0; i < instance->drawable_count; i++) {
		struct drawable *drawable = &instance->drawable[i];

		if (!drawable->hidden) {
			pose_drawable(instance, drawable);
		}
	}
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

void instance_world_vertex(const struct instance *instance,
	const struct drawable *drawable, int vertex, float out[3])
{
	const float *from = drawable->position[vertex];
	const vec4 *world = instance->world[drawable->node];

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
