/*
 * Compares the fixed-point loops in C with sums in 64 bits, and those of all
 * other kernels with the C, bit for bit.
 */
#include "app/anim/kernel/fixed.h"
#include "app/anim/kernel/kernel.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	VERTICES = 67,
	JOINTS = 9,
	INFLUENCES_MAX = 8,
	GUARD = 4,
	ROUNDS = 40
};

struct fixture {
	/* With the alignment of an arena's arrays. */
	_Alignas(16) struct fixed_base base[VERTICES * INFLUENCES_MAX + 1];
	_Alignas(16) struct fixed_vector from[VERTICES];
	_Alignas(16) struct fixed_vector step[VERTICES];
	struct fixed_matrix palette[JOINTS];
	struct fixed_pair pair[VERTICES][3];
	int32_t run[VERTICES * (1 + INFLUENCES_MAX)];
	struct fixed_group group[INFLUENCES_MAX];
	int group_count;
	struct fixed_weights weights;
	struct fixed_rebase rebase[VERTICES];
};

/* The output of a loop, and memory behind it that must not change. */
struct output {
	_Alignas(16) struct fixed_vector vector[VERTICES + GUARD];
	_Alignas(16) struct fixed_sum sum[VERTICES + GUARD];
	_Alignas(16) struct fixed_base base[VERTICES + GUARD];
};

/* Any numbers, the ends of the range, or numbers whose sums do not overflow. */
enum filling {
	FILL_ANY,
	FILL_ENDS,
	FILL_SMALL
};

static void fill(void *to, size_t size, enum filling filling, uint32_t *seed)
{
	static const int16_t end[] = {
		-32768, -32767, -1, 0, 1, 32767, 16384, -16384};
	int16_t *out = to;

	for (size_t i = 0; i < size / sizeof(*out); i++) {
		uint32_t value = next_random(seed);

		out[i] = (int16_t)value;
		if (filling == FILL_ENDS) {
			out[i] = end[value % 8];
		} else if (filling == FILL_SMALL) {
			out[i] = (int16_t)(value % 8001 - 4000);
		}
	}
}

/* Groups of 1, 2, ... influences with runs of random lengths. */
static void make_groups(struct fixture *f, uint32_t *seed)
{
	int32_t *end = f->run;
	int left = VERTICES;

	f->group_count = 0;
	for (int k = 1; k <= INFLUENCES_MAX; k++) {
		struct fixed_group *group = &f->group[f->group_count];
		int most = k < INFLUENCES_MAX ? left / 2 : left;

		*group = (struct fixed_group){k, 0, end};
		while (most > 0) {
			int count = (int)(next_random(seed) % 9) + 1;

			count = count < most ? count : most;
			*end++ = count;
			for (int i = 0; i < k; i++) {
				*end++ = (int32_t)(next_random(seed) % JOINTS *
					sizeof(struct fixed_matrix));
			}
			group->run_count++;
			most -= count;
			left -= count;
		}
		f->group_count += group->run_count > 0;
	}
}

static void set_up(struct fixture *f, enum filling filling, uint32_t seed)
{
	memset(f, 0, sizeof(*f));
	fill(f->base, sizeof(f->base), filling, &seed);
	fill(f->from, sizeof(f->from), filling, &seed);
	fill(f->step, sizeof(f->step), filling, &seed);
	fill(f->palette, sizeof(f->palette), filling, &seed);
	fill(f->pair, sizeof(f->pair), filling, &seed);
	fill(&f->weights, sizeof(f->weights), filling, &seed);
	make_groups(f, &seed);
	fill(f->rebase, sizeof(f->rebase), filling, &seed);
	for (int i = 0; i < VERTICES; i++) {
		f->rebase[i].base_index = (uint32_t)(i * 5 % VERTICES);
		f->rebase[i].delta_index = (uint16_t)(i * 7 % VERTICES);
	}
}

static int64_t dot_wide(const int16_t row[4], const struct fixed_base *base)
{
	return (int64_t)row[0] * base->x + (int64_t)row[1] * base->y +
		(int64_t)row[2] * base->z + (int64_t)row[3] * base->w;
}

static int64_t weigh_wide(
	const struct fixed_pair *pair, struct fixed_weights weights)
{
	return (int64_t)pair->a * weights.a + (int64_t)pair->b * weights.b;
}

static void assert_sums(const struct fixed_vector *got, const int64_t sum[3])
{
	assert_int_equal(got->x, sum[0] >> 16);
	assert_int_equal(got->y, sum[1] >> 16);
	assert_int_equal(got->z, sum[2] >> 16);
	assert_int_equal((uint16_t)got->fraction, sum[0] & 0xffff);
}

