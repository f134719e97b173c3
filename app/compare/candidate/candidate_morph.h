/*
 * A candidate of morph key frames that are baked from the clip (AN4044,
 * section 1), with linear interpolation between them.
 */
#ifndef APP_COMPARE_CANDIDATE_CANDIDATE_MORPH_H
#define APP_COMPARE_CANDIDATE_CANDIDATE_MORPH_H

#include "app/anim/kernel/fixed.h"
#include "app/compare/candidate/candidate.h"
#include "app/compare/candidate/fit.h"

/*
 * How key frames are stored in a file (KHR_mesh_quantization). Positions are
 * 15-bit numbers of the placement. A normal is a vector of MORPH_NORMAL_LENGTH
 * in 127ths, and the normals of the mesh itself are diagonals of
 * +-MORPH_NORMAL_BASE on each axis: so the difference from the mesh to any key
 * frame fits a signed byte.
 */
enum {
	MORPH_POSITION_MAX = 16383,
	MORPH_NORMAL_LENGTH = 54,
	MORPH_NORMAL_BASE = 73,
	MORPH_POSITION_FILE_BYTES = 8, /* of a vertex, as glTF aligns it */
	MORPH_NORMAL_FILE_BYTES = 4
};

/* The placement of all key frames of clips within a box of world space. */
struct fixed_placement candidate_morph_placement(const struct bounds *box);

/* A position and a normal in the numbers of a file. */
void candidate_morph_position(const struct fixed_placement *placement,
	const float position[3], int16_t out[3]);
void candidate_morph_normal(const float normal[3], int8_t out[3]);

/*
 * Interpolates between the clip's poses at key->time_s, which is copied. All of
 * them are kept in memory if they fit keep_bytes; else two at a time, which
 * seek() bakes again. The reference must outlive the candidate. 0, or -ENOMEM
 * after logging an error.
 */
int candidate_morph(struct candidate *candidate, struct reference *reference,
	const struct kernel *kernel, const struct fixed_placement *placement,
	const struct fit_keys *key, size_t keep_bytes, const struct log *log);

#endif
