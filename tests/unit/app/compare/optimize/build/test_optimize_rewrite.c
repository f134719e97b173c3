/* Where a rewritten file has the unit of its positions, and what it lists. */
#include "platform/base/compiler.h"
#include "tests/support/test.h"
#include "tests/unit/app/compare/optimize/build/rewrite_bench.h"

enum {
	UNIT = 8 /* of positions up to 5 */
};

/* The first number is the largest. */
static const float positions[3][3] = {{-5, 0, 0}, {3, 0, 0}, {0, 4, 3}};
static const struct optimize_plan in_units = {
	.directions = true, .positions = true};

/* States the bounds of the positions, by which their unit is chosen. */
static void set_positions(struct file *file)
{
	json_t *accessor;

	set(file, file->attributes, "POSITION", positions, 3, FLOAT, "VEC3");
	accessor = json_array_get(
		file->accessors, json_array_size(file->accessors) - 1);
	json_object_set_new(
		accessor, "min", json_pack("[f, f, f]", -5.0, 0.0, 0.0));
	json_object_set_new(
		accessor, "max", json_pack("[f, f, f]", 3.0, 4.0, 3.0));
}

static void expect_positions(const struct file *file, bool units)
{
	float found[NUMBERS_MAX];

	assert_int_equal(
		read_array(file, json_object_get(rewritten(file), "attributes"),
			"POSITION", found)
			.component,
		units ? SHORT : FLOAT);
	for (int i = 0; i < 9; i++) {
		float value = (&positions[0][0])[i];

		assert_near(
			found[i], units ? 32767.0f * value / UNIT : value, 0.5);
	}
}

static json_t *element(json_t *root, const char *list, size_t index)
{
	return json_array_get(json_object_get(root, list), index);
}

static json_t *node_of(const struct file *file)
{
	return element(gltf_document_json(file->document), "nodes", 0);
}

static void expect_numbers(
	const json_t *object, const char *key, const float *wanted, int count)
{
	const json_t *numbers = json_object_get(object, key);

	assert_int_equal(json_array_size(numbers), count);
	for (int i = 0; i < count; i++) {
		assert_near(
			json_number_value(json_array_get(numbers, (size_t)i)),
			wanted[i], 1e-6);
	}
}

/* Rewrites the file with a member of node 0, which it takes. */
static void rebuild_node(struct file *file, const char *key, json_t *value,
	struct optimize_plan plan)
{
	begin(file, 4096);
	set_positions(file);
	if (value) {
		json_object_set_new(element(file->root, "nodes", 0), key, value);
	}
	rebuild(file, plan);
	expect_positions(file, plan.positions);
}

static void test_a_node_gets_the_unit_as_its_scale(void **state)
{
	static const float unit[3] = {UNIT, UNIT, UNIT};
	static const float scaled[3] = {2 * UNIT, -3 * UNIT, 0.5f * UNIT};
	struct file file;

	(void)state;
	rebuild_node(&file, NULL, NULL, in_units);
	expect_numbers(node_of(&file), "scale", unit, 3);
	assert_null(json_object_get(node_of(&file), "matrix"));
	end(&file);
	rebuild_node(&file, "scale", json_pack("[f, f, f]", 2.0, -3.0, 0.5),
		in_units);
	expect_numbers(node_of(&file), "scale", scaled, 3);
	end(&file);
	rebuild_node(&file, NULL, NULL, (struct optimize_plan){0});
	assert_null(json_object_get(node_of(&file), "scale"));
	end(&file);
}

/* 1, 2, 3... as a file has them, and with their first columns enlarged. */
static json_t *count_up(float first, float wanted[16])
{
	json_t *numbers = json_array();

	for (int i = 0; i < 16; i++) {
		float value = first + (float)i;

		json_array_append_new(numbers, json_real((double)value));
		wanted[i] = i < 12 && i % 4 != 3 ? UNIT * value : value;
	}
	return numbers;
}

/* The last row stays, and so does the last column, where the node is. */
static void test_a_matrix_is_enlarged_but_not_moved(void **state)
{
	struct file file;
	float wanted[16];

	(void)state;
	rebuild_node(&file, "matrix", count_up(1, wanted), in_units);
	expect_numbers(node_of(&file), "matrix", wanted, 16);
	assert_null(json_object_get(node_of(&file), "scale"));
	end(&file);
}

/* An error in metres is one of a smaller model then. */
static void test_an_error_in_metres_is_divided_by_the_unit(void **state)
{
	const json_t *extras;
	struct file file;

	(void)state;
	rebuild_node(
		&file, "extras", json_pack("{s:f}", "error_m", 0.25), in_units);
	extras = json_object_get(node_of(&file), "extras");
	assert_near(json_number_value(json_object_get(extras, "error_m")),
		0.25 / UNIT, 1e-9);
	end(&file);
}

/* A skin with two joints, and with matrices or without. */
static void rebuild_skin(
	struct file *file, const float *matrix, struct optimize_plan plan)
{
	json_t *skin = json_pack("{s:[i, i]}", "joints", 1, 2);

