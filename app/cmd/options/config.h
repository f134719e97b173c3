/*
 * limber.conf: a file of options.
 *
 * Most keys are options by their names and are stored through the rows of
 * options_table.h; the sections [buttons] and [actions] have a syntax of their
 * own. An option on the command line overrides the one in the file.
 */
#ifndef APP_CMD_OPTIONS_CONFIG_H
#define APP_CMD_OPTIONS_CONFIG_H

#include "app/cmd/options/options.h"
#include "platform/base/arena.h"

/*
 * Owns the strings of the options that were read. The caller zeroes it first.
 */
struct config {
	struct arena arena;
};

/*
 * Finds the file to read: given (the value of --config), else $LIMBER_CONFIG,
 * else, if search, $XDG_CONFIG_HOME/limber/limber.conf, with $HOME/.config when
 * that variable is not set, else /etc/limber.conf. Writes its path to path, of
 * size bytes. Returns 1; 0 if there is no file or its name is "none"; or
 * -ENAMETOOLONG after logging an error.
 */
int config_find(const char *given, bool search, char *path, size_t size,
	const struct log *log);

/*
 * Reads the file into *options, which keeps pointers into *config. Options that
 * the command does not have are checked and skipped. Returns 0, or -errno after
 * logging an error that begins "FILE:LINE: ".
 */
int config_load(struct config *config, const char *path,
	enum command_bit command, struct options *options,
	const struct log *log);

/* The same for an open file; path is only used in messages. */
int config_read(struct config *config, FILE *file, const char *path,
	enum command_bit command, struct options *options,
	const struct log *log);

/* Releases the strings: the options must not be used any more. */
void config_release(struct config *config);

#endif
