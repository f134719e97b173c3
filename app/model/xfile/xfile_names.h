/*
 * A map from names to numbers, which resolves references in .x files.
 *
 * It is a binary tree that tells names apart by single bits (a crit-bit tree).
 * A look-up takes at most as many steps as the name has bits, whatever names a
 * file chooses; a hash table would get slow with names that collide.
 */
#ifndef APP_MODEL_XFILE_XFILE_NAMES_H
#define APP_MODEL_XFILE_XFILE_NAMES_H

#include <stdint.h>

#include "platform/base/arena.h"

struct xfile_names {
	struct xfile_named *named;
	struct xfile_name_node *node;
	int named_count, node_count;
	int root; /* as struct xfile_name_node.child; if named_count > 0 */
};

/* An empty map for at most count names. 0, or -ENOMEM without an error. */
int xfile_names_init(
	struct xfile_names *names, struct arena *arena, size_t count);

/*
 * Adds a name with a number >= 0. The map keeps the pointer. Of equal names the
 * first one counts; an empty name is ignored.
 */
void xfile_names_add(struct xfile_names *names, const char *name, int number);

/* The number of a name, or -1. */
int xfile_names_find(const struct xfile_names *names, const char *name);

#endif
