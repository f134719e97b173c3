#include "app/anim/skin.h"
#include "platform/base/memory_budget.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>

enum {
	VERTICES = 4,
	WIDTH = 4
};

static float POSITION[VERTICES][3] = {
	{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}};
static float NORMAL[VERTICES][3] = {
	{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6f, 0.8f, 0}};
static uint16_t JOINT[VERTICES * WIDTH] = {
	3, 1, 2, 0, /* unsorted */
	5, 0, 0, 0, /* one */
	9, 8, 7, 6, /* nothing at all */
	2, 4, 6, 8, /* all equal */
};
static float WEIGHT[VERTICES * WIDTH] = {
	0.25f,
	0,
	0.625f,
	0.125f,
	1,
	0,
	0,
	0,
	0,
	0,
	0,
	0,
	0.25f,
	0.25f,
	0.25f,
	0.25f,
};

static struct model_primitive make_primitive(void)
{
	return (struct model_primitive){.vertex_count = VERTICES,
		.position = POSITION,
		.normal = NORMAL,
		.influences = WIDTH,
		.joint = JOINT,
		.weight = WEIGHT};
}

static void set_up(struct skin_stream *stream, struct arena *arena)
{
	struct model_primitive primitive = make_primitive();

	*arena = arena_empty();
	assert_int_equal(skin_stream_init(stream, &primitive, 1, arena), 0);
}

static void assert_influence(const struct skin_stream *stream, int index,
	int joint, double weight, int to_next)
{
	const struct joint_weight *influence = &stream->influence[index];

	assert_int_equal(influence->joint_offset, joint * 64);
	assert_near(influence->weight, weight, 0);
	assert_int_equal(influence->next_vertex_offset,
		to_next * (int)sizeof(struct joint_weight));
}

static void test_influences_are_sorted_by_decreasing_weight(void **state)
{
	struct skin_stream stream;
	struct arena arena;

	(void)state;
	set_up(&stream, &arena);
	assert_influence(&stream, 0, 2, 0.625, 3);
	assert_influence(&stream, 1, 3, 0.25, 2);
	assert_influence(&stream, 2, 0, 0.125, 1);
	assert_influence(&stream, 3, 5, 1, 1);
	arena_release(&arena);
}

static void test_equal_weights_keep_the_files_order(void **state)
{
	struct skin_stream stream;
	struct arena arena;

	(void)state;
	set_up(&stream, &arena);
	for (int i = 0; i < 4; i++) {
		assert_influence(&stream, 5 + i, 2 + 2 * i, 0.25, 4 - i);
	}
	arena_release(&arena);
}

static void test_pitfall_12_no_weight_at_all_holds_to_the_first(void **state)
{
	struct skin_stream stream;
	struct arena arena;

	(void)state;
	set_up(&stream, &arena);
	assert_influence(&stream, 4, 9, 1, 1);
	assert_near(stream.position[4][2], 9, 0);
	arena_release(&arena);
}

static void test_pitfall_12_bad_weights_are_left_out(void **state)
{
	uint16_t joint[8] = {1, 2, 3, 4, 5, 6, 7, 8};
	float weight[8] = {-1, 0.5f, NAN, 0.25f, 0, 0.125f, 0.125f, -0.0f};
	struct model_primitive primitive = make_primitive();
	struct skin_stream stream;
	struct arena arena = arena_empty();

	(void)state;
	primitive.vertex_count = 1;
	primitive.influences = 8;
	primitive.joint = joint;
	primitive.weight = weight;
	assert_int_equal(skin_stream_init(&stream, &primitive, 1, &arena), 0);
	assert_int_equal(stream.influence_count, 4);
	assert_influence(&stream, 0, 2, 0.5, 4);
	assert_influence(&stream, 1, 4, 0.25, 3);
	assert_influence(&stream, 2, 6, 0.125, 2);
	assert_influence(&stream, 3, 7, 0.125, 1);
	arena_release(&arena);
}

