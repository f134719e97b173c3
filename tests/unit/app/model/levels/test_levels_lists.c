/* The file of levels: what a list of numbers may be, and what it belongs to. */
#include "app/model/levels/levels_file.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
	VERTICES = 5,
	CORNERS = 9, /* of the full list */
	BYTES = 6,   /* of a target's displacements: two vertices in bytes */
	WORDS = 64
};

/* Two meshes of one and two primitives; the first one has no normals. */
struct fixture {
	float position[3][VERTICES][3], normal[VERTICES][3];
	float texcoord[VERTICES][2], weight[VERTICES][4];
	uint8_t color[VERTICES][4];
	uint16_t joint[VERTICES][4];
	int8_t moved[2][BYTES];
	uint32_t index[3][CORNERS], coarse[3];
	struct model_span span[2];
	struct model_lod lod;
	struct model_target target[2];
	struct model_primitive primitive[3];
	struct model_mesh mesh[2];
	struct model model;
};

static void begin(struct fixture *f)
{
	memset(f, 0, sizeof(*f));
	for (int p = 0; p < 3; p++) {
		for (uint32_t i = 0; i < CORNERS; i++) {
			f->index[p][i] = (i + (uint32_t)p) % VERTICES;
		}
		f->primitive[p] =
			(struct model_primitive){.vertex_count = VERTICES,
				.position = f->position[p],
				.index_count = CORNERS,
				.index = f->index[p]};
	}
	f->lod = (struct model_lod){
		.error_m = 2.0f, .index_count = 3, .index = f->coarse};
	for (int t = 0; t < 2; t++) {
		struct model_deltas *deltas =
			t ? &f->target[t].normal : &f->target[t].position;

		f->span[t].count = 2;
		*deltas = (struct model_deltas){.vertex_count = VERTICES,
			.number = MODEL_INT8,
			.unit = 127.0f,
			.span_count = 1,
			.span = &f->span[t],
			.value = f->moved[t]};
	}
	f->primitive[2].normal = f->normal;
	f->primitive[2].texcoord = f->texcoord;
	f->primitive[2].color = f->color;
	f->primitive[2].influences = 4;
	f->primitive[2].joint = f->joint[0];
	f->primitive[2].weight = f->weight[0];
	f->primitive[2].target = f->target;
	f->primitive[2].lod_count = 1;
	f->primitive[2].lod = &f->lod;
	f->mesh[0].primitive_count = 1;
	f->mesh[0].primitive = &f->primitive[0];
	f->mesh[1].primitive_count = 2;
	f->mesh[1].primitive = &f->primitive[1];
	f->model.mesh_count = 2;
	f->model.mesh = f->mesh;
	f->model.arena = arena_empty();
}

/* Writes the file, whose primitives are too small for levels of limber's. */
static size_t write_words(struct fixture *f, uint32_t word[WORDS])
{
	FILE *out = fmemopen(word, WORDS * sizeof(*word), "w");
	long size;

	assert_non_null(out);
	assert_int_equal(levels_write(&f->model, out), 0);
	size = ftell(out);
	assert_int_equal(fclose(out), 0);
	return (size_t)size;
}

static uint32_t bits_of(float number)
{
	uint32_t bits;

	memcpy(&bits, &number, sizeof(bits));
	return bits;
}

/* Reads the file; each byte in memory of its size, for the sanitizers. */
static int read_words(struct fixture *f, const uint32_t *word, size_t size)
{
	uint8_t *bytes = malloc(size + 1);
	int error;

	assert_non_null(bytes);
	memcpy(bytes, word, size);
	error = levels_read(&f->model, bytes, size);
	free(bytes);
	return error;
}

/* A list of short numbers in the file: error, kind, count and the numbers. */
struct list {
	float error_m;
	uint32_t kind, count, pair[5];
	bool is_read;
};

static int put_list(uint32_t *word, const struct list *list)
{
	word[0] = bits_of(list->error_m);
	word[1] = list->kind;
	word[2] = list->count;
	memcpy(word + 3, list->pair, sizeof(list->pair));
	return 3 + (int)(list->count + 1) / 2;
}

#define PAIR(a, b) ((uint32_t)(b) << 16 | (a))