static void test_skinning_sums_rows_times_vectors(void **state)
{
	static struct fixture f;
	static struct output out;
	const struct fixed_base *base = f.base;
	int v = 0;

	(void)state;
	set_up(&f, FILL_SMALL, 1);
	fixed_loops_c.skin(
		f.group, f.group_count, f.base, f.palette, out.vector);
	for (int g = 0; g < f.group_count; g++) {
		const int32_t *run = f.group[g].run;

		for (int r = 0; r < f.group[g].run_count; r++) {
			int k = f.group[g].influences;

			for (int i = 0; i < run[0]; i++, v++) {
				int64_t sum[3] = {0, 0, 0};

				for (int j = 0; j < k * 3; j++) {
					int joint = run[1 + j / 3] /
						(int)sizeof(struct fixed_matrix);

					sum[j % 3] += dot_wide(
						f.palette[joint].row[j % 3],
						&base[j / 3]);
				}
				assert_sums(&out.vector[v], sum);
				base += k;
			}
			run += 1 + k;
		}
	}
	assert_int_equal(v, VERTICES);
}

static void test_a_lerp_weighs_and_rounds(void **state)
{
	static struct fixture f;
	static struct output out;

	(void)state;
	set_up(&f, FILL_SMALL, 2);
	fixed_loops_c.lerp(VERTICES, (const struct fixed_pair(*)[3])f.pair,
		f.weights, out.vector);
	for (int v = 0; v < VERTICES; v++) {
		int64_t sum[3];

		for (int k = 0; k < 3; k++) {
			sum[k] = 32768 + weigh_wide(&f.pair[v][k], f.weights);
		}
		assert_sums(&out.vector[v], sum);
	}
}

static void base_sums(const struct fixed_vector *base, int64_t sum[3])
{
	uint16_t fraction = (uint16_t)base->fraction;

	sum[0] = (int64_t)base->x * 65536 + fraction;
	sum[1] = (int64_t)base->y * 65536 + fraction;
	sum[2] = (int64_t)base->z * 65536 + fraction;
}

static void test_a_pair_of_targets_is_added(void **state)
{
	static struct fixture f;
	static struct output out;

	(void)state;
	set_up(&f, FILL_SMALL, 3);
	fixed_loops_c.morph_pair(VERTICES, f.from,
		(const struct fixed_pair(*)[3])f.pair, f.weights, out.vector);
	for (int v = 0; v < VERTICES; v++) {
		int64_t sum[3];

		base_sums(&f.from[v], sum);
		for (int k = 0; k < 3; k++) {
			sum[k] += weigh_wide(&f.pair[v][k], f.weights);
		}
		assert_sums(&out.vector[v], sum);
	}
}

static void test_many_pairs_are_added_like_one(void **state)
{
	static struct fixture f;
	static struct output out, one;
	const struct fixed_pair(*pair)[3] =
		(const struct fixed_pair(*)[3])f.pair;

	(void)state;
	set_up(&f, FILL_SMALL, 4);
	fixed_loops_c.morph_pair(VERTICES, f.from, pair, f.weights, one.vector);
	fixed_loops_c.morph_begin(VERTICES, f.from, out.sum);
	fixed_loops_c.morph_add(VERTICES, pair, f.weights, out.sum);
	fixed_loops_c.morph_end(VERTICES, out.sum, out.vector);
	assert_memory_equal(out.vector, one.vector, sizeof(out.vector));
}

static void test_moved_influences_are_rewritten(void **state)
{
	static const struct fixed_rebase rebase[2] = {
		{{100, -200, 300, -5}, 1, 2, 16384},
		{{-7, 8, -9, -32768}, 0, 0, -32768}};
	static const struct fixed_vector delta[3] = {
		{77, 1, 2, 3}, {0, 0, 0, 0}, {-1, 4, 41, -400}};
	static const struct fixed_base want[2] = {
		{-7, 7, -10, -32768}, {101, -190, 200, -5}};
	struct fixed_base out[2];

	(void)state;
	/* 4 / 4 = 1, 41 / 4 = 10.25; -1 / 2 and -3 / 2 are rounded up. */
	fixed_loops_c.rebase(2, rebase, delta, out);
	assert_memory_equal(out, want, sizeof(want));
}

static void test_increments_stop_at_the_ends(void **state)
{
	static const struct fixed_vector step[3] = {
		{1, -1, 30000, -30000}, {0, 1, 2, 3}, {-5, 32767, -32768, 1}};
	struct fixed_vector v[3] = {{32767, -32768, 30000, -30000},
		{7, 8, 9, 10}, {-32766, 1, -1, 32767}};
	static const struct fixed_vector want[3] = {
		{32767, -32768, 32767, -32768}, {7, 9, 11, 13},
		{-32768, 32767, -32768, 32767}};

	(void)state;
	fixed_loops_c.increment(3, step, v);
	assert_memory_equal(v, want, sizeof(want));
}