	begin(file, 4096);
	set_positions(file);
	json_object_set_new(
		element(file->root, "nodes", 0), "skin", json_integer(0));
	json_array_append_new(
		json_object_get(file->root, "nodes"), json_object());
	json_array_append_new(
		json_object_get(file->root, "nodes"), json_object());
	json_object_set_new(file->root, "skins", json_pack("[o]", skin));
	if (matrix) {
		set(file, skin, "inverseBindMatrices", matrix, 2, FLOAT, "MAT4");
	}
	rebuild(file, plan);
	expect_positions(file, plan.positions);
	assert_null(json_object_get(node_of(file), "scale"));
}

static void expect_matrices(const struct file *file, const float wanted[32])
{
	const json_t *skin =
		element(gltf_document_json(file->document), "skins", 0);
	float found[NUMBERS_MAX];
	struct gltf_document_array array =
		read_array(file, skin, "inverseBindMatrices", found);

	assert_int_equal(array.count, 2);
	assert_int_equal(array.width, 16);
	assert_int_equal(array.component, FLOAT);
	assert_all_near(found, wanted, 32, 1e-6);
}

static void test_matrices_of_a_skin_get_the_unit(void **state)
{
	float matrix[32], wanted[32], same[32] = {0};
	struct file file;

	(void)state;
	json_decref(count_up(1, wanted));
	json_decref(count_up(17, wanted + 16));
	for (int i = 0; i < 32; i++) {
		matrix[i] = (float)(i + 1);
		same[i] = i % 16 % 5 == 0 ? (i % 16 == 15 ? 1 : UNIT) : 0;
	}
	rebuild_skin(&file, matrix, in_units);
	expect_matrices(&file, wanted);
	end(&file);
	rebuild_skin(&file, matrix, (struct optimize_plan){0});
	expect_matrices(&file, matrix);
	end(&file);
	/* Without matrices the joints have the identity. */
	rebuild_skin(&file, NULL, in_units);
	expect_matrices(&file, same);
	end(&file);
	rebuild_skin(&file, NULL, (struct optimize_plan){0});
	assert_null(json_object_get(
		element(gltf_document_json(file.document), "skins", 0),
		"inverseBindMatrices"));
	end(&file);
}

static int count_of(const struct file *file, const char *list, const char *name)
{
	const json_t *names =
		json_object_get(gltf_document_json(file->document), list);
	int count = 0;

	for (size_t i = 0; i < json_array_size(names); i++) {
		count += strcmp(json_string_value(json_array_get(names, i)),
				 name) == 0;
	}
	return count;
}

/* Each extension once, whether the file had it before or not. */
static void test_extensions_that_were_required_stay(void **state)
{
	static const char own[] = "KHR_mesh_quantization";
	static const char other[] = "KHR_texture_transform";

	(void)state;
	for (int i = 0; i < 8; i++) {
		bool others = i & 1, owns = i & 2, units = i & 4;
		struct file file;

		begin(&file, 4096);
		set_positions(&file);
		for (int list = 0; list < 2; list++) {
			json_t *names = json_array();

			if (others) {
				json_array_append_new(names, json_string(other));
			}
			if (owns) {
				json_array_append_new(names, json_string(own));
			}
			json_object_set_new(file.root,
				list ? "extensionsRequired" : "extensionsUsed",
				names);
		}
		rebuild(&file, units ? in_units : (struct optimize_plan){0});
		for (int list = 0; list < 2; list++) {
			const char *name =
				list ? "extensionsRequired" : "extensionsUsed";

			assert_int_equal(count_of(&file, name, other), others);
			assert_int_equal(
				count_of(&file, name, own), owns || units);
		}
		end(&file);
	}
}

static size_t length_of(const struct file *file, const char *list)
{
	return json_array_size(
		json_object_get(gltf_document_json(file->document), list));
}

/* A file whose arrays nothing refers to becomes one without arrays. */
static void test_arrays_that_nothing_uses_are_not_written(void **state)
{
	struct file file;

	(void)state;
	begin(&file, 4096);
	set_positions(&file);
	json_object_clear(file.attributes);
	rebuild(&file, (struct optimize_plan){0});
	assert_int_equal(length_of(&file, "accessors"), 0);
	assert_int_equal(length_of(&file, "bufferViews"), 0);
	assert_int_equal(length_of(&file, "buffers"), 0);
	end(&file);
	begin(&file, 4096);
	add(&file, positions, 3, FLOAT, "VEC3");
	set_positions(&file);
	rebuild(&file, (struct optimize_plan){0});
	assert_int_equal(length_of(&file, "accessors"), 1);
	assert_int_equal(length_of(&file, "bufferViews"), 1);
	assert_int_equal(length_of(&file, "buffers"), 1);
	end(&file);
}

