/*
 * One way to show the clip: what it costs and how far it is off.
 *
 * A candidate is built from the reference, then measured. The functions it
 * brings do its real work of a frame; everything a technique needs beside
 * them was made ready before.
 */
#ifndef APP_COMPARE_CANDIDATE_H
#define APP_COMPARE_CANDIDATE_H

#include "app/compare/board_cost.h"
#include "app/compare/screen_error.h"

/* AN4044's three, and the two it recommends together. */
enum technique {
	TECHNIQUE_MORPHING,
	TECHNIQUE_HIERARCHICAL,
	TECHNIQUE_SKELETAL,
	TECHNIQUE_COMBINED,
	TECHNIQUE_COUNT
};

/* A technique as AN4044, section 4 rates it. */
struct technique_rating {
	const char *name;
	const char *control;
	const char *looks;
	const char *coding;
};

extern const struct technique_rating technique_rating[TECHNIQUE_COUNT];

struct candidate_error {
	float peak_px, mean_px;
	int peak_frame; /* of the reference */
};

struct candidate {
	char name[40]; /* "morph, 9 keys" */
	enum technique technique;
	bool listed;   /* in the table; the others are points of the plot */
	int key_count; /* of a morph, else 0 */
	bool even;     /* its keys are evenly spread, not fitted */

	/*
	 * Bytes of what moves: vertices, influences, keys, matrices. Indices,
	 * texture coordinates, colours and pictures are the same for all
	 * techniques and not counted. In memory with the output vertices; in
	 * the file as glTF stores it.
	 */
	size_t memory_bytes, file_bytes;

	/* The vertices it shows, and the reference's vertex for each. */
	int vertex_count;
	const int *source; /* NULL: the same */

	/* Filled by candidate_measure(). */
	struct candidate_error error;
	double frame_us;     /* of this machine, the median */
	double instructions; /* a frame; below 0: this machine cannot say */

	/* Of the board's core, predicted; not of this machine. */
	struct board_cost board;

	/* The frame's work, and a vertex afterwards in world space. */
	void (*pose)(struct candidate *candidate, float time_s);
	void (*vertex)(
		const struct candidate *candidate, int vertex, float out[3]);
	void (*destroy)(struct candidate *candidate);
	void *state;
};

/*
 * The model as it is: skinned with at most max_influences (0: all), and with
 * its targets or without. 0, or -errno after a sentence.
 */
int candidate_as_is(struct candidate *candidate,
	const struct reference *reference, const struct kernel *kernel,
	int max_influences, bool targets, const struct log *log);

/*
 * Key frames, straight lines between them; key is copied. A kernel with loops
 * in fixed point uses those, and then candidate_morph_vertices() is not to be
 * asked.
 */
int candidate_morph(struct candidate *candidate,
	const struct reference *reference, const struct kernel *kernel,
	const int *key, int key_count, const struct log *log);

/*
 * Every triangle rigid with the joint that moves most of it: AN4044's
 * hierarchical technique, the joints as pivots.
 */
int candidate_rigid(struct candidate *candidate,
	const struct reference *reference, const struct log *log);

/* Holds it against the reference, then times it. */
void candidate_measure(struct candidate *candidate,
	const struct reference *reference, const struct screen *screen);

void candidate_destroy(struct candidate *candidate);

/*
 * What a rigid candidate is made of, for writing it to a file: vertices in
 * the space of the node that carries them.
 */
struct rigid_part {
	int node;
	int first_vertex, vertex_count;
	int first_index, index_count;
	int part; /* of the reference: whose material and normals */
};

struct rigid {
	struct arena arena;
	const struct reference *reference;
	struct pose pose;
	struct clip_cursor cursor;
	mat4 *world;

	int part_count;
	struct rigid_part *part;
	int *source;          /* [vertex_count] */
	float (*position)[3]; /* likewise */
	float (*normal)[3];
	int *node; /* [vertex_count]: who carries it */
	int vertex_count;
	uint32_t *index; /* from the part's first vertex */
	int index_count;
};

const struct rigid *candidate_rigid_parts(const struct candidate *candidate);

/* A morph's vertices after its last pose: [vertex_count] each. */
void candidate_morph_vertices(const struct candidate *candidate,
	const float (**position)[3], const float (**normal)[3]);

/* The frames that are keys of a morph. */
const int *candidate_morph_keys(const struct candidate *candidate);

#endif