/* The fixture's pairs are room for two keys of random numbers. */
static const struct fixed_key *source_key(const struct fixture *f)
{
	return (const struct fixed_key *)f->pair;
}

static const struct fixed_key *destiny_key(const struct fixture *f)
{
	return source_key(f) + (VERTICES & ~1);
}

static void test_a_lerp_of_keys_is_one_of_pairs(void **state)
{
	static struct fixture f;
	static struct fixed_pair pair[VERTICES][3];
	static struct output out, want;
	const struct fixed_key *source = source_key(&f);
	const struct fixed_key *destiny = destiny_key(&f);

	(void)state;
	set_up(&f, FILL_ANY, 4);
	for (int v = 0; v < VERTICES - 1; v++) {
		pair[v][0] = (struct fixed_pair){source[v].x, destiny[v].x};
		pair[v][1] = (struct fixed_pair){source[v].y, destiny[v].y};
		pair[v][2] = (struct fixed_pair){source[v].z, destiny[v].z};
	}
	fixed_loops_c.lerp(VERTICES - 1, (const struct fixed_pair(*)[3])pair,
		f.weights, want.vector);
	fixed_loops_c.lerp_keys(
		VERTICES - 1, source, destiny, f.weights, out.vector);
	assert_memory_equal(
		out.vector, want.vector, (VERTICES - 1) * sizeof(*out.vector));
}

/* Runs all loops with count vertices, which may be 0. */
static void run_all(const struct fixed_loops *loops, const struct fixture *f,
	int count, struct output out[6])
{
	const struct fixed_pair(*pair)[3] =
		(const struct fixed_pair(*)[3])f->pair;

	memset(out, 0x5a, 6 * sizeof(*out));
	loops->skin(
		f->group, f->group_count, f->base, f->palette, out[0].vector);
	loops->lerp(count, pair, f->weights, out[1].vector);
	loops->lerp_keys(count, source_key(f), destiny_key(f), f->weights,
		out[5].vector);
	memcpy(out[2].vector, f->from, sizeof(f->from));
	loops->increment(count, f->step, out[2].vector);
	loops->morph_pair(count, f->from, pair, f->weights, out[3].vector);
	loops->morph_begin(count, f->from, out[4].sum);
	loops->morph_add(count, pair, f->weights, out[4].sum);
	loops->morph_end(count, out[4].sum, out[4].vector);
	loops->rebase(count, f->rebase, f->from, out[4].base);
}

static void test_all_kernels_give_the_same_bits(void **state)
{
	static struct fixture f;
	static struct output want[6], got[6];

	(void)state;
	for (int k = 0; kernel_registry[k]; k++) {
		const struct fixed_loops *loops = kernel_registry[k]->fixed;

		if (!loops) {
			continue;
		}
		for (int round = 0; round < ROUNDS * 3; round++) {
			int count = round / 3 * VERTICES / (ROUNDS - 1);

			set_up(&f, (enum filling)(round % 3),
				(uint32_t)round * 77 + 5);
			run_all(&fixed_loops_c, &f, count, want);
			run_all(loops, &f, count, got);
			for (int i = 0; i < 6; i++) {
				assert_memory_equal(
					&got[i], &want[i], sizeof(*want));
			}
		}
	}
}

static void test_a_morph_may_overwrite_its_base(void **state)
{
	static struct fixture f;
	static struct output want;
	const struct fixed_pair(*pair)[3] =
		(const struct fixed_pair(*)[3])f.pair;

	(void)state;
	for (int k = 0; kernel_registry[k]; k++) {
		const struct fixed_loops *loops = kernel_registry[k]->fixed;

		if (!loops) {
			continue;
		}
		set_up(&f, FILL_ANY, 9);
		fixed_loops_c.morph_pair(
			VERTICES, f.from, pair, f.weights, want.vector);
		loops->morph_pair(VERTICES, f.from, pair, f.weights, f.from);
		assert_memory_equal(f.from, want.vector, sizeof(f.from));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_skinning_sums_rows_times_vectors),
		cmocka_unit_test(test_a_lerp_weighs_and_rounds),
		cmocka_unit_test(test_a_lerp_of_keys_is_one_of_pairs),
		cmocka_unit_test(test_a_pair_of_targets_is_added),
		cmocka_unit_test(test_many_pairs_are_added_like_one),
		cmocka_unit_test(test_moved_influences_are_rewritten),
		cmocka_unit_test(test_increments_stop_at_the_ends),
		cmocka_unit_test(test_all_kernels_give_the_same_bits),
		cmocka_unit_test(test_a_morph_may_overwrite_its_base),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
