#include "app/scene/overlay/overlay_heat.h"

#include "app/anim/math/vec.h"
#include "app/model/model_deltas.h"
#include "app/scene/instance/batch/batch.h"
#include "platform/base/scalar.h"

#include <errno.h>

static int init_materials(struct overlay_heat *heat, struct arena *arena)
{
	const struct model *model = heat->instance->model;
	struct model_material *material = ARENA_ARRAY(
		arena, struct model_material, (size_t)model->material_count);

	if (!material) {
		return -ENOMEM;
	}
	for (int i = 0; i < model->material_count; i++) {
		material[i] = model_plain_material;
		material[i].double_sided = model->material[i].double_sided;
	}
	heat->plain = *model;
	heat->plain.material = material;
	return 0;
}

static int init_colors(struct overlay_heat *heat, struct arena *arena)
{
	struct instance *instance = heat->instance;
	int at = 0;

	for (int d = 0; d < instance->drawable_count; d++) {
		for (int b = 0; b < instance->drawable[d].batch_count; b++) {
			int count = batch_array_length(
				&instance->drawable[d].batch[b]);

			heat->color[at] = arena_alloc(arena, (size_t)count, 4);
			if (!heat->color[at]) {
				return -ENOMEM;
			}
			for (int i = 0; i < count; i++) {
				overlay_heat_ramp(0.0f, heat->color[at][i]);
				heat->color[at][i][3] = 255;
			}
			at++;
		}
	}
	return 0;
}

int overlay_heat_init(struct overlay_heat *heat, struct instance *instance,
	struct arena *arena)
{
	int error;

	*heat = (struct overlay_heat){.instance = instance};
	for (int d = 0; d < instance->drawable_count; d++) {
		heat->batch_count += instance->drawable[d].batch_count;
	}
	heat->color = arena_alloc(
		arena, (size_t)heat->batch_count, sizeof(*heat->color));
	heat->kept = arena_alloc(
		arena, (size_t)heat->batch_count, sizeof(*heat->kept));
	if (!heat->color || !heat->kept) {
		return -ENOMEM;
	}
	error = init_materials(heat, arena);
	return error ? error : init_colors(heat, arena);
}

void overlay_heat_paint(
	struct overlay_heat *heat, overlay_heat_color_fn color, void *user)
{
	uint8_t(**rgb)[4] = heat->color;

	for (int d = 0; d < heat->instance->drawable_count; d++) {
		const struct drawable *drawable = &heat->instance->drawable[d];

		for (int b = 0; b < drawable->batch_count; b++, rgb++) {
			const struct batch *batch = &drawable->batch[b];

			for (int i = 0; i < batch_array_length(batch); i++) {
				color(user, d, batch_vertex(drawable, batch, i),
					(*rgb)[i]);
			}
		}
	}
}

/* What a heat map shows: node_value or, if that is NULL, a morph target. */
struct subject {
	const struct instance *instance;
	const float *node_value;
	int target;
	/* greatest distance that the target moves a vertex; above 0 */
	float farthest;
};

/* How far the target moves a vertex; 0 in a mesh with fewer targets. */
static float distance_of(const struct subject *subject,
	const struct drawable *drawable, int vertex)
{
	const struct model_target *targets = drawable->primitive->target;
	int target = subject->target;
	float moved[3] = {0.0f, 0.0f, 0.0f};

	if (target < drawable_target_count(subject->instance, drawable)) {
		model_deltas_get(&targets[target].position, vertex, moved);
	}
	return vec_length(moved);
}

static float value_of(const struct subject *subject,
	const struct drawable *drawable, int vertex)
{
	struct skin_influence influence[SKIN_INFLUENCES_MAX];
	const struct model_skin *skin;
	float value = 0.0f;
	int count;

	if (!subject->node_value) {
		return distance_of(subject, drawable, vertex) /
			subject->farthest;
	}
	if (drawable->skin < 0) {
		return subject->node_value[drawable->node];
	}
	skin = &subject->instance->model->skin[drawable->skin];
	count = skin_gather_influences(
		drawable->primitive, (uint32_t)vertex, influence);
	for (int i = 0; i < count; i++) {
		value += influence[i].weight *
			subject->node_value[skin->joint[influence[i].joint]];
	}
	return value;
}

static void color_subject(void *user, int drawable, int vertex, uint8_t rgb[3])
{
	const struct subject *subject = user;

	overlay_heat_ramp(
		value_of(subject, &subject->instance->drawable[drawable], vertex),
		rgb);
}

void overlay_heat_paint_nodes(struct overlay_heat *heat, const float *value)
{
	struct subject subject = {
		.instance = heat->instance, .node_value = value};

	overlay_heat_paint(heat, color_subject, &subject);
}

void overlay_heat_paint_target(struct overlay_heat *heat, int target)
{
	struct subject subject = {
		.instance = heat->instance, .target = target, .farthest = 1e-9f};

	for (int d = 0; d < heat->instance->drawable_count; d++) {
		const struct drawable *drawable = &heat->instance->drawable[d];

		for (int v = 0; v < drawable->primitive->vertex_count; v++) {
			float distance = distance_of(&subject, drawable, v);

			subject.farthest =
				scalar_max(distance, subject.farthest);
		}
	}
	overlay_heat_paint(heat, color_subject, &subject);
}

/* Gives the batches the heat map's colours, or their own ones back. */
static void set_colors(struct overlay_heat *heat, bool painted)
{
	int at = 0;

	for (int d = 0; d < heat->instance->drawable_count; d++) {
		struct drawable *drawable = &heat->instance->drawable[d];

		for (int b = 0; b < drawable->batch_count; b++, at++) {
			struct batch *batch = &drawable->batch[b];

			if (painted) {
				heat->kept[at] = batch->color;
			}
			batch->color = painted
				? (const uint8_t(*)[4])heat->color[at]
				: heat->kept[at];
		}
	}
}

void overlay_heat_switch(struct overlay_heat *heat, bool on)
{
	struct instance *instance = heat->instance;

	if (on == (heat->model != NULL)) {
		return;
	}
	if (on) {
		heat->model = instance->model;
		heat->normal_mapping = instance->normal_mapping;
	}
	instance->model = on ? &heat->plain : heat->model;
	instance->normal_mapping = !on && heat->normal_mapping;
	heat->model = on ? heat->model : NULL;
	set_colors(heat, on);
}

void overlay_heat_ramp(float fraction, uint8_t rgb[3])
{
	static const float stop[4][3] = {{70.0f, 110.0f, 190.0f},
		{70.0f, 190.0f, 120.0f}, {246.0f, 204.0f, 72.0f},
		{236.0f, 60.0f, 56.0f}};
	float at = scalar_clamp(fraction, 0.0f, 1.0f) * 3.0f;
	int from = at < 1.0f ? 0 : at < 2.0f ? 1 : 2;
	float part = at - (float)from;

	for (int i = 0; i < 3; i++) {
		rgb[i] = (uint8_t)(stop[from][i] +
			(stop[from + 1][i] - stop[from][i]) * part + 0.5f);
	}
}
