/*
 * What optimizing does with the file that it reads again: accessors in any
 * order, clips that move nothing, and files that it refuses.
 */
#include "app/compare/optimize/optimize.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

/* Without a bound that may be used, two files are built and none is searched. */
static const struct optimize_request request = {
	.bound_px = 0.0f,
	.width = 48,
	.height = 64,
	.memory_bytes = MODEL_MEMORY_BYTES,
};

/* Whether a key's value is the number of an accessor, wherever it stands. */
static bool refers(const char *key, const char *above)
{
	static const char *const keys[] = {
		"indices", "inverseBindMatrices", "input", "output"};

	for (size_t i = 0; i < ARRAY_COUNT(keys); i++) {
		if (strcmp(key, keys[i]) == 0) {
			return true;
		}
	}
	return strcmp(above, "attributes") == 0 || strcmp(above, "targets") == 0;
}

/* Adds a number to each reference to an accessor, modulo their count. */
static void shift(json_t *value, const char *above, int by, int count)
{
	json_t *member;
	const char *key;
	size_t i;

	json_array_foreach(value, i, member)
	{
		shift(member, above, by, count);
	}
	json_object_foreach(value, key, member)
	{
		if (json_is_integer(member) && refers(key, above)) {
			json_integer_set(member,
				(json_integer_value(member) + by) % count);
		} else {
			shift(member, key, by, count);
		}
	}
}

/* Moves all accessors one place down the list, and the last to the first. */
static void turn(json_t *root)
{
	json_t *accessors = json_object_get(root, "accessors");
	size_t last = json_array_size(accessors) - 1;
	json_t *moved = json_incref(json_array_get(accessors, last));

	json_array_remove(accessors, last);
	json_array_insert_new(accessors, 0, moved);
	shift(root, "", 1, (int)last + 1);
}

static struct optimize_result optimized(const char *path)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct optimize_result result;
	struct model *model;

	assert_int_equal(model_load(path, &log, &model), 0);
	assert_int_equal(optimize_model(model, &request, &log, &result), 0);
	model_destroy(model);
	return result;
}

/* Each accessor is once the first, the second... and the last of the list. */
static void check_any_order(const char *source, const struct test_path *folder)
{
	struct test_path path = path_join(folder, "turned.gltf");
	struct optimize_result wanted = optimized(source);
	json_t *root = json_load_file(source, 0, NULL);
	size_t count = json_array_size(json_object_get(root, "accessors"));

	assert_true(count > 0);
	for (size_t i = 0; i < count; i++) {
		struct optimize_result found;

		turn(root);
		assert_int_equal(json_dump_file(root, path.text, 0), 0);
		found = optimized(path.text);
		assert_int_equal(found.after.file, wanted.after.file);
		assert_memory_equal(found.data, wanted.data, found.after.file);
		free(found.data);
	}
	json_decref(root);
	free(wanted.data);
}

static void test_the_order_of_accessors_does_not_matter(void **state)
{
	static const char *const names[] = {
		"gltf/accessor/sparse.gltf",
		"gltf/clip/single_key.gltf",
		"gltf/mesh/indices.gltf",
		"gltf/skin/and_morph.gltf",
	};
	struct test_path folder = temp_dir_make();

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		check_any_order(fixture_path(names[i]).text, &folder);
	}
	temp_dir_remove(&folder);
}

/* A triangle on a skin, and twice more as instances. */
static const struct numbers {
	float position[3][3];
	float weight[3][4];
	float matrix[3][16];
	uint8_t joint[3][4];
} numbers = {
	.position = {{-3.0f, 0.0f, 0.5f}, {3.0f, 0.0f, 0.0f}, {0.0f, 2.0f}},
	.weight = {{1.0f}, {0.5f, 0.5f}, {0.25f, 0.75f}},
	.matrix = {{[0] = 1.0f, [5] = 2.0f, [10] = 1.0f, [15] = 1.0f},
		{[0] = 1.0f, [5] = 1.0f, [10] = 3.0f, [15] = 1.0f}},
	.joint = {{0}, {0, 1}, {0, 1}},
};

/* glTF allows more matrices than joints. */
static const char skinned[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0,1,2,3]}],"
	"\"nodes\":[{\"mesh\":0,\"skin\":0},{},{},{\"mesh\":0,\"extensions\":"
	"{\"EXT_mesh_gpu_instancing\":{\"attributes\":{\"TRANSLATION\":0}}}}],"
	"\"extensionsUsed\":[\"EXT_mesh_gpu_instancing\"],"
	"\"skins\":[{\"joints\":[1,2],\"inverseBindMatrices\":2}],"
	"\"meshes\":[{\"primitives\":[{\"attributes\":"
	"{\"POSITION\":4,\"JOINTS_0\":3,\"WEIGHTS_0\":1}}]}],"
	"\"buffers\":[{\"byteLength\":288,\"uri\":\"data.bin\"}],"
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":288}],\"accessors\":["
	"{\"bufferView\":0,\"componentType\":5126,\"count\":2,\"type\":\"VEC3\"},"
	"{\"bufferView\":0,\"byteOffset\":36,\"componentType\":5126,"
	"\"count\":3,\"type\":\"VEC4\"},"
	"{\"bufferView\":0,\"byteOffset\":84,\"componentType\":5126,"
	"\"count\":3,\"type\":\"MAT4\"},"
	"{\"bufferView\":0,\"byteOffset\":276,\"componentType\":5121,"
	"\"count\":3,\"type\":\"VEC4\"},"
	"{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}]}";

