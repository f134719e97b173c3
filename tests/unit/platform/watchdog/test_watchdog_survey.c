/* Which watchdogs limber doctor finds, in a simulated /dev and /sys. */
#include "platform/watchdog/watchdog.h"
#include "tests/support/files.h"
#include "tests/support/survey_capture.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

static void make_folder(const struct test_path *at, const char *name)
{
	assert_int_equal(mkdir(path_join(at, name).text, 0700), 0);
}

static void write_text(
	const struct test_path *at, const char *name, const char *text)
{
	file_write(path_join(at, name).text, text, strlen(text));
}

/* Makes a sysfs with two watchdogs and a device node of the first. */
static void make_watchdogs(const struct test_path *folder, const char *active)
{
	make_folder(folder, "dev");
	make_folder(folder, "class");
	make_folder(folder, "class/watchdog");
	make_folder(folder, "class/watchdog/watchdog0");
	make_folder(folder, "class/watchdog/watchdog1");
	write_text(folder, "class/watchdog/watchdog0/identity", "imx2+ wdt\n");
	write_text(folder, "class/watchdog/watchdog0/timeout", "60\n");
	write_text(folder, "class/watchdog/watchdog0/state", active);
	write_text(folder, "class/watchdog/watchdog1/dev", "248:1\n");
	write_text(folder, "dev/watchdog0", "");
}

static void test_watchdogs_are_reported_without_starting_them(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path devices = path_join(&folder, "dev");
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, folder.text);
	int before, after;
	char *content;

	(void)state;
	make_watchdogs(&folder, "inactive\n");
	before = dup(STDIN_FILENO);
	watchdog_survey(devices.text, &survey);
	after = dup(STDIN_FILENO);
	assert_int_equal(after, before + 1);
	close(after);
	close(before);
	assert_int_equal(capture.count, 2);
	survey_capture_expect(&capture, 0, SURVEY_WORKS, "/watchdog0",
		"imx2+ wdt, restarts the board after 60 seconds", NULL);
	survey_capture_expect(&capture, 1, SURVEY_MISSING, "/watchdog1",
		"device node does not exist", "c 248 1");
	content = file_read(path_join(&devices, "watchdog0").text, NULL);
	assert_string_equal(content, "");
	free(content);
	temp_dir_remove(&folder);
}

static void test_an_active_watchdog_is_taken(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path devices = path_join(&folder, "dev");
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, folder.text);

	(void)state;
	make_watchdogs(&folder, "active\n");
	watchdog_survey(devices.text, &survey);
	survey_capture_expect(&capture, 0, SURVEY_TAKEN, "/watchdog0",
		"another program uses it", "RuntimeWatchdogSec");
	temp_dir_remove(&folder);
}

static void test_no_watchdog_is_one_finding(void **state)
{
	struct test_path folder = temp_dir_make();
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, folder.text);

	(void)state;
	watchdog_survey(folder.text, &survey);
	assert_int_equal(capture.count, 1);
	survey_capture_expect(&capture, 0, SURVEY_MISSING, "watchdog",
		"no watchdog", "modprobe softdog");
	write_text(&folder, "watchdog", "");
	watchdog_survey(folder.text, &survey);
	assert_int_equal(capture.count, 2);
	survey_capture_expect(&capture, 1, SURVEY_WORKS, "/watchdog",
		"restarts the board after some seconds", NULL);
	temp_dir_remove(&folder);
}

static void test_a_watchdog_that_says_little_is_reported(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path devices = path_join(&folder, "dev");
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, folder.text);
	char name[201];

	(void)state;
	make_watchdogs(&folder, "");
	write_text(&folder, "class/watchdog/watchdog0/identity", "");
	write_text(&folder, "class/watchdog/watchdog0/timeout", "3600");
	watchdog_survey(devices.text, &survey);
	assert_string_equal(capture.finding[0].text,
		"restarts the board after 3600 seconds");
	/* A long name is cut. */
	memset(name, 'n', sizeof(name) - 1);
	name[sizeof(name) - 1] = '\0';
	write_text(&folder, "class/watchdog/watchdog0/identity", name);
	write_text(&folder, "class/watchdog/watchdog0/timeout", "9\n");
	watchdog_survey(devices.text, &survey);
	assert_int_equal(strspn(capture.finding[2].text, "n"), 79);
	assert_string_equal(capture.finding[2].text + 79,
		", restarts the board after 9 seconds");
	temp_dir_remove(&folder);
}

static void test_the_name_of_old_kernels_is_that_of_the_first(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path devices = path_join(&folder, "dev");
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, folder.text);

	(void)state;
	make_watchdogs(&folder, "inactive\n");
	write_text(&folder, "dev/watchdog", "");
	assert_int_equal(unlink(path_join(&devices, "watchdog0").text), 0);
	assert_int_equal(
		unlink(path_join(&folder, "class/watchdog/watchdog1/dev").text),
		0);
	watchdog_survey(devices.text, &survey);
	assert_int_equal(capture.count, 1);
	survey_capture_expect(&capture, 0, SURVEY_WORKS, "/watchdog",
		"imx2+ wdt, restarts the board after 60 seconds", NULL);
	temp_dir_remove(&folder);
}

