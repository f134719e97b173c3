/*
 * "one, two, three": the names there are, for a sentence.
 */
#ifndef PLATFORM_BASE_NAME_LIST_H
#define PLATFORM_BASE_NAME_LIST_H

/* Begins as {""}. */
struct name_list {
	char text[160];
};

/* Appends a name; one that has no room left is dropped. */
void name_list_add(struct name_list *list, const char *name);

#endif
