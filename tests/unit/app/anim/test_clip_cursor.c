/*
 * What a cursor has room for, and cursors and poses that memory does not
 * suffice for.
 */
#include "app/anim/clip.h"
#include "app/anim/math/transform.h"
#include "platform/base/memory_budget.h"
#include "tests/support/test.h"

#include <errno.h>

enum {
	NODES = 2
};

/* The last clip is not the model's. */
static const struct model_clip CLIPS[4] = {{.channel_count = 7},
	{.channel_count = 90}, {.channel_count = 5}, {.channel_count = 99}};

static struct model make(struct model_node *node, int clip_count)
{
	static const float weights[2] = {0.5f, 0.25f};

	for (int i = 0; i < NODES; i++) {
		node[i] = (struct model_node){
			.parent = -1, .mesh = -1, .rest = transform_identity()};
	}
	return (struct model){.node_count = NODES,
		.node = node,
		.clip_count = clip_count,
		.clip = (struct model_clip *)CLIPS,
		.weight_count = 2,
		.rest_weights = (float *)weights};
}

static void test_a_cursor_has_room_for_each_clip_of_the_model(void **state)
{
	static const int most[] = {0, 7, 90, 90};

	(void)state;
	for (int count = 0; count <= 3; count++) {
		struct model_node node[NODES];
		struct model model = make(node, count);
		struct arena arena = arena_empty();
		struct clip_cursor cursor;

		assert_int_equal(clip_cursor_init(&cursor, &model, &arena), 0);
		assert_int_equal(cursor.channel_count, most[count]);
		arena_release(&arena);
	}
}

/* Each array has a block of its own, and those after a large one may fit. */
static void test_a_cursor_without_memory_for_an_array_is_refused(void **state)
{
	int refused = 0, made = 0;

	(void)state;
	for (size_t limit = 0; limit < 20000; limit += 64) {
		struct model_node node[NODES];
		struct model model = make(node, 3);
		struct memory_budget budget = {.limit_bytes = limit};
		struct arena arena = arena_within(&budget);
		struct clip_cursor cursor;
		int error;

		arena.block_bytes = 64;
		error = clip_cursor_init(&cursor, &model, &arena);
		if (error == 0) {
			assert_non_null(cursor.key);
			assert_non_null(cursor.turn);
			assert_non_null(cursor.moving);
			assert_non_null(cursor.part);
			assert_int_equal(cursor.still.node_count, NODES);
			made++;
		} else {
			assert_int_equal(error, -ENOMEM);
			refused++;
		}
		arena_release(&arena);
	}
	assert_true(refused > 10 && made > 10);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_cursor_has_room_for_each_clip_of_the_model),
		cmocka_unit_test(
			test_a_cursor_without_memory_for_an_array_is_refused),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
