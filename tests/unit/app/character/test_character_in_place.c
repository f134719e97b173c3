/* Clips that walk away, as limber play shows them: in their place. */
#include "app/anim/clip.h"
#include "app/character/show/character_in_place.h"
#include "app/scene/instance/bounds.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const float way[3] = {0.5f, 0.0f, -1.5f};

struct walk {
	struct acting acting;
	struct arena arena;
	int clip, hips;
	struct model_channel *channel; /* the translation of the hips */
	float *value;                  /* its keys */
};

/* Keys of the walk's own values: linear, in steps, or cubic ones without slope. */
static void make_keys(struct walk *walk, enum model_interpolation interpolation)
{
	struct model_channel *channel = walk->channel;
	size_t count = (size_t)channel->key_count;
	size_t size = interpolation == MODEL_CUBICSPLINE ? 9 : 3;
	float *value = ARENA_ARRAY(&walk->arena, float, count *size);

	assert_non_null(value);
	for (size_t i = 0; i < count; i++) {
		memcpy(value + i * size + (size == 9 ? 3 : 0),
			channel->value + 3 * i, 3 * sizeof(*value));
	}
	walk->value = value;
	channel->value = value;
	channel->interpolation = interpolation;
}

static void begin(struct walk *walk, enum model_interpolation interpolation)
{
	struct model *model;
	struct model_clip *clip;

	*walk = (struct walk){.arena = arena_empty()};
	acting_begin(&walk->acting, "assets/walker.glb");
	model = walk->acting.model;
	walk->clip = model_find_clip(model, "walk");
	walk->hips = model_find_node(model, "hips");
	clip = &model->clip[walk->clip];
	for (int i = 0; i < clip->channel_count; i++) {
		if (clip->channel[i].node == walk->hips &&
			clip->channel[i].path == MODEL_TRANSLATION) {
			walk->channel = &clip->channel[i];
		}
	}
	assert_non_null(walk->channel);
	make_keys(walk, interpolation);
}

static void end(struct walk *walk)
{
	acting_end(&walk->acting);
	arena_release(&walk->arena);
}

/* Where the hips of a clip are at a time, below their parent. */
static void place(const struct walk *walk, const struct model_clip *clip,
	float time_s, float out[3])
{
	struct pose *pose = &walk->acting.instance->pose;

	clip_sample(clip, time_s, &(struct clip_cursor){0}, pose);
	memcpy(out, pose->local[walk->hips].translation, sizeof(float[3]));
}

/* Lets the keys of the hips begin at this time, as Blender exports them. */
static void begin_late(struct walk *walk, float lead_s)
{
	struct model_clip *clip = &walk->acting.model->clip[walk->clip];
	struct model_channel *channel = walk->channel;
	float *time_s =
		ARENA_ARRAY(&walk->arena, float, (size_t)channel->key_count);

	assert_non_null(time_s);
	for (int i = 0; i < channel->key_count; i++) {
		time_s[i] = lead_s +
			channel->time_s[i] * (1 - lead_s / clip->duration_s);
	}
	channel->time_s = time_s;
	clip->lead_s = lead_s;
}

/* Lets the hips go their way, as much of it as of the clip has passed. */
static void walk_away(struct walk *walk)
{
	const struct model_clip *clip = &walk->acting.model->clip[walk->clip];
	struct model_channel *channel = walk->channel;
	bool cubic = channel->interpolation == MODEL_CUBICSPLINE;

	for (int i = 0; i < channel->key_count; i++) {
		float *key = walk->value + (size_t)i * (cubic ? 9 : 3);

		for (int axis = 0; axis < 3; axis++) {
			float slope =
				way[axis] / (clip->duration_s - clip->lead_s);

			key[(cubic ? 3 : 0) + axis] +=
				slope * (channel->time_s[i] - clip->lead_s);
			if (cubic) {
				key[axis] += slope;
				key[6 + axis] += slope;
			}
		}
	}
}

static void check_stays(enum model_interpolation interpolation, float lead_s)
{
	enum {
		MOMENTS = 23
	};
	float before[MOMENTS][3], way_m[64];
	const struct model_clip *clip;
	struct model shown;
	struct walk walk;

	begin(&walk, interpolation);
	begin_late(&walk, lead_s);
	clip = &walk.acting.model->clip[walk.clip];
	for (int i = 0; i < MOMENTS; i++) {
		place(&walk, clip, clip->duration_s * (float)i / (MOMENTS - 1),
			before[i]);
	}
	walk_away(&walk);
	acting_expect(&walk.acting, "[motion]\nroot = hips\n");
	assert_true(walk.acting.model->clip_count <= 64);
	assert_int_equal(character_in_place(walk.acting.character,
				 walk.acting.model, &walk.arena, &shown, way_m),
		0);
	for (int i = 0; i < MOMENTS; i++) {
		float now[3];

		place(&walk, &shown.clip[walk.clip],
			clip->duration_s * (float)i / (MOMENTS - 1), now);
		for (int axis = 0; axis < 3; axis++) {
			assert_near(now[axis], (double)before[i][axis], 2e-6);
		}
	}
	assert_near(way_m[walk.clip], sqrt(0.5 * 0.5 + 1.5 * 1.5), 1e-4);
	end(&walk);
}

