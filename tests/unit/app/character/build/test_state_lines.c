/* What the lines of states and transitions make. */
#include "app/character/character_data.h"
#include "platform/base/compiler.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static void expect_clip(const struct acting *acting,
	const struct character_entry *entry, const char *name)
{
	if (!name) {
		assert_null(entry->of->clip);
		return;
	}
	assert_ptr_equal(entry->of->clip,
		&acting->model->clip[model_find_clip(acting->model, name)]);
}

static void test_what_a_state_leaves_out_has_its_usual_value(void **state)
{
	const struct character_machine *machine;
	const struct character_state *one;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(
		&acting, "[state a]\nclip = walk\n[state b]\nclip = rest\n");
	machine = &acting.character->machine;
	assert_int_equal(machine->state_count, 2);
	assert_int_equal(machine->transition_count, 0);
	assert_int_equal(machine->current, 0);
	assert_int_equal(machine->wanted, -1);
	assert_int_equal(machine->running, -1);
	assert_true(machine->fresh);
	for (int i = 0; i < 2; i++) {
		one = &machine->state[i];
		assert_string_equal(one->name, i ? "b" : "a");
		assert_int_equal(one->entry_count, 1);
		expect_clip(&acting, one->entry, i ? NULL : "walk");
		assert_near(one->entry[0].shown_s, -1, 0);
		assert_ptr_equal(one->entry[0].cursor, machine->cursor);
		assert_near(*one->position, 0, 0);
		assert_near(*one->rate, 1, 0);
		assert_int_equal(one->repeat, CLIP_LOOP);
		assert_int_equal(one->next, -1);
		assert_near(one->pause_s, 0, 0);
		assert_near(one->fade.duration_s, 0.3, 1e-7);
		assert_int_equal(one->fade.curve, INERTIA_SMOOTH);
		assert_null(one->enter);
		assert_null(one->leave);
	}
	acting_end(&acting);
}

/* The first clip plays, or the model is at rest. */
static void test_a_file_without_states_has_one(void **state)
{
	static const struct {
		const char *model, *name, *clip;
	} rows[] = {{"assets/walker.glb", "idle", "idle"},
		{"tests/fixtures/gltf/scene/ground.gltf", "rise", "rise"},
		{"tests/fixtures/gltf/mesh/weights.gltf", "rest", NULL}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		const struct character_machine *machine;
		struct acting acting;

		acting_begin(&acting, rows[i].model);
		acting_expect(&acting, "[parameter p]\n");
		machine = &acting.character->machine;
		assert_int_equal(machine->state_count, 1);
		assert_string_equal(machine->state[0].name, rows[i].name);
		assert_int_equal(machine->state[0].entry_count, 1);
		expect_clip(&acting, machine->state[0].entry, rows[i].clip);
		acting_end(&acting);
	}
}

static void test_a_state_is_as_its_lines_say(void **state)
{
	const struct character_state *one;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter p]\n[parameter q]\n[state a]\n"
		"blend = q, run 3, idle -1, rest 0.5\nrate = p\nrepeat = once\n"
		"next = c\npause = 2.5\nfade = 3 frames cubic\n"
		"enter = next, pause\nleave = previous\n"
		"[state b]\nclip = walk\nrepeat = ping-pong\nnext = a\n"
		"[state c]\nclip = run\nrepeat = loop\n");
	one = acting.character->machine.state;
	assert_int_equal(one->entry_count, 3);
	for (int i = 0; i < 3; i++) {
		assert_near(one->entry[i].at, ((double[]){-1, 0.5, 3})[i], 0);
		expect_clip(&acting, &one->entry[i],
			((const char *[]){"idle", NULL, "run"})[i]);
		assert_ptr_equal(one->entry[i].cursor,
			&acting.character->machine.cursor[i]);
	}
	assert_ptr_equal(one->position, &acting.character->parameter[1].value);
	assert_ptr_equal(one->rate, &acting.character->parameter[0].value);
	assert_int_equal(one->repeat, CLIP_ONCE);
	assert_int_equal(one->next, 2);
	assert_near(one->pause_s, 2.5, 0);
	assert_int_equal(one->fade.frames, 3);
	assert_int_equal(one->fade.curve, INERTIA_CUBIC);
	assert_int_equal(one->enter->verb, CHARACTER_NEXT);
	assert_int_equal(one->enter->next->verb, CHARACTER_PAUSE);
	assert_int_equal(one->leave->verb, CHARACTER_NEXT);
	assert_int_equal(one[1].repeat, CLIP_PING_PONG);
	assert_int_equal(one[1].next, 0);
	assert_int_equal(one[2].repeat, CLIP_LOOP);
	acting_end(&acting);
}

