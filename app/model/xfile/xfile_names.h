/*
 * Numbers found by name: what a .x file's references are resolved with.
 */
#ifndef APP_MODEL_XFILE_XFILE_NAMES_H
#define APP_MODEL_XFILE_XFILE_NAMES_H

#include "platform/base/arena.h"

struct xfile_names {
	size_t mask; /* the table's size - 1 */
	struct xfile_named *table;
};

/* An empty table for at most count names. 0 or -ENOMEM; says nothing. */
int xfile_names_init(
	struct xfile_names *names, struct arena *arena, size_t count);

/*
 * Enters a name, which must stay where it is, with a number from 0. The first
 * of equal names keeps its number; an empty name is not entered.
 */
void xfile_names_add(struct xfile_names *names, const char *name, int number);

/* The name's number, or -1. */
int xfile_names_find(const struct xfile_names *names, const char *name);

#endif
