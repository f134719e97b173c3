/* Vertices at one place, their triangles, and the limits of their numbers. */
#include "app/model/levels/simplify_mesh.h"

#include "app/model/levels/simplify_choose.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	SIDES_MAX = 65,
	VERTICES = 1 + 2 * SIDES_MAX
};

struct disc {
	float position[VERTICES][3], normal[VERTICES][3];
	int index_count;
	uint32_t index[9 * SIDES_MAX];
	bool shared[VERTICES];
	struct model_primitive primitive;
	struct simplify simplify;
};

static void begin(struct disc *disc, int vertex_count)
{
	const struct simplify_input input = {
		.primitive = &disc->primitive,
		.index = disc->index,
		.index_count = disc->index_count,
		.extent = 4.0f,
		.shared = disc->shared,
	};

	disc->primitive = (struct model_primitive){.vertex_count = vertex_count,
		.position = disc->position,
		.normal = disc->normal};
	assert_int_equal(simplify_begin(&disc->simplify, &input, NULL), 0);
}

static void add_triangle(struct disc *disc, uint32_t a, uint32_t b, uint32_t c)
{
	disc->index[disc->index_count++] = a;
	disc->index[disc->index_count++] = b;
	disc->index[disc->index_count++] = c;
}

/* A disc around the vertex 0, of one ring or of two. */
static void make_disc(struct disc *disc, int sides, int rings)
{
	memset(disc, 0, sizeof(*disc));
	for (int i = 0; i < sides; i++) {
		uint32_t own = 1 + (uint32_t)i;
		uint32_t next = 1 + (uint32_t)((i + 1) % sides);
		uint32_t far = own + (uint32_t)sides;
		uint32_t far_next = next + (uint32_t)sides;
		double step = 6.283185307 / sides;

		disc->position[own][0] = (float)cos(i * step);
		disc->position[own][1] = (float)sin(i * step);
		disc->position[far][0] = (float)(2 * cos((i - 0.5) * step));
		disc->position[far][1] = (float)(2 * sin((i - 0.5) * step));
		add_triangle(disc, 0, own, next);
		if (rings == 2) {
			add_triangle(disc, own, far, far_next);
			add_triangle(disc, own, far_next, next);
		}
	}
	begin(disc, 1 + rings * sides);
}

static void test_a_vertex_of_24_neighbours_is_the_largest_to_go(void **state)
{
	static struct disc disc;

	(void)state;
	for (int sides = 24; sides <= 25; sides++) {
		make_disc(&disc, sides, 1);
		assert_int_equal(simplify_choose_again(&disc.simplify, 0, 5),
			sides == 24);
		simplify_end(&disc.simplify);
	}
}

static void test_a_vertex_of_64_triangles_is_the_largest_to_go_to(void **state)
{
	static struct disc disc;

	(void)state;
	for (int sides = 64; sides <= 65; sides++) {
		make_disc(&disc, sides, 2);
		assert_int_equal(simplify_choose_again(&disc.simplify, 7, 0),
			sides == 64);
		simplify_end(&disc.simplify);
	}
}

/* A flat disc has no error, and the limit of no error allows that. */
static void test_an_error_of_the_limit_is_compared(void **state)
{
	static struct disc disc;

	(void)state;
	make_disc(&disc, 6, 1);
	simplify_choose(&disc.simplify, 0, 0.0f);
	assert_int_equal(disc.simplify.known[0], SIMPLIFY_BEST);
	assert_int_not_equal(disc.simplify.best[0].to, 0);
	assert_near(disc.simplify.best[0].error, 0, 0);
	simplify_end(&disc.simplify);
}

/*
 * Places in units of a cell of the grid, from the first vertex on: those that
 * round to the same number are one, along each axis.
 */
