/* How sequences move parts from frame to frame, and how buttons do. */
#include "app/character/character_data.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <string.h>

/* Frames and degrees that floats hold exactly. */
static const double rate_hz = 64.0;

static const char arm[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0]}],\"nodes\":["
	"{\"name\":\"Base\",\"children\":[1],\"scale\":[0.5,0.25,2]},"
	"{\"name\":\"Arm\",\"translation\":[0.5,1,2]}]}";

static const char text[] =
	"[parameter ends]\nrange = 0 1000\n"
	"[part Arm]\nheading = 0 -90 90 64\nx = 1000.1 -9000 9000 1\n"
	"[sequence s]\nstep = one 0.5, Arm heading 16, Arm x 0.3\n"
	"then = add ends 1\nstep = two 0.5, Arm heading 8\n"
	"[buttons]\nUP = run s\nLEFT hold = move Arm heading 1\n";

struct bench {
	struct test_path folder;
	struct acting acting;
};

static void begin(struct bench *bench, const char *character)
{
	struct test_path path;

	bench->folder = temp_dir_make();
	path = path_join(&bench->folder, "arm.gltf");
	file_write(path.text, arm, strlen(arm));
	acting_begin(&bench->acting, path.text);
	acting_expect(&bench->acting, character);
}

static void end(struct bench *bench)
{
	acting_end(&bench->acting);
	temp_dir_remove(&bench->folder);
}

static void run(struct bench *bench, int frames)
{
	struct acting *acting = &bench->acting;

	acting_run_to(acting, acting->now_s + ((double)frames - 0.5) / rate_hz,
		rate_hz);
}

static float value(const struct bench *bench, int freedom)
{
	return bench->acting.character->part[0].freedom[freedom].value;
}

static void test_a_sequence_goes_from_step_to_step(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench, text);
	run(&bench, 4);
	acting_press(&bench.acting, BUTTON_UP);
	acting_release(&bench.acting, BUTTON_UP);
	run(&bench, 16);
	assert_near(value(&bench, CHARACTER_HEADING), 8, 0);
	run(&bench, 15);
	assert_true(value(&bench, CHARACTER_HEADING) < 16);
	assert_true(value(&bench, CHARACTER_X) > 0.3f);
	run(&bench, 1);
	assert_near(value(&bench, CHARACTER_HEADING), 16, 0);
	assert_near(value(&bench, CHARACTER_X), 0.3f, 0);
	/* What then happens, happens in the next frame. */
	assert_near(acting_value(&bench.acting, "ends"), 0, 0);
	run(&bench, 1);
	assert_near(acting_value(&bench.acting, "ends"), 1, 0);
	run(&bench, 15);
	assert_near(value(&bench, CHARACTER_HEADING), 12, 0);
	run(&bench, 16);
	assert_near(value(&bench, CHARACTER_HEADING), 8, 0);
	run(&bench, 64);
	assert_near(value(&bench, CHARACTER_HEADING), 8, 0);
	assert_near(acting_value(&bench.acting, "ends"), 1, 0);
	end(&bench);
}

/* From where the parts are. */
static void test_a_sequence_begins_again_when_it_runs(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench, text);
	run(&bench, 4);
	for (int i = 0; i < 3; i++) {
		acting_press(&bench.acting, BUTTON_UP);
		acting_release(&bench.acting, BUTTON_UP);
		run(&bench, 16);
		assert_near(value(&bench, CHARACTER_HEADING),
			16 - 16.0 / (2 << i), 0);
	}
	end(&bench);
}

/* A slow frame ends 64 steps at most; the next one goes on with the others. */
static void test_a_frame_ends_at_most_64_steps(void **state)
{
	static const char quick[] =
		"[part Arm]\nheading = 0 -90 90\n[sequence s]\nrepeat = yes\n"
		"step = one 0.015625, Arm heading 16\n"
		"step = two 0.015625, Arm heading 8\n"
		"[buttons]\nUP = run s\n";
	const struct character_sequence *sequence;
	struct bench bench;

	(void)state;
	begin(&bench, quick);
	run(&bench, 4);
	acting_press(&bench.acting, BUTTON_UP);
	acting_release(&bench.acting, BUTTON_UP);
	run(&bench, 1);
	sequence = &bench.acting.character->sequence[0];
	assert_near(sequence->elapsed_s, 0, 0);
	acting_run_to(&bench.acting, bench.acting.now_s + 2, 0.5);
	assert_near(sequence->elapsed_s, 1, 0);
	end(&bench);
}

static void test_a_button_turns_a_part_by_its_speed(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench, text);
	run(&bench, 4);
	acting_press(&bench.acting, BUTTON_LEFT);
	for (int i = 1; i < 4; i++) {
		run(&bench, 1);
		assert_near(value(&bench, CHARACTER_HEADING), i, 0);
	}
	end(&bench);
}

/* Of the world, whatever the scale above the part is. */
static void test_a_freedom_moves_a_part_by_metres(void **state)
{
	struct bench bench;
	float at[3];

	(void)state;
	begin(&bench, "[part Arm]\nx = 1\ny = 2\nz = -3\n");
	run(&bench, 1);
	acting_place(&bench.acting, "Arm", at);
	assert_all_near(at, ((float[]){1.25f, 2.25f, 1}), 3, 1e-5);
	end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_sequence_goes_from_step_to_step),
		cmocka_unit_test(test_a_sequence_begins_again_when_it_runs),
		cmocka_unit_test(test_a_frame_ends_at_most_64_steps),
		cmocka_unit_test(test_a_button_turns_a_part_by_its_speed),
		cmocka_unit_test(test_a_freedom_moves_a_part_by_metres),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
