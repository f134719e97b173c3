/*
 * Pseudo-random numbers that are the same in every run, and vertices made of
 * them.
 */
#ifndef TESTS_SUPPORT_MODEL_SCATTERED_H
#define TESTS_SUPPORT_MODEL_SCATTERED_H

#include <stdint.h>

/*
 * Number i >= 0 of a low-discrepancy sequence in -1..1: an additive recurrence
 * with the inverse of the plastic number.
 */
float scattered(int i);

/* The position of vertex v, each coordinate in -1..1, and its unit normal. */
void scattered_point(int v, float position[3], float normal[3]);

/* Unit vector i of a sequence that covers all directions. */
void scattered_direction(int i, float out[3]);

/* count joints of 0..joints-1 for vertex v; the weights add up to 1. */
void scattered_influences(
	int v, int count, int joints, uint16_t *joint, float *weight);

#endif
