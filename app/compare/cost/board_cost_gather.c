/*
 * Predicts what it costs to copy a drawable's posed vertices for GL, and to
 * find the normals of its triangles (app/scene/instance/batch/batch_gather.c).
 *
 * Most of it is reading: vertices of a triangle, or of a level of detail, may
 * lie far apart. So the reads are followed through caches like the board's.
 */
#include "app/compare/cost/board_cost.h"
#include "app/compare/cost/line_reads.h"

/*
 * What the timing model counts (tests/arm1136) of a vertex, of a facet and of a
 * corner of a level, with all data in L1; more where vertices are stored in
 * another order, as those of a skin are.
 */
static const struct board_cost gathered_vertex = {14.8, 10.1};
static const struct board_cost ordered_vertex = {18.2, 11.1};
static const struct board_cost facet = {101.6, 84.0};
static const struct board_cost corner = {111.0, 91.0};
static const struct board_cost ordered_corner = {114.0, 91.0};
/* A line that is read from the second-level cache, and one from memory. */
static const struct board_cost cached_line = {10.0, 0.0};
static const struct board_cost missed_line = {78.0, 0.0};

/* The arrays that are read. */
enum {
	SOURCE,
	INVERSE_ORDER,
	POSITION,
	NORMAL,
	CORNER,
	INDEX, /* of the primitive */
	LIST,  /* the index of the batch's list */
	GATHERED
};

enum {
	VECTOR_BYTES = 8 /* of a struct fixed_vector */
};

/* What gathering a drawable takes. */
struct gathered {
	const struct drawable *drawable;
	const uint32_t *inverse_order; /* or NULL */
	struct line_reads reads;
	double vertices, facets, corners;
};

static void read(struct gathered *to, uint32_t array, uint32_t index)
{
	line_reads_add(&to->reads, array, index, sizeof(uint32_t));
}

static void read_vector(struct gathered *to, uint32_t array, uint32_t index)
{
	line_reads_add(&to->reads, array, index, VECTOR_BYTES);
}

/* Where the primitive's vertex is stored. */
static uint32_t stored(struct gathered *to, uint32_t vertex)
{
	if (!to->inverse_order) {
		return vertex;
	}
	read(to, INVERSE_ORDER, vertex);
	return to->inverse_order[vertex];
}

static void copy(struct gathered *to, const struct batch *batch, int first,
	int count, bool lit)
{
	for (int v = first; v < first + count; v++) {
		uint32_t from;

		read(to, SOURCE, (uint32_t)v);
		from = stored(to, batch->source[v]);
		read_vector(to, POSITION, from);
		if (lit && to->drawable->primitive->normal) {
			read_vector(to, NORMAL, from);
		}
	}
	to->vertices += count;
}

/* The facets of a list of so many corners, which is batch->index or a list's. */
static void find_facets(
	struct gathered *to, const uint16_t *index, int corner_count, int first)
{
	for (int i = 0; i + 2 < corner_count; i += 3) {
		for (int k = 0; k < 3; k++) {
			int at = index ? index[i + k] : i + k;

			if (index) {
				line_reads_add(&to->reads, LIST,
					(uint32_t)(i + k), sizeof(*index));
			}
			read_vector(to, GATHERED, (uint32_t)(first + at));
		}
	}
	to->facets += corner_count / 3;
}

/* The normals of a level's vertices: those of triangles of the full list. */
static void find_corners(struct gathered *to, const struct batch *batch,
	const struct batch_lod *list)
{
	const uint32_t *index = to->drawable->primitive->index;

	for (int i = 0; i < list->vertex_count; i++) {
		int v = list->first_vertex + i;
		uint32_t first = batch->corner[v] / 3 * 3;

		read(to, CORNER, (uint32_t)v);
		for (uint32_t k = 0; k < 3; k++) {
			read(to, INDEX, first + k);
			read_vector(to, POSITION, stored(to, index[first + k]));
		}
	}
	to->corners += list->vertex_count;
}

static void gather_full(struct gathered *to, const struct batch *batch, bool lit)
{
	copy(to, batch, 0, batch->vertex_count, lit);
	if (lit && !to->drawable->primitive->normal) {
		find_facets(to, batch->index,
			batch->index ? batch->index_count : batch->vertex_count,
			0);
	}
}

static void gather_list(struct gathered *to, const struct batch *batch,
	const struct batch_lod *list, bool lit)
{
	if (!list) {
		gather_full(to, batch, lit);
		return;
	}
	copy(to, batch, list->first_vertex, list->vertex_count, lit);
	if (!lit || to->drawable->primitive->normal) {
		return;
	}
	if (list->flat || !batch->corner) {
		find_facets(
			to, list->index, list->index_count, list->first_vertex);
	} else {
		find_corners(to, batch, list);
	}
}

static void begin(struct gathered *to, const struct drawable *drawable)
{
	const struct drawable_fixed *fixed = drawable->fixed;

	to->drawable = drawable;
	to->inverse_order = fixed ? fixed->inverse_order : NULL;
	to->vertices = to->facets = to->corners = 0.0;
	line_reads_begin(&to->reads);
}

static void add_times(
	struct board_cost *sum, const struct board_cost *each, double count)
{
	sum->cycles += each->cycles * count;
	sum->instructions += each->instructions * count;
}

static struct board_cost cost_of(const struct gathered *gathered)
{
	struct board_cost sum = {0.0, 0.0};

	const bool ordered = gathered->inverse_order != NULL;

	add_times(&sum, ordered ? &ordered_vertex : &gathered_vertex,
		gathered->vertices);
	add_times(&sum, &facet, gathered->facets);
	add_times(&sum, ordered ? &ordered_corner : &corner, gathered->corners);
	add_times(&sum, &cached_line, gathered->reads.cached);
	add_times(&sum, &missed_line, gathered->reads.missed);
	return sum;
}

struct board_cost board_cost_gather_drawn(const struct drawable *drawable)
{
	struct gathered gathered;

	begin(&gathered, drawable);
	for (int i = 0; i < drawable->batch_count; i++) {
		const struct batch *batch = &drawable->batch[i];
		const struct batch_lod *list = drawable_shaded(drawable, batch);
		const struct batch_lod *shadow =
			drawable_shadow(drawable, batch);

		if (!batch->source) {
			continue;
		}
		gather_list(&gathered, batch, list, true);
		/* A list for shadows may have the vertices of the full list. */
		if (shadow != list && (list || shadow->first_vertex > 0)) {
			gather_list(&gathered, batch, shadow, false);
		}
	}
	return cost_of(&gathered);
}

struct board_cost board_cost_gather(const struct drawable *drawable)
{
	struct gathered gathered;

	begin(&gathered, drawable);
	for (int i = 0; i < drawable->batch_count; i++) {
		const struct batch *batch = &drawable->batch[i];

		if (batch->source) {
			gather_full(&gathered, batch, true);
		}
	}
	return cost_of(&gathered);
}
