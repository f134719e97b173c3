/*
 * How many instructions this thread executes, where the machine tells.
 */
#ifndef PLATFORM_PROCESS_INSTRUCTION_COUNT_H
#define PLATFORM_PROCESS_INSTRUCTION_COUNT_H

#include <stdint.h>

struct instruction_count {
	int descriptor;
};

/*
 * Begins to count instructions in user space. 0, or -errno and nothing to
 * end: many virtual machines, containers and kernels have no such counter.
 */
int instruction_count_begin(struct instruction_count *count);

/* Ends it: the instructions since, or -errno. */
int64_t instruction_count_end(struct instruction_count *count);

#endif
