/*
 * The program's name and version.
 */
#ifndef APP_CMD_VERSION_H
#define APP_CMD_VERSION_H

#include <stdio.h>

/* Returns "limber X.Y.Z (processor)". */
const char *version_text(void);

/* Prints version_text(), the compiler and the built-in kernels and drivers. */
void version_print(FILE *out);

#endif
