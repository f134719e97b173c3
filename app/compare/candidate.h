/*
 * A candidate: one technique that plays the clip, with its error and its costs.
 *
 * A candidate is baked from the reference when it is created; pose() and
 * vertex() then do what the technique does for each frame, which
 * candidate_measure() times and compares with the reference.
 */
#ifndef APP_COMPARE_CANDIDATE_H
#define APP_COMPARE_CANDIDATE_H

#include "app/compare/board_cost.h"
#include "app/compare/screen_view.h"
#include "app/compare/technique.h"

struct candidate_error {
	float peak_px, mean_px; /* over all vertices of all frames */
	int peak_frame;         /* of the reference */
};

struct candidate {
	char name[40]; /* "morph, 9 keys" */
	enum technique technique;
	bool listed;   /* in the table; the others are only in the plot */
	int key_count; /* of a morph, else 0 */
	bool even;     /* a morph's keys are evenly spaced, not fitted */

	/*
	 * Bytes of vertices, influences, targets, keys and matrices. Indices,
	 * texture coordinates, colours and images are the same for every
	 * technique and are not counted. memory_bytes includes the posed
	 * vertices; file_bytes is the size in a glTF file.
	 */
	size_t memory_bytes, file_bytes;

	int vertex_count;  /* of the vertices that it shows */
	const int *source; /* [vertex_count] of the reference; NULL: the same */

	/* Set by candidate_measure(). */
	struct candidate_error error;
	double frame_us;     /* on this machine, the median */
	double instructions; /* a frame; negative: there is no counter */

	/* Predicted for the board; the same on every machine. */
	struct board_cost board;

	/* Poses all vertices at time_s, in seconds of the clip. */
	void (*pose)(struct candidate *candidate, float time_s);
	/* One vertex of the last pose, in world space. */
	void (*vertex)(
		const struct candidate *candidate, int vertex, float out[3]);
	void (*destroy)(struct candidate *candidate);
	void *state;
};

/*
 * The model itself, skinned with at most max_influences (0: all) a vertex, and
 * with or without its morph targets. Returns 0, or -errno after logging an
 * error.
 */
int candidate_original(struct candidate *candidate,
	const struct reference *reference, const struct kernel *kernel,
	int max_influences, bool targets, const struct log *log);

/*
 * Fills error, frame_us and instructions: poses every frame of the reference,
 * then runs passes over the clip.
 */
void candidate_measure(struct candidate *candidate,
	const struct reference *reference, const struct screen_view *screen);

void candidate_destroy(struct candidate *candidate);

#endif
