/* Which type of number each array of an optimised file has. */
#include "app/compare/optimize/optimize.h"
#include "app/model/gltf/document/gltf_document.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

enum {
	BYTE = 5120,
	UBYTE = 5121,
	SHORT = 5122,
	USHORT = 5123,
	FLOAT = 5126,
	VERTICES = 3,
	DATA_BYTES = 4096
};

/* A file with a triangle on node 0, to which a test adds arrays. */
struct file {
	json_t *root, *attributes, *accessors, *views;
	uint8_t data[DATA_BYTES];
	size_t size;

	struct optimize_result result;
	struct gltf_document *document; /* of the optimised file */
};

static json_t *at(json_t *root, const char *list, size_t index)
{
	return json_array_get(json_object_get(root, list), index);
}

static int add(struct file *file, const void *value, int count, int width,
	int component, const char *type)
{
	size_t each = component == FLOAT ? 4 : 2;
	size_t bytes = each * (size_t)count * (size_t)width;

	assert_true(file->size + bytes <= sizeof(file->data));
	memcpy(file->data + file->size, value, bytes);
	json_array_append_new(file->views,
		json_pack("{s:i, s:i, s:i}", "buffer", 0, "byteOffset",
			(int)file->size, "byteLength", (int)bytes));
	file->size += (bytes + 3) & ~(size_t)3;
	json_array_append_new(file->accessors,
		json_pack("{s:i, s:i, s:i, s:s}", "bufferView",
			(int)json_array_size(file->views) - 1, "componentType",
			component, "count", count, "type", type));
	return (int)json_array_size(file->accessors) - 1;
}

static void begin(struct file *file)
{
	static const float triangle[VERTICES][3] = {
		{-1.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.5f, 0.0f}};

	*file = (struct file){
		.root = json_pack("{s:{s:s}, s:i, s:[{s:[i]}], s:[{s:i}],"
				  " s:[{s:[{s:{}}]}], s:[], s:[]}",
			"asset", "version", "2.0", "scene", 0, "scenes",
			"nodes", 0, "nodes", "mesh", 0, "meshes", "primitives",
			"attributes", "accessors", "bufferViews"),
	};
	assert_non_null(file->root);
	file->attributes = json_object_get(
		at(at(file->root, "meshes", 0), "primitives", 0), "attributes");
	file->accessors = json_object_get(file->root, "accessors");
	file->views = json_object_get(file->root, "bufferViews");
	json_object_set_new(file->attributes, "POSITION",
		json_integer(add(file, triangle, VERTICES, 3, FLOAT, "VEC3")));
}

/* By the first bound no key is needed, by the second all are. */
static const float loose_px = 1e3f, strict_px = 0.5f;

static void optimize(struct file *file, float bound_px)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	const struct optimize_request request = {.bound_px = bound_px,
		.width = 48,
		.height = 64,
		.memory_bytes = MODEL_MEMORY_BYTES};
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "model.gltf");
	struct test_path data = path_join(&folder, "data.bin");
	struct model_source source = {
		.name = "small.glb", .memory_bytes = MODEL_MEMORY_BYTES};
	struct model *model;

	json_object_set_new(file->root, "buffers",
		json_pack("[{s:s, s:i}]", "uri", "data.bin", "byteLength",
			(int)file->size));
	file_write(data.text, file->data, file->size);
	assert_int_equal(json_dump_file(file->root, path.text, 0), 0);
	assert_int_equal(model_load(path.text, &log, &model), 0);
	assert_int_equal(
		optimize_model(model, &request, &log, &file->result), 0);
	model_destroy(model);
	temp_dir_remove(&folder);
	source.data = file->result.data;
	source.size = file->result.after.file;
	assert_int_equal(gltf_document_open(&source, &log, &file->document), 0);
}

static void end(struct file *file)
{
	gltf_document_close(file->document);
	free(file->result.data);
	json_decref(file->root);
}

/* The array to which a member refers, whose stored numbers are as wanted. */
static struct gltf_document_array expect(const struct file *file,
	const json_t *object, const char *key, int component,
	const float *wanted)
{
	json_t *index = json_object_get(object, key);
	struct gltf_document_array array;
	float found[64];

	assert_true(json_is_integer(index));
	array = gltf_document_array(
		file->document, (int)json_integer_value(index));
	assert_int_equal(array.component, component);
	assert_int_equal(array.normalized,
		component != FLOAT && strncmp(key, "JOINTS", 6) != 0 &&
			key[0] != '_');
	assert_true(array.count * array.width <= 64);
	assert_int_equal(gltf_document_floats(file->document,
				 (int)json_integer_value(index), found),
		0);
	if (wanted) {
		assert_all_near(found, wanted, array.count * array.width, 1e-6);
	}
	return array;
}

