#include "app/model/model_order.h"

#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>

struct links {
	int first_child;
	int next_sibling;
};

static void link_children(const int *parent, int count, struct links *links)
{
	int i;

	for (i = 0; i < count; i++) {
		links[i] = (struct links){-1, -1};
	}
	for (i = count - 1; i >= 0; i--) {
		if (parent[i] >= 0) {
			links[i].next_sibling = links[parent[i]].first_child;
			links[parent[i]].first_child = i;
		}
	}
}

/* Returns the root's next node in depth-first order, or -1 at the end. */
static int next_depth_first(
	const int *parent, const struct links *links, int node)
{
	if (links[node].first_child >= 0) {
		return links[node].first_child;
	}
	while (node >= 0 && links[node].next_sibling < 0) {
		node = parent[node];
	}
	return node < 0 ? -1 : links[node].next_sibling;
}

/*
 * Returns a node on a cycle. A node that was not ordered is not below a root,
 * so count steps from child to parent end on a cycle.
 */
static int find_cycle(const int *parent, int count, const int *new_index)
{
	int node = 0;
	int i;

	while (new_index[node] >= 0) {
		node++;
	}
	for (i = 0; i < count; i++) {
		node = parent[node];
	}
	return node;
}

int model_order_nodes(const int *parent, int count, int *order, int *new_index,
	int *node_on_cycle)
{
	struct links *links;
	int done = 0;
	int root, node;

	*node_on_cycle = -1;
	links = malloc((size_t)count * sizeof(*links) + 1);
	if (!links) {
		return -ENOMEM;
	}
	link_children(parent, count, links);
	for (node = 0; node < count; node++) {
		new_index[node] = -1;
	}
	for (root = 0; root < count; root++) {
		if (parent[root] >= 0) {
			continue;
		}
		for (node = root; node >= 0;
			node = next_depth_first(parent, links, node)) {
			new_index[node] = done;
			order[done++] = node;
		}
	}
	free(links);
	if (done < count) {
		*node_on_cycle = find_cycle(parent, count, new_index);
		return -ELOOP;
	}
	return 0;
}
