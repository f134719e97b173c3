/* How far a clip carries the root, where each foot is ahead, and [clip]. */
#include "app/character/character_data.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

/* The root and its left foot move, which hang below the first node or are it. */
static const char model[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[%s]}],\"nodes\":["
	"{\"name\":\"Root\",\"children\":[1,2,3]},"
	"{\"name\":\"L\"},{\"name\":\"R\"},"
	"{\"name\":\"Top\",\"translation\":[0,%d,0]},"
	"{\"name\":\"Turned\",%s"
	"\"rotation\":[0,0.70710678,0,0.70710678]}],"
	"\"animations\":[{\"name\":\"go\",\"channels\":["
	"{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"translation\"}},"
	"{\"sampler\":1,\"target\":{\"node\":1,\"path\":\"translation\"}}],"
	"\"samplers\":[{\"input\":0,\"output\":1},{\"input\":2,\"output\":3}]}],"
	"\"accessors\":["
	"{\"bufferView\":0,\"componentType\":5126,\"count\":2,"
	"\"type\":\"SCALAR\",\"min\":[0],\"max\":[2]},"
	"{\"bufferView\":1,\"componentType\":5126,\"count\":2,"
	"\"type\":\"VEC3\"},"
	"{\"bufferView\":2,\"componentType\":5126,\"count\":4,"
	"\"type\":\"SCALAR\",\"min\":[0],\"max\":[2]},"
	"{\"bufferView\":3,\"componentType\":5126,\"count\":4,"
	"\"type\":\"VEC3\"}],"
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":8},"
	"{\"buffer\":0,\"byteOffset\":8,\"byteLength\":24},"
	"{\"buffer\":0,\"byteOffset\":32,\"byteLength\":16},"
	"{\"buffer\":0,\"byteOffset\":48,\"byteLength\":48}],"
	"\"buffers\":[{\"byteLength\":96,\"uri\":\"m.bin\"}]}";

struct keys {
	float root_s[2], root[2][3], foot_s[4], foot[4][3];
};

static void load(struct acting *acting, bool turned, int height_m,
	const struct keys *keys)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "m.bin");
	char text[sizeof(model) + 32];

	file_write(path.text, keys, sizeof(*keys));
	path = path_join(&folder, "m.gltf");
	snprintf(text, sizeof(text), model, turned ? "4" : "0,4", height_m,
		turned ? "\"children\":[0]," : "");
	file_write(path.text, text, strlen(text));
	acting_begin(acting, path.text);
	temp_dir_remove(&folder);
}

#define FEET "[motion]\nroot = Root\nfeet = L R\n[state a]\nclip = go\n"

static void begin(struct acting *acting, bool turned, const struct keys *keys)
{
	load(acting, turned, 1, keys);
	acting_expect(acting, FEET);
}

/* A quarter turn about y takes x to -z, and z to x. */
static void test_a_clip_carries_the_root_over_the_ground(void **state)
{
	static const struct keys keys = {.root_s = {0, 2},
		.root = {{0.1f, 0, 0.1f}, {0.4f, 0.5f, 1.1f}},
		.foot_s = {0, 0.5f, 1, 2}};
	static const float carried[2][2] = {{0.3f, 1}, {1, -0.3f}};

	(void)state;
	for (int turned = 0; turned < 2; turned++) {
		struct acting acting;
		const struct character_clip *clip;

		begin(&acting, turned, &keys);
		clip = &acting.character->clip[0];
		assert_all_near(clip->carried_m, carried[turned], 2, 1e-5);
		assert_all_near(clip->travel, ((float[]){0.3f, 0, 1}), 3, 1e-5);
		for (int axis = 0; axis < 2; axis++) {
			assert_near(clip->ground_m_per_s[axis],
				carried[turned][axis] / 2, 1e-5);
		}
		assert_int_equal(clip->mark_count, 0);
		acting_end(&acting);
	}
}

/* One foot goes along an axis by so much, at first or later. */
static void expect_marks(int axis, float range_m, const float times_s[2],
	bool ahead_first, const double marks[2])
{
	struct keys keys = {
		.root_s = {0, 2}, .foot_s = {0, times_s[0], times_s[1], 2}};
	const struct character_clip *clip;
	struct acting acting;

	keys.foot[1][axis] = (ahead_first ? 0.5f : -0.5f) * range_m;
	keys.foot[2][axis] = -keys.foot[1][axis];
	begin(&acting, false, &keys);
	clip = &acting.character->clip[0];
	assert_int_equal(clip->mark_count, marks ? 2 : 0);
	for (int i = 0; marks && i < 2; i++) {
		assert_near(clip->mark[i], marks[i], 1e-5);
	}
	acting_end(&acting);
}