static void test_a_walk_that_goes_away_stays_in_its_place(void **state)
{
	(void)state;
	check_stays(MODEL_LINEAR, 0.0f);
	check_stays(MODEL_CUBICSPLINE, 0.0f);
	check_stays(MODEL_LINEAR, 0.04f);
	check_stays(MODEL_CUBICSPLINE, 0.04f);
}

static void test_other_clips_and_ways_in_steps_stay_as_they_are(void **state)
{
	const struct model *model;
	struct model shown;
	struct walk walk;
	float way_m[64];

	(void)state;
	begin(&walk, MODEL_STEP);
	walk_away(&walk);
	model = walk.acting.model;
	acting_expect(&walk.acting, "[motion]\nroot = hips\n");
	assert_int_equal(character_in_place(walk.acting.character, model,
				 &walk.arena, &shown, way_m),
		0);
	for (int c = 0; c < model->clip_count; c++) {
		if (way_m[c] > 0.0f) {
			continue; /* another clip that goes */
		}
		for (int i = 0; i < model->clip[c].channel_count; i++) {
			assert_ptr_equal(shown.clip[c].channel[i].value,
				model->clip[c].channel[i].value);
		}
	}
	assert_near(way_m[walk.clip], 0.0, 0.0);
	assert_ptr_equal(shown.node, model->node);
	end(&walk);
}

/* The box of the walk as it is shown, when the model goes this way in it. */
static struct bounds shown_box(const struct walk *walk, const float go[2])
{
	struct instance *instance = walk->acting.instance;
	size_t count = (size_t)instance->model->clip_count;
	float(*gone)[2] = calloc(count, sizeof(*gone));
	struct bounds *box = calloc(count, sizeof(*box)), found;
	struct bounds_sides *sides = calloc(count, sizeof(*sides));

	assert_true(gone && box && sides);
	memcpy(gone[walk->clip], go, sizeof(*gone));
	bounds_of_model(instance, (const float(*)[2])gone, box, sides);
	found = box[walk->clip];
	free(sides);
	free(box);
	free(gone);
	return found;
}

/* The model stands until the first key, so it goes only from there on. */
static void test_the_box_of_a_late_walk_is_that_in_its_place(void **state)
{
	static const float nowhere[2] = {0.0f, 0.0f};
	const float away[2] = {way[0], way[2]};
	struct bounds before, after;
	struct walk walk;

	(void)state;
	begin(&walk, MODEL_LINEAR);
	begin_late(&walk, 0.5f * walk.acting.model->clip[walk.clip].duration_s);
	before = shown_box(&walk, nowhere);
	walk_away(&walk);
	after = shown_box(&walk, away);
	for (int axis = 0; axis < 3; axis++) {
		assert_near(after.low[axis], (double)before.low[axis], 1e-3);
		assert_near(after.high[axis], (double)before.high[axis], 1e-3);
	}
	end(&walk);
}

/* Also the first clip, and if another channel comes before that of the root. */
static void test_a_way_along_one_axis_is_taken_too(void **state)
{
	static const float place[3][3] = {{0}, {10, 0, 0}, {20, 0, 0}},
			   far_z[2][3] = {{0, 1, 0}, {0, 3, -8}},
			   size[2][3] = {{1, 1, 1}, {2, 2, 2}};
	struct model_channel channel[2];
	struct arena arena = arena_empty();
	struct acting acting;
	struct model shown;
	float way_m[4];

	(void)state;
	acting_begin(&acting, "tests/fixtures/gltf/clip/far.gltf");
	assert_int_equal(acting.model->clip_count, 4);
	acting.model->node[0].name = "carrier";
	memcpy((float *)acting.model->clip[0].channel[0].value, place,
		sizeof(place));
	channel[0] = channel[1] = acting.model->clip[1].channel[0];
	channel[0].path = MODEL_SCALE;
	channel[0].value = size[0];
	channel[1].value = far_z[0];
	acting.model->clip[1].channel = channel;
	acting.model->clip[1].channel_count = 2;
	acting_expect(&acting, "[motion]\nroot = carrier\n");
	assert_int_equal(character_in_place(acting.character, acting.model,
				 &arena, &shown, way_m),
		0);
	assert_near(way_m[0], 20, 1e-4);
	assert_near(way_m[1], 8, 1e-4);
	for (int i = 0; i < 3; i++) {
		assert_all_near(shown.clip[0].channel[0].value + 3 * i,
			((float[3]){0}), 3, 1e-5);
	}
	assert_ptr_equal(shown.clip[1].channel[0].value, size);
	assert_all_near(
		shown.clip[1].channel[1].value, ((float[]){0, 1, 0}), 3, 1e-5);
	assert_near(shown.clip[1].channel[1].value[5], 0, 1e-5);
	acting_end(&acting);
	arena_release(&arena);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_walk_that_goes_away_stays_in_its_place),
		cmocka_unit_test(
			test_other_clips_and_ways_in_steps_stay_as_they_are),
		cmocka_unit_test(test_a_way_along_one_axis_is_taken_too),
		cmocka_unit_test(
			test_the_box_of_a_late_walk_is_that_in_its_place),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
