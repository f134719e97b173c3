/*
 * A model and one clip as C source, for boards without a file system.
 */
#ifndef APP_EMBED_EMBED_H
#define APP_EMBED_EMBED_H

#include "app/model/model.h"

#include <stdio.h>

/* What the source takes on the board, exactly. */
struct embed_size {
	size_t rom_bytes; /* of all tables, without the player's code */
	size_t ram_bytes; /* of the state */
};

/*
 * Writes const tables and a player of one file: it includes nothing but the C
 * library and calls nothing of limber. All its names begin with prefix, a C
 * identifier. Colours are the materials'; textures are left out. clip is an
 * index, or -1 for the rest pose.
 *
 * 0, -EINVAL where the model has a node with a matrix (shear), or -ENOMEM,
 * after a sentence; what cannot be written shows in ferror().
 */
int embed_print(const struct model *model, int clip, const char *prefix,
	const struct log *log, FILE *out, struct embed_size *size);

#endif
