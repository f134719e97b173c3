/* Large primitives become parts that show the same surface. */
#include "app/model/model_deltas.h"
#include "app/model/model_loader.h"
#include "app/model/model_stats.h"
#include "app/model/split/split.h"
#include "tests/unit/app/model/split/split_grid.h"

#include <errno.h>
#include <string.h>

enum {
	WIDTH = 256,
	HEIGHT = 300,
	COUNT = WIDTH * HEIGHT,
	INFLUENCES = 4,
	TARGETS = 2
};

/* Values that tell vertices apart. */
static float value_of(int vertex, int component)
{
	return (float)(vertex * 5 + component);
}

static float *floats(struct arena *arena, int width)
{
	float *value = ARENA_ARRAY(arena, float, COUNT *width);

	assert_non_null(value);
	for (int i = 0; i < COUNT * width; i++) {
		value[i] = value_of(i / width, i % width);
	}
	return value;
}

static void add_targets(struct model *model, struct model_primitive *primitive,
	struct arena *integers)
{
	struct arena scratch = arena_empty();
	float(*delta)[3] = arena_alloc(&scratch, COUNT, sizeof(*delta));

	primitive->target =
		ARENA_ARRAY(&model->arena, struct model_target, TARGETS);
	/* Floats of few vertices, and integers of all. */
	for (int v = COUNT - 1000; v < COUNT; v++) {
		delta[v][1] = (float)v / 3.0f;
	}
	assert_int_equal(model_deltas_pack(&primitive->target[0].position,
				 (const float(*)[3])delta, COUNT, MODEL_FLOAT,
				 1.0f, &model->targets),
		0);
	for (int v = 0; v < COUNT; v++) {
		delta[v][2] = (float)(v % 30000) / 32767.0f;
		delta[v][1] = 0.0f;
	}
	assert_int_equal(model_deltas_pack(&primitive->target[1].normal,
				 (const float(*)[3])delta, COUNT, MODEL_INT16,
				 32767.0f, integers),
		0);
	arena_release(&scratch);
}

/* A mesh of a plain triangle and the large grid with all attributes. */
static struct model *make_model(struct arena *integers)
{
	const struct model_source source = {
		.name = "grid", .memory_bytes = (size_t)1 << 28};
	const struct log quiet = {0};
	struct model *model = model_create(&source, "test", &quiet);
	struct model_primitive *primitive;
	struct grid grid;

	assert_non_null(model);
	model->mesh_count = 1;
	model->mesh = ARENA_NEW(&model->arena, struct model_mesh);
	model->mesh->target_count = TARGETS;
	model->mesh->primitive_count = 2;
	model->mesh->primitive = primitive =
		ARENA_ARRAY(&model->arena, struct model_primitive, 2);
	primitive[0].file_index = 4;
	primitive[0].vertex_count = 3;
	primitive[0].target =
		ARENA_ARRAY(&model->arena, struct model_target, TARGETS);
	grid_begin(&grid, WIDTH, HEIGHT, HEIGHT);
	primitive[1] = (struct model_primitive){
		.file_index = 5,
		.material = 6,
		.vertex_count = COUNT,
		.position = (float(*)[3])floats(&model->arena, 3),
		.normal = (float(*)[3])floats(&model->arena, 3),
		.tangent = (float(*)[4])floats(&model->arena, 4),
		.texcoord = (float(*)[2])floats(&model->arena, 2),
		.color = arena_alloc(&model->arena, COUNT, 4),
		.influences = INFLUENCES,
		.weight = floats(&model->arena, INFLUENCES),
		.joint = ARENA_ARRAY(&model->arena, uint16_t, COUNT * INFLUENCES),
		.index_count = grid.primitive.index_count,
		.index = ARENA_ARRAY(
			&model->arena, uint32_t, grid.primitive.index_count),
	};
	for (int i = 0; i < COUNT * INFLUENCES; i++) {
		primitive[1].joint[i] = (uint16_t)(i % 60001);
		primitive[1].color[i / 4][i % 4] = (uint8_t)(i % 251);
	}
	memcpy(primitive[1].index, grid.primitive.index,
		(size_t)grid.primitive.index_count * sizeof(uint32_t));
	add_targets(model, &primitive[1], integers);
	arena_release(&grid.arena);
	return model;
}

