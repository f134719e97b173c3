/*
 * A candidate: one technique that plays one clip.
 *
 * A candidate is made from the reference. For each frame it then does what
 * limber's player does with the file that `limber compare --export` writes for
 * this technique. candidate_error_measure() compares it with the reference and
 * candidate_time_measure() times it.
 */
#ifndef APP_COMPARE_CANDIDATE_CANDIDATE_H
#define APP_COMPARE_CANDIDATE_CANDIDATE_H

#include "app/compare/cost/board_cost.h"
#include "app/compare/measure/screen_view.h"

/*
 * Bytes of vertices, influences, targets, keys and matrices. Indices, texture
 * coordinates, colours and images are the same for every technique and are not
 * counted. All clips of one technique share the bytes in shared; each has its
 * own.
 */
struct candidate_bytes {
	size_t shared, own;           /* in memory, with the posed vertices */
	size_t shared_file, own_file; /* in a glTF file */
};

struct candidate {
	struct reference *reference; /* not owned */
	struct candidate_bytes bytes;
	struct board_frame board; /* predicted, the same on every machine */

	int vertex_count; /* of the vertices that the candidate shows */
	const int *source; /* [vertex_count] the reference's vertex; NULL: same */

	/* pose() may leave out normals: the caller will not take() them. */
	bool positions_only;

	/*
	 * Prepares pose() for the same time; this is not timed. It may pose the
	 * reference. NULL: nothing to prepare.
	 */
	void (*seek)(struct candidate *candidate, float time_s);
	/* Poses all vertices at time_s, in seconds of the clip. */
	void (*pose)(struct candidate *candidate, float time_s);
	/*
	 * Writes the last pose in world space: [vertex_count] positions, and
	 * unit normals if normal is not NULL, zeros where there are none.
	 */
	void (*take)(const struct candidate *candidate, float (*position)[3],
		float (*normal)[3]);
	void (*destroy)(struct candidate *candidate);
	void *state;
};

/*
 * The model itself, skinned with at most max_influences (0: all) a vertex, and
 * with or without its morph targets. rate_hz is the playback rate, over whose
 * frames the predicted cost is averaged. Returns 0, or -errno after logging an
 * error.
 */
int candidate_original(struct candidate *candidate, struct reference *reference,
	const struct kernel *kernel, int max_influences, bool targets,
	double rate_hz, const struct log *log);

/* Seeks and poses. */
void candidate_pose(struct candidate *candidate, float time_s);

/* Does nothing to a candidate of zeros. */
void candidate_destroy(struct candidate *candidate);

#endif
