/* Levels of meshes whose triangles share no vertices, or no normals. */
#include "app/model/levels/levels.h"
#include "app/model/levels/levels_file.h"
#include "tests/unit/app/model/levels/levels_net.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>

/* A dome without edges. */
static void shape_dome(
	float u, float v, float position[3], float normal[3], uint8_t color[4])
{
	float x = 2.0f * u - 1.0f, y = 2.0f * v - 1.0f;

	shape_flat(u, v, position, normal, color);
	position[2] = 0.3f * (1.0f - x * x) * (1.0f - y * y);
}

/* A roof, whose two sides are at right angles. */
static void shape_roof(
	float u, float v, float position[3], float normal[3], uint8_t color[4])
{
	shape_flat(u, v, position, normal, color);
	position[2] = 0.5f - fabsf(u - 0.5f);
}

/* Hills of 5 triangles, which are as large as those of a game of low detail. */
static void shape_hills(
	float u, float v, float position[3], float normal[3], uint8_t color[4])
{
	shape_flat(u, v, position, normal, color);
	position[2] = 0.03f * sinf(u * 50.0f) * sinf(v * 50.0f);
}

static void find_plane(const struct model_primitive *primitive,
	const uint32_t corner[3], float out[3])
{
	const float *a = primitive->position[corner[0]];
	const float *b = primitive->position[corner[1]];
	const float *c = primitive->position[corner[2]];
	float length = 0.0f;

	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;

		out[i] = (b[j] - a[j]) * (c[k] - a[k]) -
			(b[k] - a[k]) * (c[j] - a[j]);
		length += out[i] * out[i];
	}
	length = sqrtf(length);
	for (int i = 0; i < 3 && length > 0.0f; i++) {
		out[i] /= length;
	}
}

/* Gives each triangle three vertices of its own, with its plane's normal. */
static void divide(struct net *net)
{
	struct model_primitive *primitive = net->primitive;
	struct model_primitive whole = *primitive;
	struct arena *arena = &net->model->arena;

	primitive->vertex_count = INDICES;
	primitive->position = arena_alloc(arena, INDICES, sizeof(float[3]));
	primitive->normal = arena_alloc(arena, INDICES, sizeof(float[3]));
	primitive->color = arena_alloc(arena, INDICES, 4);
	for (uint32_t i = 0; i < INDICES; i++) {
		uint32_t from = whole.index[i];

		memcpy(primitive->position[i], whole.position[from],
			sizeof(float[3]));
		memcpy(primitive->color[i], whole.color[from], 4);
		primitive->index[i] = i;
	}
	for (uint32_t i = 0; i < INDICES; i++) {
		find_plane(primitive, primitive->index + i / 3 * 3,
			primitive->normal[i]);
	}
}

static struct net make_divided(shape_function shape)
{
	struct net net = make_net(shape, 1);

	divide(&net);
	return net;
}

static int shaded_count(const struct model_primitive *primitive)
{
	int count = 0;

	for (int i = 0; i < primitive->lod_count; i++) {
		count += !primitive->lod[i].shadow_only;
	}
	return count;
}

static int count_vertices(const struct model_lod *lod)
{
	static bool used[INDICES];
	int count = 0;

	memset(used, 0, sizeof(used));
	for (int i = 0; i < lod->index_count; i++) {
		count += !used[lod->index[i]];
		used[lod->index[i]] = true;
	}
	return count;
}

static void test_triangles_without_common_vertices_get_levels(void **state)
{
	struct net net = make_divided(shape_dome);
	const struct model_lod *lod;
	int count;

	(void)state;
	assert_int_equal(levels_make(net.model), 0);
	count = shaded_count(net.primitive);
	assert_true(count >= 4);
	lod = &net.primitive->lod[count - 1];
	assert_true(lod->index_count < INDICES / 8);
	/* Their corners are at common vertices. */
	assert_true(count_vertices(lod) < lod->index_count / 2);
	free_net(&net);
}

/* Gives a position's triangles this many vertices, in turn. */
static void share_out(struct net *net, const int vertices[COUNT])
{
	struct model_primitive *primitive = net->primitive;
	struct model_primitive whole = *primitive;
	struct arena *arena = &net->model->arena;
	static int uses[COUNT];
	static uint32_t other[COUNT][6];
	uint32_t count = 0;

	memset(uses, 0, sizeof(uses));
	primitive->position = arena_alloc(arena, INDICES, sizeof(float[3]));
	primitive->normal = arena_alloc(arena, INDICES, sizeof(float[3]));
	primitive->color = arena_alloc(arena, INDICES, 4);
	for (int i = 0; i < INDICES; i++) {
		uint32_t from = whole.index[i];
		int use = uses[from]++;

		if (use < vertices[from]) {
			memcpy(primitive->position[count], whole.position[from],
				sizeof(float[3]));
			memcpy(primitive->normal[count], whole.normal[from],
				sizeof(float[3]));
			memcpy(primitive->color[count], whole.color[from], 4);
			other[from][use] = count++;
		}
		primitive->index[i] = other[from][use % vertices[from]];
	}
	primitive->vertex_count = (int)count;
}

