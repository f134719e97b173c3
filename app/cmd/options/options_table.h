/*
 * The rows of the command line: one an option, for all subcommands.
 */
#ifndef APP_CMD_OPTIONS_OPTIONS_TABLE_H
#define APP_CMD_OPTIONS_OPTIONS_TABLE_H

#include "app/cmd/options/options.h"

#include <stddef.h>

enum {
	OPTIONS_MAX = 64 /* rows, for arrays of their names */
};

struct option_entry {
	char letter;       /* or 0 */
	const char *name;  /* without dashes */
	const char *value; /* what follows it, or NULL */
	int commands;
	const char *summary;
	const char *expected; /* what a good value looks like */
	/*
	 * True when the value is good. NULL: the member at that offset of
	 * struct options keeps it as it is, a text that is not empty, or true
	 * for a switch.
	 */
	bool (*set)(struct options *options, const char *value);
	size_t member;
};

/* All of them; the last one has no name. */
extern const struct option_entry option_entries[];

#endif
