/* What limber doctor prints of findings, in words and as JSON. */
#include "app/cmd/doctor/doctor_report.h"
#include "app/cmd/version.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

struct printed {
	char *text;
	size_t size;
	struct doctor_report report;
};

static const struct log *nowhere(void)
{
	static struct log log;

	log = log_to_nowhere();
	return &log;
}

/* Reports findings of two sections, one driver of which has two devices. */
static void begin(struct printed *printed, bool json)
{
	struct doctor_report *report = &printed->report;
	FILE *out = open_memstream(&printed->text, &printed->size);
	struct survey survey;

	assert_non_null(out);
	assert_int_equal(doctor_report_begin(report, out, json, nowhere()), 0);
	survey = doctor_report_survey(report);
	assert_string_equal(survey.system, "/sys");
	doctor_report_section(report, "Displays", "displays");
	report->driver = "fbdev";
	survey_report(&survey, SURVEY_WORKS, "/dev/fb0", NULL, "%d pages", 2);
	survey_report(&survey, SURVEY_BROKEN, "fbdev", "chmod it", "is closed");
	doctor_report_section(report, "The files", "files");
	survey_report(&survey, SURVEY_WORKS, "a.glb", NULL, "it is there");
	assert_int_equal(report->works, 2);
}

static void end(struct printed *printed, bool plays, const char *display,
	bool automatic)
{
	assert_int_equal(doctor_report_end(&printed->report, plays, display,
				 automatic, nowhere()),
		0);
	fclose(printed->report.out);
}

static void test_words_name_the_driver_unless_it_is_the_subject(void **state)
{
	static const char wanted[] = "\n\nDisplays\n"
				     "  works    fbdev /dev/fb0: 2 pages\n"
				     "  broken   fbdev: is closed\n"
				     "           -> chmod it\n"
				     "\nThe files\n"
				     "  works    a.glb: it is there\n"
				     "\nlimber plays here, on fbdev\n";
	size_t version = strlen(version_text());
	struct printed printed;

	(void)state;
	begin(&printed, false);
	end(&printed, true, "fbdev", true);
	assert_memory_equal(printed.text, version_text(), version);
	assert_string_equal(printed.text + version, wanted);
	free(printed.text);
}

static void test_the_verdict_names_the_cause(void **state)
{
	static const struct {
		bool plays;
		const char *display;
		bool automatic;
		const char *verdict;
	} cases[] = {
		{true, "kms", true, "\nlimber plays here, on kms\n"},
		{true, "null", false,
			"\nlimber plays here with --display null\n"},
		{false, "kms", true,
			"\nlimber cannot play here: no GL driver works\n"},
		{false, NULL, false,
			"\nlimber cannot play here: no display works: "
			"limber render can write pictures to files\n"},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		size_t length = strlen(cases[i].verdict);
		struct printed printed;

		begin(&printed, false);
		end(&printed, cases[i].plays, cases[i].display,
			cases[i].automatic);
		assert_true(printed.size > length);
		assert_string_equal(
			printed.text + printed.size - length, cases[i].verdict);
		free(printed.text);
	}
}

static void test_json_has_what_is_known(void **state)
{
	json_t *wanted = json_pack("{s:s, s:b, s:s, s:["
				   "{s:s, s:s, s:s, s:s, s:s},"
				   "{s:s, s:s, s:s, s:s, s:s, s:s},"
				   "{s:s, s:s, s:s, s:s}]}",
		"version", version_text(), "plays", 1, "display", "fbdev",
		"findings", "section", "displays", "driver", "fbdev", "state",
		"works", "subject", "/dev/fb0", "text", "2 pages", "section",
		"displays", "driver", "fbdev", "state", "broken", "subject",
		"fbdev", "text", "is closed", "remedy", "chmod it", "section",
		"files", "state", "works", "subject", "a.glb", "text",
		"it is there");
	struct printed printed;
	json_t *found;

	(void)state;
	assert_non_null(wanted);
	begin(&printed, true);
	end(&printed, true, "fbdev", true);
	assert_int_equal(printed.text[printed.size - 1], '\n');
	found = json_loads(printed.text, 0, NULL);
	assert_true(json_equal(found, wanted));
	json_decref(found);
	json_decref(wanted);
	free(printed.text);
}

static void test_json_without_a_display_has_null(void **state)
{
	struct printed printed;
	json_t *found;

	(void)state;
	begin(&printed, true);
	end(&printed, false, NULL, false);
	found = json_loads(printed.text, 0, NULL);
	assert_true(json_is_null(json_object_get(found, "display")));
	assert_true(json_is_false(json_object_get(found, "plays")));
	json_decref(found);
	free(printed.text);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_words_name_the_driver_unless_it_is_the_subject),
		cmocka_unit_test(test_the_verdict_names_the_cause),
		cmocka_unit_test(test_json_has_what_is_known),
		cmocka_unit_test(test_json_without_a_display_has_null),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
