#include "app/model/xfile/xfile_names.h"

#include <errno.h>
#include <stdint.h>
#include <string.h>

struct xfile_named {
	const char *name; /* NULL means that the slot is free */
	int number;
};

int xfile_names_init(
	struct xfile_names *names, struct arena *arena, size_t count)
{
	size_t size = 4;

	/* At least half of the slots stay free, which keeps probes short. */
	while (size / 2 < count) {
		size *= 2;
	}
	names->mask = size - 1;
	names->table = ARENA_ARRAY(arena, struct xfile_named, size);
	return names->table ? 0 : -ENOMEM;
}

/* FNV-1a. */
static size_t hash(const char *name)
{
	uint32_t hash = 2166136261u;

	for (; *name; name++) {
		hash = (hash ^ (unsigned char)*name) * 16777619u;
	}
	return hash;
}

/* The slot of the name, or the free slot for it. */
static struct xfile_named *look_up(
	const struct xfile_names *names, const char *name)
{
	size_t slot = hash(name) & names->mask;

	while (names->table[slot].name &&
		strcmp(names->table[slot].name, name) != 0) {
		slot = (slot + 1) & names->mask;
	}
	return &names->table[slot];
}

void xfile_names_add(struct xfile_names *names, const char *name, int number)
{
	struct xfile_named *named = look_up(names, name);

	if (*name && !named->name) {
		named->name = name;
		named->number = number;
	}
}

int xfile_names_find(const struct xfile_names *names, const char *name)
{
	const struct xfile_named *named = look_up(names, name);

	return named->name ? named->number : -1;
}
