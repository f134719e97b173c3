#include "app/compare/export/export_bake.h"

#include "app/model/color.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

void export_attribute(json_t *attributes, const char *name, int accessor)
{
	json_object_set_new(attributes, name, json_integer(accessor));
}

/*
 * Returns a copy of elements source[0..count - 1] (NULL: the first count),
 * which the caller frees; NULL if there is no memory.
 */
static void *gather(const void *from, size_t size, int count, const int *source)
{
	uint8_t *to = malloc((size_t)count * size);

	for (int i = 0; to && i < count; i++) {
		size_t at = (size_t)(source ? source[i] : i);

		memcpy(to + (size_t)i * size, (const uint8_t *)from + at * size,
			size);
	}
	return to;
}

/* Vertex colours are sRGB in limber, and linear in glTF. */
static void add_colors(struct glb *glb, json_t *attributes,
	const struct model_primitive *primitive, int vertex_count,
	const int *source)
{
	float(*color)[4] = malloc((size_t)vertex_count * sizeof(*color));

	if (!color) {
		glb->error = -ENOMEM;
		return;
	}
	for (int i = 0; i < vertex_count; i++) {
		const uint8_t *from = primitive->color[source ? source[i] : i];

		for (int c = 0; c < 4; c++) {
			float shown = (float)from[c] / 255.0f;

			color[i][c] = c < 3 ? color_decode_srgb(shown) : shown;
		}
	}
	export_attribute(attributes, "COLOR_0",
		glb_add_array(glb, color, vertex_count, 4, GLB_FLOAT));
	free(color);
}

void export_attributes(struct glb *glb, json_t *attributes,
	const struct model_primitive *primitive, int vertex_count,
	const int *source)
{
	if (primitive->texcoord) {
		void *texcoord = gather(primitive->texcoord,
			sizeof(*primitive->texcoord), vertex_count, source);

		glb->error = texcoord ? glb->error : -ENOMEM;
		export_attribute(attributes, "TEXCOORD_0",
			texcoord ? glb_add_array(glb, texcoord, vertex_count, 2,
					   GLB_FLOAT)
				 : -1);
		free(texcoord);
	}
	if (primitive->color) {
		add_colors(glb, attributes, primitive, vertex_count, source);
	}
}

int export_indices(struct glb *glb, const uint32_t *index, int count)
{
	static const uint32_t nothing[3] = {0, 0, 0};
	uint16_t *small;
	uint32_t most = 0;
	int accessor;

	index = count > 0 ? index : nothing;
	count = count > 0 ? count : 3;
	for (int i = 0; i < count; i++) {
		most = index[i] > most ? index[i] : most;
	}
	/* 65535 restarts a strip in some programs, so glTF excludes it. */
	if (most >= UINT16_MAX) {
		return glb_add_array(glb, index, count, 1, GLB_UINT);
	}
	small = malloc((size_t)count * sizeof(*small));
	if (!small) {
		glb->error = glb->error ? glb->error : -ENOMEM;
		return -1;
	}
	for (int i = 0; i < count; i++) {
		small[i] = (uint16_t)index[i];
	}
	accessor = glb_add_array(glb, small, count, 1, GLB_USHORT);
	free(small);
	return accessor;
}