/* A range below a twentieth of the height, of 1 m, is no step. */
static void test_marks_are_where_a_foot_is_ahead_most(void **state)
{
	static const float middle[2] = {0.5f, 1.5f};
	static const float early[2] = {2.0f / CHARACTER_SAMPLES, 1.5f};
	static const float late[2] = {0.5f, 2 - 2.0f / CHARACTER_SAMPLES};

	(void)state;
	for (int axis = 0; axis < 3; axis += 2) {
		expect_marks(axis, 0.4f, middle, true, (double[]){0.5, 1.5});
		expect_marks(axis, 0.4f, middle, false, (double[]){1.5, 2.5});
		expect_marks(axis, 0.4f, early, true,
			(double[]){(double)early[0], 1.5});
		expect_marks(axis, 0.4f, early, false,
			(double[]){1.5, 2 + (double)early[0]});
		expect_marks(axis, 0.4f, late, false,
			(double[]){(double)late[1], 2.5});
		expect_marks(axis, 0.052f, middle, true, (double[]){0.5, 1.5});
		expect_marks(axis, 0.048f, middle, true, NULL);
	}
}

static void test_a_clip_without_a_duration_carries_nothing(void **state)
{
	static const struct keys keys = {.root_s = {0, 0.5f},
		.root = {{0, 0, 0}, {2, 0, 1}},
		.foot_s = {0, 0.1f, 0.2f, 0.5f}};
	const struct character_clip *clip;
	struct acting acting;

	(void)state;
	load(&acting, false, 1, &keys);
	acting_expect(&acting, FEET);
	clip = acting.character->clip;
	assert_all_near(clip->ground_m_per_s, ((float[]){4, 2}), 2, 1e-5);
	((struct model_clip *)acting.model->clip)->duration_s = 0;
	acting_expect(&acting, FEET);
	clip = acting.character->clip;
	assert_all_near(clip->ground_m_per_s, ((float[]){0, 0}), 2, 0);
	assert_all_near(clip->carried_m, ((float[]){0, 0}), 2, 0);
	acting_end(&acting);
}

/* As long as a foot rests there, the first moment is marked. */
static void test_marks_may_be_at_the_start_and_where_a_foot_rests(void **state)
{
	static const struct {
		float ahead[4]; /* at 0, 0.5, 1.5 and 2 s */
		double marks[2];
	} cases[] = {{{0.2f, -0.2f, 0, 0}, {0, 0.5}},
		{{-0.2f, 0.2f, 0, 0}, {0.5, 2}},
		{{0, 0.25f, 0.25f, -0.25f}, {0.5, 94.0 / 48}},
		{{0, -0.25f, -0.25f, 0.25f}, {94.0 / 48, 2.5}}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct keys keys = {
			.root_s = {0, 2}, .foot_s = {0, 0.5f, 1.5f, 2}};
		const struct character_clip *clip;
		struct acting acting;

		for (int k = 0; k < 4; k++) {
			keys.foot[k][2] = cases[i].ahead[k];
		}
		begin(&acting, false, &keys);
		clip = acting.character->clip;
		assert_int_equal(clip->mark_count, 2);
		assert_near(clip->mark[0], cases[i].marks[0], 1e-5);
		assert_near(clip->mark[1], cases[i].marks[1], 1e-5);
		acting_end(&acting);
	}
}

static const struct keys steps = {.root_s = {0, 2},
	.foot_s = {0, 0.5f, 1.5f, 2},
	.foot = {{0}, {0, 0, 0.2f}, {0, 0, -0.2f}}};

/* Ahead of the first node as a foot, the left one is behind. */
static void test_the_first_node_may_be_a_foot(void **state)
{
	const struct character_clip *clip;
	struct acting acting;

	(void)state;
	load(&acting, false, 1, &steps);
	acting_expect(
		&acting, "[motion]\nfeet = Root L\n[state a]\nclip = go\n");
	clip = acting.character->clip;
	assert_int_equal(clip->mark_count, 2);
	assert_near(clip->mark[0], 1.5, 1e-5);
	assert_near(clip->mark[1], 2.5, 1e-5);
	acting_end(&acting);
}

