/*
 * limber.conf: what the command line would say, kept in a file.
 *
 * Most keys are options by their names and go through the rows of the one
 * options table; [buttons] and [actions] have a language of their own. The
 * command line wins over the file, the file over what is built in.
 */
#ifndef APP_CMD_OPTIONS_CONFIG_H
#define APP_CMD_OPTIONS_CONFIG_H

#include "app/cmd/options/options.h"
#include "platform/base/arena.h"

/* Holds the strings that options point to. Begins zeroed. */
struct config {
	struct arena arena;
};

/*
 * The file to read: given (of --config), else $LIMBER_CONFIG, else, if
 * search, $XDG_CONFIG_HOME/limber/limber.conf ($HOME/.config for the first)
 * or /etc/limber.conf, whichever is there first. False when there is none,
 * also for the name "none".
 */
bool config_find(const char *given, bool search, char *path, size_t size);

/*
 * Reads the file into *options. Options that the command has not are checked
 * and left out. 0, or -errno after a sentence that begins "FILE:LINE: ".
 */
int config_load(struct config *config, const char *path,
	enum command_bit command, struct options *options,
	const struct log *log);

/* The same from an open file, which path names in sentences. */
int config_read(struct config *config, FILE *file, const char *path,
	enum command_bit command, struct options *options,
	const struct log *log);

/* The options that were read must not be used any more. */
void config_release(struct config *config);

#endif
