#include "app/scene/draw/edge_list.h"

#include <stdbool.h>

enum {
	LINES_A_CALL = 768,
	VERTICES_MAX = 65536,
	RECENT_BITS = 10
};

struct edges {
	const struct gl *gl;
	int used;
	uint16_t line[LINES_A_CALL][2];
	/*
	 * A hash table of edges drawn recently: the lower vertex in the upper
	 * 16 bits, the higher one below. Two equal ends mark a free entry.
	 */
	uint32_t recent[1 << RECENT_BITS];
};

static void flush(struct edges *edges)
{
	if (edges->used > 0) {
		edges->gl->DrawElements(GL_LINES, edges->used * 2,
			GL_UNSIGNED_SHORT, edges->line);
	}
	edges->used = 0;
}

/*
 * Returns false if the edge was drawn recently. Triangles that share an edge
 * are near each other in most lists, so a small table suffices.
 */
static bool is_new(struct edges *edges, uint16_t from, uint16_t to)
{
	uint32_t ends = from < to ? (uint32_t)from << 16 | to
				  : (uint32_t)to << 16 | from;
	/* Knuth's multiplicative hash. */
	uint32_t *recent =
		&edges->recent[ends * 2654435761u >> (32 - RECENT_BITS)];

	if (*recent == ends) {
		return false;
	}
	*recent = ends;
	return from != to;
}

static void add(struct edges *edges, uint16_t from, uint16_t to)
{
	if (is_new(edges, from, to)) {
		edges->line[edges->used][0] = from;
		edges->line[edges->used][1] = to;
		if (++edges->used == LINES_A_CALL) {
			flush(edges);
		}
	}
}

void edge_list_draw(const struct gl *gl, const uint16_t *index, int count)
{
	struct edges edges = {.gl = gl};

	if (!index && count > VERTICES_MAX) {
		count = VERTICES_MAX / 3 * 3;
	}
	for (int i = 0; i + 2 < count; i += 3) {
		for (int corner = 0; corner < 3; corner++) {
			int from = i + corner, to = i + (corner + 1) % 3;

			add(&edges, index ? index[from] : (uint16_t)from,
				index ? index[to] : (uint16_t)to);
		}
	}
	flush(&edges);
}
