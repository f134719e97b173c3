/* What limber doctor says of clips that play once. */
#include "app/cmd/doctor/doctor_clips.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

struct heard {
	int count;
	char finding[512];
};

static void hear(void *context, const char *finding)
{
	struct heard *heard = context;

	heard->count++;
	snprintf(heard->finding, sizeof(heard->finding), "%s", finding);
}

static struct heard check(const char *path, int wanted)
{
	struct heard heard = {0};
	const struct examiner examiner = {hear, &heard};
	struct log log = log_to_nowhere();

	assert_int_equal(doctor_clips_check(path, 0, &examiner, &log), wanted);
	return heard;
}

static void test_clips_that_play_once_are_counted(void **state)
{
	struct heard heard = check("tests/fixtures/gltf/clip/door.gltf", 0);

	(void)state;
	assert_int_equal(heard.count, 1);
	assert_non_null(strstr(heard.finding,
		"clips that end in another shape than they begin with (4), such as open: limber plays them once"));
}

static void test_nothing_is_said_of_clips_that_repeat(void **state)
{
	(void)state;
	assert_int_equal(check("assets/face.glb", 0).count, 0);
	assert_int_equal(check("tests/fixtures/none.glb", -ENOENT).count, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_clips_that_play_once_are_counted),
		cmocka_unit_test(test_nothing_is_said_of_clips_that_repeat),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