static void test_eight_watchdogs_are_looked_for(void **state)
{
	struct test_path folder = temp_dir_make();
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, folder.text);

	(void)state;
	write_text(&folder, "watchdog8", "");
	watchdog_survey(folder.text, &survey);
	assert_int_equal(capture.count, 1);
	assert_int_equal(capture.finding[0].state, SURVEY_MISSING);
	/* The name of old kernels is that of the first one. */
	write_text(&folder, "watchdog", "");
	write_text(&folder, "watchdog7", "");
	write_text(&folder, "watchdog3", "");
	watchdog_survey(folder.text, &survey);
	assert_int_equal(capture.count, 3);
	survey_capture_expect(
		&capture, 1, SURVEY_WORKS, "/watchdog3", "restarts", NULL);
	survey_capture_expect(
		&capture, 2, SURVEY_WORKS, "/watchdog7", "restarts", NULL);
	temp_dir_remove(&folder);
}

/* Surveys as an ordinary user; returns whether the finding is as expected. */
static int survey_as_a_stranger(const struct test_path *folder)
{
	struct survey_capture capture;
	const struct survey survey =
		survey_capture_begin(&capture, folder->text);

	if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) {
		return 1;
	}
	watchdog_survey(folder->text, &survey);
	return capture.count == 1 && capture.finding[0].state == SURVEY_BROKEN &&
			strstr(capture.finding[0].text, "no permission")
		? 0
		: 2;
}

static void test_a_watchdog_of_root_is_denied_to_others(void **state)
{
	struct test_path folder = temp_dir_make();
	int status = -1;
	pid_t child;

	(void)state;
	write_text(&folder, "watchdog0", "");
	assert_int_equal(chmod(path_join(&folder, "watchdog0").text, 0400), 0);
	assert_int_equal(chmod(folder.text, 0755), 0);
	child = fork();
	if (child == 0) {
		_exit(survey_as_a_stranger(&folder));
	}
	assert_int_equal(waitpid(child, &status, 0), child);
	assert_int_equal(status, 0);
	temp_dir_remove(&folder);
}

static void test_folders_with_long_names_hold_no_watchdogs(void **state)
{
	struct survey_capture capture;
	char path[300] = "";
	const struct survey survey = survey_capture_begin(&capture, path);

	(void)state;
	memset(path, 'p', sizeof(path) - 1);
	path[sizeof(path) - 1] = '\0';
	watchdog_survey(path, &survey);
	assert_int_equal(capture.count, 1);
	assert_int_equal(capture.finding[0].state, SURVEY_MISSING);
	watchdog_survey("/dev/null", &survey);
	assert_int_equal(capture.count, 2);
	assert_int_equal(capture.finding[1].state, SURVEY_MISSING);
}

/* A path has at most 255 characters. */
static void test_a_path_of_255_characters_is_looked_at(void **state)
{
	struct test_path folder = temp_dir_make();
	char pad[256] = "";

	(void)state;
	memset(pad, 'p', 255 - strlen(folder.text) - strlen("//watchdog0"));
	for (int more = 0; more < 2; more++) {
		struct survey_capture capture;
		const struct survey survey =
			survey_capture_begin(&capture, folder.text);
		struct test_path devices = path_join(&folder, pad);

		make_folder(&folder, pad);
		write_text(&devices, "watchdog0", "");
		watchdog_survey(devices.text, &survey);
		assert_int_equal(capture.count, 1);
		assert_int_equal(capture.finding[0].state,
			more ? SURVEY_MISSING : SURVEY_WORKS);
		strcat(pad, "p");
	}
	temp_dir_remove(&folder);
}

static void test_an_old_name_of_255_characters_is_looked_at(void **state)
{
	struct test_path folder = temp_dir_make();
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, folder.text);
	struct test_path devices;
	char pad[256] = "";

	(void)state;
	memset(pad, 'p', 255 - strlen(folder.text) - strlen("//watchdog"));
	devices = path_join(&folder, pad);
	make_folder(&folder, pad);
	write_text(&devices, "watchdog", "");
	watchdog_survey(devices.text, &survey);
	assert_int_equal(capture.count, 1);
	assert_int_equal(capture.finding[0].state, SURVEY_WORKS);
	temp_dir_remove(&folder);
}

/* The state of a watchdog whose attributes have such paths. */
static enum survey_state state_below(
	const struct test_path *folder, const char *pad)
{
	struct test_path system = path_join(folder, pad);
	struct test_path devices = path_join(&system, "dev");
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, system.text);

	make_folder(folder, pad);
	make_watchdogs(&system, "active\n");
	watchdog_survey(devices.text, &survey);
	return capture.finding[0].state;
}

static void test_an_attribute_s_path_may_have_255_characters(void **state)
{
	struct test_path folder = temp_dir_make();
	char pad[256] = "";

	(void)state;
	memset(pad, 'p',
		255 - strlen(folder.text) -
			strlen("//class/watchdog/watchdog0/state"));
	assert_int_equal(state_below(&folder, pad), SURVEY_TAKEN);
	strcat(pad, "p");
	assert_int_equal(state_below(&folder, pad), SURVEY_WORKS);
	temp_dir_remove(&folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_watchdogs_are_reported_without_starting_them),
		cmocka_unit_test(test_an_active_watchdog_is_taken),
		cmocka_unit_test(test_no_watchdog_is_one_finding),
		cmocka_unit_test(test_a_watchdog_that_says_little_is_reported),
		cmocka_unit_test(
			test_the_name_of_old_kernels_is_that_of_the_first),
		cmocka_unit_test(test_eight_watchdogs_are_looked_for),
		cmocka_unit_test(test_a_watchdog_of_root_is_denied_to_others),
		cmocka_unit_test(test_folders_with_long_names_hold_no_watchdogs),
		cmocka_unit_test(test_a_path_of_255_characters_is_looked_at),
		cmocka_unit_test(test_an_old_name_of_255_characters_is_looked_at),
		cmocka_unit_test(
			test_an_attribute_s_path_may_have_255_characters),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
