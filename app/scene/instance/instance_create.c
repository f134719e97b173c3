/*
 * Creates instances (instance.h): their drawables, batches, matrices and poses.
 */
#include "app/scene/instance/instance.h"

#include "app/anim/math/vec.h"
#include "app/model/color.h"
#include "app/model/model_alpha.h"
#include "app/model/model_deltas.h"
#include "app/scene/draw/alpha.h"
#include "app/scene/draw/bump.h"
#include "app/scene/draw/emission.h"
#include "app/scene/draw/glow.h"
#include "app/scene/instance/batch/batch.h"
#include "app/scene/instance/bounds.h"
#include "app/scene/instance/drawable_fixed.h"
#include "app/scene/stage/light.h"
#include "platform/base/count.h"
#include "platform/base/interrupt.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/*
 * Returns the power of two that scales size into (0.5, 1], or 1 if size is
 * between 0.25 and 16 or is absurd.
 */
static float near_one(float size)
{
	float scale = 1.0f;

	if (!(size > 1e-12f && size < 1e12f) ||
		(size >= 0.25f && size <= 16.0f)) {
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
			largest = scalar_max(
				scalar_abs(primitive->position[v][axis]),
				largest);
		}
	}
	return largest;
}

static void measure_box(struct drawable *drawable, int target_count)
{
	const struct model_primitive *primitive = drawable->primitive;
	struct bounds box = bounds_empty();

	for (int v = 0; v < primitive->vertex_count; v++) {
		const float *base = primitive->position[v];

		bounds_add(&box, base);
		for (int t = 0; t < target_count; t++) {
			float at[3];

			model_deltas_get(&primitive->target[t].position, v, at);
			vec_add_scaled(base, at, 1.0f, at);
			bounds_add(&box, at);
		}
	}
	bounds_center(&box, drawable->box_middle);
	for (int axis = 0; axis < 3 && !bounds_is_empty(&box); axis++) {
		drawable->box_half[axis] =
			0.5f * (box.high[axis] - box.low[axis]);
	}
}

static void *alloc_vectors(struct arena *arena, int count)
{
	return arena_alloc(arena, (size_t)count, sizeof(float[3]));
}

/* Base positions are the model's own array, or a copy times vertex_scale. */
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
		const struct model_target *target = &primitive->target[i];
		struct morph_term *term = &drawable->term[i];

		if (model_deltas_floats(
			    &target->position, arena, &term->position) != 0 ||
			model_deltas_floats(
				&target->normal, arena, &term->normal) != 0 ||
			model_deltas_floats(
				&target->tangent, arena, &term->tangent) != 0) {
			return -ENOMEM;
		}
	}
	return 0;
}

/* A rigid drawable's output is its base; others get arrays of their own. */
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

/* Uses fixed point if the kernel has it and the positions fit, else float. */
static int init_vertices(struct instance *instance, struct drawable *drawable)
{
	const struct model *model = instance->model;
	const struct fixed_loops *loops = instance->kernel->fixed;
	int mesh = model->node[drawable->node].mesh;
	struct arena *arena = &instance->arena;
	int error;

	if (loops) {
		error = drawable_fixed_init(drawable, model, loops,
			instance->drawn_vertices_only, arena);
		if (!error && drawable->skin >= 0) {
			skin_stream_count(
				&drawable->stream, drawable->primitive);
		}
		if (error != -ERANGE) {
			return error;
		}
		instance->float_count++;
	}
	if (drawable->skin < 0) {
		drawable->vertex_scale =
			near_one(largest_coordinate(drawable->primitive));
	}
	error = init_base(drawable, arena);
	if (!error && drawable->morphed) {
		error = init_morph(
			drawable, model->mesh[mesh].target_count, arena);
	}
	return error ? error : init_output(drawable, arena);
}

static void init_color(struct drawable *drawable, const struct model *model)
{
	const struct model_material *material =
		&model->material[drawable->primitive->material];
	float emission[3], shown[3];

	model_material_shown(material, shown);
	emission_color(model, drawable->primitive, emission);
	for (int i = 0; i < 3; i++) {
		drawable->color[i] = fx16_from_float(shown[i]);
		drawable->emission[i] = fx16_from_float(emission[i]);
	}
	drawable->emission[3] = FX16_ONE;
	drawable->color[3] = fx16_from_float(material->base_color[3]);
}

