/*
 * A library that stretches the time of a program that is started with
 * LD_PRELOAD=months.so. The monotonic clock stands still but for a microsecond
 * a look; to sleep moves it to the moment of waking. After MONTHS_FRAMES sleeps
 * it jumps to the next hour.
 *
 * At each hour the library writes a line to MONTHS_OUT, a file descriptor: the
 * bytes that are allocated, the open file descriptors, the microseconds of the
 * processor that the program has used, and those that the library's own
 * yardstick has used, the same work after each frame. Other programs on the
 * machine slow both down alike, so their ratio is the cost of a frame. Then the
 * library waits for a byte from MONTHS_IN. After MONTHS_HOURS hours it sends
 * the program SIGTERM.
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
	YARDSTICK_WORDS = 4096, /* 16 KiB, as the first cache of an ARM11 */
	YARDSTICK_TURNS = 20,
	SECOND_NS = 1000000000
};

#define HOUR_NS (INT64_C(3600) * SECOND_NS)

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static int64_t now_ns = SECOND_NS;
static int sleeps;
static int64_t yardstick_ns;
static uint32_t yardstick_words[YARDSTICK_WORDS];

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

/* The kernel's own call, which fills a struct timespec of this program's size. */
static int system_clock(clockid_t id, struct timespec *out)
{
	long call = SYS_clock_gettime;

#ifdef SYS_clock_gettime64
	if (sizeof(time_t) > sizeof(long)) {
		call = SYS_clock_gettime64;
	}
#endif
	return (int)syscall(call, id, out);
}

static int64_t processor_ns(clockid_t id)
{
	struct timespec now;

	if (system_clock(id, &now) != 0) {
		abort();
	}
	return (int64_t)now.tv_sec * SECOND_NS + now.tv_nsec;
}

static void measure_yardstick(void)
{
	int64_t began_ns = processor_ns(CLOCK_THREAD_CPUTIME_ID);

	for (uint32_t turn = 0; turn < YARDSTICK_TURNS; turn++) {
		for (uint32_t i = 0; i < YARDSTICK_WORDS; i++) {
			uint32_t other =
				yardstick_words[(i * 5 + turn) % YARDSTICK_WORDS];

			yardstick_words[i] =
				yardstick_words[i] * 1664525 + (other ^ i);
		}
	}
	yardstick_ns += processor_ns(CLOCK_THREAD_CPUTIME_ID) - began_ns;
}

static void report(void)
{
	struct mallinfo2 memory = mallinfo2();
	int64_t used_ns = processor_ns(CLOCK_PROCESS_CPUTIME_ID) - yardstick_ns;
	char line[128], answer;
	int length = snprintf(line, sizeof(line), "%zu %d %lld %lld\n",
		memory.uordblks + memory.hblkhd, open_descriptors(),
		(long long)(used_ns / 1000), (long long)(yardstick_ns / 1000));

	if (write(number("MONTHS_OUT"), line, (size_t)length) != length ||
		read(number("MONTHS_IN"), &answer, 1) != 1) {
		abort();
	}
}

int clock_gettime(clockid_t id, struct timespec *out)
{
	int64_t now;

	if (id != CLOCK_MONOTONIC) {
		return system_clock(id, out);
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
	measure_yardstick();
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
