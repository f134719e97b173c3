/* Large primitives become parts that show the same surface. */
#include "app/model/model_deltas.h"
#include "app/model/model_loader.h"
#include "app/model/model_stats.h"
#include "app/model/split/split.h"
#include "app/model/split/split_triangles.h"
#include "tests/support/test.h"

#include <errno.h>
#include <string.h>

/* A grid of vertices, of which the first rows have triangles. */
struct grid {
	struct arena arena;
	struct model_primitive primitive;
};

static void begin(struct grid *grid, int width, int height, int used_rows)
{
	struct model_primitive *primitive = &grid->primitive;
	int count = 0;

	*grid = (struct grid){.arena = arena_empty()};
	primitive->vertex_count = width * height;
	primitive->position = arena_alloc(&grid->arena,
		(size_t)primitive->vertex_count, sizeof(float[3]));
	primitive->index = ARENA_ARRAY(
		&grid->arena, uint32_t, 6 * (size_t)primitive->vertex_count);
	assert_non_null(primitive->position);
	assert_non_null(primitive->index);
	for (int v = 0; v < primitive->vertex_count; v++) {
		/* Neighbours in memory are far from each other. */
		primitive->position[v][0] = (float)(v * 7919 % width);
		primitive->position[v][1] = (float)(v / width);
	}
	for (int v = 0; v + width + 1 < width * used_rows; v++) {
		const uint32_t corner[] = {(uint32_t)v, (uint32_t)v + 1,
			(uint32_t)(v + width), (uint32_t)v + 1,
			(uint32_t)(v + width + 1), (uint32_t)(v + width)};

		memcpy(primitive->index + count, corner, sizeof(corner));
		count += 6;
	}
	primitive->index_count = count;
}

static uint64_t corner_hash(uint64_t a, uint64_t b, uint64_t c)
{
	return (a * 1000003 + b) * 1000003 + c;
}

static uint64_t hash_of(const uint32_t *index, int count, const uint32_t *name)
{
	uint64_t sum = 0;

	for (int i = 0; i < count; i += 3) {
		sum += corner_hash(name ? name[index[i]] : index[i],
			name ? name[index[i + 1]] : index[i + 1],
			name ? name[index[i + 2]] : index[i + 2]);
	}
	return sum;
}

/* Marks the part's vertices in seen, and compares them with earlier parts'. */
static void expect_vertices(const struct split_part *part, int most, bool *seen)
{
	assert_in_range(part->vertex_count, 1, most);
	for (int v = 0; v < part->vertex_count; v++) {
		assert_int_equal(
			seen[part->vertex[v]], v < part->repeated_count);
	}
	for (int v = 0; v < part->vertex_count; v++) {
		seen[part->vertex[v]] = true;
	}
	for (int i = 0; i < part->index_count; i++) {
		assert_in_range(part->index[i], 0, part->vertex_count - 1);
	}
}

/* Returns the number of parts. */
static int expect_partition(struct grid *grid, int most)
{
	const struct model_primitive *primitive = &grid->primitive;
	bool *seen = ARENA_ARRAY(&grid->arena, bool, primitive->vertex_count);
	struct split_part *first;
	uint64_t hash = 0;
	int parts = 0, fresh = 0, indices = 0;

	assert_int_equal(
		split_triangles(primitive, most, &grid->arena, &first), 0);
	for (const struct split_part *part = first; part; part = part->next) {
		parts++;
		expect_vertices(part, most, seen);
		fresh += part->vertex_count - part->repeated_count;
		indices += part->index_count;
		hash += hash_of(part->index, part->index_count, part->vertex);
	}
	assert_int_equal(fresh, primitive->vertex_count);
	assert_int_equal(indices, primitive->index_count);
	assert_true(hash ==
		hash_of(primitive->index, primitive->index_count, NULL));
	return parts;
}

static void test_parts_have_each_triangle_once_and_few_vertices(void **state)
{
	struct grid grid;

	(void)state;
	begin(&grid, 40, 30, 30);
	for (int most = 3; most < 1300; most += most < 20 ? 1 : 97) {
		int parts = expect_partition(&grid, most);

		/* Two triangles a vertex: a part of 3 has but one of them. */
		assert_in_range(parts, 1200 / most, 1 + 8 * 1200 / most);
	}
	assert_int_equal(expect_partition(&grid, 1200), 1);
	assert_int_equal(expect_partition(&grid, 1199), 2);
	arena_release(&grid.arena);
}

static void test_vertices_without_triangles_are_kept(void **state)
{
	struct grid grid;

	(void)state;
	begin(&grid, 40, 30, 7);
	assert_int_equal(expect_partition(&grid, 300), 1 + 4);
	arena_release(&grid.arena);
	begin(&grid, 40, 30, 0);
	assert_int_equal(expect_partition(&grid, 300), 4);
	arena_release(&grid.arena);
}

static void test_triangles_in_one_place_are_divided_by_number(void **state)
{
	struct grid grid;

	(void)state;
	begin(&grid, 40, 30, 30);
	memset(grid.primitive.position, 0, 1200 * sizeof(float[3]));
	assert_in_range(expect_partition(&grid, 200), 6, 12);
	arena_release(&grid.arena);
}

