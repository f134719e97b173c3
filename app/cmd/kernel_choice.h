/*
 * --kernel: a name into a kernel.
 */
#ifndef APP_CMD_KERNEL_CHOICE_H
#define APP_CMD_KERNEL_CHOICE_H

#include "app/anim/kernel/kernel.h"
#include "platform/base/log.h"

/* The named kernel, the best one for NULL; NULL after a sentence. */
const struct kernel *kernel_choose(const char *name, const struct log *log);

#endif
