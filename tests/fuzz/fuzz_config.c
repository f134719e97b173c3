/*
 * Parses any text as limber.conf, including its GPIO lines and keys.
 */
#include "app/cmd/options/config.h"

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct config config = {arena_empty()};
	struct options options = options_default();
	struct log log = log_to_nowhere();
	FILE *file = size ? fmemopen((void *)data, size, "r") : NULL;

	if (file) {
		config_read(
			&config, file, "limber.conf", FOR_PLAY, &options, &log);
		fclose(file);
	}
	config_release(&config);
	return 0;
}
