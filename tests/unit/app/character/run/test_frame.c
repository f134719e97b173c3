/* The time and the order of a character's frame, and where another goes on. */
#include "app/character/character.h"
#include "tests/unit/app/character/state/states.h"

/* The states with a parameter, and with operations that note what they see. */
struct fixture {
	struct states states;
	struct character_parameter parameter;
	struct character_op op[3];
	float seen[3];
	int count;
};

static void begin(struct fixture *f)
{
	struct character *character = &f->states.character;

	states_begin(&f->states);
	f->states.instance.world = f->states.bones.world;
	f->parameter = (struct character_parameter){.range = {0, 100}};
	f->count = 0;
	character->parameter = &f->parameter;
	character->parameter_count = 1;
	character->motion.foot[0] = character->motion.foot[1] = -1;
	character->seen_s = 5;
	character->now_s = 2;
}

static void end(struct fixture *f)
{
	states_end(&f->states);
}

static void update(struct fixture *f, double time_s)
{
	const struct character_frame frame = {
		.time_s = time_s, .motion_level = 0.5f, .eye = {1, 2, 3}};

	character_update(&f->states.character, &frame);
}

/* By up to ten seconds, and never back; the time that passes is without pauses. */
static void test_a_frame_takes_the_time_since_the_last_one(void **state)
{
	static const struct {
		double time_s, passed_s;
	} rows[] = {{5.25, 0.25}, {5, 0}, {4, 0}, {14.5, 9.5}, {15, 10},
		{15.5, 10}, {1000, 10}};

	(void)state;
	for (size_t i = 0; i < 2 * ARRAY_COUNT(rows); i++) {
		bool paused = i % 2;
		double passed_s = rows[i / 2].passed_s;
		struct fixture f;
		struct character *character = &f.states.character;

		begin(&f);
		character->paused = paused;
		character->camera_turn = character->camera_tilt = 7;
		character->camera_zoom = 7;
		update(&f, rows[i / 2].time_s);
		assert_near(character->seen_s, rows[i / 2].time_s, 0);
		assert_near(character->real_s, passed_s, 0);
		assert_near(character->step_s, paused ? 0 : passed_s, 0);
		assert_near(character->exact_s, paused ? 0 : passed_s, 0);
		assert_near(character->now_s, paused ? 2 : 2 + passed_s, 0);
		assert_near(character->camera_turn, 0, 0);
		assert_near(character->camera_tilt, 0, 0);
		assert_near(character->camera_zoom, 0, 0);
		assert_near(character->motion_level, 0.5, 0);
		assert_all_near(character->eye, ((float[]){1, 2, 3}), 3, 0);
		end(&f);
	}
}

/* Notes where the node is in the world, and moves it by a metre. */
static void note_and_move(struct character *character, void *what)
{
	struct instance *instance = character->instance;
	struct fixture *f = what;

	f->seen[f->count++] = instance->world[0][3][0];
	instance->pose.local[0].translation[0] += 1;
	instance->pose.animated[0] = true;
}

/* Before the first operation that reads them, or at the end. */
static void test_world_matrices_are_made_once(void **state)
{
	static const struct {
		enum character_stage stage[3];
		float seen[3], last;
	} rows[] = {
		{{CHARACTER_STAGE_LAYER, CHARACTER_STAGE_PART,
			 CHARACTER_STAGE_BONE},
			{0, 0, 0}, 3},
		{{CHARACTER_STAGE_LAYER, CHARACTER_STAGE_BONE,
			 CHARACTER_STAGE_WORLD},
			{0, 0, 2}, 2},
		{{CHARACTER_STAGE_BONE, CHARACTER_STAGE_WORLD,
			 CHARACTER_STAGE_ATTACHED},
			{0, 1, 1}, 1},
		{{CHARACTER_STAGE_WORLD, CHARACTER_STAGE_WORLD,
			 CHARACTER_STAGE_CLOTH},
			{0, 0, 0}, 0},
	};
	static const float speed = 4;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct fixture f;
		struct character *character = &f.states.character;

		begin(&f);
		character->motion.speed = &speed;
		character->op = f.op;
		character->op_count = 3;
		for (int k = 0; k < 3; k++) {
			f.op[k] =
				(struct character_op){.stage = rows[i].stage[k],
					.run = note_and_move,
					.what = &f};
		}
		update(&f, 5.25);
		assert_int_equal(f.count, 3);
		assert_all_near(f.seen, rows[i].seen, 3, 0);
		assert_near(f.states.instance.world[0][3][0], rows[i].last, 0);
		/* The ground follows from them. */
		assert_near(character->motion.scroll[1], 1, 0);
		end(&f);
	}
}

