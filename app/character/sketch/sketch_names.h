/* Names of a model in a character file. */
#ifndef APP_CHARACTER_SKETCH_SKETCH_NAMES_H
#define APP_CHARACTER_SKETCH_SKETCH_NAMES_H

#include <stdbool.h>
#include <stdio.h>

/* Writes a name, in quotes if it has blanks or commas. */
void sketch_write_name(FILE *out, const char *name);

/* Whether a character file can hold the name, and a terminal show it. */
bool sketch_is_usable(const char *name);

/* Whether it is so short that it can stand in the heading of a section. */
bool sketch_fits_heading(const char *name);

#endif
