#include "app/demo/face_keys.h"

#include "app/anim/kernel/kernel.h"

#include <errno.h>

/* Computes the base plus one target at weight 1. */
static int bake_key(const struct face_keys *keys,
	const struct drawable *drawable, int target, struct morph_key *out)
{
	const struct model_primitive *primitive = drawable->primitive;
	const struct kernel *kernel = keys->instance->kernel;
	struct arena *arena = &keys->instance->arena;
	int count = primitive->vertex_count;
	struct morph_term term = {
		.weight = drawable->vertex_scale,
		.position =
			(const float(*)[3])primitive->target[target].position,
		.normal = (const float(*)[3])primitive->target[target].normal,
	};
	float(*position)[3] =
		arena_alloc(arena, (size_t)count, sizeof(*position));
	float(*normal)[3] = arena_alloc(arena, (size_t)count, sizeof(*normal));

	if (!position || !normal) {
		return -ENOMEM;
	}
	kernel->morph_targets(
		count, drawable->base_position, &term, 1, false, position);
	out->position = (const float(*)[3])position;
	if (!drawable->base_normal) {
		return 0;
	}
	term.weight = 1.0f;
	kernel->morph_targets(
		count, drawable->base_normal, &term, 1, true, normal);
	kernel->normalize(count, normal);
	out->normal = (const float(*)[3])normal;
	return 0;
}

static int init_part(struct face_keys *keys, struct face_part *part,
	struct drawable *drawable)
{
	struct arena *arena = &keys->instance->arena;
	int error;

	part->key[0] = (struct morph_key){
		.position = drawable->base_position,
		.normal = drawable->base_normal,
	};
	for (int k = 1; k < keys->key_count; k++) {
		error = bake_key(keys, drawable, k - 1, &part->key[k]);
		if (error) {
			return error;
		}
	}
	error = morph_init(&part->morph, drawable->primitive->vertex_count,
		part->key[0], arena);
	if (!error) {
		instance_use_vertices(drawable, part->morph.temporal,
			part->morph.temporal_normal);
	}
	return error;
}

static int triples(const struct face_keys *keys)
{
	return (keys->key_count - 1 + 2) / 3;
}

/* Key k has the weight 1 for target k - 1 and 0 for all others. */
static int init_weights(struct face_keys *keys, struct face_part *part)
{
	struct arena *arena = &keys->instance->arena;
	size_t count = (size_t)triples(keys);

	for (int k = 0; k < keys->key_count; k++) {
		float(*weight)[3] = arena_alloc(arena, count, sizeof(*weight));

		if (!weight) {
			return -ENOMEM;
		}
		if (k > 0) {
			weight[(k - 1) / 3][(k - 1) % 3] = 1.0f;
		}
		part->key[k].position = (const float(*)[3])weight;
	}
	return morph_init(&part->morph, (int)count, part->key[0], arena);
}

static struct face_part *add_part(struct face_keys *keys)
{
	struct face_part *part = &keys->part[keys->part_count++];

	part->key = ARENA_ARRAY(&keys->instance->arena, struct morph_key,
		(size_t)keys->key_count);
	return part->key ? part : NULL;
}

static int init_parts(struct face_keys *keys)
{
	struct instance *instance = keys->instance;

	for (int i = 0; i < instance->drawable_count; i++) {
		struct drawable *drawable = &instance->drawable[i];
		struct face_part *part;

		if (drawable->node != keys->node ||
			keys->part_count == FACE_PARTS_MAX) {
			continue;
		}
		part = add_part(keys);
		if (!part || init_part(keys, part, drawable) != 0) {
			return -ENOMEM;
		}
	}
	return 0;
}

static bool any_is_fixed(const struct instance *instance, int node)
{
	for (int i = 0; i < instance->drawable_count; i++) {
		if (instance->drawable[i].node == node &&
			instance->drawable[i].fixed) {
			return true;
		}
	}
	return false;
}

int face_keys_init(struct face_keys *keys, struct instance *instance, int node)
{
	const struct model *model = instance->model;
	const struct model_mesh *mesh = &model->mesh[model->node[node].mesh];
	struct face_part *part;

	*keys = (struct face_keys){
		.instance = instance,
		.node = node,
		.key_count = mesh->target_count + 1,
		.target_name = mesh->target_name,
		.weighs = any_is_fixed(instance, node),
	};
	if (!keys->weighs) {
		return init_parts(keys);
	}
	part = add_part(keys);
	return part ? init_weights(keys, part) : -ENOMEM;
}

void face_keys_go(struct face_keys *keys, int key,
	const struct morph_motion *motion, double now_ms)
{
	struct morph_motion own = *motion;

	own.curve = MORPH_LINEAR;
	for (int i = 0; i < keys->part_count; i++) {
		morph_trigger(&keys->part[i].morph, keys->part[i].key[key],
			&own, now_ms);
	}
}

void face_keys_hold(struct face_keys *keys, int from, int to, float amount)
{
	for (int i = 0; i < keys->part_count; i++) {
		struct face_part *part = &keys->part[i];

		morph_hold(&part->morph, part->key[from], part->key[to], amount);
	}
}

void face_keys_update(struct face_keys *keys, double now_ms)
{
	for (int i = 0; i < keys->part_count; i++) {
		morph_update(&keys->part[i].morph, now_ms);
	}
}

float face_keys_omega(const struct face_keys *keys, double now_ms)
{
	return morph_omega(&keys->part[0].morph, now_ms);
}

void face_keys_apply(const struct face_keys *keys)
{
	const struct model *model = keys->instance->model;
	struct pose *pose = &keys->instance->pose;
	float *weight = pose->weight + model->node[keys->node].weight_offset;

	if (!keys->weighs) {
		return;
	}
	for (int t = 0; t < keys->key_count - 1; t++) {
		weight[t] = keys->part[0].morph.temporal[t / 3][t % 3];
	}
}
