/*
 * The table of options: one row for each option of each command.
 *
 * Two commands may use the same name for different options; each then has a
 * row of its own.
 */
#ifndef APP_CMD_OPTIONS_OPTIONS_TABLE_H
#define APP_CMD_OPTIONS_OPTIONS_TABLE_H

#include "app/cmd/options/options.h"

#include <stddef.h>

enum {
	OPTIONS_MAX = 64 /* rows at most; the size of arrays of names */
};

/* What an option's value becomes in struct options. */
enum option_kind {
	OPTION_TEXT,   /* const char *, as given; an empty text is refused */
	OPTION_SWITCH, /* bool: true; such an option has no value */
	OPTION_INT,    /* int from low to high */
	OPTION_FLOAT,  /* float from low to high */
	OPTION_DOUBLE, /* double from low to high */
	OPTION_PARSED, /* whatever set() stores */
};

struct option_entry {
	char letter;         /* the short form's, or 0 */
	const char *name;    /* without dashes */
	const char *value;   /* the value's name in the help; NULL: a switch */
	int commands;        /* bits of enum command_bit */
	const char *summary; /* one line of at most 73 characters */
	/* What a valid value is; follows "give" in an error. */
	const char *expected;

	enum option_kind kind;
	size_t member; /* offset in struct options; unused by OPTION_PARSED */
	double low, high;
	/* OPTION_PARSED: stores the value and returns whether it is valid. */
	bool (*set)(struct options *options, const char *value);
};

/* Ends with a row without a name. */
extern const struct option_entry option_entries[];

#endif
