/* What an optimised file holds, in the words and numbers of glTF. */
#include "app/compare/optimize/optimize.h"
#include "app/model/gltf/document/gltf_document.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	COUNT = 3 /* of vertices, joints and instances */
};

/* The unit of a triangle with coordinates of up to 3. */
static const float unit = 4.0f;

static const float bound_px = 0.5f;

struct numbers {
	float position[COUNT][3];
	float weight[COUNT][4];
	float matrix[COUNT][16];
	float translation[COUNT][3];
	float scale[COUNT][3];
	uint8_t joint[COUNT][4];
	int16_t rotation[COUNT][4];
};

static const struct numbers numbers = {
	.position = {{-3.0f, 0.0f, 0.5f}, {3.0f, 0.0f, 0.0f},
		{0.0f, 2.0f, -1.0f}},
	.weight = {{1.0f}, {1.0f}, {1.0f}},
	.matrix = {{1.0f, 0.25f, 0.0f, 0.0f, 0.0f, 1.5f, 0.0f, 0.0f, -0.5f,
			   0.0f, 1.0f, 0.0f, 0.125f, -2.0f, 3.0f, 1.0f},
		{2.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.75f, 0.0f, 0.0f, 0.0f,
			1.0f, 0.0f, 1.0f, 2.0f, -3.0f, 1.0f},
		{1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, -1.0f,
			0.0f, 0.0f, 5.0f, 0.0f, 7.0f, 1.0f}},
	.translation = {{1.0f, 20.0f, 300.0f}, {-7.0f, 0.0f, 0.5f},
		{1e-3f, -2.0f, 9.0f}},
	.scale = {{1.0f, 2.0f, 3.0f}, {0.5f, 0.25f, 1.0f}, {7.0f, 7.0f, 7.0f}},
	.joint = {{0}, {1}, {2}},
	.rotation = {{0, 0, 0, 32767}, {32767, 0, 0, 0}, {0, -23170, 0, 23170}},
};

/* Meshes on rigid nodes, on two skins, and with instances. */
static const char text[] =
	"{\"asset\":{\"version\":\"2.0\",\"extras\":{\"limber_error_px\":0.25,"
	"\"by\":\"hand\"}},\"extensionsUsed\":[\"EXT_mesh_gpu_instancing\"],"
	"\"scene\":0,\"scenes\":[{\"nodes\":[0,1,2,3,4,5,6,7,8]}],"
	"\"buffers\":[{\"uri\":\"data.bin\",\"byteLength\":384}],"
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":384}],"
	"\"nodes\":[{\"mesh\":0},"
	"{\"mesh\":0,\"scale\":[1,2,3],\"extras\":{\"error_m\":0.5}},"
	"{\"mesh\":0,\"matrix\":[1,2,4,0,-3,1,6,0,8,3,1,0,5,6,7,1]},"
	"{\"mesh\":1,\"skin\":0},{\"mesh\":2,\"skin\":1},"
	"{\"mesh\":3,\"extensions\":{\"EXT_mesh_gpu_instancing\":{"
	"\"attributes\":{\"TRANSLATION\":7,\"ROTATION\":8,\"SCALE\":9,\"_KIND\":5}}}},"
	"{\"name\":\"a\"},{\"name\":\"b\"},{\"name\":\"c\"}],"
	"\"skins\":[{\"joints\":[6,7,8]},"
	"{\"joints\":[6,7,8],\"inverseBindMatrices\":5}],"
	"\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]},"
	"{\"primitives\":[{\"attributes\":{\"POSITION\":1,\"JOINTS_0\":2,"
	"\"WEIGHTS_0\":3}}]},"
	"{\"primitives\":[{\"attributes\":{\"POSITION\":4,\"JOINTS_0\":2,"
	"\"WEIGHTS_0\":3}}]},"
	"{\"primitives\":[{\"attributes\":{\"POSITION\":6}}]}],"
	"\"accessors\":["
	"{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"
	"{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"
	"{\"bufferView\":0,\"byteOffset\":348,\"componentType\":5121,"
	"\"count\":3,\"type\":\"VEC4\"},"
	"{\"bufferView\":0,\"byteOffset\":36,\"componentType\":5126,"
	"\"count\":3,\"type\":\"VEC4\"},"
	"{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"
	"{\"bufferView\":0,\"byteOffset\":84,\"componentType\":5126,"
	"\"count\":3,\"type\":\"MAT4\"},"
	"{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"
	"{\"bufferView\":0,\"byteOffset\":276,\"componentType\":5126,"
	"\"count\":3,\"type\":\"VEC3\"},"
	"{\"bufferView\":0,\"byteOffset\":360,\"componentType\":5122,"
	"\"normalized\":true,\"count\":3,\"type\":\"VEC4\"},"
	"{\"bufferView\":0,\"byteOffset\":312,\"componentType\":5126,"
	"\"count\":3,\"type\":\"VEC3\"}]}";

