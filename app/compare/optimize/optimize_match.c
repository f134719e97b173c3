#include "app/compare/optimize/optimize_match.h"

#include <errno.h>
#include <stdlib.h>

/* The drawables of one primitive of the file at one node. */
struct run {
	const struct instance *instance;
	int begin, end;
	int first_vertex, vertex_count;
};

static bool is_same_primitive(const struct drawable *a, const struct drawable *b)
{
	return a->node == b->node &&
		a->primitive->file_index == b->primitive->file_index;
}

/* Moves on to the next run. Returns false at the end. */
static bool next(struct run *run)
{
	const struct drawable *drawable = run->instance->drawable;

	run->begin = run->end;
	run->first_vertex += run->vertex_count;
	run->vertex_count = 0;
	while (run->end < run->instance->drawable_count &&
		is_same_primitive(&drawable[run->begin], &drawable[run->end])) {
		run->vertex_count +=
			drawable[run->end++].primitive->vertex_count;
	}
	return run->end > run->begin;
}

/*
 * Writes the numbers in the file of the run's vertices. Returns the largest one
 * plus 1.
 */
static int number_vertices(const struct run *run, uint32_t *number)
{
	uint32_t count = 0;

	for (int i = run->begin; i < run->end; i++) {
		const struct model_primitive *primitive =
			run->instance->drawable[i].primitive;

		for (int v = 0; v < primitive->vertex_count; v++) {
			*number = primitive->file_vertex
				? primitive->file_vertex[v]
				: (uint32_t)v;
			count = *number >= count ? *number + 1 : count;
			number++;
		}
	}
	return (int)count;
}

static int match_run(
	const struct run *wanted, const struct run *found, int *source)
{
	size_t most = wanted->vertex_count > found->vertex_count
		? (size_t)wanted->vertex_count
		: (size_t)found->vertex_count;
	uint32_t *number = malloc((most + 1) * sizeof(*number));
	int count = number ? number_vertices(wanted, number) : 0;
	int *place = calloc((size_t)count + 1, sizeof(*place));
	int error = number && place ? 0 : -ENOMEM;

	for (int v = 0; v < wanted->vertex_count && !error; v++) {
		place[number[v]] = wanted->first_vertex + v;
	}
	if (!error && number_vertices(found, number) != count) {
		error = -EINVAL;
	}
	for (int v = 0; v < found->vertex_count && !error; v++) {
		source[found->first_vertex + v] = place[number[v]];
	}
	free(number);
	free(place);
	return error;
}

int optimize_match(const struct instance *wanted, const struct instance *found,
	int *source)
{
	struct run a = {.instance = wanted}, b = {.instance = found};
	int error = 0;

	while (!error) {
		bool more = next(&a);

		if (next(&b) != more) {
			return -EINVAL;
		}
		if (!more) {
			return 0;
		}
		error = match_run(&a, &b, source);
	}
	return error;
}
