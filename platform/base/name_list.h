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
 * The names that there are, for a message that one is missing: first those that
 * are like it, as the list may have no room for all. Initialize it with the
 * wanted name and add all names, then set others and add them all again.
 */
struct name_choice {
	const char *wanted;
	bool others;
	int left_out;
	struct name_list list;
};

/*
 * Adds a name if it is, or as an other one if it is not, like the wanted one:
 * apart from case and punctuation, one contains the other, or they differ by a
 * letter or, of more than five letters, by two.
 */
void name_choice_add(struct name_choice *choice, const char *name);

/* Ends the list with the number of names that were left out, if there are some. */
void name_choice_end(struct name_choice *choice);

#endif
