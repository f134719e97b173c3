/*
 * A hash table from names to numbers, which resolves references in .x files.
 */
#ifndef APP_MODEL_XFILE_XFILE_NAMES_H
#define APP_MODEL_XFILE_XFILE_NAMES_H

#include "platform/base/arena.h"

struct xfile_names {
	size_t mask; /* the table's size - 1 */
	struct xfile_named *table;
};

/* An empty table for at most count names. 0, or -ENOMEM without an error. */
int xfile_names_init(
	struct xfile_names *names, struct arena *arena, size_t count);

/*
 * Adds a name with a number >= 0. The table keeps the pointer. Of equal names
 * the first one counts; an empty name is ignored.
 */
void xfile_names_add(struct xfile_names *names, const char *name, int number);

/* The number of a name, or -1. */
int xfile_names_find(const struct xfile_names *names, const char *name);

#endif