static int make_batches(struct drawable *drawable,
	const struct model_material *material, struct arena *arena)
{
	int error = batch_make(drawable, material->base_color, arena);

	return error || material->unlit ? error
					: batch_add_mirrored(drawable, arena);
}

/*
 * Whether another node may show the drawable's arrays, too: no update writes
 * them, neither for morph targets or joints nor for bumps or facets.
 */
static bool is_constant(const struct drawable *drawable)
{
	for (int i = 0; i < drawable->batch_count; i++) {
		if (drawable->batch[i].source) {
			return false;
		}
	}
	return drawable->skin < 0 && !drawable->morphed && !drawable->light;
}

/*
 * Makes a drawable of what another node shows: with the same arrays, but
 * batches of its own, which may get other colours. Returns 0 or -ENOMEM.
 */
static int share_drawable(struct instance *instance, struct drawable *drawable,
	int node, const struct drawable *shown)
{
	size_t count = (size_t)shown->batch_count;

	*drawable = *shown;
	drawable->node = node;
	drawable->shared = true;
	drawable->batch = ARENA_ARRAY(&instance->arena, struct batch, count);
	if (!drawable->batch) {
		return -ENOMEM;
	}
	memcpy(drawable->batch, shown->batch, count * sizeof(struct batch));
	instance->float_count += instance->kernel->fixed && !shown->fixed;
	return 0;
}

static int init_drawable(struct instance *instance, struct drawable *drawable,
	int node, int primitive_index, struct glow_map *glow)
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
		measure_box(drawable, mesh->target_count);
	}
	drawable->alpha = model_alpha_of(model, drawable->primitive);
	drawable->mean_alpha = model_alpha_mean(model, drawable->primitive);
	drawable->unseen = !model_alpha_is_seen(model, drawable->primitive);
	init_color(drawable, model);
	error = init_vertices(instance, drawable);
	if (!error) {
		error = make_batches(drawable,
			&model->material[drawable->primitive->material],
			&instance->arena);
	}
	if (!error) {
		error = glow_sort(drawable, model, glow, &instance->arena);
	}
	if (!error) {
		batch_gather_all(drawable);
		error = bump_init(drawable, model, &instance->arena);
	}
	return error;
}

/*
 * Counts the primitives of all nodes. Nodes share meshes, so the sum may
 * overflow although the count of each mesh is small.
 */
static int count_drawables(const struct model *model, int *out)
{
	*out = 0;
	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];

		if (model_node_shows_mesh(node) &&
			!count_add(*out,
				model->mesh[node->mesh].primitive_count, out)) {
			(void)memory_budget_take(model->budget, SIZE_MAX);
			return -ENOMEM;
		}
	}
	return 0;
}

/*
 * Makes the drawables of a node. shown, or NULL, are those of another node that
 * has the same mesh.
 */
static int init_node(struct instance *instance, int node,
	const struct drawable *shown, struct glow_map *glow,
	struct drawable *out)
{
	const struct model_node *n = &instance->model->node[node];
	const struct model_mesh *mesh = &instance->model->mesh[n->mesh];
	int error = 0;

	for (int p = 0; p < mesh->primitive_count && !error; p++) {
		bool skinned = n->skin >= 0 && mesh->primitive[p].influences > 0;

		error = shown && !skinned && is_constant(&shown[p])
			? share_drawable(instance, &out[p], node, &shown[p])
			: init_drawable(instance, &out[p], node, p, glow);
	}
	return error;
}

/* shown[mesh]: the drawables of the last node that has the mesh, or NULL. */
static int init_nodes(struct instance *instance, const struct drawable *shown[])
{
	const struct model *model = instance->model;
	struct drawable *next = instance->drawable;
	struct glow_map glow = {0};
	int error = 0;

	for (int i = 0; i < model->node_count && !error; i++) {
		const struct model_node *node = &model->node[i];

		if (!model_node_shows_mesh(node)) {
			continue;
		}
		error = interrupt_pending()
			? -EINTR
			: init_node(instance, i, shown[node->mesh], &glow, next);
		shown[node->mesh] = next;
		next += model->mesh[node->mesh].primitive_count;
	}
	glow_map_release(&glow);
	return error;
}

