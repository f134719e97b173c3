#include "platform/base/survey.h"
#include "tests/support/files.h"
#include "tests/support/survey_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <grp.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
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

static void test_control_characters_of_devices_are_replaced(void **state)
{
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);

	(void)state;
	survey_report(&survey, SURVEY_WORKS, "a\033b", "do", "x\x7fy\n%s",
		"\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
	assert_string_equal(capture.finding[0].subject, "a?b");
	assert_string_equal(capture.finding[0].text,
		"x?y?\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
	assert_string_equal(capture.finding[0].remedy, "do");
	survey_report(&survey, SURVEY_WORKS, "", NULL, "%s",
		"\xC3|\x80|\xC2\x9B|\xC0\xAF|\xED\xA0\x80|\xF5|\xE2\x82");
	assert_string_equal(capture.finding[1].text, "?|?|??|??|???|?|??");
}

static void test_long_names_and_texts_are_cut(void **state)
{
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);
	char name[129], text[513];

	(void)state;
	memset(name, 'n', sizeof(name));
	memset(text, 't', sizeof(text));
	/* As long as there is room for, then one more. */
	for (int more = 0; more < 2; more++) {
		name[127 + more] = text[511 + more] = '\0';
		survey_report(&survey, SURVEY_WORKS, name, NULL, "%s", text);
		name[127] = 'n';
		text[511] = 't';
		assert_int_equal(strlen(capture.finding[more].subject), 127);
		assert_int_equal(strlen(capture.finding[more].text), 511);
	}
}

static void test_the_end_of_a_message_is_its_remedy(void **state)
{
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);
	struct survey_message sentence;
	const struct log log = survey_log(&sentence);

	(void)state;
	log_note(&log, "a note");
	log_error(&log, "x.conf:2: dmeo: no such key: did you mean demo?");
	log_error(&log, "a second one");
	survey_report_message(&survey, SURVEY_BROKEN, "x", &sentence, NULL);
	survey_capture_expect(&capture, 0, SURVEY_BROKEN, "x",
		"x.conf:2: dmeo: no such key", "did you mean demo?");
	survey_report_message(&survey, SURVEY_MISSING, "x", &sentence, "else");
	survey_capture_expect(&capture, 1, SURVEY_MISSING, "x",
		"x.conf:2: dmeo: no such key", "else");
	strcpy(sentence.text, "alone");
	survey_report_message(&survey, SURVEY_BROKEN, "x", &sentence, NULL);
	survey_capture_expect(&capture, 2, SURVEY_BROKEN, "x", "alone", NULL);
}

static void test_a_denied_user_is_told_the_group(void **state)
{
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "device");
	const struct group *group = getgrnam("video");
	bool given;

	(void)state;
	file_write(path.text, "", 0);
	assert_int_equal(chmod(path.text, 0600), 0);
	survey_report_denied(&survey, path.text);
	survey_capture_expect(&capture, 0, SURVEY_BROKEN, path.text,
		"no permission", "run limber as root");
	assert_int_equal(chmod(path.text, 0660), 0);
	given = group && chown(path.text, (uid_t)-1, group->gr_gid) == 0;
	survey_report_denied(&survey, path.text);
	temp_dir_remove(&folder);
	if (!given) {
		skip_because("only root gives files to the group video");
	}
	survey_capture_expect(&capture, 1, SURVEY_BROKEN, path.text,
		"no permission", "sudo usermod -aG video $USER");
}

static void test_a_device_without_a_node_gets_its_mknod(void **state)
{
	struct test_path folder = temp_dir_make();
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, folder.text);

	(void)state;
	make_folder(&folder, "class");
	make_folder(&folder, "class/graphics");
	make_folder(&folder, "class/graphics/fb0");
	make_folder(&folder, "class/graphics/fb1");
	write_text(&folder, "class/graphics/fb0/dev", "29:0\n");
	write_text(&folder, "class/graphics/fb1/dev", "rubbish\n");
	assert_true(survey_report_no_node(
		&survey, "/dev/fb0", "class/graphics/fb0", -ENOENT));
	survey_capture_expect(&capture, 0, SURVEY_MISSING, "/dev/fb0",
		"its device node does not exist",
		"sudo mknod -m 660 /dev/fb0 c 29 0");
	assert_false(survey_report_no_node(
		&survey, "/dev/fb0", "class/graphics/fb0", -EIO));
	assert_false(survey_report_no_node(
		&survey, "/dev/fb1", "class/graphics/fb1", -ENOENT));
	assert_false(survey_report_no_node(
		&survey, "/dev/fb2", "class/graphics/fb2", -ENOENT));
	assert_int_equal(capture.count, 1);
	temp_dir_remove(&folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_control_characters_of_devices_are_replaced),
		cmocka_unit_test(test_long_names_and_texts_are_cut),
		cmocka_unit_test(test_the_end_of_a_message_is_its_remedy),
		cmocka_unit_test(test_a_denied_user_is_told_the_group),
		cmocka_unit_test(test_a_device_without_a_node_gets_its_mknod),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
