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

/* The node after this one, depth first, or -1 after the root's subtree. */
static int step(const int *parent, const struct links *links, int node)
{
	if (links[node].first_child >= 0) {
		return links[node].first_child;
	}
	while (node >= 0 && links[node].next_sibling < 0) {
		node = parent[node];
	}
	return node < 0 ? -1 : links[node].next_sibling;
}

/* Every ancestor walk from a node that no root reaches ends on a cycle. */
static int find_cycle(const int *parent, int count, const int *place)
{
	int node = 0;
	int i;

	while (place[node] >= 0) {
		node++;
	}
	for (i = 0; i < count; i++) {
		node = parent[node];
	}
	return node;
}

int model_order_nodes(
	const int *parent, int count, int *order, int *place, int *culprit)
{
	struct links *links;
	int done = 0;
	int root, node;

	*culprit = -1;
	links = malloc((size_t)count * sizeof(*links) + 1);
	if (!links) {
		return -ENOMEM;
	}
	link_children(parent, count, links);
	for (node = 0; node < count; node++) {
		place[node] = -1;
	}
	for (root = 0; root < count; root++) {
		if (parent[root] >= 0) {
			continue;
		}
		for (node = root; node >= 0; node = step(parent, links, node)) {
			place[node] = done;
			order[done++] = node;
		}
	}
	free(links);
	if (done < count) {
		*culprit = find_cycle(parent, count, place);
		return -ELOOP;
	}
	return 0;
}
