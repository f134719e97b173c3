#include "app/scene/instance/batch/index_order.h"

#include <stdlib.h>
#include <string.h>

int index_order_misses(const uint16_t *index, int count)
{
	int32_t slot[INDEX_ORDER_CACHE];
	int misses = 0;

	memset(slot, 0xFF, sizeof(slot));
	for (int i = 0; i < count; i++) {
		int32_t *kept = &slot[index[i] % INDEX_ORDER_CACHE];

		misses += *kept != index[i];
		*kept = index[i];
	}
	return misses;
}

static uint16_t lowest(const uint16_t *corner)
{
	uint16_t low = corner[0] < corner[1] ? corner[0] : corner[1];

	return low < corner[2] ? low : corner[2];
}

static int count_vertices(const uint16_t *index, int count)
{
	int vertices = 0;

	for (int i = 0; i < count; i++) {
		vertices = index[i] < vertices ? vertices : index[i] + 1;
	}
	return vertices;
}

/*
 * Sorts triangles by counting, so that those with the same lowest vertex keep
 * their order. first, [vertices], is 0 before the call; afterwards it says
 * where in out the triangles of each lowest vertex end.
 */
static void sort(const uint16_t *index, int count, int *first, int vertices,
	uint16_t *out)
{
	int before = 0;

	for (int i = 0; i < count; i += 3) {
		first[lowest(index + i)] += 3;
	}
	for (int v = 0; v < vertices; v++) {
		int own = first[v];

		first[v] = before;
		before += own;
	}
	for (int i = 0; i < count; i += 3) {
		int *next = &first[lowest(index + i)];

		memcpy(out + *next, index + i, 3 * sizeof(*out));
		*next += 3;
	}
}

void index_order_improve(uint16_t *index, int count)
{
	size_t bytes = (size_t)count * sizeof(*index);
	int vertices = count_vertices(index, count);
	int *first = calloc((size_t)vertices + 1, sizeof(*first));
	uint16_t *sorted = malloc(bytes + 1);

	if (first && sorted) {
		sort(index, count, first, vertices, sorted);
		if (index_order_misses(sorted, count) <
			index_order_misses(index, count)) {
			memcpy(index, sorted, bytes);
		}
	}
	free(sorted);
	free(first);
}