struct file {
	struct test_path folder;
	struct optimize_result result;
	struct gltf_document *document;
	json_t *root;
};

/* Optimizes a model whose data.bin holds the numbers. */
static void open_optimized(struct file *file, const char *model_text)
{
	const struct log log = log_to_stderr(LOG_ERROR);
	const struct optimize_request request = {
		.bound_px = bound_px,
		.width = 480,
		.height = 640,
		.memory_bytes = MODEL_MEMORY_BYTES,
	};
	struct test_path model_path, data;
	struct model_source source = {
		.name = "small.glb", .memory_bytes = MODEL_MEMORY_BYTES};
	struct model *model;

	file->folder = temp_dir_make();
	model_path = path_join(&file->folder, "model.gltf");
	data = path_join(&file->folder, "data.bin");
	file_write(data.text, &numbers, sizeof(numbers));
	file_write(model_path.text, model_text, strlen(model_text));
	assert_int_equal(model_load(model_path.text, &log, &model), 0);
	assert_int_equal(
		optimize_model(model, &request, &log, &file->result), 0);
	model_destroy(model);
	source.data = file->result.data;
	source.size = file->result.after.file;
	assert_int_equal(gltf_document_open(&source, &log, &file->document), 0);
	file->root = gltf_document_json(file->document);
}

static void close_optimized(struct file *file)
{
	gltf_document_close(file->document);
	free(file->result.data);
	temp_dir_remove(&file->folder);
}

static int begin(void **state)
{
	static struct file file;

	open_optimized(&file, text);
	*state = &file;
	return 0;
}

static int end(void **state)
{
	close_optimized(*state);
	return 0;
}

static json_t *item(const struct file *file, const char *list, int index)
{
	json_t *found = json_array_get(
		json_object_get(file->root, list), (size_t)index);

	assert_non_null(found);
	return found;
}

static int integer(json_t *object, const char *key)
{
	json_t *value = json_object_get(object, key);

	assert_true(json_is_integer(value));
	return (int)json_integer_value(value);
}

static void check_array(
	json_t *object, const char *key, const float *wanted, int count)
{
	json_t *array = json_object_get(object, key);

	assert_int_equal(json_array_size(array), count);
	for (int i = 0; i < count; i++) {
		assert_near(json_number_value(json_array_get(array, (size_t)i)),
			wanted[i], 1e-6);
	}
}

static void check_floats(const struct file *file, int accessor,
	const float *wanted, int width, int component)
{
	float found[COUNT * 16];
	struct gltf_document_array array =
		gltf_document_array(file->document, accessor);

	assert_int_equal(array.count, COUNT);
	assert_int_equal(array.width, width);
	assert_int_equal(array.component, component);
	assert_int_equal(
		gltf_document_floats(file->document, accessor, found), 0);
	assert_all_near(found, wanted, (size_t)(COUNT * width), 0.0);
}

/* The first three columns multiply by the unit, the fourth moves. */
static void enlarge(float *matrix)
{
	for (int column = 0; column < 3; column++) {
		for (int row = 0; row < 3; row++) {
			matrix[4 * column + row] *= unit;
		}
	}
}