static json_t *primitive_of(const struct file *file)
{
	return at(at(gltf_document_json(file->document), "meshes", 0),
		"primitives", 0);
}

/* An attribute of floats, as it is written and as it is in the new file. */
struct attribute {
	const char *name;
	int width;
	float value[VERTICES][4];
	int component;
	float wanted[VERTICES][4];
};

static void check_attribute(const struct attribute *attribute)
{
	static const char *const types[] = {"VEC2", "VEC3", "VEC4"};
	float value[VERTICES * 4], wanted[VERTICES * 4];
	int width = attribute->width;
	struct file file;

	for (int i = 0; i < VERTICES * width; i++) {
		value[i] = attribute->value[i / width][i % width];
		wanted[i] = attribute->wanted[i / width][i % width];
	}
	begin(&file);
	json_object_set_new(file.attributes, attribute->name,
		json_integer(add(&file, value, VERTICES, width, FLOAT,
			types[width - 2])));
	optimize(&file, loose_px);
	expect(&file, json_object_get(primitive_of(&file), "attributes"),
		attribute->name, attribute->component, wanted);
	end(&file);
}

/* Directions get the length 1; those without a length stay. */
static void test_directions_are_bytes(void **state)
{
	static const struct attribute attributes[] = {
		{"NORMAL", 3, {{0, 0, 2}, {0, -0.5f, 0}, {0, 0, 0}}, BYTE,
			{{0, 0, 127}, {0, -127, 0}, {0, 0, 0}}},
		{"NORMAL", 3, {{3, 4, 0}, {0, 3, 4}, {4, 0, -3}}, BYTE,
			{{76, 102, 0}, {0, 76, 102}, {102, 0, -76}}},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(attributes); i++) {
		check_attribute(&attributes[i]);
	}
}

/* Colours fit shorts from 0 to 1; what limber does not know stays. */
static void test_colours_within_0_and_1_are_shorts(void **state)
{
	static const struct attribute attributes[] = {
		{"COLOR_0", 3, {{0, 0.5f, 1}, {0.25f, 0, 0}, {1, 1, 1}}, USHORT,
			{{0, 32768, 65535}, {16384, 0, 0},
				{65535, 65535, 65535}}},
		{"COLOR_0", 4, {{0, 0, 1, 0}, {0, 0, 0, 1}, {1, 0, 0, 0}}, USHORT,
			{{0, 0, 65535, 0}, {0, 0, 0, 65535}, {65535, 0, 0, 0}}},
		{"COLOR_0", 3, {{0, 0, 0}, {0, 0, 0}, {0, 0, 1.25f}}, FLOAT,
			{{0, 0, 0}, {0, 0, 0}, {0, 0, 1.25f}}},
		{"COLOR_0", 3, {{-0.25f, 0, 0}, {0, 0, 0}, {0, 0, 1}}, FLOAT,
			{{-0.25f, 0, 0}, {0, 0, 0}, {0, 0, 1}}},
		{"_KIND", 3, {{0, 0.5f, 1}, {0, 0, 0}, {1, 1, 1}}, FLOAT,
			{{0, 0.5f, 1}, {0, 0, 0}, {1, 1, 1}}},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(attributes); i++) {
		check_attribute(&attributes[i]);
	}
}

/* Where the columns of a matrix lie, of an element and of the next ones. */
struct matrix {
	const char *type;
	int rows, component;
	size_t column; /* bytes, of which the last may only fill up */
};

/*
 * An attribute of matrices whose numbers are 1, 2, 3..., with bytes of 0xEE
 * between their columns.
 */
