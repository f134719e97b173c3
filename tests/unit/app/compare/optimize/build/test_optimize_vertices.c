/* The vertices, targets, weights and indices that a rewritten file has. */
#include "tests/support/test.h"
#include "tests/unit/app/compare/optimize/build/rewrite_bench.h"

#include <string.h>

enum {
	POINTS = 0 /* a mode */
};

enum {
	SIDE = 5, /* of a grid of quads */
	GRID = (SIDE + 1) * (SIDE + 1),
	CORNERS = SIDE * SIDE * 6
};

/* Where the grid's vertex is in the file, of whose 64 some are not used. */
static uint32_t place_of(int vertex)
{
	return (uint32_t)(2 + vertex * 17 % 61);
}

static void make_grid(float id[64], uint32_t index[CORNERS])
{
	static const int corner[6] = {0, 1, SIDE + 1, 1, SIDE + 2, SIDE + 1};

	for (int i = 0; i < 64; i++) {
		id[i] = (float)i;
	}
	for (int i = 0; i < CORNERS; i++) {
		int quad = i / 6 * 7 % (SIDE * SIDE);

		index[i] = place_of(
			quad / SIDE * (SIDE + 1) + quad % SIDE + corner[i % 6]);
	}
}

/* The number of triangles with these corners, in this order or turned. */
static int count_triangles(const int *corner, int count, const int wanted[3])
{
	int found = 0;

	for (int i = 0; i < count; i += 3) {
		for (int turn = 0; turn < 3; turn++) {
			found += corner[i] == wanted[turn] &&
				corner[i + 1] == wanted[(turn + 1) % 3] &&
				corner[i + 2] == wanted[(turn + 2) % 3];
		}
	}
	return found;
}

/* Each vertex has a number, also where the order of vertices changes. */
static void test_triangles_keep_the_corners_and_their_attributes(void **state)
{
	float id[64], place[64][3], found[NUMBERS_MAX], at[NUMBERS_MAX];
	uint32_t index[CORNERS], list[CORNERS];
	int before[CORNERS], after[CORNERS];
	struct gltf_document_array array;
	struct file file;

	(void)state;
	make_grid(id, index);
	for (int v = 0; v < 64; v++) {
		place[v][0] = (float)(v % 8);
		place[v][1] = (float)(v / 8);
		place[v][2] = 0.5f;
	}
	begin(&file, 8192);
	set(&file, file.attributes, "POSITION", place, 64, FLOAT, "VEC3");
	set(&file, file.attributes, "_ID", id, 64, FLOAT, "SCALAR");
	set(&file, file.primitive, "indices", index, CORNERS, UINT, "SCALAR");
	rebuild(&file, (struct optimize_plan){0});
	array = read_array(&file,
		json_object_get(rewritten(&file), "attributes"), "_ID", found);
	assert_int_equal(array.count, GRID);
	assert_int_equal(read_array(&file,
				 json_object_get(rewritten(&file), "attributes"),
				 "POSITION", at)
				 .count,
		GRID);
	array = gltf_document_array(
		file.document, index_of(rewritten(&file), "indices"));
	assert_int_equal(array.count, CORNERS);
	assert_int_equal(array.component, USHORT);
	gltf_document_uints(
		file.document, index_of(rewritten(&file), "indices"), list);
	for (int i = 0; i < CORNERS; i++) {
		const float *to = at + 3 * list[i];

		assert_true(list[i] < GRID);
		before[i] = (int)index[i];
		after[i] = (int)found[list[i]];
		assert_near(to[0] + 8 * to[1], after[i], 0);
		assert_near(to[2], 0.5, 0);
	}
	for (int i = 0; i < CORNERS; i += 3) {
		assert_int_equal(count_triangles(after, CORNERS, before + i), 1);
	}
	end(&file);
}

/*
 * Vertices are sorted by their first use in the new order of triangles:
 * wherever the file has the list, and whether one primitive uses it or two.
 */
