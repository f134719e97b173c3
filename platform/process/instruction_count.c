#define _DEFAULT_SOURCE /* syscall() */

#include "platform/process/instruction_count.h"

#include <errno.h>
#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

/* perf_event_open(2); the C library has no function for it. */
int instruction_count_begin(struct instruction_count *count)
{
	struct perf_event_attr wanted = {
		.type = PERF_TYPE_HARDWARE,
		.size = sizeof(wanted),
		.config = PERF_COUNT_HW_INSTRUCTIONS,
		.exclude_kernel = 1,
		.exclude_hv = 1,
	};

	count->descriptor = (int)syscall(
		SYS_perf_event_open, &wanted, 0, -1, -1, PERF_FLAG_FD_CLOEXEC);
	return count->descriptor < 0 ? -errno : 0;
}

/* Not counted: virtual machines do not let programs count instructions. */
int64_t instruction_count_end(struct instruction_count *count)
{
	uint64_t value;
	ssize_t got = read(count->descriptor, &value, sizeof(value));
	int error = got < 0 ? errno : EIO;

	close(count->descriptor);
	count->descriptor = -1;
	return got == (ssize_t)sizeof(value) ? (int64_t)value : -error;
}
