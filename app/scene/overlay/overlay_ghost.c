#include "app/scene/overlay/overlay_ghost.h"

#include "app/scene/draw/alpha.h"
#include "platform/base/fixed.h"

#include <errno.h>

enum {
	LEVELS_COARSER = 2
};

static int init_glass(struct overlay_ghost *ghost)
{
	const struct model *model = ghost->figure->model;
	struct model_material *material = ARENA_ARRAY(&ghost->instance->arena,
		struct model_material, (size_t)model->material_count);

	if (!material) {
		return -ENOMEM;
	}
	for (int i = 0; i < model->material_count; i++) {
		material[i] = model_plain_material;
	}
	ghost->glass = *model;
	ghost->glass.material = material;
	ghost->instance->model = &ghost->glass;
	for (int d = 0; d < ghost->instance->drawable_count; d++) {
		struct drawable *drawable = &ghost->instance->drawable[d];

		drawable->alpha = MODEL_BLEND;
		for (int b = 0; b < drawable->batch_count; b++) {
			drawable->batch[b].color = NULL;
		}
	}
	alpha_list_blended(ghost->instance);
	return 0;
}

int overlay_ghost_init(struct overlay_ghost *ghost,
	const struct instance *figure, bool solid, const struct log *log)
{
	int error;

	*ghost = (struct overlay_ghost){.figure = figure};
	error = instance_create(
		figure->model, figure->kernel, log, &ghost->instance);
	if (error) {
		ghost->instance = NULL;
		return error;
	}
	ghost->instance->normal_mapping = false;
	error = solid ? 0 : init_glass(ghost);
	if (error) {
		error = memory_budget_fail(ghost->instance->arena.budget,
			figure->model->path, log);
		overlay_ghost_finish(ghost);
	}
	return error;
}

void overlay_ghost_finish(struct overlay_ghost *ghost)
{
	instance_destroy(ghost->instance);
	*ghost = (struct overlay_ghost){0};
}

/* Returns a level coarser than the figure's, as a frame has several ghosts. */
static int ghost_lod(const struct drawable *figure)
{
	int coarsest = figure->batch_count > 0 ? figure->batch[0].lod_count : 0;
	int lod = figure->lod + LEVELS_COARSER;

	return lod < coarsest ? lod : coarsest;
}

void overlay_ghost_draw(struct overlay_ghost *ghost, const struct gl *gl,
	const struct texture_set *textures, const float color[4])
{
	struct instance *instance = ghost->instance;

	for (int d = 0; d < instance->drawable_count; d++) {
		struct drawable *drawable = &instance->drawable[d];

		drawable->lod = ghost_lod(&ghost->figure->drawable[d]);
		for (int i = 0; i < 4; i++) {
			drawable->color[i] = fx16_from_float(color[i]);
		}
	}
	instance_update(instance);
	draw_instance(gl, instance, textures, DRAW_SHADED);
	gl->DepthMask(GL_TRUE);
	gl->Disable(GL_BLEND);
}

void overlay_ghost_draw_solid(struct overlay_ghost *ghost, const struct gl *gl,
	const struct texture_set *textures)
{
	instance_update(ghost->instance);
	draw_instance(gl, ghost->instance, textures, DRAW_SHADED);
}

/*
 * Returns the time of the channel's first key at or after the limit or, if
 * after is false, of its last key before the limit. Returns a negative time if
 * there is none.
 */
static float key_beyond(
	const struct model_channel *channel, float limit_s, bool after)
{
	int low = 0, high = channel->key_count;

	while (low < high) { /* the first key after or at the limit */
		int middle = low + (high - low) / 2;

		if (channel->time_s[middle] < limit_s) {
			low = middle + 1;
		} else {
			high = middle;
		}
	}
	if (after) {
		return low < channel->key_count ? channel->time_s[low] : -1.0f;
	}
	return low > 0 ? channel->time_s[low - 1] : -1.0f;
}

float overlay_ghost_key_time(
	const struct model_clip *clip, float time_s, float gap_s)
{
	bool after = gap_s > 0.0f;
	float found = -1.0f;

	for (int i = 0; i < clip->channel_count; i++) {
		float key = key_beyond(&clip->channel[i], time_s + gap_s, after);

		if (key >= 0.0f &&
			(found < 0.0f || (after ? key < found : key > found))) {
			found = key;
		}
	}
	return found;
}
