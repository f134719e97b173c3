#include "app/demo/vertex_tint.h"

#include <errno.h>
#include <string.h>

static int init_materials(struct vertex_tint *tint)
{
	struct model *plain = &tint->plain;
	size_t count = (size_t)tint->kept->material_count;
	struct model_material *material = ARENA_ARRAY(
		&tint->instance->arena, struct model_material, count);

	if (!material) {
		return -ENOMEM;
	}
	memcpy(material, tint->kept->material, count * sizeof(*material));
	for (size_t i = 0; i < count; i++) {
		material[i].texture = material[i].normal_texture = -1;
		material[i].roughness = 1.0f;
		material[i].alpha = MODEL_OPAQUE;
	}
	*plain = *tint->kept;
	plain->material = material;
	return 0;
}

/* A gathered batch would need a copy of the colours. */
static bool can_paint(const struct drawable *drawable)
{
	return drawable->batch_count == 1 && !drawable->batch[0].source;
}

int vertex_tint_init(struct vertex_tint *tint, struct instance *instance)
{
	struct arena *arena = &instance->arena;
	size_t count = (size_t)instance->drawable_count;

	*tint = (struct vertex_tint){
		.instance = instance, .kept = instance->model};
	tint->kept_color = arena_alloc(arena, count, sizeof(*tint->kept_color));
	tint->color = arena_alloc(arena, count, sizeof(*tint->color));
	if (!tint->kept_color || !tint->color) {
		return -ENOMEM;
	}
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		size_t vertices = (size_t)drawable->primitive->vertex_count;

		if (!can_paint(drawable)) {
			continue;
		}
		tint->color[i] = arena_alloc(arena, vertices, 4);
		if (!tint->color[i]) {
			return -ENOMEM;
		}
		memset(tint->color[i], 255, vertices * 4);
		tint->kept_color[i] = drawable->batch[0].color;
	}
	return init_materials(tint);
}

void vertex_tint_switch(struct vertex_tint *tint, bool on)
{
	struct instance *instance = tint->instance;

	instance->model = on ? &tint->plain : tint->kept;
	for (int i = 0; i < instance->drawable_count; i++) {
		if (tint->color[i]) {
			instance->drawable[i].batch[0].color = on
				? (const uint8_t(*)[4])tint->color[i]
				: tint->kept_color[i];
		}
	}
}

void vertex_tint_set(struct vertex_tint *tint, int drawable, int vertex,
	const uint8_t rgb[3])
{
	const struct drawable_fixed *fixed =
		tint->instance->drawable[drawable].fixed;

	if (tint->color[drawable]) {
		size_t at = fixed && fixed->inverse_order
			? fixed->inverse_order[vertex]
			: (size_t)vertex;

		memcpy(tint->color[drawable][at], rgb, 3);
	}
}
