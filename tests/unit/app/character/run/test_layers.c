/* What layers, expressions and morphs add to the pose of a state. */
#include "app/character/run/layers.h"
#include "app/character/state/entry.h"
#include "tests/unit/app/character/state/states.h"

#include <math.h>

/* A layer of the clip of state 0 above a pose whose morph weight is 100. */
struct fixture {
	struct states states;
	struct character_layer layer;
	struct character_action action;
	struct character_event event; /* at the clip's end */
	float weight, rate;
};

static void begin(struct fixture *f, bool once)
{
	struct states *states = &f->states;
	struct character_layer *layer = &f->layer;

	states_begin(states);
	memset(layer, 0, sizeof(*layer));
	assert_int_equal(
		pose_init(&states->character.scratch, &states->bones.model,
			&states->bones.model.arena),
		0);
	f->action = (struct character_action){.verb = CHARACTER_PAUSE};
	f->event = (struct character_event){.time_s = 2, .action = &f->action};
	states->of[0].event = &f->event;
	f->weight = 0.75f;
	f->rate = 1;
	layer->is.weight = &f->weight;
	layer->rate = &f->rate;
	layer->once = once;
	layer->entry.of = &states->of[0];
	layer->entry.cursor = &states->cursor[0];
	character_entry_begin(&layer->entry, 0);
	states->character.step_s = step_s;
	states->character.exact_s = (double)step_s;
}

static void end(struct fixture *f)
{
	states_end(&f->states);
}

/* Runs a frame, and returns the morph's weight. */
static float run(struct fixture *f)
{
	struct pose *pose = &f->states.instance.pose;

	f->states.character.pending_count = 0;
	pose->weight[0] = 100;
	character_layer_run(&f->states.character, &f->layer);
	return pose->weight[0];
}

static float smooth(float u)
{
	u = u < 0 ? 0 : u > 1 ? 1 : u;
	return u * u * (3 - 2 * u);
}

/* A clip of 2 s that fades within half a second at both ends. */
static void test_a_layer_plays_once_at_its_rate(void **state)
{
	static const float rates[] = {1, 0.5f, 2, -1, -0.5f};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rates); i++) {
		struct fixture f;
		float done_s = 0;

		begin(&f, true);
		f.layer.is.fade_s = 0.5f;
		f.rate = rates[i];
		assert_near(run(&f), 100, 0);
		character_layer_play(&f.layer);
		while (done_s < 2.5f) {
			float at_s, wanted, shown = run(&f);

			done_s += step_s * fabsf(f.rate);
			at_s = f.rate < 0 ? 2 - done_s : done_s;
			wanted = 0.75f * smooth(2 * done_s) *
				smooth(2 * (2 - done_s));
			assert_int_equal(f.layer.playing, done_s < 2);
			assert_near(f.layer.is.now, wanted, 1e-6);
			assert_near(shown, 100 + (at_s - 100) * wanted, 1e-4);
		}
		/* Played again, it begins anew. */
		character_layer_play(&f.layer);
		run(&f);
		assert_true(f.layer.playing);
		assert_near(f.layer.entry.time_s,
			f.rate < 0 ? 2 + step_s * f.rate : step_s * f.rate, 0);
		end(&f);
	}
}

/* Without a fade it has its weight at once. */
static void test_a_layer_that_does_not_advance_shows_its_start(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f, true);
	f.rate = 0;
	character_layer_play(&f.layer);
	assert_near(f.layer.entry.time_s, 0, 0);
	for (int i = 0; i < 3; i++) {
		assert_near(run(&f), 25, 1e-5);
		assert_near(f.layer.is.now, 0.75, 0);
		assert_true(f.layer.playing);
	}
	/* With one it has not begun. */
	f.layer.is.fade_s = 0.5f;
	assert_near(run(&f), 100, 0);
	assert_true(f.layer.playing);
	end(&f);
}

/* Unless nothing of it is shown. */
static void test_the_end_of_a_layer_causes_its_events(void **state)
{
	static const struct {
		float weight;
		bool has_clip;
		int events;
	} rows[] = {{0.75f, true, 1}, {0.01f, true, 1}, {0, true, 0},
		{0.75f, false, 0}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct fixture f;

		begin(&f, true);
		f.weight = rows[i].weight;
		character_layer_play(&f.layer);
		for (int k = 0; k < 7; k++) {
			run(&f);
			assert_int_equal(f.states.character.pending_count, 0);
		}
		if (!rows[i].has_clip) {
			f.states.of[0].clip = NULL;
		}
		assert_near(run(&f), 100, 0);
		assert_int_equal(
			f.states.character.pending_count, rows[i].events);
		run(&f);
		assert_int_equal(f.states.character.pending_count, 0);
		end(&f);
	}
}

