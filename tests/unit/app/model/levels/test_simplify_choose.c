/* Where a vertex may go, and where it goes, against plain definitions. */
#include "app/model/levels/simplify_choose.h"

#include "app/model/levels/simplify_attributes.h"
#include "app/model/levels/simplify_error.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum {
	SIDE = 5,
	PLACES = SIDE * SIDE,
	COPIES = 3,
	VERTICES = PLACES * COPIES,
	INDICES_MAX = 3 * 64,
	CASES = 80
};

/* Vertices v, v + PLACES and v + 2 PLACES of the net are at one place. */
struct net {
	float position[VERTICES][3], normal[VERTICES][3];
	uint8_t color[VERTICES][4];
	int index_count;
	uint32_t index[INDICES_MAX];
	bool shared[VERTICES];
	struct model_primitive primitive;
	struct simplify simplify;
};

static void begin(struct net *net)
{
	const struct simplify_input input = {
		.primitive = &net->primitive,
		.index = net->index,
		.index_count = net->index_count,
		.extent = 4.0f,
		.shared = net->shared,
	};

	net->primitive = (struct model_primitive){.vertex_count = VERTICES,
		.position = net->position,
		.normal = net->normal,
		.color = net->color};
	assert_int_equal(simplify_begin(&net->simplify, &input, NULL), 0);
}

static void add_triangle(struct net *net, uint32_t a, uint32_t b, uint32_t c)
{
	/* Triangles begin at any of their corners. */
	const uint32_t corner[3] = {a, b, c};

	for (int i = 0; i < 3; i++) {
		net->index[net->index_count + i] =
			corner[(i + net->index_count / 3) % 3];
	}
	net->index_count += 3;
}

static float random_part(uint32_t *seed, float most)
{
	return most * (float)random_within(seed, 10000) / 10000.0f;
}

/* The copy of a place that a triangle uses: a seam, and some exceptions. */
static uint32_t copy_of(uint32_t *seed, int place, int column, int odd)
{
	int copy = column < SIDE / 2;

	if (random_one_in(seed, odd)) {
		copy = random_between(seed, 0, COPIES - 1);
	}
	return (uint32_t)(place + PLACES * copy);
}

static void reverse_triangles(struct net *net)
{
	for (int a = 0, b = net->index_count - 3; a < b; a += 3, b -= 3) {
		for (int i = 0; i < 3; i++) {
			uint32_t own = net->index[a + i];

			net->index[a + i] = net->index[b + i];
			net->index[b + i] = own;
		}
	}
}

/*
 * A net with hills, holes and a seam; the more even, the fewer exceptions. A
 * flat one has places at halves, and triangles without an area.
 */
static void draw_net(struct net *net, uint32_t *seed, bool flat)
{
	int odd = random_between(seed, 5, 100);
	int upright = random_between(seed, 0, 2);
	float rough = 0.1f * (float)random_between(seed, 1, 9);

	memset(net, 0, sizeof(*net));
	for (int v = 0; v < VERTICES; v++) {
		float *p = net->position[v];

		for (int i = 0; i < 3; i++) {
			net->normal[v][i] = random_part(seed, 2.0f);
			p[i] = v >= PLACES ? net->position[v - PLACES][i]
				: !flat    ? random_part(seed, rough)
				: i == upright
				? 0.0f
				: 0.5f * (float)random_between(seed, 0, 1);
		}
		p[(upright + 1) % 3] += v < PLACES ? (float)(v % SIDE) : 0.0f;
		p[(upright + 2) % 3] += v < PLACES ? (float)(v / SIDE) : 0.0f;
		net->color[v][0] = (uint8_t)random_between(seed, 0, 255);
	}
	for (int i = 0; i < (SIDE - 1) * (SIDE - 1) * 2; i++) {
		int column = i / 2 % (SIDE - 1), upper = i % 2;
		int from = i / 2 / (SIDE - 1) * SIDE + column;
		int a = upper ? from + SIDE : from, b = from + 1;
		int c = upper ? from + SIDE + 1 : from + SIDE;
		bool turned = random_one_in(seed, odd);

		if (!random_one_in(seed, odd)) {
			add_triangle(net, copy_of(seed, a, column, odd),
				copy_of(seed, turned ? c : b, column, odd),
				copy_of(seed, turned ? b : c, column, odd));
			/* Some are there twice. */
			i -= random_one_in(seed, 4 * odd);
		}
	}
	if (random_one_in(seed, 2)) {
		reverse_triangles(net);
	}
	begin(net);
	net->simplify.divided = random_one_in(seed, 2);
}

/* A triangle's corner at a place, or -1. */
static int corner_at(const uint32_t *at, uint32_t place)
{
	for (int i = 0; i < 3; i++) {
		if (at[i] % PLACES == place) {
			return i;
		}
	}
	return -1;
}

