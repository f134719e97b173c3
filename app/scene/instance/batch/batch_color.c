/* Changes of the colours of a drawable's vertices. */
#include "app/model/color.h"
#include "app/scene/instance/batch/batch.h"

#include <errno.h>
#include <string.h>

int batch_recolor(struct drawable *drawable, batch_dye *dye, void *user,
	struct arena *arena)
{
	for (int i = 0; i < drawable->batch_count; i++) {
		struct batch *batch = &drawable->batch[i];
		size_t count = (size_t)batch_array_length(batch);
		uint8_t(*color)[4];

		if (!batch->color) {
			continue;
		}
		color = arena_alloc(arena, count, sizeof(*color));
		if (!color) {
			return -ENOMEM;
		}
		memcpy(color, batch->color, count * sizeof(*color));
		for (int v = 0; v < batch_array_length(batch); v++) {
			dye(user, batch_vertex(drawable, batch, v), color[v]);
		}
		batch->color = (const uint8_t(*)[4])color;
	}
	return 0;
}

static void multiply(void *user, int vertex, uint8_t color[4])
{
	const float *factor = user;

	(void)vertex;
	for (int i = 0; i < 3; i++) {
		color[i] = (uint8_t)(color[i] * factor[i] + 0.5f);
	}
}

int batch_tint(
	struct drawable *drawable, const float factor[3], struct arena *arena)
{
	float copy[3];

	for (int i = 0; i < 3; i++) {
		copy[i] = factor[i];
		drawable->color[i] =
			(fx16_t)((float)drawable->color[i] * factor[i]);
	}
	return batch_recolor(drawable, multiply, copy, arena);
}

static void mirror(void *user, int vertex, uint8_t color[4])
{
	(void)user;
	(void)vertex;
	color_mirror(color);
}

static bool has_dark_color(const struct batch *batch)
{
	for (int v = 0; batch->color && v < batch_array_length(batch); v++) {
		uint8_t color[3];

		memcpy(color, batch->color[v], sizeof(color));
		color_mirror(color);
		if (memcmp(color, batch->color[v], sizeof(color)) != 0) {
			return true;
		}
	}
	return false;
}

int batch_add_mirrored(struct drawable *drawable, struct arena *arena)
{
	for (int i = 0; i < drawable->batch_count; i++) {
		if (has_dark_color(&drawable->batch[i])) {
			return batch_recolor(drawable, mirror, NULL, arena);
		}
	}
	return 0;
}
