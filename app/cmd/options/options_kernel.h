/*
 * Chooses the kernel that --math and --kernel ask for.
 */
#ifndef APP_CMD_OPTIONS_OPTIONS_KERNEL_H
#define APP_CMD_OPTIONS_OPTIONS_KERNEL_H

#include "app/anim/kernel/kernel.h"
#include "app/cmd/options/options.h"

/*
 * The kernel named by --kernel; without a name, the first in the registry whose
 * arithmetic is the one of --math. Returns NULL after logging an error when
 * there is no such kernel or the two options contradict each other: then the
 * command line is wrong.
 */
const struct kernel *options_kernel(
	const struct options_vertices *options, const struct log *log);

#endif