/* The number of triangles with an edge from one place to another. */
static int count_edges(const struct net *net, uint32_t from, uint32_t to)
{
	int count = 0;

	for (int t = 0; t < net->index_count; t += 3) {
		int corner = corner_at(net->index + t, from);

		count += corner >= 0 &&
			net->index[t + (corner + 1) % 3] % PLACES == to;
	}
	return count;
}

static bool touch(const struct net *net, uint32_t a, uint32_t b)
{
	return count_edges(net, a, b) + count_edges(net, b, a) > 0;
}

static bool is_border(const struct net *net, uint32_t a, uint32_t b)
{
	return count_edges(net, a, b) + count_edges(net, b, a) == 1;
}

/* Whether the triangles at a place are a disc, or half of one. */
static bool is_disc(const struct net *net, uint32_t place, bool *half)
{
	int triangles = 0, edges = 0, borders = 0;

	for (int t = 0; t < net->index_count; t += 3) {
		triangles += corner_at(net->index + t, place) >= 0;
	}
	for (uint32_t i = 0; i < PLACES; i++) {
		if (count_edges(net, place, i) > 1 ||
			count_edges(net, i, place) > 1) {
			return false;
		}
		edges += touch(net, place, i);
		borders += is_border(net, place, i);
	}
	*half = borders == 2;
	return triangles > 0 &&
		((borders == 0 && edges == triangles) ||
			(borders == 2 && edges == triangles + 1));
}

/* Edges of a place between triangles with different vertices of it. */
static int count_seams(const struct net *net, uint32_t place)
{
	int count = 0;

	for (int t = 0; t < net->index_count; t += 3) {
		for (int s = 0; s < net->index_count; s += 3) {
			const uint32_t *a = net->index + t, *b = net->index + s;
			int i = corner_at(a, place), j = corner_at(b, place);

			count += i >= 0 && j >= 0 && a[i] != b[j] &&
				a[(i + 1) % 3] % PLACES ==
					b[(j + 2) % 3] % PLACES;
		}
	}
	return count;
}

static void plane_of(const struct net *net, uint32_t a, uint32_t b, uint32_t c,
	double out[3])
{
	const float *p = net->position[a], *q = net->position[b];
	const float *r = net->position[c];

	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;

		out[i] = ((double)q[j] - (double)p[j]) *
				((double)r[k] - (double)p[k]) -
			((double)q[k] - (double)p[k]) *
				((double)r[j] - (double)p[j]);
	}
}

static double dot(const double a[3], const double b[3])
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Whether a triangle turns by more than the angle of a cosine of a quarter. */
static bool turns(const struct net *net, uint32_t from, uint32_t to)
{
	for (int t = 0; t < net->index_count; t += 3) {
		const uint32_t *at = net->index + t;
		int corner = corner_at(at, from);
		uint32_t b, c;
		double old[3], new[3];

		if (corner < 0) {
			continue;
		}
		b = net->simplify.to[at[(corner + 1) % 3]] % PLACES;
		c = net->simplify.to[at[(corner + 2) % 3]] % PLACES;
		if (b == to || c == to || b == c || b == from || c == from) {
			continue;
		}
		plane_of(net, from, b, c, old);
		plane_of(net, to, b, c, new);
		if (dot(old, old) > 0 &&
			dot(old, new) <=
				0.25 * sqrt(dot(old, old) * dot(new, new))) {
			return true;
		}
	}
	return false;
}

/* Sets what each used vertex becomes, if that is one vertex of the other place. */
static bool pair(const struct net *net, uint32_t from, uint32_t to,
	uint32_t becomes[VERTICES])
{
	bool used[COPIES] = {false}, paired[COPIES] = {false};

	for (uint32_t v = 0; v < VERTICES; v++) {
		becomes[v] = v;
	}
	for (int t = 0; t < net->index_count; t += 3) {
		const uint32_t *at = net->index + t;
		int own = corner_at(at, from), other = corner_at(at, to);

		if (own < 0) {
			continue;
		}
		used[at[own] / PLACES] = true;
		if (other < 0) {
			continue;
		}
		if (paired[at[own] / PLACES] && becomes[at[own]] != at[other]) {
			return false;
		}
		paired[at[own] / PLACES] = true;
		becomes[at[own]] = at[other];
	}
	for (int i = 0; i < COPIES; i++) {
		if (used[i] && !paired[i]) {
			return false;
		}
	}
	return true;
}

static bool is_allowed(const struct net *net, uint32_t from, uint32_t to,
	uint32_t becomes[VERTICES])
{
	int common = 0;
	bool half;

	for (uint32_t i = 0; i < PLACES; i++) {
		common += touch(net, from, i) && touch(net, to, i);
	}
	return touch(net, from, to) && is_disc(net, from, &half) &&
		(!half || is_border(net, from, to)) &&
		common == (half ? 1 : 2) && !turns(net, from, to) &&
		(!net->simplify.divided || count_seams(net, from) <= 2) &&
		pair(net, from, to, becomes);
}

