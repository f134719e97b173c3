/* Shadow proxies. */
#include "app/scene/shadow/shadow_proxy.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	SIDE = 100, /* vertices of a net in the xy plane, facing z */
	COUNT = SIDE * SIDE,
	INDICES = (SIDE - 1) * (SIDE - 1) * 6,
};

struct net {
	float position[COUNT][3], normal[COUNT][3];
	uint32_t index[INDICES];
	uint16_t joint[COUNT];
	float weight[COUNT];
	struct model_primitive primitive;
	struct arena arena;
};

static struct net *make_net(void)
{
	struct net *net = calloc(1, sizeof(*net));
	uint32_t *next;

	assert_non_null(net);
	for (int i = 0; i < COUNT; i++) {
		net->position[i][0] = (float)(i % SIDE);
		net->position[i][1] = (float)(i / SIDE);
		net->normal[i][2] = 1.0f;
		net->weight[i] = 1.0f;
	}
	next = net->index;
	for (uint32_t i = 0; i < COUNT - SIDE; i++) {
		if (i % SIDE != SIDE - 1) {
			const uint32_t corner[6] = {i, i + 1, i + SIDE,
				i + SIDE, i + 1, i + SIDE + 1};

			memcpy(next, corner, sizeof(corner));
			next += 6;
		}
	}
	net->primitive = (struct model_primitive){
		.vertex_count = COUNT,
		.position = net->position,
		.normal = net->normal,
		.influences = 1,
		.joint = net->joint,
		.weight = net->weight,
		.index_count = INDICES,
		.index = net->index,
	};
	return net;
}

static void free_net(struct net *net)
{
	arena_release(&net->arena);
	free(net);
}

static void test_a_fine_net_loses_most_triangles_and_keeps_its_border(
	void **state)
{
	struct net *net = make_net();
	float low = 1e9f, high = -1e9f;
	uint16_t *index;
	int count;

	(void)state;
	assert_int_equal(shadow_proxy_make(&net->primitive, NULL, &net->arena,
				 &index, &count),
		0);
	assert_true(count > 0 && count < INDICES / 2);
	assert_int_equal(count % 3, 0);
	for (int i = 0; i < count; i++) {
		const float *p = net->position[index[i]];

		assert_true(index[i] < COUNT);
		assert_true(index[i] != index[i / 3 * 3 + (i + 1) % 3]);
		low = p[0] < low ? p[0] : low;
		high = p[0] > high ? p[0] : high;
	}
	/* A cell is SIDE / 40 wide. */
	assert_true(low <= 3.0f && high >= (float)SIDE - 4.0f);
	free_net(net);
}

/* Vertices with different joints are not merged. */
static void test_joints_stay_apart(void **state)
{
	struct net *net = make_net();
	uint16_t *index;
	int count;

	(void)state;
	for (int i = 0; i < COUNT; i++) {
		net->joint[i] = (uint16_t)i;
	}
	assert_int_equal(shadow_proxy_make(&net->primitive, NULL, &net->arena,
				 &index, &count),
		0);
	assert_int_equal(count, INDICES);
	for (int i = 0; i < count; i++) {
		assert_int_equal(index[i], net->index[i]);
	}
	free_net(net);
}

static void test_vertices_are_named_where_they_are_drawn_from(void **state)
{
	struct net *net = make_net();
	uint32_t place[COUNT];
	uint16_t *here, *there;
	int count, moved;

	(void)state;
	for (uint32_t i = 0; i < COUNT; i++) {
		place[i] = COUNT - 1 - i;
	}
	assert_int_equal(shadow_proxy_make(&net->primitive, NULL, &net->arena,
				 &here, &count),
		0);
	assert_int_equal(shadow_proxy_make(&net->primitive, place, &net->arena,
				 &there, &moved),
		0);
	assert_int_equal(count, moved);
	for (int i = 0; i < count; i++) {
		assert_int_equal(there[i], COUNT - 1 - here[i]);
	}
	free_net(net);
}

/*
 * A box that is thinner than a cell, with hard edges: four vertices a side. No
 * triangle may get lost, or the shadow would be in pieces.
 */
static void test_a_thin_box_with_hard_edges_stays_closed(void **state)
{
	float position[24][3], normal[24][3] = {{0}};
	uint32_t index[36];
	struct model_primitive primitive = {.vertex_count = 24,
		.position = position,
		.normal = normal,
		.index_count = 36,
		.index = index};
	struct arena arena = arena_empty();
	uint16_t *kept;
	int count;

	(void)state;
	for (int i = 0; i < 24; i++) {
		static const float size[3] = {0.015f, 1.0f, 0.015f};
		static const uint32_t corner[6] = {0, 1, 2, 2, 1, 3};
		int axis = i / 8, side = i / 4 % 2;
		bool on[3];

		on[axis] = side;
		on[(axis + 1) % 3] = i & 1;
		on[(axis + 2) % 3] = i >> 1 & 1;
		for (int k = 0; k < 3; k++) {
			position[i][k] = on[k] ? size[k] : 0.0f;
		}
		normal[i][axis] = side ? 1.0f : -1.0f;
		for (int k = 0; i % 4 == 0 && k < 6; k++) {
			index[i / 4 * 6 + k] = (uint32_t)i + corner[k];
		}
	}
	assert_int_equal(
		shadow_proxy_make(&primitive, NULL, &arena, &kept, &count), 0);
	assert_int_equal(count, 36);
	arena_release(&arena);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_fine_net_loses_most_triangles_and_keeps_its_border),
		cmocka_unit_test(test_joints_stay_apart),
		cmocka_unit_test(
			test_vertices_are_named_where_they_are_drawn_from),
		cmocka_unit_test(test_a_thin_box_with_hard_edges_stays_closed),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