enum {
	ROW = 8 /* triangles that share no vertex */
};

/* Triangles in a row against their number, but one of them far to a side. */
static void place_row(struct grid *grid, int axis, int far, float distance)
{
	struct model_primitive *primitive = &grid->primitive;

	begin(grid, 3, ROW, 0);
	memset(primitive->position, 0, 3 * ROW * sizeof(float[3]));
	for (int v = 0; v < 3 * ROW; v++) {
		primitive->position[v][axis] = v / 3 == far ? distance : 0.0f;
		primitive->position[v][(axis + 1) % 3] =
			(float)(ROW - 1 - v / 3);
		primitive->index[v] = (uint32_t)v;
	}
	primitive->index_count = 3 * ROW;
}

/* The first two of them by the place on that side, then by number. */
static void expect_first(struct grid *grid, int one, int other)
{
	struct split_part *part = NULL;

	assert_int_equal(split_triangles(&grid->primitive, ROW * 3 / 2,
				 &grid->arena, &part),
		0);
	assert_int_equal(part->vertex_count, 6);
	for (int i = 0; i < 6; i++) {
		int triangle = i < 3 ? one : other;

		assert_int_equal(part->vertex[i], 3 * triangle + i % 3);
	}
}

/* The row's first three are divided again, one of which is higher than they are wide. */
static void test_a_group_is_divided_along_its_own_side(void **state)
{
	struct grid grid;
	struct split_part *part = NULL;

	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		place_row(&grid, axis, ROW - 1, 2.5f);
		assert_int_equal(
			split_triangles(&grid.primitive, 3, &grid.arena, &part),
			0);
		assert_int_equal(part->vertex_count, 3);
		assert_int_equal(part->vertex[0], 3 * (ROW - 3));
		arena_release(&grid.arena);
	}
}

static void test_equal_sides_are_divided_along_the_first(void **state)
{
	struct grid grid;

	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		place_row(&grid, axis, 0, ROW - 1);
		expect_first(
			&grid, axis < 2 ? 1 : ROW - 2, axis < 2 ? 2 : ROW - 1);
		arena_release(&grid.arena);
	}
}

static void test_triangles_are_divided_along_the_longest_side(void **state)
{
	struct grid grid;

	(void)state;
	for (int i = 0; i < 3 * ROW; i++) {
		int far = i / 3, first = far == 0;

		place_row(&grid, i % 3, far, (float)ROW);
		expect_first(&grid, first, far <= 1 ? 2 : 1);
		arena_release(&grid.arena);
		place_row(&grid, i % 3, far, (float)-ROW);
		expect_first(&grid, far ? 0 : far, far ? far : 1);
		arena_release(&grid.arena);
		/* A shorter side than that of the row. */
		place_row(&grid, i % 3, far, 6.5f);
		expect_first(&grid, ROW - 2, ROW - 1);
		arena_release(&grid.arena);
	}
}

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
	begin(&grid, WIDTH, HEIGHT, HEIGHT);
	primitive[1] = (struct model_primitive){
		.file_index = 5,
		.material = 6,
		.vertex_count = COUNT,
		.position = (float(*)[3])floats(&model->arena, 3),
		.normal = (float(*)[3])floats(&model->arena, 3),
		.texcoord = (float(*)[2])floats(&model->arena, 2),
		.influences = INFLUENCES,
		.weight = floats(&model->arena, INFLUENCES),
		.joint = ARENA_ARRAY(&model->arena, uint16_t, COUNT * INFLUENCES),
		.index_count = grid.primitive.index_count,
		.index = ARENA_ARRAY(
			&model->arena, uint32_t, grid.primitive.index_count),
	};
	for (int i = 0; i < COUNT * INFLUENCES; i++) {
		primitive[1].joint[i] = (uint16_t)(i % 60001);
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
	assert_null(part->tangent);
	assert_null(part->color);
	for (int v = 0; v < part->vertex_count; v++) {
		int from = (int)part->file_vertex[v];

		expect_array(*part->position, 3, v, from);
		expect_array(*part->normal, 3, v, from);
		expect_array(*part->texcoord, 2, v, from);
		expect_array(part->weight, INFLUENCES, v, from);
		for (int i = 0; i < INFLUENCES; i++) {
			assert_int_equal(part->joint[v * INFLUENCES + i],
				(from * INFLUENCES + i) % 60001);
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
		begin(&grid[p], 40, 30, p == 0 ? 14 : p == 1 ? 15 : 3);
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
			test_parts_have_each_triangle_once_and_few_vertices),
		cmocka_unit_test(test_vertices_without_triangles_are_kept),
		cmocka_unit_test(
			test_triangles_are_divided_along_the_longest_side),
		cmocka_unit_test(test_a_group_is_divided_along_its_own_side),
		cmocka_unit_test(test_equal_sides_are_divided_along_the_first),
		cmocka_unit_test(
			test_triangles_in_one_place_are_divided_by_number),
		cmocka_unit_test(
			test_parts_have_the_attributes_of_their_vertices),
		cmocka_unit_test(
			test_few_used_vertices_become_a_part_of_their_own),
		cmocka_unit_test(test_no_memory_is_an_error),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
