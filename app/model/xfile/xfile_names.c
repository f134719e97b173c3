#include "app/model/xfile/xfile_names.h"

#include <errno.h>
#include <string.h>

/*
 * A node tells names apart by one bit of their byte at index `byte`: the only
 * bit that is not set in mask. A child is the index of a node, or -1 - the
 * index of a name in named[]. byte, and then mask, increases from the root to
 * the leaves.
 */
struct xfile_name_node {
	size_t byte;
	uint8_t mask;
	int child[2];
};

struct xfile_named {
	const char *name;
	int number;
};

int xfile_names_init(
	struct xfile_names *names, struct arena *arena, size_t count)
{
	*names = (struct xfile_names){
		.named = ARENA_ARRAY(arena, struct xfile_named, count),
		.node = ARENA_ARRAY(arena, struct xfile_name_node, count),
	};
	return names->named && names->node ? 0 : -ENOMEM;
}

/* Returns 1 if the bit that is not set in mask is set in byte, else 0. */
static int side(uint8_t mask, uint8_t byte)
{
	return (1 + (mask | byte)) >> 8;
}

/* Returns which child of the node, 0 or 1, a name of that length belongs to. */
static int choose(
	const struct xfile_name_node *node, const char *name, size_t length)
{
	return side(node->mask,
		node->byte < length ? (uint8_t)name[node->byte] : 0);
}

/* Returns the only name that can be equal. The map must not be empty. */
static const struct xfile_named *look_up(
	const struct xfile_names *names, const char *name, size_t length)
{
	int at = names->root;

	while (at >= 0) {
		const struct xfile_name_node *node = &names->node[at];

		at = node->child[choose(node, name, length)];
	}
	return &names->named[-1 - at];
}

/* Returns all bits but the highest one in which a and b differ. */
static uint8_t mask_of(uint8_t a, uint8_t b)
{
	uint8_t bits = a ^ b;

	bits |= (uint8_t)(bits >> 1);
	bits |= (uint8_t)(bits >> 2);
	bits |= (uint8_t)(bits >> 4);
	return (uint8_t) ~(bits & ~(bits >> 1));
}

/* Adds a leaf: name differs from the closest name first at `byte`. */
static void insert(struct xfile_names *names, const char *name, size_t length,
	const char *closest, size_t byte)
{
	uint8_t mask = mask_of((uint8_t)name[byte], (uint8_t)closest[byte]);
	int own = side(mask, (uint8_t)name[byte]);
	int *link = &names->root;
	struct xfile_name_node *added = &names->node[names->node_count];

	while (*link >= 0) {
		struct xfile_name_node *node = &names->node[*link];

		if (node->byte > byte ||
			(node->byte == byte && node->mask > mask)) {
			break;
		}
		link = &node->child[choose(node, name, length)];
	}
	*added = (struct xfile_name_node){.byte = byte, .mask = mask};
	added->child[own] = -1 - names->named_count;
	added->child[1 - own] = *link;
	*link = names->node_count++;
}

bool xfile_names_add(struct xfile_names *names, const char *name, int number)
{
	size_t length = strlen(name), byte = 0;

	if (length == 0) {
		return true;
	}
	if (names->named_count == 0) {
		names->root = -1;
	} else {
		const char *closest = look_up(names, name, length)->name;

		if (strcmp(closest, name) == 0) {
			return false;
		}
		while (closest[byte] == name[byte]) {
			byte++;
		}
		insert(names, name, length, closest, byte);
	}
	names->named[names->named_count++] = (struct xfile_named){name, number};
	return true;
}

int xfile_names_find(const struct xfile_names *names, const char *name)
{
	const struct xfile_named *named;

	if (names->named_count == 0) {
		return -1;
	}
	named = look_up(names, name, strlen(name));
	return strcmp(named->name, name) == 0 ? named->number : -1;
}
