#include "app/scene/shadow/shadow_ground.h"

#include "app/anim/math/vec.h"
#include "app/model/model_deltas.h"
#include "app/scene/draw/draw.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdlib.h>

/* Parts of the model's extent. */
static const float flat_part = 0.1f;    /* that ground is high at most */
static const float wide_part = 0.8f;    /* of each side of the model */
static const float above_part = 0.05f;  /* that something stands above it */
static const float level_part = 0.001f; /* between heights that are one */

struct search {
	struct instance *instance;
	struct bounds all;
	float extent;
	struct bounds *box; /* of each drawable that may be ground, or empty */
};

static bool is_moved(const struct model *model, int node)
{
	for (int c = 0; c < model->clip_count; c++) {
		const struct model_clip *clip = &model->clip[c];

		for (int i = 0; i < clip->channel_count; i++) {
			const struct model_channel *channel = &clip->channel[i];

			if (channel->node == node && !channel->constant &&
				channel->path != MODEL_WEIGHTS) {
				return true;
			}
		}
	}
	return false;
}

static bool stands_still(const struct model *model, int node)
{
	for (; node >= 0; node = model->node[node].parent) {
		if (is_moved(model, node)) {
			return false;
		}
	}
	return true;
}

static struct bounds box_of(
	const struct instance *instance, const struct drawable *drawable)
{
	struct bounds box = bounds_empty();

	for (int v = 0; v < drawable->primitive->vertex_count; v++) {
		float point[3];

		instance_world_vertex(instance, drawable, v, point);
		for (int axis = 0; axis < 3; axis++) {
			point[axis] *= instance->unit_scale;
		}
		bounds_add(&box, point);
	}
	return box;
}

/* Whether all vertices are at the box's top or bottom. */
static bool is_level(const struct search *search,
	const struct drawable *drawable, const struct bounds *box)
{
	float near = level_part * search->extent;

	for (int v = 0; v < drawable->primitive->vertex_count; v++) {
		float point[3], y;

		instance_world_vertex(search->instance, drawable, v, point);
		y = point[1] * search->instance->unit_scale;
		if (y > box->low[1] + near && y < box->high[1] - near) {
			return false;
		}
	}
	return true;
}

static bool moves_vertices(
	const struct model_deltas *deltas, int vertex_count, float near)
{
	for (int v = 0; v < vertex_count; v++) {
		float moved[3];

		model_deltas_get(deltas, v, moved);
		if (vec_length(moved) > near) {
			return true;
		}
	}
	return false;
}

/* Whether a target moves a vertex. In files of key frames, all have targets. */
static bool is_bent(const struct search *search, const struct drawable *drawable)
{
	const struct model_primitive *primitive = drawable->primitive;
	int targets = drawable_target_count(search->instance, drawable);
	float near = level_part * search->extent / search->instance->unit_scale;

	for (int t = 0; t < targets; t++) {
		if (moves_vertices(&primitive->target[t].position,
			    primitive->vertex_count, near)) {
			return true;
		}
	}
	return false;
}

static bool is_solid(
	const struct search *search, const struct drawable *drawable)
{
	const struct model *model = search->instance->model;

	return drawable->skin < 0 &&
		model->material[drawable->primitive->material].alpha ==
		MODEL_OPAQUE;
}

static bool may_be_ground(const struct search *search,
	const struct drawable *drawable, const struct bounds *box)
{
	return !bounds_is_empty(box) &&
		box->high[1] - search->all.low[1] <= flat_part * search->extent &&
		is_level(search, drawable, box) &&
		stands_still(search->instance->model, drawable->node) &&
		!is_bent(search, drawable);
}

/* Together, the surfaces have to be nearly as wide as the model. */
static bool is_wide(const struct search *search, const struct bounds *ground)
{
	const struct bounds *all = &search->all;

	for (int axis = 0; axis < 3; axis += 2) {
		if (ground->high[axis] - ground->low[axis] <
			wide_part * (all->high[axis] - all->low[axis])) {
			return false;
		}
	}
	return all->high[1] > ground->high[1] + above_part * search->extent;
}

/* The candidates whose surface is as high as that of one of them. */
static bool gather(
	struct shadow_ground *ground, const struct search *search, int like)
{
	struct bounds together = bounds_empty();
	float y = search->box[like].high[1];

	ground->count = 0;
	ground->y = y;
	for (int i = 0; i < search->instance->drawable_count; i++) {
		const struct bounds *box = &search->box[i];

		if (!bounds_is_empty(box) &&
			scalar_abs(box->high[1] - y) <=
				level_part * search->extent) {
			ground->drawable[ground->count++] = i;
			bounds_join(&together, box);
		}
	}
	return is_wide(search, &together);
}

/* Of several surfaces, the highest one is seen. */
static void choose(struct shadow_ground *ground, struct search *search)
{
	int count = search->instance->drawable_count, best = -1;

	for (int i = 0; i < count; i++) {
		const struct instance *instance = search->instance;
		const struct drawable *drawable = &instance->drawable[i];
		struct bounds box = is_solid(search, drawable)
			? box_of(instance, drawable)
			: bounds_empty();

		search->box[i] = may_be_ground(search, drawable, &box)
			? box
			: bounds_empty();
	}
	for (int i = 0; i < count; i++) {
		const struct bounds *box = &search->box[i];

		if (!bounds_is_empty(box) &&
			(best < 0 || box->high[1] > search->box[best].high[1]) &&
			gather(ground, search, i)) {
			best = i;
		}
	}
	ground->count = 0;
	if (best >= 0) {
		(void)gather(ground, search, best);
	}
}

int shadow_ground_find(struct shadow_ground *ground, struct instance *instance)
{
	size_t count = (size_t)instance->drawable_count;
	struct search search = {.instance = instance};

	*ground = (struct shadow_ground){.count = 0};
	ground->drawable = ARENA_ARRAY(&instance->arena, int, count);
	search.box = calloc(count + 1, sizeof(*search.box));
	if (!ground->drawable || !search.box) {
		free(search.box);
		return -ENOMEM;
	}
	search.all = bounds_of_clip(instance, -1);
	search.extent = bounds_extent(&search.all);
	choose(ground, &search);
	free(search.box);
	return 0;
}

bool shadow_ground_begin(const struct shadow_ground *ground,
	const struct stage *stage, const struct gl *gl,
	struct instance *instance, const struct texture_set *textures)
{
	if (ground->count == 0 || !stage->has_stencil) {
		return false;
	}
	stage_ground_begin(gl);
	for (int i = 0; i < ground->count; i++) {
		struct drawable *drawable =
			&instance->drawable[ground->drawable[i]];

		draw_instance_part(
			gl, instance, drawable, textures, DRAW_SHADED);
		drawable->hidden = true;
	}
	stage_ground_end(gl, ground->y);
	return true;
}

void shadow_ground_end(
	const struct shadow_ground *ground, struct instance *instance)
{
	for (int i = 0; i < ground->count; i++) {
		instance->drawable[ground->drawable[i]].hidden = false;
	}
}
