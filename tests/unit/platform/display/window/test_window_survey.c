#include "tests/support/files.h"
#include "tests/support/survey_capture.h"
#include "tests/support/test.h"

#include <netinet/in.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#if __has_include(<SDL.h>)
#include "platform/display/window/window_survey.h"

/* A server that accepts connections but never answers. The caller closes it. */
static int listen_at(const char *name, bool abstract)
{
	struct sockaddr_un address = {.sun_family = AF_UNIX};
	int fd = socket(AF_UNIX, SOCK_STREAM, 0);
	size_t length = strlen(name);

	assert_true(fd >= 0 && length + 1 < sizeof(address.sun_path));
	memcpy(address.sun_path + abstract, name, length);
	if (bind(fd, (const struct sockaddr *)&address,
		    (socklen_t)(offsetof(struct sockaddr_un, sun_path) +
			    length + 1)) < 0) {
		close(fd);
		return -1;
	}
	assert_int_equal(listen(fd, 1), 0);
	return fd;
}

static void survey_window(struct survey_capture *capture)
{
	const struct survey survey = survey_capture_begin(capture, NULL);

	window_survey(&survey);
	assert_int_equal(capture->count, 1);
}

/* A survey finds the server of DISPLAY, but not after it was closed. */
static void expect_a_server_until_closed(int fd)
{
	struct survey_capture capture;

	survey_window(&capture);
	survey_capture_expect(
		&capture, 0, SURVEY_WORKS, "window", "answers", NULL);
	close(fd);
	survey_window(&capture);
	survey_capture_expect(&capture, 0, SURVEY_BROKEN, "window",
		"does not answer", "export DISPLAY=");
}

static void test_a_survey_knows_the_drivers_of_sdl(void **state)
{
	static const struct {
		const char *names;
		enum survey_state state;
	} cases[] = {
		{"dummy", SURVEY_WORKS},
		{"DUMMY", SURVEY_WORKS},
		{"none,dummy", SURVEY_WORKS},
		{"dummy,none", SURVEY_WORKS},
		{"dumm", SURVEY_BROKEN},
		{"dummy2", SURVEY_BROKEN},
		{"none", SURVEY_BROKEN},
		{",", SURVEY_BROKEN},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct survey_capture capture;

		setenv("SDL_VIDEODRIVER", cases[i].names, 1);
		survey_window(&capture);
		survey_capture_expect(&capture, 0, cases[i].state, "window",
			cases[i].names,
			cases[i].state == SURVEY_BROKEN ? "unset SDL_VIDEODRIVER"
							: NULL);
	}
	unsetenv("SDL_VIDEODRIVER");
}

static void test_a_survey_connects_to_an_x_server(void **state)
{
	char name[64], display[16];
	int fd = -1, number = 60;

	(void)state;
	unsetenv("SDL_VIDEODRIVER");
	while (fd < 0 && number < 99) {
		snprintf(name, sizeof(name), "/tmp/.X11-unix/X%d", ++number);
		fd = listen_at(name, true);
	}
	assert_true(fd >= 0);
	snprintf(display, sizeof(display), ":%d.0", number);
	setenv("DISPLAY", display, 1);
	expect_a_server_until_closed(fd);
	unsetenv("DISPLAY");
}

