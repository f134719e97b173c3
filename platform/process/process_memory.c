#include "platform/process/process_memory.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

/* See proc(5): statm is "size resident shared ...", in pages. */
size_t process_memory_bytes(void)
{
	char text[128];
	char *at;
	ssize_t length;
	unsigned long pages;
	int file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);

	if (file < 0) {
		return 0;
	}
	length = read(file, text, sizeof(text) - 1);
	close(file);
	if (length <= 0) {
		return 0;
	}
	text[length] = '\0';
	(void)strtoul(text, &at, 10);
	pages = strtoul(at, NULL, 10);
	return (size_t)pages * (size_t)sysconf(_SC_PAGESIZE);
}