static void test_places_of_one_cell_are_one(void **state)
{
	static const struct {
		float cells;
		uint32_t leader;
	} place[] = {{0, 0}, {0.49f, 0}, {0.51f, 2}, {-0.49f, 0}, {1.49f, 2},
		{-0.51f, 5}, {-1.49f, 5}, {2, 7}, {0, 0}, {1, 2}, {-1, 5}};
	static struct disc disc;

	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		int count = (int)(sizeof(place) / sizeof(place[0]));
		uint32_t v = 0, length = 0;

		memset(&disc, 0, sizeof(disc));
		for (int i = 0; i < count; i++) {
			for (int j = 0; j < 3; j++) {
				disc.position[i][j] = 7.0f;
			}
			disc.position[i][axis] +=
				place[i].cells * 4.0f / 65536.0f;
		}
		begin(&disc, count);
		for (int i = 0; i < count; i++) {
			assert_int_equal(
				disc.simplify.leader[i], place[i].leader);
		}
		/* The four vertices of the first place are a ring. */
		do {
			v = disc.simplify.next[v];
			assert_int_equal(disc.simplify.leader[v], 0);
			length++;
		} while (v != 0 && length < 9);
		assert_int_equal(length, 4);
		assert_int_equal(disc.simplify.next[7], 7);
		simplify_end(&disc.simplify);
	}
}

/* Where any vertex of a place must stay, the place stays. */
static void test_a_place_stays_if_one_of_its_vertices_does(void **state)
{
	static struct disc disc;

	(void)state;
	for (int stays = 0; stays < 3; stays++) {
		memset(&disc, 0, sizeof(disc));
		disc.position[3][0] = 1.0f;
		disc.shared[stays] = true;
		begin(&disc, 4);
		assert_true(disc.simplify.locked[0]);
		assert_false(disc.simplify.locked[3]);
		simplify_end(&disc.simplify);
	}
}

/* Each vertex of a disc has its triangles, and others have none. */
static void test_triangles_are_listed_by_their_places(void **state)
{
	static struct disc disc;
	const struct simplify *simplify = &disc.simplify;
	uint32_t entries = 0;

	(void)state;
	make_disc(&disc, 5, 2);
	/* Again, since each pass lists them anew. */
	simplify_mesh_link(&disc.simplify);
	for (uint32_t v = 0; v < 11; v++) {
		uint32_t first = simplify->first_triangle[v], found = first;

		for (int i = 0; i < disc.index_count; i++) {
			if (disc.index[i] == v) {
				assert_int_equal(
					simplify->triangle[found++], i - i % 3);
			}
		}
		assert_int_equal(simplify->first_triangle[v + 1], found);
		entries += found - first;
	}
	assert_int_equal(simplify->first_triangle[0], 0);
	assert_int_equal(entries, disc.index_count);
	simplify_end(&disc.simplify);
}

static bool has_ring(const struct disc *disc, uint32_t place, int count,
	int borders, struct simplify_ring *ring)
{
	return simplify_mesh_ring(&disc->simplify, place, ring) &&
		ring->count == count && ring->border_count == borders;
}

static void test_a_ring_is_of_a_disc_or_half_a_disc(void **state)
{
	static struct disc disc;
	struct simplify_ring ring;

	(void)state;
	make_disc(&disc, 5, 2);
	assert_true(has_ring(&disc, 0, 5, 0, &ring));
	assert_true(has_ring(&disc, 3, 5, 0, &ring));
	assert_true(has_ring(&disc, 8, 4, 2, &ring));
	/* The edges along the rim are its borders. */
	for (int i = 0; i < 4; i++) {
		assert_int_equal(ring.border[i], ring.neighbour[i] > 5);
	}
	simplify_end(&disc.simplify);
	/* Two parts of a disc are none. */
	disc.index_count = 0;
	add_triangle(&disc, 0, 1, 2);
	add_triangle(&disc, 0, 2, 3);
	add_triangle(&disc, 0, 4, 5);
	begin(&disc, 11);
	assert_false(simplify_mesh_ring(&disc.simplify, 0, &ring));
	assert_true(has_ring(&disc, 2, 3, 2, &ring));
	simplify_end(&disc.simplify);
	/* A triangle that turns the other way has an edge a second time. */
	disc.index_count = 6;
	add_triangle(&disc, 0, 4, 3);
	begin(&disc, 11);
	assert_false(simplify_mesh_ring(&disc.simplify, 0, &ring));
	simplify_end(&disc.simplify);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_vertex_of_24_neighbours_is_the_largest_to_go),
		cmocka_unit_test(
			test_a_vertex_of_64_triangles_is_the_largest_to_go_to),
		cmocka_unit_test(test_an_error_of_the_limit_is_compared),
		cmocka_unit_test(test_places_of_one_cell_are_one),
		cmocka_unit_test(test_a_place_stays_if_one_of_its_vertices_does),
		cmocka_unit_test(test_triangles_are_listed_by_their_places),
		cmocka_unit_test(test_a_ring_is_of_a_disc_or_half_a_disc),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