static void check_matrix(const struct matrix *matrix)
{
	int width = matrix->rows * matrix->rows;
	int size = matrix->component == FLOAT ? 4
		: matrix->component == USHORT ? 2
					      : 1;
	size_t bytes = matrix->column * (size_t)(matrix->rows * VERTICES);
	uint8_t data[64 * VERTICES];
	float wanted[16 * VERTICES];
	struct file file;
	json_t *accessor, *number;

	memset(data, 0xEE, sizeof(data));
	for (int i = 0; i < width * VERTICES; i++) {
		uint8_t *to = data +
			(size_t)(i / matrix->rows) * matrix->column +
			(size_t)(i % matrix->rows * size);
		uint16_t integer = (uint16_t)(i + 1);

		wanted[i] = (float)(i + 1);
		memcpy(to, size == 4 ? (void *)&wanted[i] : &integer,
			(size_t)size);
	}
	begin(&file);
	/* The view has as many bytes as these floats. */
	number = json_integer(
		add(&file, data, (int)(bytes / 4), 1, FLOAT, "SCALAR"));
	accessor = json_array_get(
		file.accessors, (size_t)json_integer_value(number));
	json_object_set_new(file.attributes, "_MATRIX", number);
	json_object_set_new(accessor, "type", json_string(matrix->type));
	json_object_set_new(
		accessor, "componentType", json_integer(matrix->component));
	json_object_set_new(accessor, "count", json_integer(VERTICES));
	optimize(&file, loose_px);
	number = json_object_get(
		json_object_get(primitive_of(&file), "attributes"), "_MATRIX");
	accessor = at(gltf_document_json(file.document), "accessors",
		(size_t)json_integer_value(number));
	assert_string_equal(json_string_value(json_object_get(accessor, "type")),
		matrix->type);
	assert_int_equal(
		expect(&file, json_object_get(primitive_of(&file), "attributes"),
			"_MATRIX", matrix->component, wanted)
			.rows,
		matrix->rows);
	end(&file);
}

static void test_matrices_keep_their_type_and_numbers(void **state)
{
	static const struct matrix matrices[] = {
		{"MAT2", 2, FLOAT, 8},
		{"MAT3", 3, FLOAT, 12},
		{"MAT4", 4, FLOAT, 16},
		{"MAT2", 2, USHORT, 4},
		{"MAT3", 3, USHORT, 8},
		{"MAT4", 4, USHORT, 8},
		{"MAT2", 2, UBYTE, 4},
		{"MAT3", 3, UBYTE, 4},
		{"MAT4", 4, UBYTE, 4},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(matrices); i++) {
		check_matrix(&matrices[i]);
	}
}

/* Each weight is a whole number of 255ths, and the largest makes up the sum. */
static void test_weights_are_bytes_whose_sum_is_1(void **state)
{
	static const struct attribute weights = {"WEIGHTS_0", 4,
		{{0.3f, 0.3f, 0.4f}, {0.25f, 0.25f, 0.25f, 0.25f}, {0.0f, 1.0f}},
		UBYTE, {{76, 76, 103}, {63, 64, 64, 64}, {0, 255}}};
	static const uint16_t joints[VERTICES][4] = {
		{0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 255}};
	json_t *list = json_array(), *nodes;
	struct file file;

	(void)state;
	begin(&file);
	nodes = json_object_get(file.root, "nodes");
	for (int i = 1; i <= 257; i++) {
		json_array_append_new(nodes, json_object());
		json_array_append_new(list, json_integer(i));
	}
	json_object_set_new(at(file.root, "nodes", 0), "skin", json_integer(0));
	json_object_set_new(
		file.root, "skins", json_pack("[{s:o}]", "joints", list));
	json_object_set_new(file.attributes, "JOINTS_0",
		json_integer(add(&file, joints, VERTICES, 4, USHORT, "VEC4")));
	json_object_set_new(file.attributes, "WEIGHTS_0",
		json_integer(
			add(&file, weights.value, VERTICES, 4, FLOAT, "VEC4")));
	optimize(&file, loose_px);
	expect(&file, json_object_get(primitive_of(&file), "attributes"),
		"WEIGHTS_0", UBYTE, weights.wanted[0]);
	expect(&file, json_object_get(primitive_of(&file), "attributes"),
		"JOINTS_0", UBYTE, NULL);
	end(&file);
}

/* A target moves by fractions of the unit, and turns within -1 and 1. */
static void test_targets_within_1_are_integers(void **state)
{
	static const float moved[VERTICES][3] = {
		{0.5f, 0.0f, 0.0f}, {0.0f, -1.0f, 0.0f}, {0.0f, 0.0f, 2.0f}};
	static const float short_moved[VERTICES][3] = {
		{8192.0f}, {0.0f, -16384.0f}, {0.0f, 0.0f, 32767.0f}};
	static const float turned[VERTICES][3] = {
		{1.0f, 0.0f, 0.0f}, {0.0f, -1.0f, 0.0f}, {0.0f, 0.0f, 0.5f}};
	static const float byte_turned[VERTICES][3] = {
		{127.0f}, {0.0f, -127.0f}, {0.0f, 0.0f, 64.0f}};

	(void)state;
	for (int far = 0; far < 2; far++) {
		float turn[VERTICES][3];
		struct file file;
		json_t *target;

		memcpy(turn, turned, sizeof(turn));
		turn[2][0] = far ? -1.25f : 0.0f;
		begin(&file);
		json_object_set_new(file.attributes, "NORMAL",
			json_integer(
				add(&file, turned, VERTICES, 3, FLOAT, "VEC3")));
		target = json_pack("[{s:i, s:i}]", "POSITION",
			add(&file, moved, VERTICES, 3, FLOAT, "VEC3"), "NORMAL",
			add(&file, turn, VERTICES, 3, FLOAT, "VEC3"));
		json_object_set_new(
			at(at(file.root, "meshes", 0), "primitives", 0),
			"targets", target);
		optimize(&file, loose_px);
		target = at(primitive_of(&file), "targets", 0);
		expect(&file, target, "POSITION", SHORT, short_moved[0]);
		expect(&file, target, "NORMAL", far ? FLOAT : BYTE,
			far ? turn[0] : byte_turned[0]);
		end(&file);
	}
}