/* A state changes what any of its clips changes. */
static void test_a_state_knows_what_its_clips_change(void **state)
{
	const struct character_state *one;
	struct acting acting;
	uint8_t *paths[3];

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter q]\n[state both]\nblend = q, wave 0, walk 1\n"
		"[state wave]\nclip = wave\n[state walk]\nclip = walk\n"
		"[state rest]\nclip = rest\n");
	one = acting.character->machine.state;
	for (int i = 0; i < 3; i++) {
		paths[i] = one[i].paths;
	}
	for (int n = 0; n < acting.model->node_count; n++) {
		assert_int_equal(paths[0][n], paths[1][n] | paths[2][n]);
		assert_int_equal(one[3].paths[n], 0);
	}
	assert_int_not_equal(
		memcmp(paths[0], one[3].paths, (size_t)acting.model->node_count),
		0);
	acting_end(&acting);
}

static void test_a_blend_has_two_to_sixteen_clips(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (int count = 0; count <= 17; count++) {
		char text[512] = "[parameter v]\n[state a]\nblend = v";

		for (int i = 0; i < count; i++) {
			size_t length = strlen(text);

			snprintf(text + length, sizeof(text) - length,
				", walk %d", (7 * i) % 17);
		}
		strcat(text, "\n");
		acting_read(&acting, text);
		if (count >= 2 && count <= 16) {
			assert_int_equal(acting.error, 0);
			assert_int_equal(
				acting.character->machine.state[0].entry_count,
				count);
			continue;
		}
		assert_int_equal(acting.error, -EINVAL);
		assert_contains(acting.logged.sentence[0],
			count < 2 ? "a blend has at least two clips"
				  : "a blend has at most 16 clips");
	}
	acting_end(&acting);
}

static void test_mistakes_in_a_blend_are_named(void **state)
{
	static const char *const rows[][2] = {
		{"v, walk 1, hop 2", "no clip named hop"},
		{"v, walk 1, run", "each clip has the value at which it plays"},
		{"v, walk 1, run 0, idle 1", "two clips are at 1"},
		{"v, walk 1, run 0, idle 0", "two clips are at 0"},
		{"w, walk 1, run 0", "no parameter named w"},
	};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		char text[128];

		snprintf(text, sizeof(text),
			"[parameter v]\n[state a]\nblend = %s\n", rows[i][0]);
		acting_read(&acting, text);
		assert_int_equal(acting.error, -EINVAL);
		assert_contains(acting.logged.sentence[0], rows[i][1]);
	}
	acting_end(&acting);
}

/* What stands last says what a state plays. */
static void test_a_blend_replaces_a_clip(void **state)
{
	const struct character_state *one;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter v]\n[state a]\nclip = jump\n"
		"blend = v, run 1, walk 0\n"
		"[state b]\nblend = v, run 1, walk 0\nclip = jump\n");
	one = acting.character->machine.state;
	assert_int_equal(one->entry_count, 2);
	expect_clip(&acting, &one->entry[0], "walk");
	expect_clip(&acting, &one->entry[1], "run");
	assert_int_equal(one[1].entry_count, 1);
	expect_clip(&acting, &one[1].entry[0], "jump");
	acting_end(&acting);
}

