/*
 * Parses any text as a presets file (assets/presets.ini).
 */
#include "app/anim/procedural/procedural.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct procedural_preset preset[8];
	struct log log = log_to_nowhere();
	char *text = malloc(size + 1);

	if (!text) {
		return 0;
	}
	memcpy(text, data, size);
	text[size] = '\0';
	procedural_presets_parse(text, "presets", &log, preset, 8);
	free(text);
	return 0;
}