/* It goes on while it is off, but is not shown. */
static void test_another_layer_loops_by_its_switch(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f, false);
	f.rate = 0.5f;
	f.layer.is.now = 0;
	for (int i = 0; i < 4; i++) {
		assert_near(run(&f), 100, 0);
	}
	assert_near(f.layer.entry.time_s, 0.5, 0);
	assert_near(f.layer.entry.shown_s, -1, 0);
	f.layer.is.now = 0.5f;
	f.rate = 7;
	/* At 2.25 s: a quarter of a second after its end. */
	assert_near(run(&f), 50.125f, 1e-5);
	assert_near(f.layer.is.now, 0.5, 0);
	end(&f);
}

static void test_an_additive_layer_adds_what_differs_from_its_start(void **state)
{
	struct fixture f;
	struct pose *reference = &f.layer.reference;
	float mask[1] = {1};

	(void)state;
	for (int i = 0; i < 2; i++) {
		begin(&f, false);
		assert_int_equal(pose_init(reference, &f.states.bones.model,
					 &f.states.bones.model.arena),
			0);
		reference->weight[0] = 8;
		mask[0] = i ? 0.5f : 1;
		f.layer.mask = mask;
		f.layer.additive = true;
		f.layer.is.now = 0.5f;
		assert_near(
			run(&f), 100 + (0.25f - 8) * (i ? 0.25f : 0.5f), 1e-5);
		end(&f);
	}
}

static void test_an_expression_adds_to_its_weights(void **state)
{
	float weight[4] = {1, 2, 3, 4};
	int target[3] = {2, 0, 1};
	float amount[3] = {0.5f, -4, 100};
	struct instance instance = {.pose = {.weight = weight}};
	struct character character = {.instance = &instance};
	struct character_expression expression = {
		.is = {.now = 0.25f},
		.count = 2,
		.target = target,
		.amount = amount,
	};

	(void)state;
	character_expression_run(&character, &expression);
	assert_all_near(weight, ((float[]){0, 2, 3.125f, 4}), 4, 0);
}

/* Whatever stands behind the table. */
static void test_a_table_ends_with_its_last_value(void **state)
{
	static const struct character_curve curve = {
		.kind = CHARACTER_CURVE_TABLE,
		.table_count = 3,
		.table = {0, 0.25f, 1, INFINITY},
	};

	(void)state;
	assert_near(character_morph_curve(&curve, 1), 1, 0);
	assert_near(character_morph_curve(&curve, 0.75f), 0.625f, 0);
	assert_near(character_morph_curve(&curve, 0.5f), 0.25f, 0);
	assert_near(character_morph_curve(&curve, 0), 0, 0);
}

/* A morph of three of four weights, from 0 to these. */
static const float goal[2][3] = {{1, 2, -4}, {9, 9, 9}};
static const float none[2][3];

struct morphed {
	struct bones bones;
	struct instance instance;
	struct morph_key key[2];
	struct character_morph morph;
	struct character character;
	float weight;
};

static void begin_morph(struct morphed *m, enum character_curve_kind kind)
{
	struct bones *bones = &m->bones;
	struct character_morph *morph = &m->morph;

	memset(m, 0, sizeof(*m));
	bones_begin(bones);
	bones_add(bones, -1, 1, 2, 3);
	bones_add(bones, 0, 5, 6, 7);
	bones->node[1].mesh = 0;
	bones->model.weight_count = 4;
	bones->mesh[0].target_count = 3;
	bones_pose(bones);
	m->instance.pose = bones->pose;
	m->instance.model = &bones->model;
	m->character.instance = &m->instance;
	m->character.step_s = 0.25f;
	m->weight = 0.5f;
	m->key[0].position = none;
	m->key[1].position = goal;
	morph->node = 1;
	morph->target_count = 3;
	morph->key_count = 2;
	morph->key = m->key;
	morph->duration_s = 1;
	morph->frame_count = 4;
	morph->pace = 1;
	morph->weight = &m->weight;
	morph->curve_count = 1;
	morph->curve[0].kind = kind;
	assert_int_equal(
		morph_init(&morph->morph, 2, m->key[0], &bones->model.arena), 0);
}

static void run_morph(struct morphed *m, double now_s)
{
	m->character.now_s = now_s;
	memset(m->instance.pose.weight, 0, 4 * sizeof(float));
	character_morph_run(&m->character, &m->morph);
}