/* Lists of the first primitive, or with others of the second, with normals. */
static void expect_list(const struct list *list, int primitive)
{
	uint32_t word[WORDS];
	struct fixture f;
	size_t at = 3;

	begin(&f);
	f.primitive[1].normal = f.normal;
	f.primitive[2].lod_count = 0;
	assert_int_equal(write_words(&f, word), 6 * sizeof(*word));
	for (int p = 0; p < 3; p++) {
		word[at++] = p == primitive;
		at += p == primitive ? (size_t)put_list(word + at, list) : 0;
	}
	/* One byte more, or less, is another file. */
	assert_int_equal(read_words(&f, word, at * sizeof(*word) + 1), -EINVAL);
	assert_int_equal(read_words(&f, word, at * sizeof(*word) - 1), -EINVAL);
	assert_int_equal(read_words(&f, word, at * sizeof(*word)),
		list->is_read ? 0 : -EINVAL);
	assert_int_equal(f.primitive[primitive].lod_count, list->is_read);
	if (list->is_read) {
		const struct model_lod *lod = f.primitive[primitive].lod;

		assert_near(lod->error_m, list->error_m, 0);
		assert_int_equal(lod->shadow_only, list->kind == 1);
		assert_int_equal(lod->index_count, list->count);
		for (uint32_t i = 0; i < list->count; i++) {
			uint32_t number =
				list->pair[i / 2] >> 16 * (i % 2) & 0xffff;

			if (list->kind == 2) {
				assert_int_equal(lod->corner[i], number);
				number = f.index[primitive][number];
			} else {
				assert_null(lod->corner);
			}
			assert_int_equal(lod->index[i], number);
		}
	}
	arena_release(&f.model.arena);
}

static void test_lists_have_numbers_within_their_limits(void **state)
{
	static const struct list lists[] = {
		{0.5f, 0, 3, {PAIR(4, 0), 1}, true},
		{0.5f, 1, 3, {PAIR(0, 4), 1}, true},
		{0.5f, 2, 3, {PAIR(0, 1), 8}, true},
		{0.0f, 0, 6, {PAIR(0, 1), PAIR(2, 4), PAIR(4, 3)}, true},
		{0.5f, 0, 9, {PAIR(0, 1), PAIR(2, 4), PAIR(4, 3), PAIR(1, 2), 4},
			true},
		{0.5f, 0, 3, {PAIR(5, 0), 1}, false},
		{0.5f, 0, 3, {PAIR(0, 5), 1}, false},
		{0.5f, 1, 3, {PAIR(0, 1), 5}, false},
		{0.5f, 2, 3, {PAIR(0, 9), 8}, false},
		{0.5f, 3, 3, {PAIR(0, 1), 2}, false},
		{0.5f, 0, 0, {0}, false},
		{0.5f, 0, 1, {0}, false},
		{0.5f, 0, 2, {0}, false},
		{0.5f, 0, 4, {0}, false},
		{0.5f, 0, 10, {0}, false},
		{-0.5f, 0, 3, {PAIR(0, 1), 2}, false},
		{INFINITY, 0, 3, {PAIR(0, 1), 2}, false},
		{NAN, 0, 3, {PAIR(0, 1), 2}, false},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(lists) / sizeof(*lists); i++) {
		struct list list = lists[i];

		expect_list(&list, 0);
		/* Corners are only for triangles without normals. */
		list.is_read = list.is_read && list.kind != 2;
		expect_list(&list, 1);
		expect_list(&list, 2);
	}
}

/* A primitive of 12 indices has room in its file for a list that is longer. */
static void test_a_list_is_no_longer_than_the_full_one(void **state)
{
	struct list list = {0.5f, 0, 9, {0}, true};
	uint32_t word[WORDS];
	struct fixture f;

	(void)state;
	for (int full = 12; full >= 6; full -= 3) {
		begin(&f);
		f.mesh[0].primitive_count = 0;
		f.mesh[1].primitive_count = 1;
		f.primitive[1].index = (uint32_t[12]){0};
		f.primitive[1].index_count = full;
		write_words(&f, word);
		word[3] = 1;
		assert_int_equal(
			read_words(&f, word,
				16 + (size_t)put_list(word + 4, &list) * 4),
			full < 9 ? -EINVAL : 0);
		arena_release(&f.model.arena);
	}
}

/* Lists for shadows come last, and each list has at least its numbers. */
static void test_lists_have_an_order_and_a_number(void **state)
{
	static const struct {
		uint32_t count, kind[3];
		bool is_read;
	} cases[] = {{3, {0, 0, 1}, true}, {3, {0, 1, 1}, true},
		{3, {1, 1, 1}, true}, {3, {2, 0, 1}, true},
		{3, {1, 0, 0}, false}, {3, {0, 1, 0}, false},
		{3, {1, 1, 2}, false}, {2, {0, 0, 0}, false},
		{4, {0, 0, 0}, false}, {0x10000000, {0, 0, 0}, false}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(*cases); i++) {
		uint32_t word[WORDS] = {0};
		struct fixture f;
		size_t at = 4;

		begin(&f);
		f.mesh[1].primitive_count = 0;
		write_words(&f, word);
		word[3] = cases[i].count;
		for (int k = 0; k < 3; k++) {
			struct list list = {0.5f * (float)(k + 1),
				cases[i].kind[k], 3, {PAIR(0, k), 1}, true};

			at += (size_t)put_list(word + at, &list);
		}
		assert_int_equal(read_words(&f, word, at * 4),
			cases[i].is_read ? 0 : -EINVAL);
		assert_int_equal(
			f.primitive[0].lod_count, cases[i].is_read ? 3 : 0);
		for (int k = 0; k < f.primitive[0].lod_count; k++) {
			assert_near(f.primitive[0].lod[k].error_m,
				0.5f * (float)(k + 1), 0);
		}
		arena_release(&f.model.arena);
	}
}

