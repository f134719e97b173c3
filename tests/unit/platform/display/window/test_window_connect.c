/*
 * What limber doctor says of a window's server by how a connection to it
 * begins. The functions below replace those of the C library.
 */
#include "tests/support/survey_capture.h"
#include "tests/support/test.h"

#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>

#if __has_include(<SDL.h>)
#include "platform/display/window/window_survey.h"

/* How a connection begins and goes on; an error is 0 or that of errno. */
struct course {
	int connect_error;
	int ready; /* what poll() returns, where it goes on */
	int late_error;
	int option_error; /* of getsockopt() */
	const char *answer;
};

static struct {
	struct course course;
	int connects, polls, options;
	struct sockaddr_storage address; /* of the last connection */
	socklen_t size;
} libc;

/* 0 or -1, with errno. */
static int result_of(int error)
{
	errno = error ? error : ENOTTY;
	return error ? -1 : 0;
}

int connect(int fd, const struct sockaddr *address, socklen_t size)
{
	(void)fd;
	libc.connects++;
	assert_true(size <= sizeof(libc.address));
	memcpy(&libc.address, address, size);
	libc.size = size;
	return result_of(libc.course.connect_error);
}

int poll(struct pollfd *waited, nfds_t count, int timeout_ms)
{
	assert_int_equal(count, 1);
	assert_int_equal(waited->events, POLLOUT);
	assert_in_range(timeout_ms, 50, 1000);
	libc.polls++;
	return libc.course.ready;
}

int getsockopt(int fd, int level, int name, void *value, socklen_t *size)
{
	(void)fd;
	assert_int_equal(level, SOL_SOCKET);
	assert_int_equal(name, SO_ERROR);
	assert_int_equal(*size, sizeof(int));
	libc.options++;
	memcpy(value, &libc.course.late_error, sizeof(int));
	return result_of(libc.course.option_error);
}

static void survey_display(const char *display, struct survey_capture *capture)
{
	const struct survey survey = survey_capture_begin(capture, NULL);

	unsetenv("SDL_VIDEODRIVER");
	setenv("DISPLAY", display, 1);
	libc.connects = libc.polls = libc.options = 0;
	window_survey(&survey);
	unsetenv("DISPLAY");
	assert_int_equal(capture->count, 1);
}

static void expect_answer(const char *display, const char *answer)
{
	struct survey_capture capture;
	bool works = strcmp(answer, "answers") == 0;

	survey_display(display, &capture);
	survey_capture_expect(&capture, 0, works ? SURVEY_WORKS : SURVEY_BROKEN,
		"window", answer, works ? NULL : "export DISPLAY=");
}

static void test_each_course_of_a_connection_is_told(void **state)
{
	const struct course courses[] = {
		{0, 0, 0, 0, "answers"},
		{EAGAIN, 0, 0, 0, "answers"},
		{ECONNREFUSED, 1, 0, 0, strerror(ECONNREFUSED)},
		{ENOENT, 1, 0, 0, strerror(ENOENT)},
		{EINPROGRESS, 1, 0, 0, "answers"},
		{EINPROGRESS, 0, 0, 0, strerror(ETIMEDOUT)},
		{EINPROGRESS, -1, 0, 0, strerror(ETIMEDOUT)},
		{EINPROGRESS, 1, ECONNREFUSED, 0, strerror(ECONNREFUSED)},
		{EINPROGRESS, 1, 0, ENOBUFS, strerror(ENOBUFS)},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(courses); i++) {
		bool goes_on = courses[i].connect_error == EINPROGRESS;

		libc.course = courses[i];
		expect_answer("localhost:3.1", courses[i].answer);
		assert_int_equal(libc.connects, 1);
		assert_int_equal(libc.polls, goes_on);
		assert_int_equal(libc.options, goes_on && courses[i].ready == 1);
		expect_answer(":3", courses[i].answer);
		/* Abstract first, then in the file system. */
		assert_int_equal(libc.connects,
			strcmp(courses[i].answer, "answers") == 0 ? 1 : 2);
	}
}

static void test_a_display_of_this_machine_is_a_port(void **state)
{
	static const char *const displays[] = {
		"localhost:0", "127.0.0.1:59.0", "localhost:59535"};
	static const int ports[] = {6000, 6059, 65535};
	struct sockaddr_in address;

	(void)state;
	libc.course = (struct course){0};
	for (size_t i = 0; i < ARRAY_COUNT(ports); i++) {
		expect_answer(displays[i], "answers");
		memcpy(&address, &libc.address, sizeof(address));
		assert_int_equal(libc.size, sizeof(address));
		assert_int_equal(address.sin_family, AF_INET);
		assert_int_equal(ntohs(address.sin_port), ports[i]);
		assert_int_equal(
			ntohl(address.sin_addr.s_addr), INADDR_LOOPBACK);
	}
}

static void test_a_display_without_a_host_is_a_unix_socket(void **state)
{
	static const char *const displays[] = {":0", "unix:7.0", ":59535"};
	static const char *const names[] = {"/tmp/.X11-unix/X0",
		"/tmp/.X11-unix/X7", "/tmp/.X11-unix/X59535"};
	const size_t begin = offsetof(struct sockaddr_un, sun_path);
	struct sockaddr_un address;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		size_t length = strlen(names[i]);

		libc.course = (struct course){0};
		expect_answer(displays[i], "answers");
		memcpy(&address, &libc.address, sizeof(address));
		assert_int_equal(libc.size, begin + 1 + length);
		assert_int_equal(address.sun_family, AF_UNIX);
		assert_int_equal(address.sun_path[0], 0);
		assert_memory_equal(address.sun_path + 1, names[i], length);
		libc.course.connect_error = ECONNREFUSED;
		expect_answer(displays[i], strerror(ECONNREFUSED));
		memcpy(&address, &libc.address, sizeof(address));
		assert_int_equal(libc.size, begin + length + 1);
		assert_string_equal(address.sun_path, names[i]);
	}
}

static void test_no_other_display_is_connected_to(void **state)
{
	static const struct {
		const char *display;
		enum survey_state state;
	} cases[] = {
		{"localhost:59536", SURVEY_BROKEN},
		{":59536", SURVEY_BROKEN},
		{":-1", SURVEY_BROKEN},
		{"localhost", SURVEY_BROKEN},
		{"localhos:0", SURVEY_UNUSED},
		{"localhost2:0", SURVEY_UNUSED},
		{"127.0.0.12:0", SURVEY_UNUSED},
		{"uniq:0", SURVEY_UNUSED},
		{"unix2:0", SURVEY_UNUSED},
		{"x:0", SURVEY_UNUSED},
	};

	(void)state;
	libc.course = (struct course){0};
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct survey_capture capture;

		survey_display(cases[i].display, &capture);
		survey_capture_expect(&capture, 0, cases[i].state, "window",
			cases[i].display,
			cases[i].state == SURVEY_BROKEN ? "export DISPLAY="
							: "--display window");
		assert_int_equal(libc.connects, 0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_course_of_a_connection_is_told),
		cmocka_unit_test(test_a_display_of_this_machine_is_a_port),
		cmocka_unit_test(test_a_display_without_a_host_is_a_unix_socket),
		cmocka_unit_test(test_no_other_display_is_connected_to),
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