static void test_nodes_enlarge_their_mesh(void **state)
{
	const struct file *file = *state;
	float matrix[16] = {1, 2, 4, 0, -3, 1, 6, 0, 8, 3, 1, 0, 5, 6, 7, 1};
	json_t *node = item(file, "nodes", 1);

	enlarge(matrix);
	check_array(item(file, "nodes", 0), "scale",
		(const float[]){unit, unit, unit}, 3);
	check_array(node, "scale", (const float[]){unit, 2 * unit, 3 * unit}, 3);
	assert_near(json_number_value(json_object_get(
			    json_object_get(node, "extras"), "error_m")),
		0.5f / unit, 1e-6);
	check_array(item(file, "nodes", 2), "matrix", matrix, 16);
	for (int i = 3; i < 9; i++) {
		assert_null(json_object_get(item(file, "nodes", i), "scale"));
		assert_null(json_object_get(item(file, "nodes", i), "matrix"));
	}
}

/* A skin without matrices gets those that enlarge. */
static void test_inverse_bind_matrices_enlarge_a_skin(void **state)
{
	const struct file *file = *state;
	float wanted[COUNT][16];

	for (int i = 0; i < COUNT; i++) {
		memset(wanted[i], 0, sizeof(wanted[i]));
		wanted[i][0] = wanted[i][5] = wanted[i][10] = unit;
		wanted[i][15] = 1.0f;
	}
	check_floats(file,
		integer(item(file, "skins", 0), "inverseBindMatrices"),
		wanted[0], 16, 5126);
	memcpy(wanted, numbers.matrix, sizeof(wanted));
	for (int i = 0; i < COUNT; i++) {
		enlarge(wanted[i]);
	}
	check_floats(file,
		integer(item(file, "skins", 1), "inverseBindMatrices"),
		wanted[0], 16, 5126);
}

/* They keep their node's scale, as it would move them, too. */
static void test_instances_keep_their_numbers(void **state)
{
	const struct file *file = *state;
	json_t *extensions =
		json_object_get(item(file, "nodes", 5), "extensions");
	json_t *attributes = json_object_get(
		json_object_get(extensions, "EXT_mesh_gpu_instancing"),
		"attributes");
	float rotation[COUNT][4];

	for (int i = 0; i < COUNT * 4; i++) {
		rotation[i / 4][i % 4] = numbers.rotation[i / 4][i % 4];
	}
	check_floats(file, integer(attributes, "TRANSLATION"),
		numbers.translation[0], 3, 5126);
	check_floats(
		file, integer(attributes, "ROTATION"), rotation[0], 4, 5122);
	assert_true(gltf_document_array(
		file->document, integer(attributes, "ROTATION"))
			    .normalized);
	check_floats(
		file, integer(attributes, "SCALE"), numbers.scale[0], 3, 5126);
	check_floats(file, integer(attributes, "_KIND"), numbers.matrix[0], 16,
		5126);
}

/* Each mesh's points, times its unit, are those of the file before. */
static void test_points_are_fractions_of_the_unit(void **state)
{
	const struct file *file = *state;

	for (int mesh = 0; mesh < 4; mesh++) {
		json_t *primitive = json_array_get(
			json_object_get(item(file, "meshes", mesh), "primitives"),
			0);
		int accessor = integer(
			json_object_get(primitive, "attributes"), "POSITION");
		struct gltf_document_array array =
			gltf_document_array(file->document, accessor);
		float found[COUNT][3], step = 1.0f;

		assert_int_equal(array.count, COUNT);
		assert_int_equal(
			gltf_document_floats(file->document, accessor, found[0]),
			0);
		if (mesh < 3) {
			assert_true(array.normalized);
			assert_int_equal(array.component, 5122);
			step = unit / 32767.0f;
		} else {
			assert_int_equal(array.component, 5126);
		}
		for (int i = 0; i < COUNT * 3; i++) {
			assert_near(found[i / 3][i % 3] * step,
				numbers.position[i / 3][i % 3], 0.51f * step);
		}
	}
}

