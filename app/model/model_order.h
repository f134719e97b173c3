/*
 * Putting nodes into an order in which parents come before their children.
 */
#ifndef APP_MODEL_MODEL_ORDER_H
#define APP_MODEL_MODEL_ORDER_H

/*
 * parent[i] is the parent of node i, below count, or -1. Fills order[] with
 * the nodes' numbers, every parent before its children and each subtree in
 * one piece, otherwise as they come, and place[] with the inverse:
 * place[order[i]] == i. Both have room for count entries.
 *
 * 0, -ENOMEM, or -ELOOP where nodes are their own ancestors; *culprit is then
 * one of those. Says nothing.
 */
int model_order_nodes(
	const int *parent, int count, int *order, int *place, int *culprit);

#endif
