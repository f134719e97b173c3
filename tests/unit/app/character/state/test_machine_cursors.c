/* States share what a clip needs while it plays, as one state plays at a time. */
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double rate_hz = 50.0;

/* The memory of a character with so many states of one clip, in bytes. */
static size_t bytes_of(struct acting *acting, int states)
{
	char text[8192] = "";
	size_t length = 0;

	for (int i = 0; i < states; i++) {
		length += (size_t)snprintf(text + length, sizeof(text) - length,
			"[state s%d]\nclip = %s\n", i, i % 2 ? "walk" : "run");
	}
	acting_expect(acting, text);
	return acting->character->arena.used_bytes;
}

static void test_a_state_takes_little_memory(void **state)
{
	struct acting acting;
	size_t few, many, pose;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	few = bytes_of(&acting, 4);
	many = bytes_of(&acting, 104);
	/* Less than a pose, of which a clip's cursor has one. */
	pose = (size_t)acting.model->node_count * sizeof(struct transform);
	assert_true(many > few);
	assert_in_range((many - few) / 100, 1, pose - 1);
	acting_end(&acting);
}

/* The pose half a second after UP is pressed; the caller frees it. */
static struct transform *pose_after_up(const char *text)
{
	struct acting acting;
	size_t bytes;
	struct transform *kept;

	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, text);
	acting_run_to(&acting, 1.0, rate_hz);
	acting_tap(&acting, BUTTON_UP, 0.04, rate_hz);
	acting_run_to(&acting, 1.5, rate_hz);
	bytes = (size_t)acting.model->node_count * sizeof(*kept);
	kept = malloc(bytes);
	assert_non_null(kept);
	memcpy(kept, acting.instance->pose.local, bytes);
	acting_end(&acting);
	return kept;
}

/* The clips of a blend mix only what its own clips move. */
static void test_a_state_after_another_plays_as_it_does_alone(void **state)
{
	static const char first[] =
		"[parameter p]\nstart = 0.5\n"
		"[state a]\nclip = walk\nfade = 0\n"
		"[state b]\nblend = p, wave 0, idle 1\nfade = 0\n"
		"[buttons]\nUP = go b\n";
	static const char alone[] =
		"[parameter p]\nstart = 0.5\n"
		"[state c]\nclip = idle\nfade = 0\n"
		"[state b]\nblend = p, wave 0, idle 1\nfade = 0\n"
		"[buttons]\nUP = go b\n";
	struct transform *after = pose_after_up(first);
	struct transform *wanted = pose_after_up(alone);
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	assert_memory_equal(after, wanted,
		(size_t)acting.model->node_count * sizeof(*after));
	acting_end(&acting);
	free(after);
	free(wanted);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_state_takes_little_memory),
		cmocka_unit_test(
			test_a_state_after_another_plays_as_it_does_alone),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
