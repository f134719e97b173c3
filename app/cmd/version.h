/*
 * What this program calls itself.
 */
#ifndef APP_CMD_VERSION_H
#define APP_CMD_VERSION_H

/* "limber X.Y.Z (processor)". */
const char *version_text(void);

#endif
