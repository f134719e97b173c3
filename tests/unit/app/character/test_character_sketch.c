/* Character files that limber sketches for a model. */
#include "app/character/sketch/character_sketch.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>

static void expect_sketch(
	struct acting *acting, const struct character_sketch_play *play)
{
	char *text = NULL;
	size_t size;
	FILE *file = open_memstream(&text, &size);

	assert_non_null(file);
	character_sketch(acting->model, play, file);
	fclose(file);
	acting_expect(acting, text);
	free(text);
}

static void test_a_sketch_of_each_model_is_right(void **state)
{
	static const char *const models[] = {"assets/walker.glb",
		"assets/face.glb", "assets/arm.glb",
		"tests/fixtures/gltf/mesh/weights.gltf"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(models); i++) {
		struct acting acting;

		acting_begin(&acting, models[i]);
		expect_sketch(&acting, NULL);
		acting_run_to(&acting, 1.0, 20.0);
		acting_end(&acting);
	}
}

/* Clips in which a sketch has to write numbers in place of names. */
static void test_a_sketch_holds_any_names(void **state)
{
	static const char *const names[] = {"", "rest", "a ;b] \"c\"", "rest",
		"Armature|walk, \xc3\xa9 # = [1] and a name that is longer than a line"};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (int i = 0; i < 5; i++) {
		acting.model->clip[i].name = names[i];
	}
	expect_sketch(&acting, NULL);
	assert_int_equal(acting.character->machine.state_count, 5);
	for (int i = 0; i < 5; i++) {
		const struct character_state *one =
			&acting.character->machine.state[i];

		assert_ptr_equal(one->entry[0].of->clip, &acting.model->clip[i]);
	}
	acting_end(&acting);
}

static bool has_morph_button(const struct acting *acting)
{
	const struct character_binding *one = acting->character->binding;

	while (one && one->action->verb != CHARACTER_MORPH) {
		one = one->next;
	}
	return one;
}

/* Shapes that a clip moves are left to the clip. */
static void test_a_sketch_leaves_animated_shapes_alone(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "tests/fixtures/gltf/clip/cubic.gltf");
	expect_sketch(&acting, NULL);
	assert_false(has_morph_button(&acting));
	acting_end(&acting);
	acting_begin(&acting, "tests/fixtures/gltf/mesh/weights.gltf");
	expect_sketch(&acting, NULL);
	assert_true(has_morph_button(&acting));
	acting_end(&acting);
}

static void test_a_sketch_begins_as_it_is_told(void **state)
{
	const struct character_sketch_play play = {
		.clip = 3, .rate = -2, .repeat = CLIP_PING_PONG};
	const struct character_state *first;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	expect_sketch(&acting, &play);
	first = &acting.character->machine.state[0];
	assert_string_equal(first->name, acting.model->clip[3].name);
	assert_near(*first->rate, -2, 0);
	assert_int_equal(first->repeat, CLIP_PING_PONG);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_sketch_of_each_model_is_right),
		cmocka_unit_test(test_a_sketch_holds_any_names),
		cmocka_unit_test(test_a_sketch_leaves_animated_shapes_alone),
		cmocka_unit_test(test_a_sketch_begins_as_it_is_told),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
