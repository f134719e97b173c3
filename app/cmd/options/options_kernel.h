/*
 * Chooses the kernel that --math and --kernel ask for.
 */
#ifndef APP_CMD_OPTIONS_OPTIONS_KERNEL_H
#define APP_CMD_OPTIONS_OPTIONS_KERNEL_H

#include "app/anim/kernel/kernel.h"
#include "app/cmd/options/options.h"

/*
 * Returns the kernel that --kernel names or, without a name, the first in the
 * registry with the arithmetic of --math. Returns NULL after logging an error
 * if there is no such kernel, or if the two options contradict each other.
 */
const struct kernel *options_kernel(
	const struct options_vertices *options, const struct log *log);

#endif
