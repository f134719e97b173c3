#include "app/scene/draw/glow.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
	CELLS_MAX = 128, /* in a row or column of the map */
	SHINES_FROM =
		8,  /* of 255: a step of RGB565, which black JPEG reaches not */
	MARGIN = 2, /* texels that filters read beside a triangle's own */
	/* Fewer dark triangles do not pay for a second drawing call. */
	LEAST_DARK = 4 /* one in four */
};

static bool shines(const uint8_t rgba[4])
{
	return rgba[0] >= SHINES_FROM || rgba[1] >= SHINES_FROM ||
		rgba[2] >= SHINES_FROM;
}

static uint32_t *corner(const struct glow_map *map, int x, int y)
{
	return &map->shining[y * (map->columns + 1) + x];
}

static void mark_cells(const struct glow_map *map)
{
	const struct model_image *image = map->image;

	for (int y = 0; y < image->height; y++) {
		const uint8_t *row =
			image->rgba + (size_t)y * (size_t)image->width * 4;
		int below = (int)((int64_t)y * map->rows / image->height) + 1;

		for (int x = 0; x < image->width; x++) {
			if (shines(row + (size_t)x * 4)) {
				int64_t at = (int64_t)x * map->columns;

				*corner(map, (int)(at / image->width) + 1,
					below) = 1;
			}
		}
	}
}

static int make_map(struct glow_map *map, const struct model_image *image)
{
	if (map->image == image) {
		return 0;
	}
	glow_map_release(map);
	map->columns = image->width < CELLS_MAX ? image->width : CELLS_MAX;
	map->rows = image->height < CELLS_MAX ? image->height : CELLS_MAX;
	map->shining =
		calloc((size_t)(map->columns + 1) * (size_t)(map->rows + 1),
			sizeof(*map->shining));
	if (!map->shining) {
		return -ENOMEM;
	}
	map->image = image;
	mark_cells(map);
	for (int y = 1; y <= map->rows; y++) {
		for (int x = 1; x <= map->columns; x++) {
			*corner(map, x, y) += *corner(map, x - 1, y) +
				*corner(map, x, y - 1) -
				*corner(map, x - 1, y - 1);
		}
	}
	return 0;
}

void glow_map_release(struct glow_map *map)
{
	free(map->shining);
	*map = (struct glow_map){0};
}

/* Returns the cell of a coordinate from 0 to 1, moved by some texels. */
static int cell_at(float coordinate, int side, int cells, int moved)
{
	int texel = (int)(coordinate * (float)side) + moved;

	texel = texel < 0 ? 0 : texel > side - 1 ? side - 1 : texel;
	return (int)((int64_t)texel * cells / side);
}

/* Whether a texel shines within the box of a triangle's coordinates. */
static bool may_shine(const struct glow_map *map, const float (*texcoord)[2],
	const uint16_t triangle[3])
{
	float least[2], most[2];
	int left = 0, top = 0, right = map->columns, bottom = map->rows;

	for (int i = 0; i < 2; i++) {
		float a = texcoord[triangle[0]][i],
		      b = texcoord[triangle[1]][i], c = texcoord[triangle[2]][i];

		least[i] = fminf(a, fminf(b, c));
		most[i] = fmaxf(a, fmaxf(b, c));
	}
	/* Beside the picture, which may repeat, every texel counts. */
	if (least[0] >= 0.0f && least[1] >= 0.0f && most[0] <= 1.0f &&
		most[1] <= 1.0f) {
		int width = map->image->width, height = map->image->height;

		left = cell_at(least[0], width, map->columns, -MARGIN);
		right = cell_at(most[0], width, map->columns, MARGIN) + 1;
		top = cell_at(least[1], height, map->rows, -MARGIN);
		bottom = cell_at(most[1], height, map->rows, MARGIN) + 1;
	}
	return *corner(map, right, bottom) - *corner(map, left, bottom) -
		*corner(map, right, top) + *corner(map, left, top) >
		0;
}

/* Sorts one list; glow_from stays 0 where it is better left alone. */
static int sort_list(const struct glow_map *map, const float (*texcoord)[2],
	const uint16_t **index, int count, int *glow_from, struct arena *arena)
{
	uint16_t *sorted;
	int dark = 0, shining;

	for (int i = 0; i + 2 < count; i += 3) {
		dark += may_shine(map, texcoord, *index + i) ? 0 : 3;
	}
	if (count == 0 || dark < count / LEAST_DARK) {
		return 0;
	}
	sorted = arena_alloc(arena, (size_t)count, sizeof(*sorted));
	if (!sorted) {
		return -ENOMEM;
	}
	shining = dark;
	dark = 0;
	*glow_from = shining;
	for (int i = 0; i + 2 < count; i += 3) {
		int *end =
			may_shine(map, texcoord, *index + i) ? &shining : &dark;

		memcpy(sorted + *end, *index + i, 3 * sizeof(*sorted));
		*end += 3;
	}
	*index = sorted;
	return 0;
}

static int sort_batch(
	const struct glow_map *map, struct batch *batch, struct arena *arena)
{
	int error = 0;

	if (!batch->index || !batch->texcoord) {
		return 0;
	}
	error = sort_list(map, batch->texcoord, &batch->index,
		batch->index_count, &batch->glow_from, arena);
	for (int i = 0; i < batch->lod_count && !error; i++) {
		struct batch_lod *lod = &batch->lod[i];

		error = sort_list(map, batch->texcoord + lod->first_vertex,
			&lod->index, lod->index_count, &lod->glow_from, arena);
	}
	return error;
}

int glow_sort(struct drawable *drawable, const struct model *model,
	struct glow_map *map, struct arena *arena)
{
	const struct model_material *material =
		&model->material[drawable->primitive->material];
	int texture = material->emissive_texture;
	int error;

	if (texture < 0 || texture == material->texture ||
		drawable->alpha == MODEL_BLEND) {
		return 0;
	}
	error = make_map(map, &model->image[model->texture[texture].image]);
	for (int i = 0; i < drawable->batch_count && !error; i++) {
		error = sort_batch(map, &drawable->batch[i], arena);
	}
	return error;
}
