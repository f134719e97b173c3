#include "app/compare/optimize/optimize_tipsify.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	CACHE = 16
};

int optimize_tipsify_misses(const uint32_t *index, int count, int vertex_count)
{
	int *fetched = calloc((size_t)vertex_count, sizeof(*fetched));
	int misses = 0;

	if (!fetched) {
		return -ENOMEM;
	}
	/* fetched[v]: the miss that fetched v, evicted CACHE misses later. */
	for (int i = 0; i < count; i++) {
		int *at = &fetched[index[i]];

		if (*at == 0 || misses - *at >= CACHE) {
			*at = ++misses;
		}
	}
	free(fetched);
	return misses;
}

/* The members are named as in the paper. */
struct tipsify {
	const uint32_t *index;
	int count, vertex_count;
	int *first; /* [vertex_count + 2]: where a vertex's triangles begin */
	int *triangle;      /* [count] */
	int *live;          /* [vertex_count]: its triangles not yet written */
	int *stamp;         /* [vertex_count]: when it entered the cache */
	bool *written;      /* [triangles] */
	uint32_t *dead_end; /* a stack of recently used vertices */
	int dead_ends;
	int time, cursor;
	uint32_t *out;
	int out_count;
};

static void list_triangles(struct tipsify *tipsify)
{
	int *first = tipsify->first;

	for (int i = 0; i < tipsify->count; i++) {
		tipsify->live[tipsify->index[i]]++;
		first[tipsify->index[i] + 2]++;
	}
	for (int v = 0; v < tipsify->vertex_count; v++) {
		first[v + 2] += first[v + 1];
	}
	/* The loop moves first[v + 1] from v's first triangle to its end. */
	for (int i = 0; i < tipsify->count; i++) {
		tipsify->triangle[first[tipsify->index[i] + 1]++] = i / 3;
	}
}

static void write_triangle(struct tipsify *tipsify, int triangle)
{
	for (int corner = 0; corner < 3; corner++) {
		uint32_t v = tipsify->index[3 * triangle + corner];

		tipsify->out[tipsify->out_count++] = v;
		tipsify->dead_end[tipsify->dead_ends++] = v;
		tipsify->live[v]--;
		if (tipsify->time - tipsify->stamp[v] > CACHE) {
			tipsify->stamp[v] = tipsify->time++;
		}
	}
	tipsify->written[triangle] = true;
}

/* Chooses the next fan vertex among those written since begin, or -1. */
static int best_neighbour(const struct tipsify *tipsify, int begin)
{
	int best = -1, most = -1;

	for (int i = begin; i < tipsify->out_count; i++) {
		uint32_t v = tipsify->out[i];
		int age = tipsify->time - tipsify->stamp[v];
		int priority = 0;

		if (tipsify->live[v] <= 0) {
			continue;
		}
		if (age + 2 * tipsify->live[v] <= CACHE) {
			priority = age;
		}
		if (priority > most) {
			most = priority;
			best = (int)v;
		}
	}
	return best;
}

static int skip_dead_end(struct tipsify *tipsify)
{
	while (tipsify->dead_ends > 0) {
		uint32_t v = tipsify->dead_end[--tipsify->dead_ends];

		if (tipsify->live[v] > 0) {
			return (int)v;
		}
	}
	for (; tipsify->cursor < tipsify->vertex_count; tipsify->cursor++) {
		if (tipsify->live[tipsify->cursor] > 0) {
			return tipsify->cursor;
		}
	}
	return -1;
}

static void run(struct tipsify *tipsify)
{
	int fan = (int)tipsify->index[0];

	tipsify->time = CACHE + 1;
	while (fan >= 0) {
		int begin = tipsify->out_count;

		for (int i = tipsify->first[fan]; i < tipsify->first[fan + 1];
			i++) {
			if (!tipsify->written[tipsify->triangle[i]]) {
				write_triangle(tipsify, tipsify->triangle[i]);
			}
		}
		fan = best_neighbour(tipsify, begin);
		if (fan < 0) {
			fan = skip_dead_end(tipsify);
		}
	}
}

/*
 * One pass over at least one triangle. *better: it has saved more than 2%, and
 * index has the new order.
 */
static int reorder(uint32_t *index, int count, int vertex_count, bool *better)
{
	size_t vertices = (size_t)vertex_count, corners = (size_t)count;
	struct tipsify tipsify = {
		.index = index,
		.count = count,
		.vertex_count = vertex_count,
		.first = calloc(vertices + 2, sizeof(int)),
		.triangle = calloc(corners, sizeof(int)),
		.live = calloc(vertices, sizeof(int)),
		.stamp = calloc(vertices, sizeof(int)),
		.written = calloc(corners / 3, sizeof(bool)),
		.dead_end = calloc(corners, sizeof(uint32_t)),
		.out = calloc(corners, sizeof(uint32_t)),
	};
	int error = -ENOMEM, before, after;

	*better = false;
	if (tipsify.first && tipsify.triangle && tipsify.live && tipsify.stamp &&
		tipsify.written && tipsify.dead_end && tipsify.out) {
		list_triangles(&tipsify);
		run(&tipsify);
		before = optimize_tipsify_misses(index, count, vertex_count);
		after = optimize_tipsify_misses(
			tipsify.out, count, vertex_count);
		error = before < 0 || after < 0 ? -ENOMEM : 0;
		*better = !error && after * 50LL < before * 49LL;
	}
	if (*better) {
		memcpy(index, tipsify.out, (size_t)count * sizeof(*index));
	}
	free(tipsify.first);
	free(tipsify.triangle);
	free(tipsify.live);
	free(tipsify.stamp);
	free(tipsify.written);
	free(tipsify.dead_end);
	free(tipsify.out);
	return error;
}

int optimize_tipsify(uint32_t *index, int count, int vertex_count)
{
	bool better = count > 0;
	int error = 0;

	while (better && !error) {
		error = reorder(index, count, vertex_count, &better);
	}
	return error;
}
