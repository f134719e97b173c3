/* The root that a sketch suggests for clips that carry a model away. */
#include "app/character/sketch/character_sketch.h"
#include "platform/base/compiler.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

/* Fails unless the sketch suggests this root; NULL: none. */
static void expect_root(const struct model *model, const char *root)
{
	char *text = acting_sketch(model, NULL);
	char *line = strstr(text, "\n;root = ");

	if (root) {
		size_t length = strlen(root);

		assert_non_null(line);
		line += strlen("\n;root = ");
		assert_memory_equal(line, root, length);
		assert_int_equal(line[length], '\n');
	} else {
		assert_null(line);
	}
	free(text);
}

/* A box below a node that each clip moves in its way. */
static void begin(struct acting *acting)
{
	acting_begin(acting, "tests/fixtures/gltf/clip/far.gltf");
	acting->model->node[0].name = "crate";
}

static void test_a_node_that_goes_away_becomes_the_root(void **state)
{
	static const struct {
		const char *clip;
		bool goes;
	} clips[] = {{"leave", true}, {"climb", false}, {"circle", false},
		{"sway", false}};
	struct acting acting;
	struct model_clip *all;
	int count;

	(void)state;
	begin(&acting);
	expect_root(acting.model, "crate");
	all = acting.model->clip;
	count = acting.model->clip_count;
	for (size_t i = 0; i < ARRAY_COUNT(clips); i++) {
		acting.model->clip = all;
		acting.model->clip_count = count;
		acting.model->clip =
			&all[model_find_clip(acting.model, clips[i].clip)];
		acting.model->clip_count = 1;
		expect_root(acting.model, clips[i].goes ? "crate" : NULL);
	}
	acting.model->clip = all;
	acting.model->clip_count = count;
	acting_end(&acting);
}

/* Such as a drawer: the rest of the model stays. */
static void test_a_part_that_goes_away_is_no_root(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting);
	acting.model->node[0].mesh = acting.model->node[1].mesh;
	expect_root(acting.model, "crate");
	acting.model->node[1].parent = -1;
	expect_root(acting.model, NULL);
	acting.model->node[0].mesh = -1;
	expect_root(acting.model, NULL);
	acting_end(&acting);
}

static void test_a_node_without_a_name_is_no_root(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting);
	acting.model->node[0].name = "";
	expect_root(acting.model, NULL);
	/* A part of what the node carries does not stand for it. */
	acting.model->node[0].mesh = acting.model->node[1].mesh;
	acting.model->node[1].name = "lid";
	expect_root(acting.model, NULL);
	acting_end(&acting);
}

/* A skin hangs on its joints, wherever its own node is. */
static void test_a_bone_that_carries_the_skin_becomes_the_root(void **state)
{
	struct acting acting;
	const struct model_clip *walk;
	int hips;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	expect_root(acting.model, NULL);
	hips = model_find_node(acting.model, "hips");
	walk = &acting.model->clip[model_find_clip(acting.model, "walk")];
	for (int i = 0; i < walk->channel_count; i++) {
		const struct model_channel *channel = &walk->channel[i];
		float(*at)[3] = (float(*)[3])channel->value;

		for (int k = 0; k < channel->key_count && channel->node == hips &&
			channel->path == MODEL_TRANSLATION;
			k++) {
			at[k][2] += channel->time_s[k];
		}
	}
	expect_root(acting.model, "hips");
	acting_end(&acting);
}

/* Moves the crate as the clip leave does, and the ground below it. */
static void test_the_suggested_root_is_right(void **state)
{
	struct acting acting;
	char *text, *line;

	(void)state;
	begin(&acting);
	text = acting_sketch(acting.model, NULL);
	line = strstr(text, "\n;root = ");
	assert_non_null(line);
	memmove(line + 1, line + 2, strlen(line + 1));
	acting_expect(&acting, text);
	assert_int_equal(acting.character->motion.root, 0);
	assert_true(acting.character->motion.by_clips);
	free(text);
	acting_end(&acting);
}

static void test_a_model_without_clips_has_no_motion(void **state)
{
	struct acting acting;
	char *text;

	(void)state;
	acting_begin(&acting, "assets/arm.glb");
	assert_int_equal(acting.model->clip_count, 0);
	text = acting_sketch(acting.model, NULL);
	assert_null(strstr(text, "[motion]"));
	free(text);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_node_that_goes_away_becomes_the_root),
		cmocka_unit_test(test_a_part_that_goes_away_is_no_root),
		cmocka_unit_test(test_a_node_without_a_name_is_no_root),
		cmocka_unit_test(
			test_a_bone_that_carries_the_skin_becomes_the_root),
		cmocka_unit_test(test_the_suggested_root_is_right),
		cmocka_unit_test(test_a_model_without_clips_has_no_motion),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
