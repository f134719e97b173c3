/*
 * Connects to the socket of the desktop's server, but exchanges no messages,
 * because a server that hangs would never answer.
 */
#include "platform/display/window/window_survey.h"

#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <poll.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "platform/display/window/sdl.h"

enum {
	X_PORT = 6000,
	WAIT_MS = 200
};

/* Returns 0 when a server accepts the connection, else -errno. */
static int try_connect(const struct sockaddr *address, socklen_t size)
{
	int fd = socket(address->sa_family,
		SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
	struct pollfd waited = {.fd = fd, .events = POLLOUT};
	int error = 0;
	socklen_t error_size = sizeof(error);

	if (fd < 0) {
		return -errno;
	}
	if (connect(fd, address, size) < 0) {
		error = errno;
	}
	if (error == EINPROGRESS) {
		error = poll(&waited, 1, WAIT_MS) == 1 ? 0 : ETIMEDOUT;
		if (!error &&
			getsockopt(fd, SOL_SOCKET, SO_ERROR, &error,
				&error_size) < 0) {
			error = errno;
		}
	}
	close(fd);
	/* EAGAIN: the server exists, but its queue of connections is full. */
	return error == EAGAIN ? 0 : -error;
}

/* A Unix socket, in the file system or abstract. */
static int try_unix_socket(const char *name, bool abstract)
{
	struct sockaddr_un address = {.sun_family = AF_UNIX};
	size_t length = strlen(name);

	if (length + 1 >= sizeof(address.sun_path)) {
		return -ENAMETOOLONG;
	}
	memcpy(address.sun_path + abstract, name, length);
	return try_connect((const struct sockaddr *)&address,
		(socklen_t)(offsetof(struct sockaddr_un, sun_path) + length + 1));
}

static int try_port(int port)
{
	struct sockaddr_in address = {
		.sin_family = AF_INET,
		.sin_port = htons((uint16_t)port),
		.sin_addr.s_addr = htonl(INADDR_LOOPBACK),
	};

	return try_connect((const struct sockaddr *)&address, sizeof(address));
}

static bool is_this_machine(const char *host, size_t length)
{
	static const char *const names[] = {"localhost", "127.0.0.1", NULL};

	for (int i = 0; names[i]; i++) {
		if (strlen(names[i]) == length &&
			strncmp(host, names[i], length) == 0) {
			return true;
		}
	}
	return false;
}

/* display is HOST:NUMBER.SCREEN; HOST is empty or "unix" for a Unix socket. */
static void report_x(const char *display, const struct survey *survey)
{
	static const char remedy[] =
		"set DISPLAY to that of a running desktop: export DISPLAY=:0";
	const char *colon = strrchr(display, ':');
	size_t length = colon ? (size_t)(colon - display) : 0;
	char name[64];
	long number = colon ? strtol(colon + 1, NULL, 10) : -1;
	int error;

	if (number < 0 || number > 59535) {
		survey_report(survey, SURVEY_BROKEN, "window", remedy,
			"DISPLAY=%s names no display", display);
		return;
	}
	if (length == 0 || (length == 4 && strncmp(display, "unix", 4) == 0)) {
		snprintf(name, sizeof(name), "/tmp/.X11-unix/X%ld", number);
		error = try_unix_socket(name, true);
		error = error ? try_unix_socket(name, false) : 0;
	} else if (is_this_machine(display, length)) {
		error = try_port(X_PORT + (int)number);
	} else {
		survey_report(survey, SURVEY_UNUSED, "window",
			"try it: limber play --display window",
			"DISPLAY=%s is on another machine, which was not tried",
			display);
		return;
	}
	if (error) {
		survey_report(survey, SURVEY_BROKEN, "window", remedy,
			"DISPLAY=%s does not answer: %s", display,
			strerror(-error));
	} else {
		survey_report(survey, SURVEY_WORKS, "window", NULL,
			"DISPLAY=%s answers", display);
	}
}

/* On Wayland alone SDL cannot copy pictures; limber needs Xwayland. */
static void report_wayland(const char *display, const struct survey *survey)
{
	const char *folder = getenv("XDG_RUNTIME_DIR");
	char name[256];
	int length = snprintf(name, sizeof(name), "%s%s%s",
		display[0] == '/' ? "" : (folder ? folder : ""),
		display[0] == '/' ? "" : "/", display);
	int error = length < (int)sizeof(name) ? try_unix_socket(name, false)
					       : -ENAMETOOLONG;

	if (error) {
		survey_report(survey, SURVEY_BROKEN, "window",
			"start limber in a terminal of the desktop",
			"WAYLAND_DISPLAY=%s does not answer: %s", display,
			strerror(-error));
	} else {
		survey_report(survey, SURVEY_BROKEN, "window",
			"sudo apt install xwayland, then log in again",
			"WAYLAND_DISPLAY=%s answers, but DISPLAY is not set",
			display);
	}
}

/* names are drivers of SDL, separated by commas. */
static bool is_driver_of_sdl(const struct sdl *sdl, const char *names)
{
	while (*names) {
		size_t length = strcspn(names, ",");

		for (int i = 0; i < sdl->GetNumVideoDrivers(); i++) {
			const char *driver = sdl->GetVideoDriver(i);

			if (strlen(driver) == length &&
				strncasecmp(names, driver, length) == 0) {
				return true;
			}
		}
		names += length + (names[length] == ',');
	}
	return false;
}

static void report_driver(
	const struct sdl *sdl, const char *driver, const struct survey *survey)
{
	if (is_driver_of_sdl(sdl, driver)) {
		survey_report(survey, SURVEY_WORKS, "window", NULL,
			"SDL_VIDEODRIVER=%s", driver);
	} else {
		survey_report(survey, SURVEY_BROKEN, "window",
			"unset SDL_VIDEODRIVER",
			"SDL has no driver of the name in SDL_VIDEODRIVER=%.99s",
			driver);
	}
}

/* Returns whether SDL can be used, and else reports why not. */
static bool has_sdl(struct sdl *sdl, const struct survey *survey)
{
	struct survey_message message;
	const struct log log = survey_log(&message);
	int error = sdl_load(sdl, &log);

	if (error) {
		survey_report_message(survey,
			error == -ENOENT ? SURVEY_MISSING : SURVEY_BROKEN,
			"window", &message, "sudo apt install " SDL_PACKAGE);
	}
	return error == 0;
}

static bool is_set(const char *value)
{
	return value && value[0];
}

void window_survey(const struct survey *survey)
{
	const char *driver = getenv("SDL_VIDEODRIVER");
	const char *x = getenv("DISPLAY");
	const char *wayland = getenv("WAYLAND_DISPLAY");
	bool other = is_set(driver) && strcmp(driver, "x11") != 0 &&
		strcmp(driver, "wayland") != 0;
	struct sdl sdl;

	if (!other && !is_set(x) && !is_set(wayland)) {
		survey_report(survey, SURVEY_MISSING, "window",
			"start limber in a terminal of the desktop, or export DISPLAY=:0",
			"there is no desktop: DISPLAY and WAYLAND_DISPLAY are not set");
	} else if (!has_sdl(&sdl, survey)) {
		return;
	} else if (other) {
		report_driver(&sdl, driver, survey);
	} else if (is_set(x)) {
		report_x(x, survey);
	} else {
		report_wayland(wayland, survey);
	}
}