static void test_vertices_are_used_in_their_order(void **state)
{
	(void)state;
	for (int i = 0; i < 4; i++) {
		float id[64], place[64][3] = {{0}}, found[NUMBERS_MAX];
		uint32_t index[CORNERS], list[CORNERS], next = 0;
		int before[CORNERS], after[CORNERS];
		struct file file;

		make_grid(id, index);
		begin(&file, 8192);
		if (i % 2) {
			set(&file, file.primitive, "indices", index, CORNERS,
				UINT, "SCALAR");
		}
		set(&file, file.attributes, "POSITION", place, 64, FLOAT,
			"VEC3");
		set(&file, file.attributes, "_ID", id, 64, FLOAT, "SCALAR");
		if (i % 2 == 0) {
			set(&file, file.primitive, "indices", index, CORNERS,
				UINT, "SCALAR");
		}
		if (i / 2) {
			json_array_append_new(
				json_object_get(
					json_array_get(json_object_get(file.root,
							       "meshes"),
						0),
					"primitives"),
				json_deep_copy(file.primitive));
		}
		rebuild(&file, (struct optimize_plan){0});
		gltf_document_uints(file.document,
			index_of(rewritten(&file), "indices"), list);
		read_array(&file,
			json_object_get(rewritten(&file), "attributes"), "_ID",
			found);
		for (int k = 0; k < CORNERS; k++) {
			assert_true(list[k] <= next);
			next += list[k] == next;
			before[k] = (int)index[k];
			after[k] = (int)found[list[k]];
		}
		assert_int_equal(next, GRID);
		for (int k = 0; k < CORNERS; k += 3) {
			assert_int_equal(
				count_triangles(after, CORNERS, before + k), 1);
		}
		end(&file);
	}
}

/* Programs may take 65535 as the end of a strip. */
static void test_indices_are_shorts_below_65535(void **state)
{
	(void)state;
	for (int most = 65533; most <= 65536; most++) {
		static const float place[3 * 65537];
		uint32_t index[4] = {0, (uint32_t)most, 1, 2}, list[4];
		struct file file;
		int accessor;

		begin(&file, sizeof(place) + 64);
		set(&file, file.attributes, "POSITION", place, 65537, FLOAT,
			"VEC3");
		set(&file, file.primitive, "indices", index, 4, UINT, "SCALAR");
		json_object_set_new(
			file.primitive, "mode", json_integer(POINTS));
		rebuild(&file, (struct optimize_plan){0});
		accessor = index_of(rewritten(&file), "indices");
		assert_int_equal(
			gltf_document_array(file.document, accessor).component,
			most < 65535 ? USHORT : UINT);
		gltf_document_uints(file.document, accessor, list);
		assert_memory_equal(list, index, sizeof(list));
		end(&file);
	}
}

static const float triangle[3][3] = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}};

/* Only positions need their bounds; targets leave out vertices that stay. */
static void test_positions_have_bounds_and_targets_are_sparse(void **state)
{
	static const float moved[40][3] = {{0}, {0}, {1, 0, 0}};
	float place[40][3] = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}};
	const json_t *target, *attributes;
	struct file file;
	json_t *delta;

	(void)state;
	begin(&file, 8192);
	set(&file, file.attributes, "POSITION", place, 40, FLOAT, "VEC3");
	set(&file, file.attributes, "NORMAL", moved, 40, FLOAT, "VEC3");
	delta = json_object();
	json_object_set_new(file.primitive, "targets", json_pack("[o]", delta));
	set(&file, delta, "POSITION", moved, 40, FLOAT, "VEC3");
	set(&file, delta, "NORMAL", moved, 40, FLOAT, "VEC3");
	rebuild(&file, (struct optimize_plan){0});
	attributes = json_object_get(rewritten(&file), "attributes");
	target = json_array_get(json_object_get(rewritten(&file), "targets"), 0);
	assert_true(member_exists(&file, attributes, "POSITION", "min"));
	assert_true(member_exists(&file, attributes, "POSITION", "max"));
	assert_false(member_exists(&file, attributes, "NORMAL", "min"));
	assert_false(member_exists(&file, attributes, "NORMAL", "max"));
	assert_false(member_exists(&file, attributes, "POSITION", "sparse"));
	assert_false(member_exists(&file, attributes, "NORMAL", "sparse"));
	assert_true(member_exists(&file, target, "POSITION", "min"));
	assert_false(member_exists(&file, target, "NORMAL", "min"));
	assert_true(member_exists(&file, target, "POSITION", "sparse"));
	assert_true(member_exists(&file, target, "NORMAL", "sparse"));
	end(&file);
}

static bool requires_quantization(const struct file *file)
{
	const json_t *names = json_object_get(
		gltf_document_json(file->document), "extensionsRequired");

	for (size_t i = 0; i < json_array_size(names); i++) {
		if (strcmp(json_string_value(json_array_get(names, i)),
			    "KHR_mesh_quantization") == 0) {
			return true;
		}
	}
	return false;
}

