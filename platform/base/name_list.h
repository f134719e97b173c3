/*
 * A list of names for a message: one, two, "three, or four". Names with blanks
 * or commas stand in quotes.
 */
#ifndef PLATFORM_BASE_NAME_LIST_H
#define PLATFORM_BASE_NAME_LIST_H

/* Initialize it with {""}. */
struct name_list {
	char text[400];
};

/* Appends a name, or leaves the list as it is when the name does not fit. */
void name_list_add(struct name_list *list, const char *name);

#endif
