/*
 * A candidate that interpolates linearly between key frames, which are vertex
 * poses baked from the clip (AN4044, section 1).
 */
#ifndef APP_COMPARE_CANDIDATE_CANDIDATE_MORPH_H
#define APP_COMPARE_CANDIDATE_CANDIDATE_MORPH_H

#include "app/anim/kernel/fixed.h"
#include "app/compare/candidate/candidate.h"
#include "app/compare/candidate/fit.h"

/*
 * How key frames are stored in a file (KHR_mesh_quantization). Positions are
 * 15-bit integers, which the placement maps to model units. A normal has a
 * length of MORPH_NORMAL_LENGTH / 127, and the normals of the mesh itself are
 * +-MORPH_NORMAL_BASE / 127 on each axis, so that the difference from the mesh
 * to any key frame fits a signed byte.
 */
enum {
	MORPH_POSITION_MAX = 16383,
	MORPH_NORMAL_LENGTH = 54,
	MORPH_NORMAL_BASE = 73,
	MORPH_POSITION_FILE_BYTES = 8, /* a vertex, aligned as glTF wants */
	MORPH_NORMAL_FILE_BYTES = 4
};

/* The placement of all key frames of clips within a box of world space. */
struct fixed_placement candidate_morph_placement(const struct bounds *box);

/* Convert a position and a unit normal to the integers of a file. */
void candidate_morph_position(const struct fixed_placement *placement,
	const float position[3], int16_t out[3]);
void candidate_morph_normal(const float normal[3], int8_t out[3]);

/*
 * Interpolates between the clip's poses at key->time_s, which is copied. All
 * key frames are kept in memory if they fit keep_bytes; else two at a time,
 * which seek() bakes when they are needed. The reference must outlive the
 * candidate. Returns 0, -EINTR (base/interrupt.h), or -ENOMEM after logging an
 * error.
 */
int candidate_morph(struct candidate *candidate, struct reference *reference,
	const struct kernel *kernel, const struct fixed_placement *placement,
	const struct fit_keys *key, size_t keep_bytes, const struct log *log);

#endif