/* The error of a collapse, or FLT_MAX. Borders count three times. */
static float measure(struct net *net, uint32_t from, uint32_t to, float shape)
{
	struct simplify *simplify = &net->simplify;
	uint32_t becomes[VERTICES];
	float error;

	if (!is_allowed(net, from, to, becomes)) {
		return FLT_MAX;
	}
	for (uint32_t v = from; v < VERTICES; v += PLACES) {
		simplify->to[v] = becomes[v];
	}
	error = simplify_error_of_attributes(simplify, from, to);
	for (uint32_t v = from; v < VERTICES; v += PLACES) {
		simplify->to[v] = v;
	}
	return hypotf(shape, error);
}

static float shape_of(
	const struct net *net, uint32_t from, uint32_t to, bool half)
{
	return simplify_error_of_shape(&net->simplify, from, to) *
		(half ? 3.0f : 1.0f);
}

/* The nearest three neighbours by shape, of which the least error counts. */
static struct simplify_collapse find_best(
	struct net *net, uint32_t from, float limit, uint8_t *known)
{
	struct simplify_collapse best = {from, from, FLT_MAX};
	bool tried[PLACES] = {false}, half;

	*known = SIMPLIFY_BEST;
	if (!is_disc(net, from, &half)) {
		return best;
	}
	for (int try = 0; try < 3; try++) {
		float least = FLT_MAX, error;
		uint32_t nearest = PLACES;

		for (uint32_t i = 0; i < PLACES; i++) {
			float shape = shape_of(net, from, i, half);

			if (shape < least && !tried[i] && touch(net, from, i) &&
				(!half || is_border(net, from, i))) {
				least = shape;
				nearest = i;
			}
		}
		if (nearest == PLACES) {
			return best;
		}
		if (try == 0 && least > limit) {
			*known = SIMPLIFY_BOUND;
			return (struct simplify_collapse){from, nearest, least};
		}
		tried[nearest] = true;
		error = measure(net, from, nearest, least);
		if (error < best.error) {
			best = (struct simplify_collapse){from, nearest, error};
		}
	}
	return best;
}

/* The edges of a triangle alone have the same error, and either may be chosen. */
static void check_choice(struct net *net, uint32_t from, float limit)
{
	const struct simplify_collapse *own = &net->simplify.best[from];
	uint8_t known;
	struct simplify_collapse best = find_best(net, from, limit, &known);
	float error = best.error;

	simplify_choose(&net->simplify, from, limit);
	assert_int_equal(net->simplify.known[from], known);
	assert_int_equal(own->from, from);
	assert_int_equal(own->to == from, best.to == from);
	if (own->to != best.to) {
		bool half = is_border(net, from, own->to);

		error = shape_of(net, from, own->to, half);
		error = known == SIMPLIFY_BEST
			? measure(net, from, own->to, error)
			: error;
		assert_near(error, best.error, 1e-6);
	}
	assert_near(own->error, error, 1e-6 * (double)error);
}

static void test_the_least_error_of_the_nearest_three_is_chosen(void **state)
{
	static struct net net;
	uint32_t seed = 3;

	(void)state;
	for (int i = 0; i < RANDOM_CASES(CASES); i++) {
		float limit = 0.01f * (float)random_between(&seed, 1, 30);

		draw_net(&net, &seed, false);
		for (uint32_t v = 0; v < PLACES; v++) {
			check_choice(&net, v, limit);
		}
		for (uint32_t v = 0; v < VERTICES; v++) {
			assert_int_equal(net.simplify.to[v], v);
		}
		simplify_end(&net.simplify);
	}
}

/* Those done before in the pass have moved corners of the triangles. */
static void test_what_is_allowed_follows_what_has_collapsed(void **state)
{
	static const int step[6] = {1, PLACES - 1, SIDE, PLACES - SIDE,
		SIDE - 1, PLACES - SIDE + 1};
	static struct net net;
	uint32_t seed = 11;
	int done = 0;

	(void)state;
	for (int i = 0; i < RANDOM_CASES(CASES); i++) {
		bool touched[PLACES] = {false};

		draw_net(&net, &seed, i % 2 == 0);
		for (int try = 0; try < 120; try++) {
			uint32_t becomes[VERTICES];
			uint32_t from = next_random(&seed) % PLACES;
			uint32_t to = (from + (uint32_t)step[try % 6]) % PLACES;
			bool allowed;

			if (from == to || touched[from] || touched[to]) {
				continue;
			}
			allowed = is_allowed(&net, from, to, becomes);
			assert_int_equal(
				simplify_choose_again(&net.simplify, from, to),
				allowed);
			for (uint32_t v = from; v < VERTICES; v += PLACES) {
				assert_int_equal(net.simplify.to[v],
					allowed ? becomes[v] : v);
			}
			touched[from] = touched[to] = allowed;
			done += allowed;
		}
		simplify_end(&net.simplify);
	}
	assert_true(done > RANDOM_CASES(CASES));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_the_least_error_of_the_nearest_three_is_chosen),
		cmocka_unit_test(test_what_is_allowed_follows_what_has_collapsed),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