static void expect_array(const float *value, int width, int vertex, int from)
{
	for (int k = 0; k < width; k++) {
		assert_near(value[vertex * width + k], value_of(from, k), 0.0);
	}
}

static void expect_deltas(const struct model_primitive *part, int v, int from)
{
	float delta[3];

	model_deltas_get(&part->target[0].position, v, delta);
	assert_near(delta[1], from >= COUNT - 1000 ? (float)from / 3.0f : 0.0f,
		0.0);
	model_deltas_get(&part->target[1].normal, v, delta);
	assert_near(delta[2], (float)(from % 30000) / 32767.0f, 0.0);
	assert_int_equal(part->target[1].position.vertex_count, 0);
}

static void expect_part(const struct model_primitive *part)
{
	assert_int_equal(part->file_index, 5);
	assert_int_equal(part->material, 6);
	assert_in_range(part->vertex_count, 1, SPLIT_VERTICES_MAX);
	for (int v = 0; v < part->vertex_count; v++) {
		int from = (int)part->file_vertex[v];

		expect_array(*part->position, 3, v, from);
		expect_array(*part->normal, 3, v, from);
		expect_array(*part->tangent, 4, v, from);
		expect_array(*part->texcoord, 2, v, from);
		expect_array(part->weight, INFLUENCES, v, from);
		for (int i = 0; i < INFLUENCES; i++) {
			assert_int_equal(part->joint[v * INFLUENCES + i],
				(from * INFLUENCES + i) % 60001);
			assert_int_equal(
				part->color[v][i], (from * 4 + i) % 251);
		}
		expect_deltas(part, v, from);
	}
}

static void test_parts_have_the_attributes_of_their_vertices(void **state)
{
	struct arena integers = arena_empty();
	struct model *model = make_model(&integers);
	size_t before = model->budget->used_bytes;
	const struct model_mesh *mesh = model->mesh;
	struct model_stats whole, divided;

	(void)state;
	model_measure(model, &whole);
	assert_int_equal(split_primitives(model, &integers), 0);
	assert_in_range(mesh->primitive_count, 3, 4);
	assert_int_equal(mesh->primitive[0].file_index, 4);
	assert_null(mesh->primitive[0].file_vertex);
	for (int p = 1; p < mesh->primitive_count; p++) {
		expect_part(&mesh->primitive[p]);
	}
	/* What was divided is freed; numbers of vertices are new. */
	assert_in_range(model->budget->used_bytes, before, before + before / 4);
	model_measure(model, &divided);
	assert_int_equal(divided.vertex_count, whole.vertex_count);
	assert_int_equal(divided.primitive_count, 2);
	assert_int_equal(divided.triangle_count, whole.triangle_count);
	assert_int_equal(
		divided.influence_histogram[4], whole.influence_histogram[4]);
	arena_release(&integers);
	model_destroy(model);
}

/*
 * Whatever was divided is freed, be it levels of the file or displacements.
 * Those in integers are in an arena of their own, before and after.
 */
static void test_what_was_divided_is_freed(void **state)
{
	enum {
		MOST = COUNT * 3 / 2 * (int)sizeof(uint32_t) /* numbers */
	};
	struct memory_budget own = {.limit_bytes = SIZE_MAX};
	struct arena integers = arena_within(&own);
	struct model *model = make_model(&integers);
	struct model_primitive *whole = &model->mesh->primitive[1];
	struct model_lod level[2];
	size_t others, own_before = own.used_bytes;
	size_t targets = model->targets.used_bytes;

	(void)state;
	others = model->budget->used_bytes;
	for (int i = 0; i < 2; i++) {
		level[i] = (struct model_lod){.index_count = 3 * COUNT,
			.index = ARENA_ARRAY(&model->arena, uint32_t, 3 * COUNT)};
	}
	whole->lod_count = 2;
	whole->lod = level;
	assert_int_equal(split_primitives(model, &integers), 0);
	assert_in_range(model->budget->used_bytes, others, others + MOST);
	assert_in_range(own.used_bytes, own_before, own_before * 5 / 4);
	assert_in_range(own.used_bytes, 6 * COUNT, SIZE_MAX);
	/* Of the thousand vertices that floats move. */
	assert_in_range(
		model->targets.used_bytes, targets, targets + 6 * 1000 * 4);
	arena_release(&integers);
	model_destroy(model);
}

