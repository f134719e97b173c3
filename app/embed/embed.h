/*
 * Export of a model and one clip as C source, for boards without a file system.
 */
#ifndef APP_EMBED_EMBED_H
#define APP_EMBED_EMBED_H

#include "app/model/model.h"

#include <stdio.h>

/* The memory that the source takes on the board, and what it lacks. */
struct embed_size {
	size_t rom_bytes; /* all tables, but not the player's code */
	size_t ram_bytes; /* the state */
	int dark_parts;   /* parts that need light but have no normals */
};

/*
 * Writes one file of const tables and a player, which uses only the C library.
 * All its names begin with prefix. It has the materials' colours but no
 * textures. clip is an index, or -1 for the rest pose.
 *
 * Returns 0 and sets *size; or, after logging an error, -EINVAL if prefix is no
 * C identifier of at most 63 characters, the model has nothing to draw or a
 * node has a matrix (shear); -EFBIG if the tables would be too large; or
 * -ENOMEM. The caller checks ferror(out).
 */
int embed_print(const struct model *model, int clip, const char *prefix,
	const struct log *log, FILE *out, struct embed_size *size);

#endif