/* glTF itself allows coordinates, colours and weights of integers. */
static void test_signed_integers_need_an_extension(void **state)
{
	static const struct {
		const char *name;
		const char *type;
		bool positions;
		int component;
	} cases[] = {
		{"NORMAL", "VEC3", false, BYTE},
		{"TANGENT", "VEC4", false, BYTE},
		{"TEXCOORD_0", "VEC2", false, USHORT},
		{"COLOR_0", "VEC4", false, USHORT},
		{"_OWN", "VEC3", false, FLOAT},
		{"POSITION", "VEC3", true, SHORT},
	};
	static const float value[3][4] = {
		{0, 0, 1, 1}, {0, 1, 0, 1}, {1, 0, 0, 1}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(*cases); i++) {
		float found[NUMBERS_MAX];
		struct file file;

		begin(&file, 4096);
		set(&file, file.attributes, "POSITION", triangle, 3, FLOAT,
			"VEC3");
		set(&file, file.attributes, cases[i].name,
			strcmp(cases[i].name, "POSITION") == 0 ? triangle[0]
							       : value[0],
			3, FLOAT, cases[i].type);
		rebuild(&file,
			(struct optimize_plan){.directions = true,
				.positions = cases[i].positions});
		assert_int_equal(
			read_array(&file,
				json_object_get(rewritten(&file), "attributes"),
				cases[i].name, found)
				.component,
			cases[i].component);
		assert_int_equal(requires_quantization(&file),
			cases[i].component == BYTE ||
				cases[i].component == SHORT);
		end(&file);
	}
}

/* Rewrites numbers of one attribute, of so many components. */
static struct gltf_document_array rewrite(const char *name, const char *type,
	int component, const void *value, int count, float out[NUMBERS_MAX])
{
	struct gltf_document_array array;
	struct file file;

	begin(&file, 4096);
	set(&file, file.attributes, "POSITION", triangle, count, FLOAT, "VEC3");
	set(&file, file.attributes, name, value, count, component, type);
	rebuild(&file,
		(struct optimize_plan){.directions = true,
			.weights = true,
			.byte_weights = true});
	array = read_array(&file,
		json_object_get(rewritten(&file), "attributes"), name, out);
	end(&file);
	return array;
}

static void test_numbers_of_joints_are_bytes_up_to_255(void **state)
{
	(void)state;
	for (int most = 254; most <= 257; most++) {
		const uint16_t joint[3][4] = {
			{0, 1, 2, 3}, {4, 5, 6, (uint16_t)most}, {7, 8, 9, 1}};
		float found[NUMBERS_MAX];

		assert_int_equal(
			rewrite("JOINTS_0", "VEC4", USHORT, joint, 3, found)
				.component,
			most <= 255 ? UBYTE : USHORT);
		for (int i = 0; i < 12; i++) {
			assert_near(found[i], joint[i / 4][i % 4], 0);
		}
	}
}

/* Coordinates of a repeated texture exceed 1. */
static void test_coordinates_stay_floats_outside_of_0_and_1(void **state)
{
	static const float ends[] = {-0.001f, 0.0f, 1.0f, 1.001f};

	(void)state;
	for (int i = 0; i < 4; i++) {
		float value[3][2] = {{0.5f, 0.25f}, {0, 1}, {1, 0}};
		bool inside = i == 1 || i == 2;
		float found[NUMBERS_MAX];

		value[2][1] = ends[i];
		assert_int_equal(
			rewrite("TEXCOORD_0", "VEC2", FLOAT, value, 3, found)
				.component,
			inside ? USHORT : FLOAT);
		assert_near(
			found[5], inside ? 65535.0f * ends[i] : ends[i], 1e-6);
	}
}

/* Differences of normals, of which the last one is beyond a byte's range. */
static void test_differences_stay_floats_outside_of_1(void **state)
{
	static const float ends[] = {-1.001f, -1.0f, 1.0f, 1.001f};

	(void)state;
	for (int i = 0; i < 4; i++) {
		const float moved[3][3] = {{0, 0, 1}, {0, -1, 0}, {ends[i]}};
		bool inside = i == 1 || i == 2;
		float found[NUMBERS_MAX];
		struct file file;
		json_t *delta = json_object();

		begin(&file, 4096);
		set(&file, file.attributes, "POSITION", triangle, 3, FLOAT,
			"VEC3");
		set(&file, file.attributes, "NORMAL", triangle, 3, FLOAT,
			"VEC3");
		json_object_set_new(
			file.primitive, "targets", json_pack("[o]", delta));
		set(&file, delta, "NORMAL", moved, 3, FLOAT, "VEC3");
		rebuild(&file, (struct optimize_plan){.directions = true});
		assert_int_equal(
			read_array(&file,
				json_array_get(json_object_get(rewritten(&file),
						       "targets"),
					0),
				"NORMAL", found)
				.component,
			inside ? BYTE : FLOAT);
		assert_near(found[6], inside ? 127.0f * ends[i] : ends[i], 0);
		end(&file);
	}
}