/* Numbers are short up to 65,536 vertices or corners, as the header says. */
static void test_long_lists_have_long_numbers(void **state)
{
	static float position[65537][3];
	static uint32_t index[65538];

	(void)state;
	for (int i = 0; i < 4; i++) {
		bool corners = i / 2, is_long = i % 2;
		uint32_t word[WORDS] = {0}, again[WORDS], last;
		struct fixture f;
		size_t size;

		begin(&f);
		f.mesh[1].primitive_count = 0;
		f.primitive[0].position = position;
		f.primitive[0].vertex_count = corners ? 7 : 65536 + is_long;
		f.primitive[0].index = index;
		f.primitive[0].index_count =
			corners ? 65535 + 3 * is_long : CORNERS;
		last = corners ? (uint32_t)f.primitive[0].index_count - 1
			       : (uint32_t)f.primitive[0].vertex_count - 1;
		write_words(&f, word);
		word[3] = 1;
		word[4] = bits_of(0.5f);
		word[5] = corners ? 2 : 0;
		word[6] = 3;
		if (is_long) {
			word[7] = 1;
			word[8] = last;
			word[9] = 2;
		} else {
			word[7] = PAIR(1, last);
			word[8] = 2;
		}
		size = is_long ? 40 : 36;
		assert_int_equal(read_words(&f, word, size), 0);
		for (int k = 0; k < 3; k++) {
			const struct model_lod *lod = f.primitive[0].lod;

			assert_int_equal(
				corners ? lod->corner[k] : lod->index[k],
				k == 1 ? last : (uint32_t)(1 + k / 2));
		}
		/* It is written as it was, but for the hash. */
		assert_int_equal(write_words(&f, again), size);
		assert_memory_equal(again + 2, word + 2, size - 8);
		arena_release(&f.model.arena);
	}
}

/* The first or the last number of what levels are made from. */
static void change(struct fixture *f, int what)
{
	float *numbers[] = {&f->position[0][0][0], &f->position[0][4][2],
		&f->position[2][0][0], &f->position[2][4][2], &f->normal[4][2],
		&f->texcoord[4][1], &f->weight[4][3],
		&f->target[0].position.unit, &f->target[1].normal.unit,
		&f->lod.error_m};
	uint32_t *integers[] = {&f->index[0][0], &f->index[1][8],
		&f->index[2][8], &f->coarse[2]};

	if (what < 10) {
		*numbers[what] += 0.25f;
	} else if (what < 14) {
		*integers[what - 10] ^= 1;
	} else if (what < 16) {
		f->moved[what - 14][BYTES - 1] ^= 1;
	} else if (what < 18) {
		f->span[what - 16].first ^= 1;
	} else if (what == 18) {
		f->color[4][3] ^= 1;
	} else if (what == 19) {
		f->joint[4][3] ^= 1;
	} else if (what == 20) {
		f->primitive[2].lod_count = 0;
	} else if (what == 21) {
		f->primitive[0].index_count = 6;
	} else if (what == 22) {
		f->primitive[2].texcoord = NULL;
	} else if (what == 23) {
		f->mesh[0].primitive_count = 0;
	} else if (what == 24) {
		f->mesh[1].primitive_count = 1;
	} else {
		f->mesh[1].target_count = 1;
	}
}

static void test_each_number_of_the_model_counts(void **state)
{
	(void)state;
	for (int what = 0; what <= 25; what++) {
		struct model_target none[2];
		uint32_t word[WORDS];
		struct fixture f;
		size_t size;

		memset(none, 0, sizeof(none));
		begin(&f);
		f.mesh[1].target_count = 2;
		/* Only the last primitive has targets to speak of. */
		f.primitive[1].target = none;
		size = write_words(&f, word);
		assert_int_equal(read_words(&f, word, size), 0);
		f.primitive[2].lod = &f.lod;
		change(&f, what);
		assert_int_equal(read_words(&f, word, size), -EINVAL);
		arena_release(&f.model.arena);
	}
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_lists_have_numbers_within_their_limits),
		cmocka_unit_test(test_a_list_is_no_longer_than_the_full_one),
		cmocka_unit_test(test_lists_have_an_order_and_a_number),
		cmocka_unit_test(test_long_lists_have_long_numbers),
		cmocka_unit_test(test_each_number_of_the_model_counts),
	};

	return cmocka_run_group_tests_name("levels_lists", tests, NULL, NULL);
}
