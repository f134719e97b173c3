/*
 * A list of names for a message: one, two, "three, or four". Names with blanks
 * or commas stand in quotes.
 */
#ifndef PLATFORM_BASE_NAME_LIST_H
#define PLATFORM_BASE_NAME_LIST_H

#include <stdbool.h>

/* Initialize it with {""}. */
struct name_list {
	char text[400];
};

/*
 * Appends a name, or leaves the list as it is and returns false when the name
 * does not fit.
 */
bool name_list_add(struct name_list *list, const char *name);

/*
 * The names that there are, for a message that one is missing. Initialize it
 * with the wanted name.
 */
struct name_choice {
	const char *wanted;
	bool others; /* only names that are not like the wanted one are added */
	int left_out;
	struct name_list list;
};

/*
 * Adds a name if the list has room for it. add_all() of name_choice_list()
 * calls this.
 */
void name_choice_add(struct name_choice *choice, const char *name);

/*
 * Lists all names, first those that are like the wanted one, as the list may
 * have no room for all: apart from case and punctuation, one contains the
 * other, or they differ by a letter or, of more than five letters, by two.
 * Calls add_all() twice to add all names. The number of names that were left
 * out ends the list, if there are some.
 */
void name_choice_list(struct name_choice *choice,
	void (*add_all)(struct name_choice *choice, const void *context),
	const void *context);

#endif
