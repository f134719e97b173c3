#include "platform/watchdog/watchdog.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/watchdog.h>
#include <signal.h>
#include <stdbool.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>

enum {
	EARLIER_S = 2,
	LONGEST_S = 3600,
	USUAL_PERIOD_MS = 1000,
	SHORT_PERIOD_MS = 250
};

/*
 * Starts the timer again, whose SIGALRM ends the process if this function is
 * not called again within limit_s. If that does not end it, the device restarts
 * the board.
 */
static void limit_silence(const struct watchdog *watchdog)
{
	const struct itimerspec until = {
		.it_value = {.tv_sec = watchdog->limit_s}};

	if (watchdog->limit_s) {
		(void)timer_settime(watchdog->timer, 0, &until, NULL);
	}
}

/*
 * Sets limit_s and creates the timer, unless the timeout, which may be any
 * number, is too short or implausibly long.
 */
static void choose_limit(struct watchdog *watchdog, int timeout_s)
{
	struct sigevent alarm = {
		.sigev_notify = SIGEV_SIGNAL, .sigev_signo = SIGALRM};

	if (timeout_s > 2 * EARLIER_S && timeout_s <= LONGEST_S &&
		timer_create(CLOCK_MONOTONIC, &alarm, &watchdog->timer) == 0) {
		watchdog->limit_s = timeout_s - EARLIER_S;
	}
	limit_silence(watchdog);
}

struct watchdog watchdog_none(void)
{
	return (struct watchdog){.fd = -1};
}

/* Whether a byte that is written to that path would replace another one. */
static bool holds_data(const char *path)
{
	struct stat status;

	return stat(path, &status) == 0 &&
		(S_ISBLK(status.st_mode) ||
			(S_ISREG(status.st_mode) && status.st_size > 0));
}

static void say_why(const char *path, int error, const struct log *log)
{
	const char *reason = error == EEXIST
		? "this is no watchdog: it holds data"
		: strerror(error);
	const char *advice = "give a watchdog's device, such as /dev/watchdog";

	if (error == ENOENT || error == ENODEV) {
		advice = "load its driver";
	} else if (error == EBUSY) {
		advice = "another program uses it: stop that program";
	} else if (error == EACCES || error == EPERM) {
		advice = "run as root";
	}

	log_warning(log,
		"--watchdog %s: %s: limber continues without it: %s, or leave --watchdog out",
		path, reason, advice);
}

int watchdog_open(struct watchdog *out, const char *path,
	const struct device_calls *calls, const struct log *log)
{
	bool refused = holds_data(path);
	int fd = refused ? -1
			 : calls->open(path, O_WRONLY | O_CLOEXEC | O_NONBLOCK);
	int timeout_s = 0;

	*out = watchdog_none();
	if (fd < 0) {
		int error = refused ? EEXIST : errno;

		say_why(path, error, log);
		return -error;
	}
	*out = (struct watchdog){
		.calls = calls,
		.log = *log,
		.path = path,
		.fd = fd,
		.period_ms = USUAL_PERIOD_MS,
		.fed_ms = INT64_MIN,
	};
	if (device_control(calls, fd, WDIOC_GETTIMEOUT, &timeout_s) == 0) {
		log_note(log, "--watchdog %s: it restarts the board after %d s",
			path, timeout_s);
		if (timeout_s == 1) {
			out->period_ms = SHORT_PERIOD_MS;
		}
		choose_limit(out, timeout_s);
	}
	return 0;
}

/* Returns 0 or an errno. */
static int write_byte(const struct watchdog *watchdog, const char *byte)
{
	ssize_t written = watchdog->calls->write(watchdog->fd, byte, 1);

	if (written == 1) {
		return 0;
	}
	return written < 0 ? errno : EIO;
}

/* Logs that feeding has begun to fail, fails otherwise, or works again. */
static void report_change(struct watchdog *watchdog, int error)
{
	if (error && error != watchdog->error) {
		log_warning(&watchdog->log,
			"--watchdog %s: cannot be fed: %s: the board may restart",
			watchdog->path, strerror(error));
	} else if (!error && watchdog->error) {
		log_warning(&watchdog->log, "--watchdog %s: is fed again",
			watchdog->path);
	}
	watchdog->error = error;
}

void watchdog_feed(struct watchdog *watchdog, int64_t now_ms)
{
	int error;

	if (watchdog->fd < 0 ||
		(watchdog->fed_ms != INT64_MIN &&
			now_ms - watchdog->fed_ms < watchdog->period_ms)) {
		return;
	}
	watchdog->fed_ms = now_ms;
	limit_silence(watchdog);
	/* Any byte feeds it except 'V', which allows it to be stopped. */
	error = write_byte(watchdog, "");
	if (error != EINTR) {
		report_change(watchdog, error);
	}
}

void watchdog_close(struct watchdog *watchdog)
{
	int error;

	if (watchdog->fd < 0) {
		return;
	}
	if (watchdog->limit_s) {
		(void)timer_delete(watchdog->timer);
	}
	error = write_byte(watchdog, "V");
	if (error) {
		log_warning(&watchdog->log,
			"--watchdog %s: cannot be stopped: %s: the board may restart",
			watchdog->path, strerror(error));
	}
	watchdog->calls->close(watchdog->fd);
	*watchdog = watchdog_none();
}
