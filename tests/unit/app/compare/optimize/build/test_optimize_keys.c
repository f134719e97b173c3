/* Which channels of an animation stay, with which keys. */
#include "tests/support/test.h"
#include "tests/unit/app/compare/optimize/build/keys_bench.h"

#include <string.h>

static void test_channels_keep_the_keys_that_suffice(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	bend(&f, 0, 7, 20);
	bend(&f, 2, 30, 31);
	choose(&f);
	expect_kept(&f, 0, (const int[]){0, 7, 20, KEYS - 1}, 4);
	expect_kept(&f, 2, (const int[]){0, 30, 31, KEYS - 1}, 4);
	/* The second does not move; the third keeps the animation's end. */
	assert_true(f.channel[1].constant);
	expect_kept(&f, 1, (const int[]){0}, 1);
	for (int c = 0; c < CHANNELS; c++) {
		assert_false(f.channel[c].dropped);
	}
	end(&f);
}

static void test_a_channel_that_nothing_moves_is_dropped(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	bend(&f, 2, 7, 20);
	f.moved[1][MODEL_TRANSLATION] = false;
	f.moved[1][MODEL_SCALE] = true;
	choose(&f);
	assert_false(f.channel[0].dropped);
	assert_true(f.channel[1].dropped);
	assert_false(f.channel[2].dropped);
	end(&f);
}

/*
 * Where no channel that moves ends last, one that stays keeps two keys: that
 * which ended last or, if nothing moves it, the first one.
 */
static void test_an_animation_keeps_its_end(void **state)
{
	(void)state;
	for (int dropped = -1; dropped < CHANNELS; dropped++) {
		struct fixture f;
		int pinned = dropped == CHANNELS - 1 ? 0 : CHANNELS - 1;

		begin(&f);
		if (dropped >= 0) {
			f.moved[dropped][MODEL_TRANSLATION] = false;
		}
		choose(&f);
		for (int c = 0; c < CHANNELS; c++) {
			assert_int_equal(f.channel[c].dropped, c == dropped);
			assert_int_equal(
				f.channel[c].kept_count, c == pinned ? 2 : 1);
		}
		end(&f);
	}
}

/*
 * Any channel that moves until then will do; a dropped one, or one that moves
 * but ends earlier, will not.
 */
static void test_a_channel_that_moves_keeps_the_end(void **state)
{
	(void)state;
	for (int mover = 0; mover < CHANNELS; mover++) {
		for (int later = 0; later <= 1; later++) {
			struct fixture f;
			/* One that ends there, else the first one. */
			int still = mover == 0 ? 2 : 0;

			begin(&f);
			bend(&f, mover, 7, 20);
			f.keys.end_s = f.time_s[mover][KEYS - 1] + (float)later;
			choose(&f);
			for (int c = 0; c < CHANNELS; c++) {
				assert_int_equal(f.channel[c].kept_count,
					c == mover                    ? 4
						: later && c == still ? 2
								      : 1);
				assert_int_equal(
					f.channel[c].ends, later && c == still);
			}
			end(&f);
			begin(&f);
			bend(&f, mover, 7, 20);
			f.keys.end_s = f.time_s[mover][KEYS - 1];
			f.moved[mover][MODEL_TRANSLATION] = false;
			choose(&f);
			assert_true(f.channel[mover].dropped);
			assert_int_equal(f.channel[mover ? 0 : 1].kept_count, 2);
			end(&f);
		}
	}
}

static void test_the_last_channel_stays_for_its_end(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	memset(f.moved, 0, sizeof(f.moved));
	choose(&f);
	assert_true(f.channel[0].dropped);
	assert_true(f.channel[1].dropped);
	assert_false(f.channel[2].dropped);
	assert_int_equal(f.channel[2].kept_count, 2);
	end(&f);
	begin(&f);
	memset(f.moved, 0, sizeof(f.moved));
	f.keys.end_s = 0.0f;
	choose(&f);
	assert_int_equal(f.channel[0].kept_count, 1);
	end(&f);
}

static void test_all_keys_are_kept_on_demand(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	assert_int_equal(optimize_keys_keep_all(&f.keys), 0);
	for (int c = 0; c < CHANNELS; c++) {
		assert_int_equal(f.channel[c].kept_count, KEYS);
		for (int k = 0; k < KEYS; k++) {
			assert_int_equal(f.channel[c].kept[k], k);
		}
	}
	end(&f);
}

/* A node's own value may be that of its channel, in each component. */
static void test_a_channel_at_rest_moves_nothing(void **state)
{
	(void)state;
	for (int i = -1; i < 3; i++) {
		bool moved[CHANNELS][4] = {{false}};
		struct fixture f;
		json_t *nodes;

		begin(&f);
		nodes = json_object_get(f.build.root, "nodes");
		json_object_set_new(json_array_get(nodes, 1), "translation",
			json_pack("[f,f,f]", 1.0, 2.0, 3.0));
		for (int k = 0; k < KEYS; k++) {
			for (int axis = 0; axis < 3; axis++) {
				f.value[1][k][axis] = (float)(axis + 1) +
					(axis == i ? 0.5f : 0.0f);
			}
		}
		json_object_set_new(
			json_array_get(nodes, 2), "matrix", json_array());
		optimize_keys_find_moved(&f.keys, moved[0]);
		assert_false(moved[0][MODEL_TRANSLATION]);
		assert_int_equal(moved[1][MODEL_TRANSLATION], i >= 0);
		assert_true(moved[2][MODEL_TRANSLATION]);
		end(&f);
	}
}

