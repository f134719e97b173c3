/*
 * Declarations that the files of the export share.
 *
 *	embed.c           counts, parts, state, player
 *	embed_table.c     writing tables, iterating over parts
 *	embed_vertices.c  tables of vertices and indices
 *	embed_motion.c    tables of nodes, skins and the clip
 */
#ifndef APP_EMBED_EMBED_INTERNAL_H
#define APP_EMBED_EMBED_INTERNAL_H

#include "app/embed/embed.h"

enum {
	EMBED_ROW = 8, /* numbers on a line */
	EMBED_NAME_SIZE = 64
};

/* The offsets of a part's data in the tables. */
struct embed_offsets {
	int vertex, index, influence, target;
};

struct embed {
	const struct model *model;
	const struct model_clip *clip; /* or NULL */
	FILE *out;
	char prefix[EMBED_NAME_SIZE]; /* "walker" */
	char upper[EMBED_NAME_SIZE];  /* "WALKER" */
	size_t rom_bytes;

	/* Counts of elements. */
	int parts, vertices, indices, influences, targets, joints, weights;
	int channels, times, values;
	int dark_parts; /* parts that need light but have no normals */
	bool wide_index, wide_joint;
	bool too_large; /* a count exceeds its type or the limit */

	int *skin_first; /* [skin_count]: index of its first joint in the tables */
	struct embed_offsets next; /* of the next part to list */
};

/* One primitive of one node. */
struct embed_part {
	const struct model_node *node;
	int node_index;
	const struct model_mesh *mesh;
	const struct model_primitive *primitive;
};

typedef void embed_part_fn(struct embed *embed, const struct embed_part *part);

void embed_each_part(struct embed *embed, embed_part_fn *function);

/* Whether the part is skinned. */
bool embed_is_skinned(const struct embed_part *part);

/* Returns the number of floats of all keys of a channel. */
int embed_channel_values(const struct model_channel *channel);

/*
 * embed_begin_table() writes "static const TYPE PREFIX_NAME[count]WIDE = {" and
 * counts count * size bytes of ROM. C has no empty arrays, so a table with
 * count 0 gets one element, which embed_end_table() writes.
 */
void embed_begin_table(struct embed *embed, const char *type, const char *name,
	const char *wide, int count, size_t size);
void embed_end_table(struct embed *embed, int count);

/* Writes numbers so that a compiler reads the same floats back. */
void embed_put_floats(struct embed *embed, const float *value, int count);

void embed_print_vertices(struct embed *embed);
void embed_print_nodes(struct embed *embed);
void embed_print_skins(struct embed *embed);
void embed_print_clip(struct embed *embed);

#endif