static void test_a_part_that_is_dropped_frees_its_arrays(void **state)
{
	struct memory_budget budget = {.limit_bytes = SIZE_MAX};
	struct model_primitive own;
	struct model_mesh mesh = {.primitive_count = 1, .primitive = &own};
	struct model model = {.mesh_count = 1,
		.mesh = &mesh,
		.budget = &budget,
		.arena = arena_within(&budget)};
	struct grid grid;
	size_t before;

	(void)state;
	grid_begin(&grid, 100, 100, 30);
	own = grid.primitive;
	own.normal = arena_alloc(&model.arena, 10000, sizeof(*own.normal));
	memcpy(own.normal, own.position, 10000 * sizeof(*own.normal));
	assert_int_equal(split_primitives(&model, NULL), 0);
	assert_int_equal(mesh.primitive_count, 2);
	assert_null(mesh.primitive[1].tangent);
	assert_null(mesh.primitive[1].color);
	before = budget.used_bytes;
	split_drop_unused(&model);
	assert_int_equal(mesh.primitive_count, 1);
	assert_in_range(before - budget.used_bytes, 7000 * 24, 7000 * 24 + 256);
	arena_release(&grid.arena);
	arena_release(&model.arena);
}

static void test_few_used_vertices_become_a_part_of_their_own(void **state)
{
	struct arena integers = arena_empty();
	struct memory_budget budget = {.limit_bytes = SIZE_MAX};
	struct model_primitive own[4];
	struct model_mesh mesh = {.primitive_count = 4, .primitive = own};
	struct model model = {.mesh_count = 1, .mesh = &mesh, .budget = &budget};
	struct grid grid[4];

	(void)state;
	for (int p = 0; p < 4; p++) {
		grid_begin(&grid[p], 40, 30, p == 0 ? 14 : p == 1 ? 15 : 3);
		own[p] = grid[p].primitive;
	}
	own[2].lod_count = 1;   /* levels of the file stay */
	own[3].index_count = 0; /* so do vertices without any triangles */
	assert_int_equal(split_primitives(&model, &integers), 0);
	assert_int_equal(mesh.primitive_count, 5);
	assert_int_equal(mesh.primitive[0].vertex_count, 14 * 40);
	assert_int_equal(mesh.primitive[0].index_count, own[0].index_count);
	assert_int_equal(mesh.primitive[1].vertex_count, 16 * 40);
	assert_int_equal(mesh.primitive[1].index_count, 0);
	assert_int_equal(mesh.primitive[1].file_vertex[0], 14 * 40);
	split_drop_unused(&model);
	assert_int_equal(mesh.primitive_count, 4);
	for (int p = 0; p < 4; p++) {
		assert_int_equal(mesh.primitive[p].vertex_count, p ? 1200 : 560);
		arena_release(&grid[p].arena);
	}
	arena_release(&model.arena);
}

static void test_no_memory_is_an_error(void **state)
{
	struct arena integers = arena_empty();
	struct model *model = make_model(&integers);

	(void)state;
	model->budget->limit_bytes = model->budget->used_bytes + 2000000;
	assert_int_equal(split_primitives(model, &integers), -ENOMEM);
	arena_release(&integers);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_parts_have_the_attributes_of_their_vertices),
		cmocka_unit_test(
			test_few_used_vertices_become_a_part_of_their_own),
		cmocka_unit_test(test_what_was_divided_is_freed),
		cmocka_unit_test(test_a_part_that_is_dropped_frees_its_arrays),
		cmocka_unit_test(test_no_memory_is_an_error),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