static int init_drawables(struct instance *instance)
{
	const struct model *model = instance->model;
	const struct drawable **shown;
	size_t count;
	int error;

	if (count_drawables(model, &instance->drawable_count) != 0) {
		return -ENOMEM;
	}
	count = (size_t)instance->drawable_count;
	instance->drawable =
		ARENA_ARRAY(&instance->arena, struct drawable, count);
	instance->blended =
		ARENA_ARRAY(&instance->arena, struct blended_drawable, count);
	shown = calloc((size_t)model->mesh_count + 1, sizeof(*shown));
	error = instance->drawable && instance->blended && shown
		? init_nodes(instance, shown)
		: -ENOMEM;
	free(shown);
	if (!error) {
		alpha_list_blended(instance);
	}
	return error;
}

static int init_skeleton(struct instance *instance)
{
	const struct model *model = instance->model;
	struct arena *arena = &instance->arena;

	instance->world = ARENA_ARRAY(arena, mat4, (size_t)model->node_count);
	instance->palette =
		ARENA_ARRAY(arena, mat4 *, (size_t)model->skin_count);
	instance->normal_palette =
		ARENA_ARRAY(arena, const mat4 *, (size_t)model->skin_count);
	if (!instance->world || !instance->palette || !instance->normal_palette) {
		return -ENOMEM;
	}
	for (int i = 0; i < model->skin_count; i++) {
		instance->palette[i] = ARENA_ARRAY(
			arena, mat4, (size_t)model->skin[i].joint_count);
		if (!instance->palette[i]) {
			return -ENOMEM;
		}
	}
	return pose_init(&instance->pose, model, arena) == 0
		? pose_normals_init(&instance->normals, model, arena)
		: -ENOMEM;
}

/* Measures the posed vertices, as units may be anything, unless it is known. */
static void choose_unit_scale(struct instance *instance, float known)
{
	instance->unit_scale = known > 0.0f ? known : 1.0f;
	if (!(known > 0.0f)) {
		instance->unit_scale =
			near_one(bounds_extent_of_model(instance));
	}
	instance_update(instance);
}

int instance_create_with(const struct model *model, const struct kernel *kernel,
	const struct instance_options *options, const struct log *log,
	struct instance **out)
{
	struct arena arena = arena_within(model->budget);
	struct instance *instance = ARENA_NEW(&arena, struct instance);
	int error = -ENOMEM;

	if (!instance) {
		goto fail;
	}
	instance->arena = arena;
	instance->model = model;
	instance->kernel = kernel;
	instance->normal_mapping = true;
	instance->drawn_vertices_only = options->drawn_vertices_only;
	light_direction(instance->towards_light);
	error = init_skeleton(instance);
	if (!error) {
		error = init_drawables(instance);
	}
	arena = instance->arena;
	if (error) {
		goto fail;
	}
	if (instance->float_count > 0) {
		log_warning(log,
			"%s: %d of the model's %d parts are posed in float because their positions do not fit 16 bits",
			model->path, instance->float_count,
			instance->drawable_count);
	}
	choose_unit_scale(instance, options->unit_scale);
	*out = instance;
	return 0;

fail:
	if (error != -EINTR) {
		(void)memory_budget_fail(model->budget, model->path, log);
	}
	arena_release(&arena);
	return error;
}

int instance_create(const struct model *model, const struct kernel *kernel,
	const struct log *log, struct instance **out)
{
	static const struct instance_options all = {
		.drawn_vertices_only = false};

	return instance_create_with(model, kernel, &all, log, out);
}

int instance_create_for_drawing(const struct model *model,
	const struct kernel *kernel, const struct log *log,
	struct instance **out)
{
	static const struct instance_options drawn = {
		.drawn_vertices_only = true};

	return instance_create_with(model, kernel, &drawn, log, out);
}

void instance_destroy(struct instance *instance)
{
	if (instance) {
		struct arena arena = instance->arena;

		arena_release(&arena);
	}
}
