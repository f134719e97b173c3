/*
 * What this program calls itself.
 */
#ifndef APP_CMD_VERSION_H
#define APP_CMD_VERSION_H

#include <stdio.h>

/* "limber X.Y.Z (processor)". */
const char *version_text(void);

/* That line, then what it was built with and which drivers it has. */
void version_print(FILE *out);

#endif