static void test_a_morph_adds_its_weights_by_a_share(void **state)
{
	struct morphed m;
	const float *weight;

	(void)state;
	begin_morph(&m, CHARACTER_CURVE_LINEAR);
	weight = m.bones.pose.weight;
	character_morph_go(&m.morph, 1, 3);
	assert_int_equal(m.morph.destiny, 1);
	assert_int_equal(m.morph.before, 0);
	run_morph(&m, 3.25);
	assert_all_near(weight, ((float[]){0.125f, 0.25f, -0.5f, 0}), 4, 1e-6);
	assert_near(character_morph_omega(&m.morph, 3.25), 0.25, 1e-6);
	run_morph(&m, 4);
	assert_all_near(weight, ((float[]){0.5f, 1, -2, 0}), 4, 0);
	bones_end(&m.bones);
}

/* A sine moves no weight. */
static void test_tables_and_bezier_curves_shape_a_morph(void **state)
{
	static const struct {
		enum character_curve_kind kind;
		enum morph_curve curve;
	} rows[] = {{CHARACTER_CURVE_LINEAR, MORPH_LINEAR},
		{CHARACTER_CURVE_SINE, MORPH_LINEAR},
		{CHARACTER_CURVE_TABLE, MORPH_SHAPED},
		{CHARACTER_CURVE_BEZIER, MORPH_SHAPED}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct morphed m;

		begin_morph(&m, CHARACTER_CURVE_LINEAR);
		m.morph.curve[1].kind = rows[i].kind;
		character_morph_use_curve(&m.morph, 1);
		assert_int_equal(m.morph.chosen, 1);
		character_morph_go(&m.morph, 1, 0);
		assert_int_equal(m.morph.morph.motion.curve, rows[i].curve);
		bones_end(&m.bones);
	}
}

/* By frames, a pause is none. */
static void test_a_morph_takes_its_frames_or_its_time_by_the_pace(void **state)
{
	static const struct {
		float pace;
		int frames, takes;
		float duration_ms;
	} rows[] = {{1, 4, 4, 1000}, {2, 4, 2, 500}, {8, 4, 1, 125},
		{8, 2, 1, 125}, {0.125f, 4, 32, 8000}, {2, 3, 2, 500}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct morphed m;

		begin_morph(&m, CHARACTER_CURVE_LINEAR);
		m.morph.by_frames = true;
		m.morph.pace = rows[i].pace;
		m.morph.frame_count = rows[i].frames;
		character_morph_go(&m.morph, 1, 0);
		assert_near(m.morph.morph.motion.duration_ms,
			rows[i].duration_ms, 1e-3);
		m.character.step_s = 0;
		run_morph(&m, 0);
		m.character.step_s = 0.25f;
		for (int frame = 1; frame <= rows[i].takes; frame++) {
			assert_true(m.morph.morph.running);
			run_morph(&m, 0.01 * frame);
		}
		assert_false(m.morph.morph.running);
		bones_end(&m.bones);
	}
}

/* Along its direction in the node's frame, by the sine of its way. */
static void test_a_sine_moves_the_node_in_its_own_frame(void **state)
{
	static const float way[][2] = {
		{0.25f, 0.70710678f}, {0.5f, 1}, {5.0f / 6, 0.5f}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(way); i++) {
		struct morphed m;
		struct transform *local;
		float moved = 0.1f * way[i][1];

		begin_morph(&m, CHARACTER_CURVE_SINE);
		m.morph.curve[0].wave = (struct morph_wave){
			.direction = {0.6f, 0, 0.8f}, .amplitude = 0.1f};
		local = &m.instance.pose.local[1];
		/* A quarter turn about y takes x to -z, and z to x. */
		memcpy(local->rotation,
			((float[]){0, 0.70710678f, 0, 0.70710678f}),
			sizeof(local->rotation));
		memcpy(local->scale, ((float[]){2, 3, 4}), sizeof(local->scale));
		character_morph_go(&m.morph, 1, 0);
		run_morph(&m, (double)way[i][0]);
		assert_all_near(local->translation,
			((float[]){5 + 3.2f * moved, 6, 7 - 1.2f * moved}), 3,
			1e-5);
		assert_true(m.instance.pose.animated[1]);
		bones_end(&m.bones);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_layer_plays_once_at_its_rate),
		cmocka_unit_test(
			test_a_layer_that_does_not_advance_shows_its_start),
		cmocka_unit_test(test_the_end_of_a_layer_causes_its_events),
		cmocka_unit_test(test_another_layer_loops_by_its_switch),
		cmocka_unit_test(
			test_an_additive_layer_adds_what_differs_from_its_start),
		cmocka_unit_test(test_an_expression_adds_to_its_weights),
		cmocka_unit_test(test_a_table_ends_with_its_last_value),
		cmocka_unit_test(test_a_morph_adds_its_weights_by_a_share),
		cmocka_unit_test(test_tables_and_bezier_curves_shape_a_morph),
		cmocka_unit_test(
			test_a_morph_takes_its_frames_or_its_time_by_the_pace),
		cmocka_unit_test(test_a_sine_moves_the_node_in_its_own_frame),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