static void test_counts_and_bytes_tell_the_streams_size(void **state)
{
	struct skin_stream stream;
	struct arena arena;

	(void)state;
	set_up(&stream, &arena);
	assert_int_equal(stream.vertex_count, 4);
	assert_int_equal(stream.influence_count, 9);
	assert_int_equal(stream.max_influences, 4);
	assert_int_equal(skin_stream_bytes(&stream), 9 * (12 + 16 + 16));
	arena_release(&arena);
}

static void test_knows_how_many_influences_each_cap_leaves(void **state)
{
	struct skin_stream stream;
	struct arena arena;

	(void)state;
	/* 3, 1, 1 and 4 influences. */
	set_up(&stream, &arena);
	assert_int_equal(stream.capped[1], 4);
	assert_int_equal(stream.capped[2], 6);
	assert_int_equal(stream.capped[3], 8);
	assert_int_equal(stream.capped[4], 9);
	assert_int_equal(stream.capped[SKIN_INFLUENCES_MAX], 9);
	arena_release(&arena);
}

static void test_base_vectors_are_multiplied_by_their_weight(void **state)
{
	struct skin_stream stream;
	struct arena arena;
	const float want[4] = {0.625f, 1.25f, 1.875f, 0.625f};
	const float want_normal[4] = {0.15f, 0.2f, 0, 0};

	(void)state;
	set_up(&stream, &arena);
	assert_all_near(stream.position[0], want, 4, 1e-6);
	assert_all_near(stream.normal[8], want_normal, 4, 1e-6);
	arena_release(&arena);
}

static void test_next_vertex_offsets_lead_through_all_vertices(void **state)
{
	struct skin_stream stream;
	struct arena arena;
	const char *at;
	const char *end;
	int vertices = 0;

	(void)state;
	set_up(&stream, &arena);
	at = (const char *)stream.influence;
	end = (const char *)(stream.influence + stream.influence_count);
	while (at < end) {
		at += ((const struct joint_weight *)at)->next_vertex_offset;
		vertices++;
	}
	assert_ptr_equal(at, end);
	assert_int_equal(vertices, VERTICES);
	arena_release(&arena);
}

static void test_position_scale_leaves_the_weight_alone(void **state)
{
	struct model_primitive primitive = make_primitive();
	struct skin_stream stream;
	struct arena arena = arena_empty();
	const float want[4] = {400, 500, 600, 1};

	(void)state;
	assert_int_equal(skin_stream_init(&stream, &primitive, 100, &arena), 0);
	assert_all_near(stream.position[3], want, 4, 1e-3);
	arena_release(&arena);
}

static void test_primitives_without_normals_have_none(void **state)
{
	struct model_primitive primitive = make_primitive();
	struct skin_stream stream;
	struct arena arena = arena_empty();

	(void)state;
	primitive.normal = NULL;
	assert_int_equal(skin_stream_init(&stream, &primitive, 1, &arena), 0);
	assert_null(stream.normal);
	assert_int_equal(skin_stream_bytes(&stream), 9 * (12 + 16));
	skin_stream_rebase(&stream, (const float(*)[3])POSITION,
		(const float(*)[3])NORMAL, 1);
	arena_release(&arena);
}

static void test_rebase_takes_a_morphed_shape(void **state)
{
	struct skin_stream stream;
	struct arena arena;
	float moved[VERTICES][3] = {{8, 0, 0}, {0, 8, 0}, {0, 0, 8}, {8, 8, 8}};
	const float want[4] = {2, 0, 0, 0.25f};
	const float same[4] = {0.625f, 0, 0, 0};

	(void)state;
	set_up(&stream, &arena);
	skin_stream_rebase(&stream, (const float(*)[3])moved, NULL, 1);
	assert_all_near(stream.position[1], want, 4, 1e-6);
	assert_all_near(stream.normal[0], same, 4, 1e-6);
	arena_release(&arena);
}

static void test_no_vertices_make_an_empty_stream(void **state)
{
	struct model_primitive primitive = {.influences = 4};
	struct skin_stream stream;
	struct arena arena = arena_empty();

	(void)state;
	assert_int_equal(skin_stream_init(&stream, &primitive, 1, &arena), 0);
	assert_int_equal(stream.influence_count, 0);
	assert_int_equal(skin_stream_bytes(&stream), 0);
	arena_release(&arena);
}

