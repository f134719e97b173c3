/*
 * The bones that the tuner shakes, in random trees whose nodes have a point
 * each or none, against what the header says of them.
 */
#include "app/demo/tuner/tuner_bones.h"
#include "tests/support/model/bones.h"
#include "tests/support/model/small_model.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

struct tree {
	struct bones bones;
	struct model_primitive point;
	struct drawable drawable[BONES_MAX];
	struct instance instance;
	struct motions motions;
	struct tuner_bones tuner;
};

static void begin(struct tree *tree)
{
	*tree = (struct tree){.point = {.vertex_count = 1}};
	bones_begin(&tree->bones);
}

/* Adds a node, maybe with a point. */
static int add(struct tree *tree, int parent, bool has_point)
{
	int node = bones_add(&tree->bones, parent, 0.0f, 1.0f, 0.0f);

	tree->bones.node[node].name = "";
	tree->bones.node[node].skin = -1;
	if (has_point) {
		tree->drawable[tree->instance.drawable_count++] =
			(struct drawable){.node = node,
				.skin = -1,
				.primitive = &tree->point};
	}
	return node;
}

static void choose(struct tree *tree)
{
	tree->instance.model = &tree->bones.model;
	tree->instance.drawable = tree->drawable;
	tree->instance.arena = arena_empty();
	assert_int_equal(
		tuner_bones_init(&tree->tuner, &tree->instance, &tree->motions),
		0);
}

static void end(struct tree *tree)
{
	arena_release(&tree->instance.arena);
	bones_end(&tree->bones);
}

static bool is_below(const struct tree *tree, int node, int above)
{
	while (node >= 0 && node != above) {
		node = tree->bones.node[node].parent;
	}
	return node == above;
}

static bool moves(const struct tree *tree, int node)
{
	bool found = false;

	for (int d = 0; d < tree->instance.drawable_count; d++) {
		found = found || is_below(tree, tree->drawable[d].node, node);
	}
	return found;
}

/* How many steps a node lies below another one. */
static int steps_below(const struct tree *tree, int node, int above)
{
	int steps = 0;

	for (; node != above; node = tree->bones.node[node].parent) {
		steps++;
	}
	return steps;
}

static int length_of_limb(const struct tree *tree, int first)
{
	int longest = 0;

	for (int i = 0; i < tree->bones.model.node_count; i++) {
		if (moves(tree, i) && is_below(tree, i, first)) {
			int steps = steps_below(tree, i, first);

			longest = steps > longest ? steps : longest;
		}
	}
	return longest;
}

/* Bones branch where two of the same parent move vertices; roots are one too. */
static bool begins_limb(const struct tree *tree, int node)
{
	int others = 0;

	for (int i = 0; i < tree->bones.model.node_count; i++) {
		others += i != node && moves(tree, i) &&
			tree->bones.node[i].parent ==
				tree->bones.node[node].parent;
	}
	return moves(tree, node) && others > 0;
}

static int expected_limb(const struct tree *tree)
{
	int found = -1, first = -1;

	for (int i = 0; i < tree->bones.model.node_count; i++) {
		first = first < 0 && moves(tree, i) ? i : first;
		if (begins_limb(tree, i) &&
			(found < 0 ||
				length_of_limb(tree, i) >
					length_of_limb(tree, found))) {
			found = i;
		}
	}
	return found >= 0 ? found : first >= 0 ? first : 0;
}

static void check_levels(const struct tree *tree, const int *shaken, int count)
{
	int deepest = 0;

	for (int i = 0; i < tree->bones.model.node_count; i++) {
		int level = TUNER_OFF_CHAIN;

		for (int b = 0; b < count; b++) {
			int steps = is_below(tree, i, shaken[b])
				? steps_below(tree, i, shaken[b])
				: -1;

			/* The nearest one above counts. */
			level = steps >= 0 && (level < 0 || steps < level)
				? steps
				: level;
		}
		level = level > TUNER_LEVELS_MAX ? TUNER_LEVELS_MAX : level;
		assert_int_equal(tree->tuner.level[i], level);
		deepest = moves(tree, i) && level > deepest ? level : deepest;
	}
	assert_int_equal(tree->tuner.deepest, deepest);
}

static void check_steps(struct tree *tree, int step)
{
	int count = tree->bones.model.node_count;
	int at = step > 0 ? 0 : count - 1;

	for (; at >= 0 && at < count; at += step) {
		if (moves(tree, at)) {
			tuner_bones_step(&tree->tuner, step);
			assert_int_equal(tree->tuner.chosen, at);
			assert_int_equal(tree->tuner.count, 1);
			check_levels(tree, &at, 1);
		}
	}
	tuner_bones_step(&tree->tuner, step);
	assert_int_equal(tree->tuner.chosen, -1);
}

static void test_random_trees(void **state)
{
	uint32_t seed = 17;

	(void)state;
	for (int round = 0; round < 300; round++) {
		struct tree tree;
		int count = 1 + (int)(next_random(&seed) % BONES_MAX);

		begin(&tree);
		for (int i = 0; i < count; i++) {
			int parent =
				(int)(next_random(&seed) % ((uint32_t)i + 1)) -
				1;

			/* Long trees as well as wide ones. */
			parent = round % 2 && i > 0 && parent < i - 3 ? i - 1
								      : parent;
			add(&tree, parent, !random_one_in(&seed, 3));
		}
		choose(&tree);
		for (int i = 0; i < count; i++) {
			assert_int_equal(tree.tuner.moves[i], moves(&tree, i));
		}
		assert_int_equal(tree.tuner.count, 1);
		assert_int_equal(tree.tuner.node[0], expected_limb(&tree));
		check_levels(&tree, tree.tuner.node, 1);
		check_steps(&tree, 1);
		check_steps(&tree, -1);
		assert_int_equal(tree.tuner.node[0], expected_limb(&tree));
		end(&tree);
	}
}

