/*
 * How much memory the program uses.
 */
#ifndef PLATFORM_PROCESS_PROCESS_MEMORY_H
#define PLATFORM_PROCESS_PROCESS_MEMORY_H

#include <stddef.h>

/*
 * The resident memory of this process in bytes, shared libraries included, as
 * Linux counts it. 0 when it cannot be read. Allocates nothing.
 */
size_t process_memory_bytes(void);

#endif