/* A target may move vertices by more than the positions are large. */
static void test_differences_beyond_the_unit_stay_floats(void **state)
{
	static const float ends[] = {-1.125f, -1.0f, 1.0f, 1.125f};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(ends); i++) {
		const float moved[3][3] = {
			{0}, {0.5f, UNIT * ends[i], 0}, {0, 0.5f}};
		bool inside = i == 1 || i == 2;
		json_t *delta = json_object();
		float found[NUMBERS_MAX];
		struct file file;

		begin(&file, 4096);
		set_positions(&file);
		json_object_set_new(
			file.primitive, "targets", json_pack("[o]", delta));
		set(&file, delta, "POSITION", moved, 3, FLOAT, "VEC3");
		rebuild(&file, in_units);
		expect_positions(&file, true);
		assert_int_equal(
			read_array(&file,
				json_array_get(json_object_get(rewritten(&file),
						       "targets"),
					0),
				"POSITION", found)
				.component,
			inside ? SHORT : FLOAT);
		assert_near(found[4], inside ? 32767.0f * ends[i] : ends[i], 0);
		end(&file);
	}
}

static int target_of(const struct file *file, int accessor)
{
	json_t *root = gltf_document_json(file->document);
	json_t *view = json_object_get(
		element(root, "accessors", (size_t)accessor), "bufferView");
	json_t *target = json_object_get(
		element(root, "bufferViews", (size_t)json_integer_value(view)),
		"target");

	return target ? (int)json_integer_value(target) : 0;
}

/* GL_ARRAY_BUFFER and GL_ELEMENT_ARRAY_BUFFER; matrices are for no buffer. */
static void test_views_say_for_which_buffer_of_gl_they_are(void **state)
{
	static const uint16_t index[3] = {0, 1, 2};
	static const float matrix[32] = {1};
	const json_t *skin;
	struct file file;

	(void)state;
	rebuild_skin(&file, matrix, in_units);
	skin = element(gltf_document_json(file.document), "skins", 0);
	assert_int_equal(
		target_of(&file, index_of(skin, "inverseBindMatrices")), 0);
	end(&file);
	begin(&file, 4096);
	set_positions(&file);
	set(&file, file.primitive, "indices", index, 3, USHORT, "SCALAR");
	rebuild(&file, in_units);
	assert_int_equal(
		target_of(&file, index_of(rewritten(&file), "indices")), 34963);
	assert_int_equal(
		target_of(&file,
			index_of(json_object_get(rewritten(&file), "attributes"),
				"POSITION")),
		34962);
	end(&file);
}

/* Positions have bounds, also where another attribute has their numbers. */
static void test_an_array_that_is_shared_has_the_bounds_of_positions(
	void **state)
{
	(void)state;
	for (int first = 0; first < 2; first++) {
		struct file file;
		const json_t *attributes;

		begin(&file, 4096);
		if (first) {
			set(&file, file.attributes, "_OWN", positions, 3, FLOAT,
				"VEC3");
		}
		set_positions(&file);
		if (!first) {
			set(&file, file.attributes, "_OWN", positions, 3, FLOAT,
				"VEC3");
		}
		rebuild(&file, (struct optimize_plan){0});
		attributes = json_object_get(rewritten(&file), "attributes");
		assert_int_equal(index_of(attributes, "_OWN"),
			index_of(attributes, "POSITION"));
		assert_true(member_exists(&file, attributes, "POSITION", "min"));
		assert_true(member_exists(&file, attributes, "POSITION", "max"));
		end(&file);
	}
}

/* Numbers of accessors that the file does not have, or that are none. */
static void test_members_without_an_accessor_are_left_alone(void **state)
{
	json_t *const values[] = {json_integer(-1), json_integer(1),
		json_integer(2), json_real(0.0), json_string("0")};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(values); i++) {
		struct file file;

		begin(&file, 4096);
		set_positions(&file);
		json_object_set(file.attributes, "_OWN", values[i]);
		rebuild(&file, in_units);
		expect_positions(&file, true);
		assert_true(json_equal(
			json_object_get(
				json_object_get(rewritten(&file), "attributes"),
				"_OWN"),
			values[i]));
		end(&file);
		json_decref(values[i]);
	}
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_node_gets_the_unit_as_its_scale),
		cmocka_unit_test(test_a_matrix_is_enlarged_but_not_moved),
		cmocka_unit_test(test_an_error_in_metres_is_divided_by_the_unit),
		cmocka_unit_test(test_matrices_of_a_skin_get_the_unit),
		cmocka_unit_test(test_views_say_for_which_buffer_of_gl_they_are),
		cmocka_unit_test(
			test_an_array_that_is_shared_has_the_bounds_of_positions),
		cmocka_unit_test(test_differences_beyond_the_unit_stay_floats),
		cmocka_unit_test(test_extensions_that_were_required_stay),
		cmocka_unit_test(test_arrays_that_nothing_uses_are_not_written),
		cmocka_unit_test(test_members_without_an_accessor_are_left_alone),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
