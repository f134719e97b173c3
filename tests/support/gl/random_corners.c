#include "tests/support/gl/random_corners.h"

#include "tests/support/random.h"

enum {
	CLOSE = 12, /* corners that lie close together */
	SPREAD = 20000
};

static int16_t to_short(int value)
{
	return (int16_t)(value < INT16_MIN  ? INT16_MIN
			: value > INT16_MAX ? INT16_MAX
					    : value);
}

void random_corners_make(
	uint32_t *seed, int reach, struct random_corner *corner, int count)
{
	for (int i = 0; i < count; i++, corner++) {
		int own = i % CLOSE;
		const int16_t *near = corner[-own].position;

		for (int axis = 0; axis < 3; axis++) {
			int any = random_within(seed, own ? reach : SPREAD);

			corner->position[axis] =
				to_short(any + (own ? near[axis] : 0));
			corner->normal[axis] =
				(int16_t)random_within(seed, INT16_MAX);
			corner->color[axis] = (uint8_t)next_random(seed);
		}
		corner->color[3] = 255;
		corner->texcoord[0] = (float)random_within(seed, 100) / 64.0f;
		corner->texcoord[1] = (float)random_within(seed, 100) / 64.0f;
	}
}

void random_corners_list(
	uint32_t *seed, int corner_count, uint16_t *index, int count)
{
	for (int i = 0; i < count; i++) {
		int near = i / 3 * CLOSE % corner_count;

		index[i] = (uint16_t)(near + (int)(next_random(seed) % CLOSE));
	}
}

void random_corners_set(const struct gl *gl, const struct random_corner *corner)
{
	const GLsizei stride = sizeof(*corner);

	gl->VertexPointer(3, GL_SHORT, stride, corner->position);
	gl->NormalPointer(GL_SHORT, stride, corner->normal);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, stride, corner->color);
	gl->TexCoordPointer(2, GL_FLOAT, stride, corner->texcoord);
}