/* A channel of three keys, the first and the last of which are the same. */
static void check_channel(const char *path, int width, const float *first,
	const float *middle, int component)
{
	static const float time_s[3] = {0.0f, 1.0f, 2.0f};
	static const char *const types[] = {"SCALAR", "", "VEC3", "VEC4"};
	static const float moved[VERTICES][3] = {{0.5f}};
	float value[3 * 4];
	struct file file;
	json_t *sampler;

	for (int key = 0; key < 3; key++) {
		memcpy(value + key * width, key == 1 ? middle : first,
			(size_t)width * sizeof(float));
	}
	begin(&file);
	if (strcmp(path, "weights") == 0) {
		json_object_set_new(
			at(at(file.root, "meshes", 0), "primitives", 0),
			"targets",
			json_pack("[{s:i}]", "POSITION",
				add(&file, moved, VERTICES, 3, FLOAT, "VEC3")));
	}
	json_object_set_new(file.root, "animations",
		json_pack("[{s:[{s:i, s:i}], s:[{s:i, s:{s:i, s:s}}]}]",
			"samplers", "input",
			add(&file, time_s, 3, 1, FLOAT, "SCALAR"), "output",
			add(&file, value, 3, width, FLOAT, types[width - 1]),
			"channels", "sampler", 0, "target", "node", 0, "path",
			path));
	optimize(&file, strict_px);
	sampler = at(at(gltf_document_json(file.document), "animations", 0),
		"samplers", 0);
	assert_int_equal(
		expect(&file, sampler, "output", component, NULL).width, width);
	expect(&file, sampler, "input", FLOAT, NULL);
	end(&file);
}

/* Keys half a turn apart, about any axis, stay exact: see turns_half(). */
static void test_rotations_are_shorts_unless_they_turn_half(void **state)
{
	(void)state;
	for (int i = 0; i < 4; i++) {
		for (int j = i + 1; j < 4; j++) {
			float from[4] = {0.0f}, half[4] = {0.0f};
			float third[4] = {0.0f};

			from[i] = half[j] = 1.0f;
			third[i] = 0.5f;
			third[j] = 0.8660254f;
			check_channel("rotation", 4, from, half, FLOAT);
			check_channel("rotation", 4, from, third, SHORT);
		}
	}
}

static void test_weights_of_targets_are_shorts_within_1(void **state)
{
	static const struct {
		float first, middle;
		int component;
	} cases[] = {
		{0.0f, 1.0f, USHORT},
		{0.25f, 0.5f, USHORT},
		{0.5f, -0.25f, SHORT},
		{-1.0f, 1.0f, SHORT},
		{0.0f, 1.25f, FLOAT},
		{-1.25f, 0.5f, FLOAT},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		check_channel("weights", 1, &cases[i].first, &cases[i].middle,
			cases[i].component);
	}
}

static void test_ways_and_scales_stay_floats(void **state)
{
	static const float first[3] = {0.5f, 0.25f, 1.0f};
	static const float middle[3] = {1.0f, 0.5f, 0.5f};

	(void)state;
	check_channel("translation", 3, first, middle, FLOAT);
	check_channel("scale", 3, first, middle, FLOAT);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_directions_are_bytes),
		cmocka_unit_test(test_colours_within_0_and_1_are_shorts),
		cmocka_unit_test(test_matrices_keep_their_type_and_numbers),
		cmocka_unit_test(test_weights_are_bytes_whose_sum_is_1),
		cmocka_unit_test(test_targets_within_1_are_integers),
		cmocka_unit_test(test_rotations_are_shorts_unless_they_turn_half),
		cmocka_unit_test(test_weights_of_targets_are_shorts_within_1),
		cmocka_unit_test(test_ways_and_scales_stay_floats),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
