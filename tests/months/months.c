/*
 * A library that stretches the time of a program that is started with
 * LD_PRELOAD=months.so. The monotonic clock stands still but for a microsecond a
 * look; to sleep moves it to the moment of waking. After MONTHS_FRAMES sleeps it
 * jumps to the next hour.
 *
 * At each hour the library writes a line to MONTHS_OUT, a file descriptor: the
 * bytes that are allocated, the open file descriptors and the milliseconds of the
 * processor that the program has used. Then it waits for a byte from MONTHS_IN.
 * After MONTHS_HOURS hours it sends the program SIGTERM.
 */
#include <errno.h>
#include <fcntl.h>
#include <malloc.h>
#include <pthread.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

enum {
	DESCRIPTORS_MOST = 1024,
	SECOND_NS = 1000000000
};

#define HOUR_NS (INT64_C(3600) * SECOND_NS)

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static int64_t now_ns = SECOND_NS;
static int sleeps;

/* The time after some more of it, and at least least_ns. */
static int64_t pass_ns(int64_t more_ns, int64_t least_ns)
{
	int64_t now;

	pthread_mutex_lock(&lock);
	now = now_ns + more_ns;
	now_ns = now = now < least_ns ? least_ns : now;
	pthread_mutex_unlock(&lock);
	return now;
}

static int number(const char *name)
{
	const char *text = getenv(name);

	if (!text) {
		abort();
	}
	return atoi(text);
}

static int open_descriptors(void)
{
	int count = 0;

	for (int fd = 0; fd < DESCRIPTORS_MOST; fd++) {
		count += fcntl(fd, F_GETFD) >= 0;
	}
	return count;
}

static void report(void)
{
	struct mallinfo2 memory = mallinfo2();
	char line[128], answer;
	int length = snprintf(line, sizeof(line), "%zu %d %ld\n",
		memory.uordblks + memory.hblkhd, open_descriptors(),
		(long)(clock() / (CLOCKS_PER_SEC / 1000)));

	if (write(number("MONTHS_OUT"), line, (size_t)length) != length ||
		read(number("MONTHS_IN"), &answer, 1) != 1) {
		abort();
	}
}

int clock_gettime(clockid_t id, struct timespec *out)
{
	int64_t now;

	if (id != CLOCK_MONOTONIC) {
#ifdef SYS_clock_gettime64
		return (int)syscall(SYS_clock_gettime64, id, out);
#else
		return (int)syscall(SYS_clock_gettime, id, out);
#endif
	}
	now = pass_ns(1000, 0);
	*out = (struct timespec){now / SECOND_NS, (long)(now % SECOND_NS)};
	return 0;
}

/* Only the frame loop sleeps until a moment. */
int clock_nanosleep(clockid_t id, int flags, const struct timespec *until,
	struct timespec *left)
{
	int64_t then = (int64_t)until->tv_sec * SECOND_NS + until->tv_nsec;
	int hours;

	(void)left;
	if (id != CLOCK_MONOTONIC || flags != TIMER_ABSTIME) {
		return ENOTSUP;
	}
	then = pass_ns(0, then);
	if (++sleeps % number("MONTHS_FRAMES") == 0) {
		hours = (int)(then / HOUR_NS) + 1;
		pass_ns(0, hours * HOUR_NS + SECOND_NS);
		report();
		if (hours >= number("MONTHS_HOURS")) {
			raise(SIGTERM);
		}
	}
	return 0;
}
