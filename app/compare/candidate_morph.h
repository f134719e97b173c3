/*
 * A candidate of morph key frames that are baked from the clip (AN4044,
 * section 1), with linear interpolation between them.
 */
#ifndef APP_COMPARE_CANDIDATE_MORPH_H
#define APP_COMPARE_CANDIDATE_MORPH_H

#include "app/compare/candidate.h"

/*
 * key is copied. It holds key_count frames of the reference in ascending order,
 * with the first and the last frame among them. The reference must outlive the
 * candidate. A kernel in fixed point does a frame's work where 16 bits can hold
 * the keys; the error is that of the float keys in both cases, as these are
 * what is exported. 0, or -ENOMEM after logging an error.
 */
int candidate_morph(struct candidate *candidate,
	const struct reference *reference, const struct kernel *kernel,
	const int *key, int key_count, const struct log *log);

/* The frames of the reference that are keys: [key_count]. */
const int *candidate_morph_keys(const struct candidate *candidate);

/*
 * The vertices of the last pose: [vertex_count] each. Only for candidates whose
 * kernel computes in float.
 */
void candidate_morph_vertices(const struct candidate *candidate,
	const float (**position)[3], const float (**normal)[3]);

#endif