/* In the frame in which the state is entered. */
static void test_what_a_trigger_causes_is_done_in_its_frame(void **state)
{
	static const float one = 1;
	struct fixture f;
	struct character *character = &f.states.character;
	struct character_condition when = {.left = &f.states.position[3],
		.right = &one,
		.is = CHARACTER_ABOVE};
	const struct character_action set = {
		.verb = CHARACTER_SET, .amount = 50};
	struct character_trigger trigger = {.when = &when, .then = &set};
	float weight = 0.5f;
	struct character_switch is = {.weight = &weight, .is_on = true};
	struct character_switch *switches[1] = {&is};

	(void)state;
	begin(&f);
	character->trigger = &trigger;
	character->trigger_count = 1;
	character->switches = switches;
	character->switch_count = 1;
	update(&f, 5.25);
	assert_near(is.now, 0.5, 0);
	f.states.position[3] = 2;
	update(&f, 5.5);
	assert_near(f.parameter.goal, 50, 0);
	assert_int_equal(character->pending_count, 0);
	end(&f);
}

/* What a button asks for plays in the next frame, which shows its start. */
static void test_a_pending_action_is_done_before_the_states(void **state)
{
	const struct character_action go = {.verb = CHARACTER_GO, .index = 2};
	struct fixture f;
	struct character *character = &f.states.character;

	(void)state;
	begin(&f);
	update(&f, 5.25);
	character->pending[0].action = &go;
	character->pending_count = 1;
	update(&f, 5.5);
	assert_int_equal(character->machine.current, 2);
	end(&f);
}

/* Files of as many, of fewer and of more clips in the state. */
static void test_another_character_goes_on_in_the_same_state(void **state)
{
	static const int counts[][2] = {{3, 3}, {2, 3}, {3, 2}, {1, 3}};
	static const char *const names[STATES] = {"a", "b", "c", "d"};

	(void)state;
	for (size_t i = 0; i < STATES * ARRAY_COUNT(counts); i++) {
		const int *count = counts[i / STATES];
		int current = (int)i % STATES;
		struct fixture f, before;
		struct character *character = &f.states.character;
		struct character_machine *machine = &character->machine;

		begin(&f);
		begin(&before);
		for (int s = 0; s < STATES; s++) {
			f.states.state[s].name = names[s];
			f.states.state[s].entry_count = count[0];
			before.states.state[s].name = names[s];
			before.states.state[s].entry_count = count[1];
			for (int k = 0; k < ENTRIES; k++) {
				before.states.entry[s][k].time_s = 10 * s + k;
				before.states.entry[s][k].shown_s = 0.5f;
			}
		}
		before.states.character.machine.current = current;
		before.states.character.machine.fresh = false;
		character->pending[0].action = &f.states.leave[0];
		character->pending_count = 1;
		character_go_on(character, &before.states.character);
		assert_int_equal(machine->current, current);
		assert_false(machine->fresh);
		assert_int_equal(character->pending_count, 1);
		assert_ptr_equal(
			character->pending[0].action, &f.states.enter[current]);
		assert_near(character->pending[0].times, 1, 0);
		for (int k = 0; k < ENTRIES; k++) {
			bool known = k < count[0] && k < count[1];
			const struct character_entry *entry =
				&f.states.entry[current][k];

			assert_near(
				entry->time_s, known ? 10 * current + k : 0, 0);
			assert_near(entry->shown_s, known ? 0.5 : 0, 0);
		}
		end(&before);
		end(&f);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_frame_takes_the_time_since_the_last_one),
		cmocka_unit_test(test_world_matrices_are_made_once),
		cmocka_unit_test(test_what_a_trigger_causes_is_done_in_its_frame),
		cmocka_unit_test(test_a_pending_action_is_done_before_the_states),
		cmocka_unit_test(
			test_another_character_goes_on_in_the_same_state),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
