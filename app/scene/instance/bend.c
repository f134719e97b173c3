#include "app/scene/instance/bend.h"

#include "app/anim/ease.h"
#include "app/anim/math/vec.h"
#include "app/model/model_deltas.h"
#include "platform/base/scalar.h"

#include <errno.h>

/*
 * Vertices that move less than this part of the farthest one count as unmoved.
 */
static const float moved_fraction = 0.08f;
/*
 * Distances from the box's middle, in halves of its sides: the reach is 1 up to
 * inner and 0 from outer on.
 */
static const float inner = 0.8f, outer = 1.45f;

static bool can_bend(const struct drawable *drawable, int node)
{
	return drawable->node == node && drawable->skin < 0 &&
		drawable->batch_count == 1 && !drawable->batch[0].source &&
		drawable->primitive->normal;
}

/* Returns the primitive's vertex that is stored at this place of the arrays. */
static int vertex_of(const struct drawable *drawable, int at)
{
	return drawable->fixed && drawable->fixed->order
		? (int)drawable->fixed->order[at]
		: at;
}

static int init_float(struct bend_part *part, struct arena *arena)
{
	struct drawable *drawable = part->drawable;
	size_t count = (size_t)drawable->primitive->vertex_count;

	part->from_position = drawable->position;
	part->from_normal = drawable->normal;
	part->position = arena_alloc(arena, count, sizeof(*part->position));
	part->normal = arena_alloc(arena, count, sizeof(*part->normal));
	if (!part->position || !part->normal) {
		return -ENOMEM;
	}
	instance_use_vertices(drawable, part->position, part->normal);
	return 0;
}

static int init_fixed(struct bend_part *part, struct arena *arena)
{
	struct batch *batch = &part->drawable->batch[0];
	size_t count = (size_t)part->drawable->primitive->vertex_count;

	part->fixed_position = ARENA_ARRAY(arena, struct fixed_vector, count);
	part->fixed_normal = ARENA_ARRAY(arena, struct fixed_vector, count);
	if (!part->fixed_position || !part->fixed_normal) {
		return -ENOMEM;
	}
	batch->fixed_position = part->fixed_position;
	batch->fixed_normal = part->fixed_normal;
	return 0;
}

static int init_part(
	struct bend_part *part, struct drawable *drawable, struct arena *arena)
{
	part->drawable = drawable;
	part->vertex = ARENA_ARRAY(arena, struct bend_vertex,
		(size_t)drawable->primitive->vertex_count);
	if (!part->vertex) {
		return -ENOMEM;
	}
	return drawable->fixed ? init_fixed(part, arena)
			       : init_float(part, arena);
}

static float displacement(const struct model_target *target, int vertex)
{
	float moved[3];

	model_deltas_get(&target->position, vertex, moved);
	return vec_length(moved);
}

static float farthest_of(const struct bend *bend, int target_count)
{
	float farthest = 0.0f;

	for (int p = 0; p < bend->part_count; p++) {
		const struct model_primitive *primitive =
			bend->part[p].drawable->primitive;

		for (int t = 0; t < target_count; t++) {
			for (int v = 0; v < primitive->vertex_count; v++) {
				float own =
					displacement(&primitive->target[t], v);

				farthest = scalar_max(own, farthest);
			}
		}
	}
	return farthest;
}

static void add_point(struct bend *bend, const float at[3])
{
	for (int axis = 0; axis < 3; axis++) {
		bend->low[axis] = scalar_min(at[axis], bend->low[axis]);
		bend->high[axis] = scalar_max(at[axis], bend->high[axis]);
	}
}

/* The box of the vertices that any target moves. */
static void find_box(struct bend *bend, int target_count)
{
	float least = moved_fraction * farthest_of(bend, target_count);

	for (int axis = 0; axis < 3; axis++) {
		bend->low[axis] = 1e9f;
		bend->high[axis] = -1e9f;
	}
	for (int p = 0; p < bend->part_count; p++) {
		const struct model_primitive *primitive =
			bend->part[p].drawable->primitive;

		for (int t = 0; t < target_count; t++) {
			for (int v = 0; v < primitive->vertex_count; v++) {
				if (displacement(&primitive->target[t], v) >
					least) {
					add_point(bend, primitive->position[v]);
				}
			}
		}
	}
}

static int16_t to_q14(float value)
{
	return (int16_t)(scalar_clamp(value, 0.0f, 1.0f) * 16384.0f + 0.5f);
}

/*
 * Returns 1 inside the box, falling smoothly to 0 outside of it. Teeth and eyes
 * inside the box thus move with the skin before them.
 */
static float reach_of(const struct bend *bend, const float at[3])
{
	float reach = 1.0f;

	for (int axis = 0; axis < 3; axis++) {
		float half = 0.5f * (bend->high[axis] - bend->low[axis]);
		float middle = 0.5f * (bend->high[axis] + bend->low[axis]);
		float part = scalar_abs(at[axis] - middle);

		/* The box of a flat shape is flat; an empty one is inside out. */
		if (half < 0.0f || (half == 0.0f && part > 0.0f)) {
			return 0.0f;
		}
		part = half > 0.0f ? part / half : 0.0f;
		reach *= ease_at(EASE_CUBIC, (outer - part) / (outer - inner));
	}
	return reach;
}

static void find_vertices(struct bend *bend)
{
	const struct bend_neck *neck = &bend->neck;

	for (int p = 0; p < bend->part_count; p++) {
		const struct drawable *drawable = bend->part[p].drawable;

		for (int i = 0; i < drawable->primitive->vertex_count; i++) {
			const float *at =
				drawable->primitive
					->position[vertex_of(drawable, i)];
			float up =
				(at[1] - neck->low) / (neck->high - neck->low);

			bend->part[p].vertex[i].turn_q14 =
				to_q14(ease_at(EASE_CUBIC, up));
			bend->part[p].vertex[i].reach_q14 =
				to_q14(reach_of(bend, at));
		}
	}
}

int bend_init(struct bend *bend, struct instance *instance, int node,
	const struct bend_neck *neck)
{
	int mesh = instance->model->node[node].mesh;

	*bend = (struct bend){.neck = *neck};
	for (int d = 0; d < instance->drawable_count &&
		bend->part_count < BEND_PARTS_MAX;
		d++) {
		struct drawable *drawable = &instance->drawable[d];

		if (can_bend(drawable, node) &&
			init_part(&bend->part[bend->part_count++], drawable,
				&instance->arena) != 0) {
			return -ENOMEM;
		}
	}
	find_box(bend, instance->model->mesh[mesh].target_count);
	find_vertices(bend);
	return 0;
}

void bend_set_wave(struct bend *bend, const struct morph_wave *wave)
{
	float low = 0.0f, high = 0.0f;

	bend->wave = *wave;
	for (int axis = 0; axis < 3; axis++) {
		float a = wave->axis[axis] * bend->low[axis];
		float b = wave->axis[axis] * bend->high[axis];

		low += scalar_min(a, b);
		high += scalar_max(b, a);
	}
	for (int p = 0; p < bend->part_count; p++) {
		const struct drawable *drawable = bend->part[p].drawable;

		for (int i = 0; i < drawable->primitive->vertex_count; i++) {
			float along = vec_dot(wave->axis,
				drawable->primitive
					->position[vertex_of(drawable, i)]);
			float place = high > low ? (along - low) / (high - low)
						 : 0.0f;

			bend->part[p].vertex[i].place =
				(uint8_t)(scalar_clamp(place, 0.0f, 1.0f) *
						(BEND_STEPS - 1) +
					0.5f);
		}
	}
}
