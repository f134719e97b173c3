/*
 * Plays what `limber export` wrote: prints the vertices at a time, as limber
 * pose does, with their normals, and the size of its state. EXPORTED is the
 * name of the file, P the prefix of its functions.
 */
#include EXPORTED

#include <stdio.h>
#include <stdlib.h>

#define JOIN2(a, b) a##b
#define JOIN(a, b)  JOIN2(a, b)

static struct JOIN(P, _state) state;

static void count(void *context, const struct JOIN(P, _triangles) * triangles)
{
	*(long *)context += triangles->count;
}

int main(int argc, char **argv)
{
	long corners = 0;

	JOIN(P, _pose)(&state, argc > 1 ? (float)atof(argv[1]) : 0.0f);
	for (size_t v = 0;
		v < sizeof(state.position) / sizeof(state.position[0]); v++) {
		const float *p = state.position[v], *n = state.normal[v];

		printf("v %.9g %.9g %.9g\nvn %.6f %.6f %.6f\n", (double)p[0],
			(double)p[1], (double)p[2], (double)n[0], (double)n[1],
			(double)n[2]);
	}
	JOIN(P, _draw)(&state, count, &corners);
	printf("corners %ld\nstate %zu\n", corners, sizeof(state));
	return 0;
}