/* The larger priority is first; of equal ones, the earlier in the file. */
static void test_transitions_have_the_order_of_their_priority(void **state)
{
	static const struct {
		int from, to;
		double priority, exit, duration_s;
		enum character_interrupt interrupt;
	} wanted[] = {
		{1, 0, 3, 0, 0.5, CHARACTER_INTERRUPT_NEVER},
		{0, 1, 1, 0.75, 2, CHARACTER_INTERRUPT_ALWAYS},
		{-1, 0, 1, 0, 0.5, CHARACTER_INTERRUPT_ALWAYS},
		{1, 1, 0, 0, 0.25, CHARACTER_INTERRUPT_HIGHER},
		{0, 0, 0, 0, 0.5, CHARACTER_INTERRUPT_ALWAYS},
		{-1, 1, -2, 1, 0.25, CHARACTER_INTERRUPT_ALWAYS},
	};
	const struct character_machine *machine;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[transition * b]\npriority = -2\nexit = 1\n"
		"[transition b b]\ninterrupt = higher\n"
		"[transition a b]\npriority = 1\nexit = 0.75\nfade = 2\n"
		"interrupt = always\n"
		"[transition * a]\npriority = 1\n"
		"[transition b a]\npriority = 3\ninterrupt = never\n"
		"[transition a a]\n"
		"[state a]\nclip = walk\nfade = 0.5\n"
		"[state b]\nclip = run\nfade = 0.25\n");
	machine = &acting.character->machine;
	assert_int_equal(machine->transition_count, ARRAY_COUNT(wanted));
	for (size_t i = 0; i < ARRAY_COUNT(wanted); i++) {
		const struct character_transition *one = &machine->transition[i];

		assert_int_equal(one->from, wanted[i].from);
		assert_int_equal(one->to, wanted[i].to);
		assert_near(one->priority, wanted[i].priority, 0);
		assert_near(one->exit, wanted[i].exit, 0);
		assert_near(one->fade.duration_s, wanted[i].duration_s, 0);
		assert_int_equal(one->interrupt, wanted[i].interrupt);
		assert_null(one->when);
	}
	acting_end(&acting);
}

/* The last comparison is the first of the list. */
static void test_comparisons_are_between_parameters_and_numbers(void **state)
{
	const struct character_condition *one;
	const struct character_parameter *parameter;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter p]\n[parameter q]\n[parameter c]\n"
		"choices = x y z\n[state a]\nclip = walk\n[transition * a]\n"
		"when = p > 0.5\nwhen = 0.25 < q\nwhen = q is p\n"
		"when = c is y\nwhen = c is \"z\"\n");
	one = acting.character->machine.transition[0].when;
	parameter = acting.character->parameter;
	for (int i = 2; i > 0; i--, one = one->next) {
		assert_int_equal(one->is, CHARACTER_EQUAL);
		assert_ptr_equal(one->left, &parameter[2].value);
		assert_near(*one->right, i, 0);
	}
	assert_int_equal(one->is, CHARACTER_EQUAL);
	assert_ptr_equal(one->left, &parameter[1].value);
	assert_ptr_equal(one->right, &parameter[0].value);
	one = one->next;
	assert_int_equal(one->is, CHARACTER_BELOW);
	assert_near(*one->left, 0.25, 0);
	assert_ptr_equal(one->right, &parameter[1].value);
	one = one->next;
	assert_int_equal(one->is, CHARACTER_ABOVE);
	assert_ptr_equal(one->left, &parameter[0].value);
	assert_near(*one->right, 0.5, 0);
	assert_null(one->next);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_what_a_state_leaves_out_has_its_usual_value),
		cmocka_unit_test(test_a_file_without_states_has_one),
		cmocka_unit_test(test_a_state_is_as_its_lines_say),
		cmocka_unit_test(test_a_state_knows_what_its_clips_change),
		cmocka_unit_test(test_a_blend_has_two_to_sixteen_clips),
		cmocka_unit_test(test_a_blend_replaces_a_clip),
		cmocka_unit_test(test_mistakes_in_a_blend_are_named),
		cmocka_unit_test(
			test_transitions_have_the_order_of_their_priority),
		cmocka_unit_test(
			test_comparisons_are_between_parameters_and_numbers),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
