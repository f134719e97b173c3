#include "app/cmd/command.h"
static int run(const struct options *options, const struct log *log)
{
	(void)options;
	(void)log;
	return EXIT_FAILED;
}
const struct command command_info = {
	.name = "info",
	.bit = FOR_INFO,
	.usage = "MODEL [--json]",
	.summary = "tell what a model holds",
	.detail = "",
	.run = run,
};
