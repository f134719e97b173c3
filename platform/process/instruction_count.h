/*
 * Counts the instructions that this thread executes, where the machine has a
 * hardware counter.
 */
#ifndef PLATFORM_PROCESS_INSTRUCTION_COUNT_H
#define PLATFORM_PROCESS_INSTRUCTION_COUNT_H

#include <stdint.h>

struct instruction_count {
	int descriptor; /* of the kernel's counter; -1 when not counting */
};

/*
 * Begins to count instructions in user space. Returns 0, or -errno: many
 * virtual machines, containers and kernels offer no such counter.
 */
int instruction_count_begin(struct instruction_count *count);

/* Ends counting. Returns the instructions since it began, or -errno. */
int64_t instruction_count_end(struct instruction_count *count);

#endif