/* A node without a member stays at 0, with a scale of 1 and without a turn. */
static void test_a_node_without_members_is_at_rest(void **state)
{
	static const enum model_path paths[] = {
		MODEL_TRANSLATION, MODEL_ROTATION, MODEL_SCALE};
	static const float rest[3][4] = {{0, 0, 0}, {0, 0, 0, 1}, {1, 1, 1}};

	(void)state;
	for (int i = 0; i < 3 * 5; i++) {
		bool moved[CHANNELS][4] = {{false}};
		float value[KEYS][4] = {{0}};
		enum model_path path = paths[i / 5];
		int width = path == MODEL_ROTATION ? 4 : 3;
		int changed = i % 5; /* or none */
		struct fixture f;

		begin(&f);
		for (int k = 0; k < KEYS * width; k++) {
			(&value[0][0])[k] = rest[i / 5][k % width] +
				(k % width == changed ? 0.5f : 0.0f);
		}
		f.channel[1].track.path = path;
		f.channel[1].track.width = width;
		f.channel[1].track.value = value[0];
		optimize_keys_find_moved(&f.keys, moved[0]);
		assert_int_equal(moved[1][path], changed < width);
		end(&f);
	}
}

/* Weights have an effect of their own, and unknown nodes any. */
static void test_channels_of_idle_nodes_move_nothing(void **state)
{
	(void)state;
	for (int i = 0; i < 4; i++) {
		bool moved[CHANNELS][4] = {{false}}, idle = i == 0;
		struct optimize_reach_node own = reach;
		struct fixture f;

		begin(&f);
		own.idle = i < 2;
		bend(&f, 0, 7, 20);
		bend(&f, 1, 9, 33);
		f.channel[1].track.reach = i == 3 ? NULL : &own;
		f.channel[1].track.path =
			i == 1 ? MODEL_WEIGHTS : MODEL_TRANSLATION;
		memset(f.moved, true, sizeof(f.moved));
		optimize_keys_find_moved(&f.keys, moved[0]);
		assert_true(moved[0][MODEL_TRANSLATION]);
		assert_int_equal(moved[1][f.channel[1].track.path], !idle);
		choose(&f);
		assert_int_equal(f.channel[1].constant, idle);
		assert_int_equal(f.channel[1].kept_count,
			idle             ? 1
				: i == 3 ? KEYS
					 : 4);
		end(&f);
	}
}

/*
 * Of two channels at rest the first one keeps the end, unless the second stays
 * anyway and the first does not; or, where both or none do, ends there.
 */
static void test_the_best_channel_keeps_the_end(void **state)
{
	(void)state;
	for (int i = 0; i < 16; i++) {
		const int rank[2] = {i / 4, i % 4}; /* 2: stays, 1: at end */
		int pinned = rank[1] > rank[0] ? 1 : 0;
		struct fixture f;

		begin(&f);
		f.keys.count = 2;
		f.keys.end_s = 100.0f;
		for (int c = 0; c < 2; c++) {
			f.moved[c][MODEL_TRANSLATION] = rank[c] >= 2;
			if (rank[c] % 2) {
				f.time_s[c][KEYS - 1] = f.keys.end_s;
			}
		}
		choose(&f);
		for (int c = 0; c < 2; c++) {
			assert_int_equal(f.channel[c].ends, c == pinned);
			assert_int_equal(
				f.channel[c].kept_count, c == pinned ? 2 : 1);
			assert_int_equal(f.channel[c].dropped,
				c != pinned && rank[c] < 2);
		}
		end(&f);
	}
}

/* One key says when a clip ends, wherever it is; it cannot become two. */
static void test_a_single_key_keeps_the_end_alone(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	for (int c = 0; c < CHANNELS; c++) {
		f.channel[c].track.key_count = 1;
	}
	f.keys.end_s = f.time_s[2][0];
	choose(&f);
	for (int c = 0; c < CHANNELS; c++) {
		assert_int_equal(f.channel[c].ends, c == 2);
		expect_kept(&f, c, (const int[]){0}, 1);
	}
	end(&f);
}

/* Of a clip that is as short as may be, both keys stay. */
static void test_two_keys_keep_the_end_of_a_short_clip(void **state)
{
	static const float ends_s[] = {1e-3f, 0.5f, 1.0f, 2.0f};

	(void)state;
	for (int i = 0; i < 4; i++) {
		struct fixture f;

		begin(&f);
		f.keys.count = 1;
		f.channel[0].track.key_count = 2;
		f.time_s[0][1] = ends_s[i];
		f.keys.end_s = ends_s[i];
		choose(&f);
		assert_true(f.channel[0].ends);
		expect_kept(&f, 0, (const int[]){0, 1}, 2);
		end(&f);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_channels_keep_the_keys_that_suffice),
		cmocka_unit_test(test_a_channel_that_nothing_moves_is_dropped),
		cmocka_unit_test(test_an_animation_keeps_its_end),
		cmocka_unit_test(test_a_channel_that_moves_keeps_the_end),
		cmocka_unit_test(test_the_last_channel_stays_for_its_end),
		cmocka_unit_test(test_all_keys_are_kept_on_demand),
		cmocka_unit_test(test_a_channel_at_rest_moves_nothing),
		cmocka_unit_test(test_a_node_without_members_is_at_rest),
		cmocka_unit_test(test_channels_of_idle_nodes_move_nothing),
		cmocka_unit_test(test_the_best_channel_keeps_the_end),
		cmocka_unit_test(test_a_single_key_keeps_the_end_alone),
		cmocka_unit_test(test_two_keys_keep_the_end_of_a_short_clip),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