static void test_the_levels_of_a_long_chain_end(void **state)
{
	struct tree tree;
	int first = 0;

	(void)state;
	begin(&tree);
	for (int i = 0; i < BONES_MAX; i++) {
		add(&tree, i - 1, true);
	}
	choose(&tree);
	check_levels(&tree, &first, 1);
	assert_int_equal(tree.tuner.deepest, TUNER_LEVELS_MAX);
	assert_int_equal(
		tree.tuner.level[TUNER_LEVELS_MAX - 1], TUNER_LEVELS_MAX - 1);
	end(&tree);
}

static void check_name(const struct tree *tree, const char *wanted)
{
	char text[40];

	tuner_bones_name(&tree->tuner, text, sizeof(text));
	assert_string_equal(text, wanted);
}

/* The character file's bones precede shoulders, and these a limb. */
static void test_named_bones(void **state)
{
	static const char *const names[] = {
		"", "shoulder.L", "hand", "shoulder.R", "tail"};
	struct tree tree;

	(void)state;
	for (int left_out = 0; left_out < 4; left_out++) {
		begin(&tree);
		for (int i = 0; i < 5; i++) {
			add(&tree, i == 2 ? 1 : i > 0 ? 0 : -1, true);
			tree.bones.node[i].name = names[i];
		}
		if (left_out == 1) {
			tree.bones.node[1].name = "arm";
		}
		if (left_out == 2) {
			tree.bones.node[1].name = tree.bones.node[3].name = "";
		}
		if (left_out == 3) {
			tree.motions.bone_count = 3;
			tree.motions.bone[0] = 4;
			tree.motions.bone[1] = 0;
			tree.motions.bone[2] = 2;
		}
		choose(&tree);
		check_levels(&tree,
			left_out == 0           ? (const int[]){1, 3}
				: left_out == 1 ? (const int[]){3}
				: left_out == 2 ? (const int[]){1}
						: (const int[]){4, 0, 2},
			left_out == 0           ? 2
				: left_out == 3 ? 3
						: 1);
		check_name(&tree,
			left_out == 0           ? "shoulder.L +1"
				: left_out == 1 ? "shoulder.R"
				: left_out == 2 ? "node 1"
						: "tail +2");
		end(&tree);
	}
	begin(&tree);
	choose(&tree);
	check_name(&tree, "none");
	end(&tree);
}

/* A model with an instance, and what its motions are. */
struct found {
	struct model *model;
	struct instance *instance;
	struct motions motions;
};

static void find(struct found *found, const char *path, const char *character)
{
	const struct character_request request = {
		.model_path = path,
		.file = character,
	};
	struct log log = log_to_stderr(LOG_WARNING);

	*found = (struct found){0};
	assert_int_equal(model_load(path, &log, &found->model), 0);
	found->instance = small_model_instance(found->model);
	assert_int_equal(
		motions_find(&request, found->instance, &log, &found->motions),
		0);
}

static void release(struct found *found)
{
	instance_destroy(found->instance);
	model_destroy(found->model);
}

/* Both shoulders first, then every bone that moves a vertex, and back. */
static void test_the_tuner_chooses_any_bone(void **state)
{
	struct tuner_bones bones;
	struct found found;
	char name[64];
	int count = 0;

	(void)state;
	find(&found, "assets/walker.glb", "none");
	assert_int_equal(
		tuner_bones_init(&bones, found.instance, &found.motions), 0);
	assert_int_equal(bones.count, 2);
	tuner_bones_name(&bones, name, sizeof(name));
	assert_string_equal(name, "shoulder.L +1");
	do {
		tuner_bones_step(&bones, 1);
		count++;
		assert_true(bones.chosen < 0 || bones.moves[bones.chosen]);
		assert_true(bones.chosen < 0 || bones.level[bones.chosen] == 0);
	} while (bones.chosen >= 0);
	assert_true(count > 20);
	assert_true(count <= found.model->node_count + 1);
	assert_int_equal(bones.count, 2);
	tuner_bones_step(&bones, -1);
	assert_int_equal(bones.count, 1);
	assert_true(bones.chosen >= 0);
	release(&found);
}

/* The arm of a robot without a character file. */
static void test_the_tuner_begins_with_the_longest_limb(void **state)
{
	struct tuner_bones bones;
	struct found found;
	char name[64];

	(void)state;
	find(&found, "assets/arm.glb", "none");
	assert_int_equal(
		tuner_bones_init(&bones, found.instance, &found.motions), 0);
	tuner_bones_name(&bones, name, sizeof(name));
	assert_string_equal(name, "Arm");
	assert_true(bones.deepest >= 2);
	release(&found);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_random_trees),
		cmocka_unit_test(test_the_levels_of_a_long_chain_end),
		cmocka_unit_test(test_named_bones),
		cmocka_unit_test(test_the_tuner_chooses_any_bone),
		cmocka_unit_test(test_the_tuner_begins_with_the_longest_limb),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
