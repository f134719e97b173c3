/*
 * Runs the fixed-point loops between markers, on data of their own that stays
 * in L1: KERNEL LOOP [INFLUENCES]. Region 1 is one warm pass of VERTICES
 * vertices; the loop's cycles a vertex are what it took over VERTICES.
 */
#include "app/anim/kernel/fixed.h"
#include "app/anim/kernel/kernel.h"
#include "tests/arm1136/marker.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	VERTICES = 256,
	RUNS = 4,
	JOINTS = 16,
	INFLUENCES_MAX = 8
};

struct data {
	_Alignas(32) struct fixed_base base[VERTICES * INFLUENCES_MAX + 1];
	struct fixed_matrix palette[JOINTS];
	_Alignas(32) struct fixed_vector from[VERTICES], out[VERTICES];
	struct fixed_pair pair[VERTICES][3];
	struct fixed_sum sum[VERTICES];
	struct fixed_group group;
	int32_t run[RUNS * (1 + INFLUENCES_MAX)];
};

static void fill(struct data *data, int influences)
{
	unsigned seed = 1;

	for (size_t i = 0; i < sizeof(*data); i++) {
		seed = seed * 1664525u + 1013904223u;
		((uint8_t *)data)[i] = (uint8_t)(seed >> 24);
	}
	data->group = (struct fixed_group){influences, RUNS, data->run};
	for (int r = 0, at = 0; r < RUNS; r++) {
		data->run[at++] = VERTICES / RUNS;
		for (int i = 0; i < influences; i++) {
			data->run[at++] = (r * 5 + i * 3) % JOINTS *
				(int)sizeof(struct fixed_matrix);
		}
	}
}

static void run(
	const struct fixed_loops *loops, const char *name, struct data *data)
{
	const struct fixed_pair(*pair)[3] =
		(const struct fixed_pair(*)[3])data->pair;
	const struct fixed_weights weights = {-12000, -20768};

	if (!strcmp(name, "skin")) {
		loops->skin(
			&data->group, 1, data->base, data->palette, data->out);
	} else if (!strcmp(name, "lerp")) {
		loops->lerp(VERTICES, pair, weights, data->out);
	} else if (!strcmp(name, "increment")) {
		loops->increment(VERTICES, data->from, data->out);
	} else if (!strcmp(name, "morph_pair")) {
		loops->morph_pair(
			VERTICES, data->from, pair, weights, data->out);
	} else if (!strcmp(name, "morph_begin")) {
		loops->morph_begin(VERTICES, data->from, data->sum);
	} else if (!strcmp(name, "morph_add")) {
		loops->morph_add(VERTICES, pair, weights, data->sum);
	} else {
		loops->morph_end(VERTICES, data->sum, data->out);
	}
}

int main(int argc, char **argv)
{
	const struct kernel *kernel = kernel_find(argc > 1 ? argv[1] : NULL);
	const char *name = argc > 2 ? argv[2] : "skin";
	static struct data data;

	if (!kernel || !kernel->fixed) {
		fprintf(stderr, "no such kernel\n");
		return 1;
	}
	fill(&data, argc > 3 ? atoi(argv[3]) : 2);
	MARKER_BEGIN(0);
	MARKER_END(0);
	run(kernel->fixed, name, &data);
	run(kernel->fixed, name, &data);
	MARKER_BEGIN(1);
	run(kernel->fixed, name, &data);
	MARKER_END(1);
	return 0;
}
