#include "app/compare/board_profile.h"

#include <string.h>

static const struct board_profile profiles[] = {
	{
		.name = "imx31-pdk",
		.summary = "ARM1136 at 532 MHz, 128 MiB",
		.ram_bytes = 128u << 20,
		.taken_bytes = 48u << 20,
		.frame_ms = 1000.0 / 30.0,
		.bytes_per_percent = 256u << 10,
	},
};

const struct board_profile *board_profile_find(const char *name)
{
	for (size_t i = 0; i < sizeof(profiles) / sizeof(*profiles); i++) {
		if (!name || strcmp(profiles[i].name, name) == 0) {
			return &profiles[i];
		}
	}
	return NULL;
}