static void test_matrices_and_instances_may_be_the_first_accessor(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path data = path_join(&folder, "data.bin");
	struct test_path path = path_join(&folder, "model.gltf");

	(void)state;
	file_write(data.text, &numbers, sizeof(numbers));
	file_write(path.text, skinned, sizeof(skinned) - 1);
	check_any_order(path.text, &folder);
	temp_dir_remove(&folder);
}

/* A refused file gives nothing back that the caller could free or write. */
static void check_refused(const struct model *model, int error, const char *why)
{
	struct log_capture said;
	const struct log log = log_capture_begin(&said);
	struct optimize_result result;

	memset(&result, 0x5A, sizeof(result));
	assert_int_equal(optimize_model(model, &request, &log, &result), error);
	assert_null(result.data);
	assert_int_equal(result.after.file, 0);
	assert_int_equal(log_capture_count(&said, LOG_ERROR), 1);
	assert_true(log_capture_has(&said, LOG_ERROR, model->path));
	assert_true(log_capture_has(&said, LOG_ERROR, why));
}

static void test_only_gltf_is_optimized(void **state)
{
	struct model *model = model_fixture("xfile/quad.x", NULL);

	(void)state;
	check_refused(model, -ENOTSUP,
		"limber optimizes glTF files only; this one is DirectX");
	model_destroy(model);
}

/* Puts the content of a fixture in place of a file that has been loaded. */
static void replace(const struct test_path *path, const char *name)
{
	size_t size;
	char *text = file_read(fixture_path(name).text, &size);

	file_write(path->text, text, size);
	free(text);
}

static void test_a_file_that_has_changed_since_is_refused(void **state)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "model.gltf");
	struct model *model;

	(void)state;
	replace(&path, "gltf/clip/cubic.gltf");
	assert_int_equal(model_load(path.text, &log, &model), 0);
	file_write(path.text, "{\"asset\":{}", 11);
	check_refused(model, -EINVAL, "");
	file_write(path.text, "no model", 8);
	check_refused(model, -ENOTSUP, "limber optimizes glTF files only");
	temp_dir_remove(&folder);
	check_refused(model, -ENOENT, strerror(ENOENT));
	model_destroy(model);
}

/* Writes cubic.gltf with a clip before its own that has a channel of no node. */
static void write_still_clip(const char *path)
{
	json_t *root = json_load_file(
		fixture_path("gltf/clip/cubic.gltf").text, 0, NULL);
	json_t *animations = json_object_get(root, "animations");
	json_t *still = json_deep_copy(json_array_get(animations, 0));

	json_object_set_new(still, "name", json_string("glow"));
	json_object_set_new(still, "channels",
		json_pack("[{s:i, s:{s:s}}]", "sampler", 0, "target", "path",
			"pointer"));
	assert_int_equal(json_array_insert_new(animations, 0, still), 0);
	assert_int_equal(json_dump_file(root, path, 0), 0);
	json_decref(root);
}

/* People and scripts call clips by their numbers. */
static void test_a_clip_without_nodes_keeps_its_number(void **state)
{
	const struct log log = log_to_stderr(LOG_ERROR);
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "model.gltf");
	struct optimize_result result;
	struct model *model, *found;

	(void)state;
	write_still_clip(path.text);
	assert_int_equal(model_load(path.text, &log, &model), 0);
	result = optimized(path.text);
	file_write(path.text, result.data, result.after.file);
	assert_int_equal(model_load(path.text, &log, &found), 0);
	assert_int_equal(found->clip_count, model->clip_count);
	for (int c = 0; c < found->clip_count; c++) {
		assert_string_equal(found->clip[c].name, model->clip[c].name);
		assert_int_equal(found->clip[c].channel_count,
			model->clip[c].channel_count);
		assert_near(found->clip[c].duration_s,
			model->clip[c].duration_s, 1e-6);
	}
	model_destroy(model);
	model_destroy(found);
	free(result.data);
	temp_dir_remove(&folder);
}

/* One of them says when the clip ends; the others need no time of their own. */
static void test_channels_that_stay_have_one_key_at_0(void **state)
{
	const struct log log = log_to_stderr(LOG_ERROR);
	struct optimize_result result =
		optimized(fixture_path("gltf/clip/single_key.gltf").text);
	struct model *found;
	int at_end = 0;

	(void)state;
	assert_int_equal(model_load_memory(result.data, result.after.file,
				 "small.glb", &log, &found),
		0);
	assert_int_equal(found->clip_count, 1);
	assert_near(found->clip[0].duration_s, 1.25, 0);
	assert_int_equal(found->clip[0].channel_count, 3);
	for (int c = 0; c < 3; c++) {
		const struct model_channel *channel = &found->clip[0].channel[c];

		assert_int_equal(channel->key_count, 1);
		at_end += channel->time_s[0] > 0.0f;
		assert_near(channel->time_s[0],
			channel->time_s[0] > 0.0f ? 1.25 : 0.0, 0);
	}
	assert_int_equal(at_end, 1);
	model_destroy(found);
	free(result.data);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_order_of_accessors_does_not_matter),
		cmocka_unit_test(
			test_matrices_and_instances_may_be_the_first_accessor),
		cmocka_unit_test(test_only_gltf_is_optimized),
		cmocka_unit_test(test_a_file_that_has_changed_since_is_refused),
		cmocka_unit_test(test_a_clip_without_nodes_keeps_its_number),
		cmocka_unit_test(test_channels_that_stay_have_one_key_at_0),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