/* The port of display 0 is 6000; fd listens at that of the display returned. */
static int listen_at_port(int *fd)
{
	struct sockaddr_in address = {.sin_family = AF_INET,
		.sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
	socklen_t size = sizeof(address);

	*fd = socket(AF_INET, SOCK_STREAM, 0);
	assert_int_equal(
		bind(*fd, (const struct sockaddr *)&address, sizeof(address)),
		0);
	assert_int_equal(listen(*fd, 1), 0);
	assert_int_equal(
		getsockname(*fd, (struct sockaddr *)&address, &size), 0);
	return ntohs(address.sin_port) - 6000;
}

static void test_a_survey_connects_to_an_x_server_by_its_port(void **state)
{
	static const char *const hosts[] = {"localhost", "127.0.0.1"};
	char display[32];

	(void)state;
	unsetenv("SDL_VIDEODRIVER");
	for (size_t i = 0; i < ARRAY_COUNT(hosts); i++) {
		int fd, number = listen_at_port(&fd);

		snprintf(display, sizeof(display), "%s:%d", hosts[i], number);
		setenv("DISPLAY", display, 1);
		expect_a_server_until_closed(fd);
	}
	unsetenv("DISPLAY");
}

static void test_a_survey_reads_any_name_of_a_display(void **state)
{
	static const struct {
		const char *display, *text;
		enum survey_state state;
	} cases[] = {
		{"rubbish", "names no display", SURVEY_BROKEN},
		{":-1", "names no display", SURVEY_BROKEN},
		{"localhost:59535", "does not answer", SURVEY_BROKEN},
		{"localhost:59536", "names no display", SURVEY_BROKEN},
		{"unix:59000", "does not answer", SURVEY_BROKEN},
		{"unit:59000", "another machine", SURVEY_UNUSED},
		{"unix2:59000", "another machine", SURVEY_UNUSED},
		{"local:0", "another machine", SURVEY_UNUSED},
		{"localhost2:0", "another machine", SURVEY_UNUSED},
		{"localnest:0", "another machine", SURVEY_UNUSED},
		{"elsewhere.example:0", "another machine", SURVEY_UNUSED},
	};

	(void)state;
	unsetenv("SDL_VIDEODRIVER");
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct survey_capture capture;

		setenv("DISPLAY", cases[i].display, 1);
		survey_window(&capture);
		survey_capture_expect(&capture, 0, cases[i].state, "window",
			cases[i].text,
			cases[i].state == SURVEY_BROKEN ? "export DISPLAY="
							: "--display window");
		assert_contains(capture.finding[0].text, cases[i].display);
	}
	unsetenv("DISPLAY");
}

/* The kernel takes names below 108 bytes; 255 fit into the survey's own path. */
static void test_a_survey_refuses_long_names_of_sockets(void **state)
{
	static const size_t lengths[] = {107, 108, 255, 256, 400};
	struct survey_capture capture;
	char name[401];

	(void)state;
	unsetenv("SDL_VIDEODRIVER");
	unsetenv("DISPLAY");
	for (size_t i = 0; i < ARRAY_COUNT(lengths); i++) {
		memset(name, 'x', lengths[i]);
		name[0] = '/';
		name[lengths[i]] = '\0';
		setenv("WAYLAND_DISPLAY", name, 1);
		survey_window(&capture);
		survey_capture_expect(&capture, 0, SURVEY_BROKEN, "window",
			"does not answer: File name too long",
			"terminal of the desktop");
	}
	name[106] = '\0';
	setenv("WAYLAND_DISPLAY", name, 1);
	survey_window(&capture);
	survey_capture_expect(&capture, 0, SURVEY_BROKEN, "window",
		"does not answer: No such file", "terminal of the desktop");
	unsetenv("WAYLAND_DISPLAY");
}

static void test_a_survey_connects_to_wayland(void **state)
{
	struct test_path folder = temp_dir_make();
	struct survey_capture capture;
	int fd;

	(void)state;
	unsetenv("SDL_VIDEODRIVER");
	unsetenv("DISPLAY");
	setenv("XDG_RUNTIME_DIR", folder.text, 1);
	setenv("WAYLAND_DISPLAY", "wayland-7", 1);
	survey_window(&capture);
	survey_capture_expect(&capture, 0, SURVEY_BROKEN, "window",
		"does not answer", "terminal of the desktop");
	fd = listen_at(path_join(&folder, "wayland-7").text, false);
	assert_true(fd >= 0);
	survey_window(&capture);
	survey_capture_expect(&capture, 0, SURVEY_BROKEN, "window",
		"DISPLAY is not set", "apt install xwayland");
	setenv("WAYLAND_DISPLAY", path_join(&folder, "wayland-7").text, 1);
	setenv("XDG_RUNTIME_DIR", "/nonexistent", 1);
	survey_window(&capture);
	survey_capture_expect(&capture, 0, SURVEY_BROKEN, "window",
		"DISPLAY is not set", "apt install xwayland");
	close(fd);
	unsetenv("WAYLAND_DISPLAY");
	unsetenv("XDG_RUNTIME_DIR");
	temp_dir_remove(&folder);
	survey_window(&capture);
	survey_capture_expect(&capture, 0, SURVEY_MISSING, "window",
		"no desktop", "export DISPLAY=:0");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_survey_connects_to_an_x_server),
		cmocka_unit_test(
			test_a_survey_connects_to_an_x_server_by_its_port),
		cmocka_unit_test(test_a_survey_reads_any_name_of_a_display),
		cmocka_unit_test(test_a_survey_knows_the_drivers_of_sdl),
		cmocka_unit_test(test_a_survey_refuses_long_names_of_sockets),
		cmocka_unit_test(test_a_survey_connects_to_wayland),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

#else
#include "tests/unit/platform/display/window/no_window.h"

int main(void)
{
	return skip_the_window();
}

#endif
