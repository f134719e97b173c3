/*
 * The displacements of morph targets (struct model_deltas): packing them when a
 * model is loaded, and reading them as floats.
 */
#ifndef APP_MODEL_MODEL_DELTAS_H
#define APP_MODEL_MODEL_DELTAS_H

#include "app/model/model.h"

/*
 * Returns deltas that refer to the displacements of all vertices, which the
 * caller keeps as long as the result.
 */
struct model_deltas model_deltas_view(const float (*value)[3], int vertex_count);

/*
 * Packs value[vertex_count]. If number is an integer type, each value times
 * unit must be an integer of that type, apart from the rounding of a float.
 * Reading gives the same floats again. Returns 0 or -ENOMEM.
 */
int model_deltas_pack(struct model_deltas *deltas, const float (*value)[3],
	int vertex_count, enum model_number number, float unit,
	struct arena *arena);

/* Copies deltas, values and spans into the arena. Returns 0 or -ENOMEM. */
int model_deltas_copy(struct model_deltas *out, const struct model_deltas *from,
	struct arena *arena);

/* Writes the displacement of a vertex; 0 if none is stored. */
void model_deltas_get(
	const struct model_deltas *deltas, int vertex, float out[3]);

/* The same in the file's integers. deltas must not be MODEL_FLOAT. */
void model_deltas_numbers(
	const struct model_deltas *deltas, int vertex, int out[3]);

/* Whether a vertex's displacement is not 0. */
bool model_deltas_moves(const struct model_deltas *deltas, int vertex);

/* Writes the displacements of all vertex_count vertices of the primitive. */
void model_deltas_unpack(
	const struct model_deltas *deltas, int vertex_count, float (*out)[3]);

/*
 * Sets *out to the displacements of all vertices as floats: to the deltas' own
 * array, to a copy in the arena, or to NULL if there are none. Returns 0 or
 * -ENOMEM.
 */
int model_deltas_floats(const struct model_deltas *deltas, struct arena *arena,
	const float (**out)[3]);

/* Returns how many displacements are stored. */
int model_deltas_count(const struct model_deltas *deltas);

/* Returns the bytes of values and spans. */
size_t model_deltas_bytes(const struct model_deltas *deltas);

#endif