/* Vertices of the finest level of two a position, and extra ones. */
static int shared_out_level(int extra)
{
	struct net net = make_net(shape_dome, 1);
	static int vertices[COUNT];
	int count;

	for (int i = 0; i < COUNT; i++) {
		vertices[i] = 2;
	}
	/* These corners have one triangle alone. */
	vertices[0] = vertices[COUNT - 1] = 1;
	for (int i = 0; i < 2 + extra; i++) {
		vertices[COUNT / 2 + 2 * i] = 3;
	}
	share_out(&net, vertices);
	assert_int_equal(net.primitive->vertex_count, 2 * COUNT + extra);
	assert_int_equal(levels_make(net.model), 0);
	count = count_vertices(&net.primitive->lod[0]);
	free_net(&net);
	return count;
}

static void test_vertices_are_merged_from_more_than_two_a_position_on(
	void **state)
{
	int two, more;

	(void)state;
	two = shared_out_level(0);
	more = shared_out_level(1);
	assert_true(3 * more < 2 * two);
}

/*
 * The least cosine between a level's planes and the normals of their corners.
 * Triangles without an area have no plane.
 */
static float least_cosine(
	const struct model_primitive *primitive, const struct model_lod *lod)
{
	float least = 1.0f;

	for (int i = 0; i < lod->index_count; i++) {
		const float *n = primitive->normal[lod->index[i]];
		float plane[3], cosine = 0.0f;

		find_plane(primitive, lod->index + i / 3 * 3, plane);
		for (int axis = 0; axis < 3; axis++) {
			cosine += n[axis] * plane[axis];
		}
		least = cosine != 0.0f && cosine < least ? cosine : least;
	}
	return least;
}

static void test_sharp_edges_stay_sharp(void **state)
{
	struct net net = make_divided(shape_roof);

	(void)state;
	assert_int_equal(levels_make(net.model), 0);
	assert_true(shaded_count(net.primitive) >= 1);
	for (int i = 0; i < shaded_count(net.primitive); i++) {
		assert_true(least_cosine(net.primitive,
				    &net.primitive->lod[i]) > 0.999f);
	}
	free_net(&net);
}

/* At this error triangles are much larger than the error, and seen as flat. */
static void test_large_triangles_stay_flat_at_fine_levels(void **state)
{
	struct net net = make_divided(shape_hills);

	(void)state;
	assert_int_equal(levels_make(net.model), 0);
	for (int i = 0; i < shaded_count(net.primitive); i++) {
		const struct model_lod *lod = &net.primitive->lod[i];

		assert_true(lod->error_m > 0.005f ||
			least_cosine(net.primitive, lod) > 0.95f);
	}
	free_net(&net);
}

static void test_colors_of_triangles_stay(void **state)
{
	struct net net = make_divided(shape_flat);
	int shaded;

	(void)state;
	for (int i = 0; i < INDICES; i++) {
		memset(net.primitive->color[i], i / 3 % 2 ? 255 : 0, 3);
	}
	assert_int_equal(levels_make(net.model), 0);
	shaded = shaded_count(net.primitive);
	for (int i = 0; i < shaded; i++) {
		assert_true(net.primitive->lod[i].error_m > 0.04f);
	}
	free_net(&net);
}

static void test_triangles_without_an_area_do_no_harm(void **state)
{
	struct net net = make_divided(shape_dome);
	struct model_primitive *primitive = net.primitive;

	(void)state;
	for (int i = 0; i < INDICES; i += 30) {
		memcpy(primitive->position[i], primitive->position[i + 1],
			sizeof(float[3]));
		for (int corner = 0; corner < 3; corner++) {
			memset(primitive->normal[i + corner], 0,
				sizeof(float[3]));
		}
	}
	assert_int_equal(levels_make(net.model), 0);
	for (int i = 0; i < primitive->lod_count; i++) {
		const struct model_lod *lod = &primitive->lod[i];

		for (int k = 0; k < lod->index_count; k++) {
			assert_true(lod->index[k] <
				(uint32_t)primitive->vertex_count);
		}
	}
	free_net(&net);
}

