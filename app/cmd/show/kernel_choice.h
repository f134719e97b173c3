/*
 * --math and --kernel into a kernel.
 */
#ifndef APP_CMD_SHOW_KERNEL_CHOICE_H
#define APP_CMD_SHOW_KERNEL_CHOICE_H

#include "app/anim/kernel/kernel.h"
#include "app/cmd/options/options.h"

/*
 * The kernel that --kernel names, else the best one of the kind that --math
 * names, else the best one. NULL after a sentence when the two contradict each
 * other or there is no such kernel.
 */
const struct kernel *kernel_choose(
	const struct options *options, const struct log *log);

#endif
