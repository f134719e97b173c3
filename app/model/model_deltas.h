/*
 * The displacements of morph targets (struct model_deltas): packing them when a
 * model is loaded, and reading them as floats.
 */
#ifndef APP_MODEL_MODEL_DELTAS_H
#define APP_MODEL_MODEL_DELTAS_H

#include "app/model/model.h"

/* All vertices' displacements, in floats that outlive the result. */
struct model_deltas model_deltas_view(const float (*value)[3], int vertex_count);

/*
 * Packs the displacements of all vertices. If number is an integer type, each
 * value times unit must be such an integer, but for the rounding of a float;
 * reading gives the same floats again. 0 or -ENOMEM.
 */
int model_deltas_pack(struct model_deltas *deltas, const float (*value)[3],
	int vertex_count, enum model_number number, float unit,
	struct arena *arena);

/* Copies deltas and what they refer to. 0 or -ENOMEM. */
int model_deltas_copy(struct model_deltas *out, const struct model_deltas *from,
	struct arena *arena);

/* Writes the displacement of a vertex, which is 0 where there is none. */
void model_deltas_get(
	const struct model_deltas *deltas, int vertex, float out[3]);

/* The same as the file's integers, for deltas that are none of MODEL_FLOAT. */
void model_deltas_numbers(
	const struct model_deltas *deltas, int vertex, int out[3]);

/* Whether a vertex's displacement is not 0. */
bool model_deltas_moves(const struct model_deltas *deltas, int vertex);

/* Writes those of all vertex_count vertices of the primitive. */
void model_deltas_unpack(
	const struct model_deltas *deltas, int vertex_count, float (*out)[3]);

/*
 * Sets *out to the displacements of all vertices as floats: the deltas' own, or
 * a copy in the arena; NULL if there are none. 0 or -ENOMEM.
 */
int model_deltas_floats(const struct model_deltas *deltas, struct arena *arena,
	const float (**out)[3]);

/* The vertices whose displacement is stored. */
int model_deltas_count(const struct model_deltas *deltas);

/* The memory of values and spans. */
size_t model_deltas_bytes(const struct model_deltas *deltas);

#endif