static struct net make_bare(void)
{
	struct net net = make_net(shape_dome, 1);

	net.primitive->normal = NULL;
	return net;
}

static void assert_same_lists(
	const struct model_primitive *a, const struct model_primitive *b)
{
	assert_int_equal(a->lod_count, b->lod_count);
	for (int i = 0; i < a->lod_count; i++) {
		const struct model_lod *one = &a->lod[i], *other = &b->lod[i];
		size_t bytes = (size_t)one->index_count * sizeof(*one->index);

		assert_int_equal(one->index_count, other->index_count);
		assert_memory_equal(one->index, other->index, bytes);
		assert_int_equal(one->shadow_only, other->shadow_only);
		assert_int_equal(!one->corner, !other->corner);
		if (one->corner) {
			assert_memory_equal(one->corner, other->corner, bytes);
		}
	}
}

static void test_a_file_keeps_the_triangles_of_normals(void **state)
{
	struct net made = make_bare(), read = make_bare(), other = make_bare();
	char *data;
	size_t size;
	FILE *out = open_memstream(&data, &size);

	(void)state;
	assert_non_null(out);
	assert_int_equal(levels_write(made.model, out), 0);
	assert_int_equal(fclose(out), 0);
	assert_int_equal(
		levels_read(read.model, (const uint8_t *)data, size), 0);
	assert_true(shaded_count(read.primitive) >= 4);
	assert_same_lists(made.primitive, read.primitive);
	/* The first list's first number, at 28 bytes, is beyond the index. */
	data[28] = data[29] = (char)0xFF;
	assert_int_equal(
		levels_read(other.model, (const uint8_t *)data, size), -EINVAL);
	assert_int_equal(other.primitive->lod_count, 0);
	free(data);
	free_net(&made);
	free_net(&read);
	free_net(&other);
}

/* Whatever the budget refuses, a list's vertices are the primitive's. */
static void test_a_budget_leaves_no_unfinished_level(void **state)
{
	int most = 0, least = 99;

	(void)state;
	for (size_t kib = 64; kib <= 8192; kib = kib * 5 / 4) {
		struct net net = make_bare();
		struct memory_budget budget = {.limit_bytes = kib * 1024};

		net.model->budget = &budget;
		net.model->arena.budget = &budget;
		assert_int_equal(levels_make(net.model), 0);
		assert_true(budget.used_bytes <= budget.limit_bytes);
		for (int i = 0; i < net.primitive->lod_count; i++) {
			const struct model_lod *lod = &net.primitive->lod[i];

			for (int k = 0; k < lod->index_count; k++) {
				assert_true(lod->index[k] < COUNT);
			}
		}
		most = net.primitive->lod_count > most ? net.primitive->lod_count
						       : most;
		least = net.primitive->lod_count < least
			? net.primitive->lod_count
			: least;
		free_net(&net);
	}
	assert_true(most > 4);
	assert_int_equal(least, 0);
}

/* Lists for shadows that a file has come after those that are made. */
static void test_shadows_of_a_file_come_after_made_levels(void **state)
{
	struct net net = make_bare();
	struct model_lod own = {.error_m = 0.01f,
		.shadow_only = true,
		.index_count = 3000,
		.index = net.primitive->index};
	int shaded;

	(void)state;
	net.primitive->lod = &own;
	net.primitive->lod_count = 1;
	assert_int_equal(levels_make(net.model), 0);
	shaded = shaded_count(net.primitive);
	assert_true(shaded >= 4);
	for (int i = 0; i < net.primitive->lod_count; i++) {
		assert_int_equal(net.primitive->lod[i].shadow_only, i >= shaded);
	}
	assert_ptr_equal(net.primitive->lod[shaded].index, own.index);
	free_net(&net);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_triangles_without_common_vertices_get_levels),
		cmocka_unit_test(
			test_vertices_are_merged_from_more_than_two_a_position_on),
		cmocka_unit_test(test_sharp_edges_stay_sharp),
		cmocka_unit_test(test_large_triangles_stay_flat_at_fine_levels),
		cmocka_unit_test(test_colors_of_triangles_stay),
		cmocka_unit_test(test_triangles_without_an_area_do_no_harm),
		cmocka_unit_test(test_a_file_keeps_the_triangles_of_normals),
		cmocka_unit_test(test_a_budget_leaves_no_unfinished_level),
		cmocka_unit_test(test_shadows_of_a_file_come_after_made_levels),
	};

	return cmocka_run_group_tests_name("levels_flat", tests, NULL, NULL);
}
