#include "app/anim/math/vec.h"
#include "app/anim/procedural/bone.h"
#include "app/anim/procedural/cloth.h"

#include <errno.h>
#include <string.h>

struct cloth_settings cloth_settings_default(void)
{
	return (struct cloth_settings){
		.columns = 8,
		.rows = 10,
		.gravity = {0, -9.81f, 0},
		.air = 4,
		.damping = 0.6f,
		.bend = 0.2f,
		.radius = 0.01f,
		.fastest = 30,
		.passes = 4,
	};
}

static bool side_is_in_range(int side)
{
	return side >= CLOTH_SIDE_MIN && side <= CLOTH_SIDE_MAX;
}

/*
 * A particle begins at most six links: right, down, two diagonals, and two to
 * every second particle.
 */
static size_t most_links(int count)
{
	return 6 * (size_t)count;
}

static bool allocate(struct cloth *cloth, struct arena *arena)
{
	size_t count = (size_t)cloth->count;
	size_t columns = (size_t)cloth->settings.columns;

	cloth->position = arena_alloc(arena, count, sizeof(float[3]));
	cloth->normal = arena_alloc(arena, count, sizeof(float[3]));
	cloth->velocity = arena_alloc(arena, count, sizeof(float[3]));
	cloth->before = arena_alloc(arena, count, sizeof(float[3]));
	cloth->offset = arena_alloc(arena, count, sizeof(float[3]));
	cloth->hang = ARENA_ARRAY(arena, float, count);
	cloth->pin = ARENA_ARRAY(arena, int, columns);
	cloth->pin_from = arena_alloc(arena, columns, sizeof(float[3]));
	cloth->pin_to = arena_alloc(arena, columns, sizeof(float[3]));
	cloth->link =
		ARENA_ARRAY(arena, struct cloth_link, most_links(cloth->count));
	return cloth->position && cloth->normal && cloth->velocity &&
		cloth->before && cloth->offset && cloth->hang && cloth->pin &&
		cloth->pin_from && cloth->pin_to && cloth->link;
}

static float distance(const float a[3], const float b[3])
{
	float offset[3];

	vec_subtract(b, a, offset);
	return vec_length(offset);
}

/* Links a particle with the one at an offset in the grid, if it exists. */
static void link_to(struct cloth *cloth, const float (*shape)[3], int i,
	int right, int down, float stiffness)
{
	int columns = cloth->settings.columns;
	int column = i % columns + right;
	int row = i / columns + down;
	int other = row * columns + column;

	if (column < 0 || column >= columns || row >= cloth->settings.rows ||
		stiffness <= 0) {
		return;
	}
	cloth->link[cloth->link_count++] = (struct cloth_link){
		.a = (uint16_t)i,
		.b = (uint16_t)other,
		.length = distance(shape[i], shape[other]),
		.stiffness = stiffness,
	};
}

static void make_links(struct cloth *cloth, const float (*shape)[3])
{
	float bend = cloth->settings.bend;

	for (int i = 0; i < cloth->count; i++) {
		link_to(cloth, shape, i, 1, 0, 1);
		link_to(cloth, shape, i, 0, 1, 1);
		link_to(cloth, shape, i, 1, 1, 0.5f);
		link_to(cloth, shape, i, -1, 1, 0.5f);
		link_to(cloth, shape, i, 2, 0, bend);
		link_to(cloth, shape, i, 0, 2, bend);
	}
}

static void measure_columns(struct cloth *cloth, const float (*shape)[3])
{
	int columns = cloth->settings.columns;

	for (int i = columns; i < cloth->count; i++) {
		cloth->hang[i] = cloth->hang[i - columns] +
			distance(shape[i - columns], shape[i]);
	}
}

/* Converts the shape to the frames of the nodes that hold its columns. */
static void fix_to_nodes(
	struct cloth *cloth, const float (*shape)[3], const mat4 *world)
{
	for (int i = 0; i < cloth->count; i++) {
		const mat4 *at = &world[cloth->pin[i % cloth->settings.columns]];
		float offset[3];
		float scale = vec_length((*at)[0]);

		vec_subtract(shape[i], (*at)[3], offset);
		bone_to_axes(at, 0, offset, offset);
		for (int k = 0; k < 3; k++) {
			cloth->offset[i][k] = scale > 0 ? offset[k] / scale : 0;
		}
	}
}

int cloth_init(struct cloth *cloth, const struct cloth_settings *settings,
	const float (*shape)[3], const int *pin, const mat4 *world,
	struct arena *arena)
{
	if (!side_is_in_range(settings->columns) ||
		!side_is_in_range(settings->rows)) {
		return -EINVAL;
	}
	*cloth = (struct cloth){
		.settings = *settings,
		.count = settings->columns * settings->rows,
	};
	if (!allocate(cloth, arena)) {
		return -ENOMEM;
	}
	memcpy(cloth->pin, pin, (size_t)settings->columns * sizeof(*cloth->pin));
	memcpy(cloth->position, shape,
		(size_t)cloth->count * sizeof(*cloth->position));
	make_links(cloth, shape);
	measure_columns(cloth, shape);
	fix_to_nodes(cloth, shape, world);
	return 0;
}

int cloth_triangles(const struct cloth_settings *settings, uint16_t *index)
{
	int columns = settings->columns;
	int count = 0;

	for (int r = 0; r + 1 < settings->rows; r++) {
		for (int c = 0; c + 1 < columns; c++) {
			int i = r * columns + c;
			/* Counter-clockwise seen from the normals' side. */
			const int corner[6] = {i, i + columns, i + 1, i + 1,
				i + columns, i + columns + 1};

			for (int k = 0; k < 6; k++) {
				index[count++] = (uint16_t)corner[k];
			}
		}
	}
	return count;
}
