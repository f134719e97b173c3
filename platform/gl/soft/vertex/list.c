/* Lists of triangles by 16-bit indices, and single triangles. */
#include "platform/gl/soft/vertex/primitive.h"

static void draw_indexed(struct draw *draw, const uint16_t index[3])
{
	struct vertex *v[3];

	v[0] = find_by_index(draw, index[0]);
	v[1] = find_by_index(draw, index[1]);
	v[2] = find_by_index(draw, index[2]);
	if (v[0] == v[1] || v[0] == v[2] || v[1] == v[2]) {
		const struct source source = {
			.indices = (const uint8_t *)index,
			.type = GL_UNSIGNED_SHORT,
		};
		const uint32_t which[3] = {0, 1, 2};

		soft_find_vertices(draw, &source, which, 3, v);
	}
	draw_transformed(draw, v);
}

void soft_list_other(struct draw *draw, const uint16_t index[3])
{
	draw_indexed(draw, index);
}

void soft_list_c(struct draw *draw, const void *indices, uint32_t count)
{
	const uint8_t *at = indices;

	for (uint32_t i = 0; i + 2 < count; i += 3, at += 6) {
		uint16_t index[3];

		memcpy(index, at, sizeof(index));
		draw_indexed(draw, index);
	}
}

void soft_draw_apart(struct draw *draw, uint32_t index)
{
	struct vertex *v[3];

	for (uint32_t i = 0; i < 3; i++) {
		v[i] = &draw->apart[i];
		soft_transform(draw, index + i, v[i]);
	}
	draw_transformed(draw, v);
}
