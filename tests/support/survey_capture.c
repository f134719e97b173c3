#include "tests/support/survey_capture.h"

#include <stdio.h>

#include "tests/support/test.h"

static void take(void *user, const struct survey_finding *finding)
{
	struct survey_capture *capture = user;
	struct survey_captured *kept;

	assert_true(capture->count < SURVEY_CAPTURE_CAPACITY);
	kept = &capture->finding[capture->count++];
	kept->state = finding->state;
	snprintf(kept->subject, sizeof(kept->subject), "%s", finding->subject);
	snprintf(kept->text, sizeof(kept->text), "%s", finding->text);
	snprintf(kept->remedy, sizeof(kept->remedy), "%s",
		finding->remedy ? finding->remedy : "");
}

struct survey survey_capture_begin(
	struct survey_capture *capture, const char *system)
{
	*capture = (struct survey_capture){0};
	return (struct survey){take, capture, system ? system : "/nonexistent"};
}

void survey_capture_expect(const struct survey_capture *capture, int number,
	enum survey_state state, const char *subject, const char *text,
	const char *remedy)
{
	const struct survey_captured *found = &capture->finding[number];

	assert_true(number < capture->count);
	assert_string_equal(
		survey_state_name(found->state), survey_state_name(state));
	assert_contains(found->subject, subject);
	assert_contains(found->text, text);
	if (remedy) {
		assert_contains(found->remedy, remedy);
	} else {
		assert_string_equal(found->remedy, "");
	}
}
