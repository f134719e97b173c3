/*
 * Numbers without a pattern, the same in every run, and vertices of them.
 */
#ifndef TESTS_SUPPORT_SCATTERED_H
#define TESTS_SUPPORT_SCATTERED_H

#include <stdint.h>

/* Number i >= 0 of a sequence that fills -1 to 1 evenly. */
float scattered(int i);

/* Where vertex v lies, within -1 to 1, and its unit normal. */
void scattered_point(int v, float position[3], float normal[3]);

/* count joints out of so many for vertex v; their weights add up to 1. */
void scattered_influences(
	int v, int count, int joints, uint16_t *joint, float *weight);

#endif