static void check_names(
	const struct file *file, const char *list, const char *first, int count)
{
	json_t *names = json_object_get(file->root, list);

	assert_int_equal(json_array_size(names), count);
	assert_string_equal(json_string_value(json_array_get(names, 0)), first);
	assert_string_equal(
		json_string_value(json_array_get(names, (size_t)count - 1)),
		"KHR_mesh_quantization");
}

static void test_the_file_states_what_it_needs_and_how_exact_it_is(void **state)
{
	const struct file *file = *state;
	json_t *extras =
		json_object_get(json_object_get(file->root, "asset"), "extras");

	check_names(file, "extensionsUsed", "EXT_mesh_gpu_instancing", 2);
	check_names(file, "extensionsRequired", "KHR_mesh_quantization", 1);
	assert_string_equal(
		json_string_value(json_object_get(extras, "by")), "hand");
	assert_near(file->result.earlier_px, 0.25f, 0.0);
	assert_true(file->result.peak_px > 0.0f);
	assert_true(file->result.peak_px <= bound_px - 0.25f);
	assert_near(
		json_number_value(json_object_get(extras, "limber_error_px")),
		bound_px, 1e-6);
}

/* A skin on a triangle with so many sets of joints and weights. */
static void open_sets(struct file *file, int sets)
{
	char model[4096];
	int used = snprintf(model, sizeof(model),
		"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
		"\"scenes\":[{\"nodes\":[0,1,2,3]}],"
		"\"nodes\":[{\"mesh\":0,\"skin\":0},{},{},{}],"
		"\"skins\":[{\"joints\":[1,2,3]}],"
		"\"buffers\":[{\"uri\":\"data.bin\",\"byteLength\":384}],"
		"\"bufferViews\":[{\"buffer\":0,\"byteLength\":384}],"
		"\"accessors\":[{\"bufferView\":0,\"byteOffset\":348,"
		"\"componentType\":5121,\"count\":3,\"type\":\"VEC4\"},"
		"{\"bufferView\":0,\"byteOffset\":36,\"componentType\":5126,"
		"\"count\":3,\"type\":\"VEC4\"},{\"bufferView\":0,"
		"\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
		"\"meshes\":[{\"primitives\":[{\"attributes\":{"
		"\"POSITION\":2");

	for (int i = 0; i < sets; i++) {
		used += snprintf(model + used, sizeof(model) - (size_t)used,
			",\"JOINTS_%d\":0,\"WEIGHTS_%d\":1", i, i);
	}
	snprintf(model + used, sizeof(model) - (size_t)used, "}}]}]}");
	open_optimized(file, model);
}

/* Up to eight sets are rounded together; the weights of more stay floats. */
static void test_all_sets_of_weights_are_kept(void **state)
{
	static const int counts[] = {1, 2, 8, 9, 12};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(counts); i++) {
		struct file file;
		json_t *attributes;

		open_sets(&file, counts[i]);
		attributes = json_object_get(
			json_array_get(json_object_get(item(&file, "meshes", 0),
					       "primitives"),
				0),
			"attributes");
		for (int set = 0; set < counts[i]; set++) {
			char name[24];
			struct gltf_document_array array;

			snprintf(name, sizeof(name), "WEIGHTS_%d", set);
			assert_in_range(integer(attributes, name), 0,
				gltf_document_array_count(file.document) - 1);
			array = gltf_document_array(
				file.document, integer(attributes, name));
			assert_int_equal(array.count, COUNT);
			assert_int_equal(array.width, 4);
			assert_int_equal(array.component == 5126, counts[i] > 8);
		}
		close_optimized(&file);
	}
}

