/*
 * The inside of the writer, for embed*.c alone.
 *
 *	embed.c           counts, parts, state, the player
 *	embed_table.c     tables, and walking over parts
 *	embed_vertices.c  what vertices have
 *	embed_motion.c    nodes, skins, the clip
 */
#ifndef APP_EMBED_EMBED_INTERNAL_H
#define APP_EMBED_EMBED_INTERNAL_H

#include "app/embed/embed.h"

enum {
	EMBED_ROW = 8, /* numbers in a line */
	EMBED_NAME_SIZE = 64
};

/* Where a part's data begin in the tables. */
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

	/* How much there is of each. */
	int parts, vertices, indices, influences, targets, joints, weights;
	int channels, times, values;
	bool wide_index, wide_joint;

	struct embed_offsets next; /* while parts are listed */
};

/* One primitive as one node shows it. */
struct embed_part {
	const struct model_node *node;
	int node_index;
	const struct model_mesh *mesh;
	const struct model_primitive *primitive;
};

typedef void embed_part_fn(struct embed *embed, const struct embed_part *part);

void embed_each_part(struct embed *embed, embed_part_fn *function);

/* Whether a skin moves the part. */
bool embed_is_skinned(const struct embed_part *part);

/* Floats of all keys of a channel. */
int embed_channel_values(const struct model_channel *channel);

/*
 * Begins "static const TYPE PREFIX_NAME[count]WIDE = {" of elements of size
 * bytes; C has no empty tables, so one of nothing gets a zero at its end.
 */
void embed_begin_table(struct embed *embed, const char *type, const char *name,
	const char *wide, int count, size_t size);
void embed_end_table(struct embed *embed, int count);

/* Numbers that read back as the same floats. */
void embed_put_floats(struct embed *embed, const float *value, int count);

void embed_print_vertices(struct embed *embed);
void embed_print_nodes(struct embed *embed);
void embed_print_skins(struct embed *embed);
void embed_print_clip(struct embed *embed);

#endif