static void test_tangents_are_multiplied_by_their_weight(void **state)
{
	static float tangent[VERTICES][4] = {
		{8, 16, 24, 1}, {2, 3, 4, 1}, {5, 6, 7, -1}, {4, -8, 12, -1}};
	static const float first[4] = {5, 10, 15, 0}, middle[4] = {5, 6, 7, 0};
	static const float last[4] = {1, -2, 3, 0};
	struct model_primitive primitive = make_primitive();
	struct skin_stream stream;
	struct arena arena;

	(void)state;
	set_up(&stream, &arena);
	assert_int_equal(
		skin_stream_add_tangents(&stream, &primitive, &arena), -EINVAL);
	primitive.tangent = tangent;
	assert_int_equal(
		skin_stream_add_tangents(&stream, &primitive, &arena), 0);
	assert_all_near(stream.tangent[0], first, 4, 0);
	assert_all_near(stream.tangent[4], middle, 4, 0);
	assert_all_near(stream.tangent[8], last, 4, 0);
	assert_int_equal(skin_stream_bytes(&stream), 9 * (12 + 3 * 16));
	arena_release(&arena);
}

static void test_influences_beyond_the_most_are_left_out(void **state)
{
	uint16_t joint[SKIN_INFLUENCES_MAX + 1] = {0};
	float weight[SKIN_INFLUENCES_MAX + 1];
	struct model_primitive primitive = make_primitive();
	struct skin_influence out[SKIN_INFLUENCES_MAX + 1];

	(void)state;
	for (int i = 0; i <= SKIN_INFLUENCES_MAX; i++) {
		weight[i] = 0.125f;
	}
	primitive.joint = joint;
	primitive.weight = weight;
	for (int more = -1; more <= 1; more++) {
		primitive.influences = SKIN_INFLUENCES_MAX + more;
		assert_int_equal(skin_gather_influences(&primitive, 0, out),
			SKIN_INFLUENCES_MAX + (more < 0 ? more : 0));
	}
}

static void test_a_stream_without_memory_is_refused(void **state)
{
	int refused = 0, made = 0;

	(void)state;
	for (size_t limit = 0; limit < 1000; limit += 8) {
		struct model_primitive primitive = make_primitive();
		struct memory_budget budget = {.limit_bytes = limit};
		struct arena arena = arena_within(&budget);
		struct skin_stream stream;
		int error;

		arena.block_bytes = 16;
		error = skin_stream_init(&stream, &primitive, 1, &arena);
		assert_true(error == 0 || error == -ENOMEM);
		refused += error != 0;
		made += error == 0;
		arena_release(&arena);
	}
	assert_true(refused > 0 && made > 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_influences_are_sorted_by_decreasing_weight),
		cmocka_unit_test(test_equal_weights_keep_the_files_order),
		cmocka_unit_test(
			test_pitfall_12_no_weight_at_all_holds_to_the_first),
		cmocka_unit_test(test_pitfall_12_bad_weights_are_left_out),
		cmocka_unit_test(test_counts_and_bytes_tell_the_streams_size),
		cmocka_unit_test(test_knows_how_many_influences_each_cap_leaves),
		cmocka_unit_test(
			test_base_vectors_are_multiplied_by_their_weight),
		cmocka_unit_test(
			test_next_vertex_offsets_lead_through_all_vertices),
		cmocka_unit_test(test_position_scale_leaves_the_weight_alone),
		cmocka_unit_test(test_primitives_without_normals_have_none),
		cmocka_unit_test(test_rebase_takes_a_morphed_shape),
		cmocka_unit_test(test_no_vertices_make_an_empty_stream),
		cmocka_unit_test(test_tangents_are_multiplied_by_their_weight),
		cmocka_unit_test(test_influences_beyond_the_most_are_left_out),
		cmocka_unit_test(test_a_stream_without_memory_is_refused),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