/* What models have whose keys are those at 3 s, in accessors 0 (time) and 1. */
#define POSE_DATA                                                            \
	"\"asset\":{\"version\":\"2.0\"},"                                   \
	"\"buffers\":[{\"uri\":\"data.bin\",\"byteLength\":384}],"           \
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":384}],"               \
	"\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":2}}]}]," \
	"\"accessors\":["                                                    \
	"{\"bufferView\":0,\"byteOffset\":12,\"componentType\":5126,"        \
	"\"count\":1,\"type\":\"SCALAR\",\"min\":[3],\"max\":[3]},"          \
	"{\"bufferView\":0,\"byteOffset\":24,\"componentType\":5126,"        \
	"\"count\":1,\"type\":\"VEC3\"},"                                    \
	"{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"

/* Two channels of one key each. */
static const char poses_text[] =
	"{" POSE_DATA "\"scene\":0,\"scenes\":[{\"nodes\":[0,1]}],"
	"\"nodes\":[{\"mesh\":0},{\"mesh\":0}],"
	"\"animations\":[{\"samplers\":[{\"input\":0,\"output\":1}],"
	"\"channels\":["
	"{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"translation\"}},"
	"{\"sampler\":0,\"target\":{\"node\":1,\"path\":\"translation\"}}]}]}";

/* A clip of poses lasts as long as before, with as many keys. */
static void test_single_keys_do_not_become_more(void **state)
{
	const struct log log = log_to_stderr(LOG_ERROR);
	struct test_path path;
	struct model *model;
	struct file file;

	(void)state;
	open_optimized(&file, poses_text);
	assert_int_equal(file.result.before.key_count, 2);
	assert_int_equal(file.result.after.key_count, 2);
	path = path_join(&file.folder, "small.glb");
	file_write(path.text, file.result.data, file.result.after.file);
	assert_int_equal(model_load(path.text, &log, &model), 0);
	assert_near(model->clip[0].duration_s, 3.0, 0.0);
	model_destroy(model);
	close_optimized(&file);
}

/* Channels whose samplers are equal, differ in interpolation, or are the same. */
static const char shared_text[] =
	"{" POSE_DATA "\"scene\":0,\"scenes\":[{\"nodes\":[0,1,2,3]}],"
	"\"nodes\":[{\"mesh\":0},{\"mesh\":0},{\"mesh\":0},{\"mesh\":0}],"
	"\"animations\":[{\"samplers\":[{\"input\":0,\"output\":1},"
	"{\"input\":0,\"output\":1,\"interpolation\":\"STEP\"},"
	"{\"input\":0,\"output\":1}],"
	"\"channels\":["
	"{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"translation\"}},"
	"{\"sampler\":1,\"target\":{\"node\":1,\"path\":\"translation\"}},"
	"{\"sampler\":2,\"target\":{\"node\":2,\"path\":\"translation\"}},"
	"{\"sampler\":0,\"target\":{\"node\":3,\"path\":\"translation\"}}]}]}";

/* Channels share a sampler if its times, values and interpolation are equal. */
static void test_equal_channels_share_a_sampler(void **state)
{
	/* The first one keeps a key at the end of the clip. */
	static const int sampler[] = {0, 1, 2, 2};
	struct file file;
	json_t *animation;

	(void)state;
	open_optimized(&file, shared_text);
	animation = json_array_get(json_object_get(file.root, "animations"), 0);
	assert_int_equal(
		json_array_size(json_object_get(animation, "samplers")), 3);
	for (size_t i = 0; i < 4; i++) {
		json_t *channel = json_array_get(
			json_object_get(animation, "channels"), i);

		assert_int_equal(
			json_integer_value(json_object_get(channel, "sampler")),
			sampler[i]);
	}
	close_optimized(&file);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_nodes_enlarge_their_mesh),
		cmocka_unit_test(test_inverse_bind_matrices_enlarge_a_skin),
		cmocka_unit_test(test_instances_keep_their_numbers),
		cmocka_unit_test(test_points_are_fractions_of_the_unit),
		cmocka_unit_test(
			test_the_file_states_what_it_needs_and_how_exact_it_is),
		cmocka_unit_test(test_all_sets_of_weights_are_kept),
		cmocka_unit_test(test_single_keys_do_not_become_more),
		cmocka_unit_test(test_equal_channels_share_a_sampler),
	};

	return cmocka_run_group_tests(tests, begin, end);
}
