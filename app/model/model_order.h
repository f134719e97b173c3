/*
 * Sorts nodes so that parents come before their children.
 */
#ifndef APP_MODEL_MODEL_ORDER_H
#define APP_MODEL_MODEL_ORDER_H

/*
 * parent[i] is the parent of node i, less than count, or -1. Fills order[count]
 * with the nodes in depth-first order, in which siblings keep their order, and
 * new_index[count] with the inverse: new_index[order[i]] == i.
 *
 * Returns 0, -ENOMEM, or -ELOOP if parents form a cycle; then *node_on_cycle is
 * a node of the cycle. Logs nothing.
 */
int model_order_nodes(const int *parent, int count, int *order, int *new_index,
	int *node_on_cycle);

#endif