static void test_marks_of_the_file_are_kept(void **state)
{
	const struct character_clip *clip;
	struct acting acting;

	(void)state;
	load(&acting, false, 1, &steps);
	acting_expect(&acting, FEET "[clip go]\nmarks = 0.25 1 1.75\n");
	clip = acting.character->clip;
	assert_int_equal(clip->mark_count, 3);
	assert_all_near(clip->mark, ((float[]){0.25f, 1, 1.75f}), 3, 0);
	acting_end(&acting);
}

static void test_feet_that_rest_have_no_marks(void **state)
{
	static const struct keys still = {
		.root_s = {0, 2}, .foot_s = {0, 0.5f, 1.5f, 2}};
	struct acting acting;

	(void)state;
	for (int height_m = 0; height_m < 2; height_m++) {
		load(&acting, false, height_m, &still);
		acting_expect(&acting, FEET);
		for (int i = 0; i < acting.character->clip_count; i++) {
			assert_int_equal(
				acting.character->clip[i].mark_count, 0);
		}
		acting_end(&acting);
	}
}

#define FIFTEEN "0 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9 1 1.1 1.2 1.3 1.4"

/* The clip takes 2 s. */
static void test_marks_and_events_lie_within_the_clip(void **state)
{
	static const struct {
		const char *text;
		bool right;
	} cases[] = {{"[clip go]\nmarks = 0.5 1.9", true},
		{"[clip go]\nmarks = 0, 1.99", true},
		{"[clip go]\nmarks = 0.01 2", true},
		{"[clip go]\nmarks = 1", true},
		{"[clip go]\nmarks = " FIFTEEN " 1.5", true},
		{"[clip go]\nmarks = " FIFTEEN " 1.5 1.6", false},
		{"[clip go]\nmarks = 0 2", false},
		{"[clip go]\nmarks = -0.1 1", false},
		{"[clip go]\nmarks = 0.1 2.01", false},
		{"[clip go]\nmarks = 1 1", false},
		{"[clip go]\nmarks = 1 0.5", false},
		{"[clip go]\nmarks = x", false},
		{"[clip go]\nevent = 0 line x", true},
		{"[clip go]\nevent = 2 line x", true},
		{"[clip go]\nevent = 2.01 line x", false},
		{"[clip go]\nevent = -0.1 line x", false},
		{"[clip go]\nevent = line x", false},
		{"[clip rest]\nevent = 0 line x", true},
		{"[clip rest]\nevent = 0.5 line x", false}};
	struct acting acting;

	(void)state;
	load(&acting, false, 1, &steps);
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		acting_read(&acting, cases[i].text);
		if ((acting.error == 0) != cases[i].right) {
			fail_msg("%s: %s", acting.error ? "refused" : "accepted",
				cases[i].text);
		}
	}
	acting_end(&acting);
}

/* In the order of the lines. */
static void test_each_clip_and_the_rest_pose_have_events(void **state)
{
	const struct character *character;
	struct acting acting;

	(void)state;
	load(&acting, false, 1, &steps);
	acting_expect(&acting,
		"[clip rest]\nevent = 0 pause\n"
		"[clip go]\nevent = 1.5 line a, pause\nevent = 0.5 tour\n");
	character = acting.character;
	assert_int_equal(character->clip_count, 2);
	assert_near(character->clip[0].event->time_s, 1.5, 0);
	assert_int_equal(character->clip[0].event->action->verb, CHARACTER_LINE);
	assert_int_equal(
		character->clip[0].event->action->next->verb, CHARACTER_PAUSE);
	assert_near(character->clip[0].event->next->time_s, 0.5, 0);
	assert_null(character->clip[0].event->next->next);
	assert_int_equal(
		character->clip[1].event->action->verb, CHARACTER_PAUSE);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_clip_carries_the_root_over_the_ground),
		cmocka_unit_test(test_a_clip_without_a_duration_carries_nothing),
		cmocka_unit_test(test_marks_are_where_a_foot_is_ahead_most),
		cmocka_unit_test(
			test_marks_may_be_at_the_start_and_where_a_foot_rests),
		cmocka_unit_test(test_the_first_node_may_be_a_foot),
		cmocka_unit_test(test_marks_of_the_file_are_kept),
		cmocka_unit_test(test_feet_that_rest_have_no_marks),
		cmocka_unit_test(test_marks_and_events_lie_within_the_clip),
		cmocka_unit_test(test_each_clip_and_the_rest_pose_have_events),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
