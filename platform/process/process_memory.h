/*
 * How much memory the program has.
 */
#ifndef PLATFORM_PROCESS_PROCESS_MEMORY_H
#define PLATFORM_PROCESS_PROCESS_MEMORY_H

#include <stddef.h>

/*
 * Bytes of memory that are this process's now, shared libraries included, as
 * Linux counts them; 0 where it cannot tell. Allocates nothing.
 */
size_t process_memory_bytes(void);

#endif
