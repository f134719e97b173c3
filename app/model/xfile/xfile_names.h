/*
 * A map from names to numbers, which resolves references in .x files.
 *
 * It is a crit-bit tree, a binary tree that tells names apart by single bits. A
 * look-up takes at most as many steps as the name has bits, whatever names a
 * file has; a hash table would become slow if names collide.
 */
#ifndef APP_MODEL_XFILE_XFILE_NAMES_H
#define APP_MODEL_XFILE_XFILE_NAMES_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/base/arena.h"

struct xfile_names {
	struct xfile_named *named;
	struct xfile_name_node *node;
	int named_count, node_count;
	int root; /* like struct xfile_name_node.child; valid if named_count >
		   0 */
};

/* Makes an empty map for count names. Returns 0 or -ENOMEM, logs nothing. */
int xfile_names_init(
	struct xfile_names *names, struct arena *arena, size_t count);

/*
 * Adds a name with a number >= 0. The map keeps the pointer. Returns false if
 * the map has the name already, which then keeps the first number. An empty
 * name is ignored.
 */
bool xfile_names_add(struct xfile_names *names, const char *name, int number);

/* Returns the number of a name, or -1. */
int xfile_names_find(const struct xfile_names *names, const char *name);

#endif
