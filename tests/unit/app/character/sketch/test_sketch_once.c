/* Which clips of a model play once. */
#include "app/character/sketch/character_sketch.h"
#include "platform/base/compiler.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

static const double rate_hz = 50.0;

/* Loads what a sketch of the model says. */
static void sketch(
	struct acting *acting, const struct character_sketch_play *play)
{
	char *text = acting_sketch(acting->model, play);

	acting_expect(acting, text);
	free(text);
}

static void begin(struct acting *acting)
{
	acting_begin(acting, "tests/fixtures/gltf/clip/door.gltf");
}

static void test_clips_that_end_in_another_shape_play_once(void **state)
{
	static const struct {
		const char *clip;
		bool once;
	} clips[] = {{"open", true}, {"swing", true}, {"push", false},
		{"rattle", false}, {"pose", false}, {"roll", false},
		{"spin", false}, {"jam", true}, {"leave", false},
		{"drive", false}, {"smile", true}, {"blink", false}};
	struct acting acting;

	(void)state;
	begin(&acting);
	sketch(&acting, NULL);
	assert_int_equal(
		acting.character->machine.state_count, (int)ARRAY_COUNT(clips));
	for (size_t i = 0; i < ARRAY_COUNT(clips); i++) {
		const struct character_state *one =
			&acting.character->machine.state[i];

		assert_string_equal(one->name, clips[i].clip);
		assert_int_equal(
			one->repeat, clips[i].once ? CLIP_ONCE : CLIP_LOOP);
	}
	acting_end(&acting);
}

static void test_all_clips_loop_if_the_user_says_so(void **state)
{
	const struct character_sketch_play play = {
		.rate = 1, .repeat = CLIP_LOOP, .all_loop = true};
	struct acting acting;

	(void)state;
	begin(&acting);
	sketch(&acting, &play);
	assert_int_equal(acting.character->machine.state[0].repeat, CLIP_LOOP);
	acting_end(&acting);
}

/* Where the far corner of the door's leaf is. */
static float depth(const struct acting *acting)
{
	return acting->instance->world[1][0][2];
}

/* It eases from the end to the start. */
static void test_a_button_plays_a_clip_again_that_plays_once(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting);
	sketch(&acting, NULL);
	acting_run_to(&acting, 3.0, rate_hz);
	assert_near(depth(&acting), 1, 1e-5);
	acting_tap(&acting, BUTTON_ENTER, 0.8, rate_hz);
	assert_string_equal(acting_state(&acting), "open");
	assert_false(acting.character->paused);
	assert_true(depth(&acting) < 1 && depth(&acting) > 0.9f);
	acting_run_to(&acting, 4.15, rate_hz);
	assert_true(depth(&acting) < 0.9f);
	acting_run_to(&acting, 5.0, rate_hz);
	assert_near(depth(&acting), 1, 1e-5);
	acting_end(&acting);
}

/* Its end is shown for a second. */
static void test_a_clip_alone_that_plays_once_begins_again(void **state)
{
	struct acting acting;
	int count;

	(void)state;
	begin(&acting);
	count = acting.model->clip_count;
	acting.model->clip_count = 1;
	sketch(&acting, NULL);
	acting_run_to(&acting, 1.98, rate_hz);
	assert_near(depth(&acting), 1, 1e-5);
	acting_run_to(&acting, 2.5, rate_hz);
	assert_true(depth(&acting) < 0.9f);
	acting_run_to(&acting, 3.2, rate_hz);
	assert_near(depth(&acting), 1, 1e-5);
	acting.model->clip_count = count;
	acting_end(&acting);
}

/* Plays the door's first clip with other keys, from 0 s to 1 s. */
static enum clip_repeat repeat_of(
	struct acting *acting, struct model_channel channel)
{
	static const float time_s[] = {0, 1};
	struct model_clip *clip = &acting->model->clip[0], kept = *clip;
	char *text;

	channel.node = clip->channel[0].node;
	channel.path = MODEL_ROTATION;
	channel.width = 4;
	channel.key_count = 2;
	channel.time_s = time_s;
	clip->duration_s = 1;
	clip->channel = &channel;
	text = acting_sketch(acting->model, NULL);
	*clip = kept;
	acting_expect(acting, text);
	free(text);
	return acting->character->machine.state[0].repeat;
}

/* A cubic key has a tangent, the value and another tangent. */
static void test_the_last_value_tells_where_a_cubic_clip_ends(void **state)
{
	static const float loop[] = {0, 0, 0, 0, 0, 0, 0, 1, 0, 3, 0, 0, 0, -3,
		0, 0, 0, 0, 0, 1, 0, 0, 0, 0};
	static const float open[] = {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0,
		0, 0, 0, 0.7071068f, 0, 0.7071068f, 0, 0, 0, 0};
	struct model_channel channel = {.interpolation = MODEL_CUBICSPLINE};
	struct acting acting;

	(void)state;
	begin(&acting);
	channel.value = loop;
	assert_int_equal(repeat_of(&acting, channel), CLIP_LOOP);
	channel.value = open;
	assert_int_equal(repeat_of(&acting, channel), CLIP_ONCE);
	acting_end(&acting);
}

static void test_packed_rotations_tell_where_a_clip_ends(void **state)
{
	static const int16_t open[][4] = {
		{0, 0, 0, MODEL_PACKED_UNIT}, {0, 23170, 0, 23170}};
	static const int16_t still[][4] = {
		{0, 23170, 0, 23170}, {0, 23170, 0, 23170}};
	struct model_channel channel = {.unit = true};
	struct acting acting;

	(void)state;
	begin(&acting);
	channel.packed = open;
	assert_int_equal(repeat_of(&acting, channel), CLIP_ONCE);
	channel.packed = still;
	assert_int_equal(repeat_of(&acting, channel), CLIP_LOOP);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_clips_that_end_in_another_shape_play_once),
		cmocka_unit_test(test_all_clips_loop_if_the_user_says_so),
		cmocka_unit_test(
			test_a_button_plays_a_clip_again_that_plays_once),
		cmocka_unit_test(test_a_clip_alone_that_plays_once_begins_again),
		cmocka_unit_test(
			test_the_last_value_tells_where_a_cubic_clip_ends),
		cmocka_unit_test(test_packed_rotations_tell_where_a_clip_ends),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