/* Parts below 0 count as 0, and where none is left all stay 0. */
static void test_weights_of_a_vertex_sum_to_1_or_0(void **state)
{
	static const float weight[3][4] = {{-0.5f, 0.25f, 0.75f, 0},
		{0, 0, 0, 0}, {0.1f, 0.2f, 0.1f, -0.0f}};
	static const float wanted[12] = {
		0, 64, 191, 0, 0, 0, 0, 0, 64, 127, 64, 0};
	float found[NUMBERS_MAX];

	(void)state;
	assert_int_equal(
		rewrite("WEIGHTS_0", "VEC4", FLOAT, weight, 3, found).component,
		UBYTE);
	assert_all_near(found, wanted, 12, 0);
}

/* Two sets share the sum of each vertex; a third is no weight of theirs. */
static void test_sets_of_weights_are_rounded_together(void **state)
{
	static const float first[3][4] = {
		{0.3f, 0.1f, 0.1f, 0}, {0.5f, 0.25f}, {1}};
	static const float second[3][4] = {
		{0.5f, 0, 0, 0}, {0.25f, 0, 0, 0}, {1}};
	static const float wanted[2][12] = {
		{76, 26, 26, 0, 127, 64, 0, 0, 127, 0, 0, 0},
		{127, 0, 0, 0, 64, 0, 0, 0, 128, 0, 0, 0}};
	float found[2][NUMBERS_MAX];
	const json_t *attributes;
	struct file file;

	(void)state;
	begin(&file, 4096);
	set(&file, file.attributes, "POSITION", triangle, 3, FLOAT, "VEC3");
	set(&file, file.attributes, "WEIGHTS_0", first, 3, FLOAT, "VEC4");
	set(&file, file.attributes, "WEIGHTS_1", second, 3, FLOAT, "VEC4");
	set(&file, file.attributes, "WEIGHTS_3", second, 3, FLOAT, "VEC4");
	rebuild(&file,
		(struct optimize_plan){.weights = true, .byte_weights = true});
	attributes = json_object_get(rewritten(&file), "attributes");
	assert_int_equal(
		read_array(&file, attributes, "WEIGHTS_3", found[0]).component,
		FLOAT);
	for (int i = 0; i < 2; i++) {
		char name[] = "WEIGHTS_0";

		name[8] = (char)('0' + i);
		assert_int_equal(
			read_array(&file, attributes, name, found[i]).component,
			UBYTE);
	}
	for (int v = 0; v < 3; v++) {
		float sum = 0.0f;

		for (int i = 0; i < 8; i++) {
			float value = found[i / 4][4 * v + i % 4];

			sum += value;
			assert_near(value, wanted[i / 4][4 * v + i % 4], 1);
		}
		assert_near(sum, 255, 0);
	}
	end(&file);
}

/* Where one set is of integers, the others keep their floats. */
static void test_weights_stay_beside_those_of_integers(void **state)
{
	static const float floats[3][4] = {{0.5f}, {0.5f}, {0.5f}};
	static const uint8_t bytes[3][4] = {{127}, {127}, {127}};

	(void)state;
	for (int i = 0; i < 2; i++) {
		float found[NUMBERS_MAX];
		const json_t *attributes;
		struct file file;

		begin(&file, 4096);
		set(&file, file.attributes, "POSITION", triangle, 3, FLOAT,
			"VEC3");
		set(&file, file.attributes, i ? "WEIGHTS_1" : "WEIGHTS_0",
			floats, 3, FLOAT, "VEC4");
		set(&file, file.attributes, i ? "WEIGHTS_0" : "WEIGHTS_1",
			bytes, 3, UBYTE, "VEC4");
		rebuild(&file,
			(struct optimize_plan){
				.weights = true, .byte_weights = true});
		attributes = json_object_get(rewritten(&file), "attributes");
		assert_int_equal(read_array(&file, attributes,
					 i ? "WEIGHTS_1" : "WEIGHTS_0", found)
					 .component,
			FLOAT);
		assert_near(found[0], 0.5, 0);
		end(&file);
	}
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_triangles_keep_the_corners_and_their_attributes),
		cmocka_unit_test(test_vertices_are_used_in_their_order),
		cmocka_unit_test(test_indices_are_shorts_below_65535),
		cmocka_unit_test(
			test_positions_have_bounds_and_targets_are_sparse),
		cmocka_unit_test(test_signed_integers_need_an_extension),
		cmocka_unit_test(test_numbers_of_joints_are_bytes_up_to_255),
		cmocka_unit_test(test_coordinates_stay_floats_outside_of_0_and_1),
		cmocka_unit_test(test_differences_stay_floats_outside_of_1),
		cmocka_unit_test(test_weights_of_a_vertex_sum_to_1_or_0),
		cmocka_unit_test(test_sets_of_weights_are_rounded_together),
		cmocka_unit_test(test_weights_stay_beside_those_of_integers),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
