/* What optimizing a file says: warnings, errors, and which nodes are idle. */
#include "app/compare/optimize/optimize.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#define TURN(node) \
	"{\"sampler\":0,\"target\":{\"node\":" node ",\"path\":\"rotation\"}}"

/* A triangle on node 0, and two nodes without a mesh, which channels turn. */
#define MODEL(extensions, members, channels)                                 \
	"{\"asset\":{\"version\":\"2.0\"}," extensions                       \
	"\"scenes\":[{\"nodes\":[0,1,2]}],\"nodes\":[{\"mesh\":0},"          \
	"{\"name\":\"first\"},{\"name\":\"second\"" members "}],"            \
	"\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}]," \
	"\"animations\":[{\"samplers\":[{\"input\":1,\"output\":2}],"        \
	"\"channels\":[" channels "]}],\"accessors\":["                      \
	"{\"bufferView\":0,\"componentType\":5126,\"count\":3,"              \
	"\"type\":\"VEC3\"},{\"bufferView\":0,\"byteOffset\":36,"            \
	"\"componentType\":5126,\"count\":2,\"type\":\"SCALAR\"},"           \
	"{\"bufferView\":0,\"byteOffset\":44,\"componentType\":5126,"        \
	"\"count\":2,\"type\":\"VEC4\"}],"                                   \
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":76}],"                \
	"\"buffers\":[{\"uri\":\"data.bin\",\"byteLength\":76}]}"

static const struct {
	float position[3][3], time_s[2], turn[2][4];
} numbers = {
	.position = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}},
	.time_s = {0, 1},
	.turn = {{0, 0, 0, 1}, {0, 0, 0.6f, 0.8f}},
};

struct said {
	struct test_path folder;
	struct model *model;
	struct optimize_result result;
	struct log_capture log; /* of optimizing, not of loading */
};

static void begin(struct said *said, const char *text)
{
	const struct log nowhere = log_to_nowhere();
	const struct log log = log_capture_begin(&said->log);
	const struct optimize_request request = {.bound_px = 1.0f,
		.width = 48,
		.height = 64,
		.memory_bytes = MODEL_MEMORY_BYTES};
	struct test_path path;

	said->folder = temp_dir_make();
	path = path_join(&said->folder, "data.bin");
	file_write(path.text, &numbers, sizeof(numbers));
	path = path_join(&said->folder, "model.gltf");
	file_write(path.text, text, strlen(text));
	assert_int_equal(model_load(path.text, &nowhere, &said->model), 0);
	assert_int_equal(
		optimize_model(said->model, &request, &log, &said->result), 0);
}

static void end(struct said *said)
{
	free(said->result.data);
	model_destroy(said->model);
	temp_dir_remove(&said->folder);
}

static void test_a_file_without_faults_says_nothing(void **state)
{
	struct said said;

	(void)state;
	begin(&said, MODEL("", ",\"extras\":1", TURN("2")));
	assert_int_equal(said.log.count, 0);
	assert_int_equal(said.result.idle.count, 0);
	assert_string_equal(said.result.idle.name, "");
	end(&said);
}

static void test_each_unknown_extension_is_named_once(void **state)
{
	struct said said;

	(void)state;
	begin(&said,
		MODEL("\"extensionsUsed\":[\"EXT_unheard_of\",\"MSFT_lod\","
		      "\"EXT_strange\"],",
			",\"extras\":1", TURN("2")));
	assert_int_equal(said.log.count, 2);
	assert_int_equal(log_capture_count(&said.log, LOG_WARNING), 2);
	assert_true(log_capture_has(&said.log, LOG_WARNING, "EXT_unheard_of"));
	assert_true(log_capture_has(&said.log, LOG_WARNING, "EXT_strange"));
	assert_true(log_capture_has(&said.log, LOG_WARNING, "model.gltf: "));
	assert_null(strstr((const char *)said.result.data + 20, "EXT_"));
	end(&said);
}

/* Loading the model has said so already, and each new file has it, too. */
static void test_what_loading_says_is_not_repeated(void **state)
{
	struct log_capture loaded;
	const struct log log = log_capture_begin(&loaded);
	struct said said;
	struct test_path path;
	struct model *again;

	(void)state;
	begin(&said,
		MODEL("\"skins\":[{\"joints\":[1]}],",
			",\"extras\":1,\"skin\":0", TURN("2")));
	assert_int_equal(said.log.count, 0);
	path = path_join(&said.folder, "model.gltf");
	assert_int_equal(model_load(path.text, &log, &again), 0);
	assert_true(log_capture_has(&loaded, LOG_WARNING, "a skin but no mesh"));
	model_destroy(again);
	end(&said);
}

/* Nothing that is drawn follows nodes 1 and 2. */
static void test_nodes_that_lose_their_motion_are_counted(void **state)
{
	struct said said;

	(void)state;
	begin(&said, MODEL("", "", TURN("1") "," TURN("2")));
	assert_int_equal(said.result.idle.count, 2);
	assert_string_equal(said.result.idle.name, "first");
	end(&said);
	begin(&said, MODEL("", "", TURN("2")));
	assert_int_equal(said.result.idle.count, 1);
	assert_string_equal(said.result.idle.name, "second");
	end(&said);
}

static void test_files_of_another_format_are_refused(void **state)
{
	static const char text[] = "xof 0302txt 0064\nMesh { 3; 0;0;0;, 1;0;0;,"
				   " 0;1;0;; 1; 3;0,1,2;; }\n";
	struct log_capture capture;
	const struct log log = log_capture_begin(&capture);
	const struct optimize_request request = {.bound_px = 1.0f,
		.width = 48,
		.height = 64,
		.memory_bytes = MODEL_MEMORY_BYTES};
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "model.x");
	struct optimize_result result;
	struct model *model;

	(void)state;
	file_write(path.text, text, strlen(text));
	assert_int_equal(model_load(path.text, &log, &model), 0);
	capture.count = 0;
	assert_int_equal(
		optimize_model(model, &request, &log, &result), -ENOTSUP);
	assert_int_equal(capture.count, 1);
	assert_int_equal(capture.level[0], LOG_ERROR);
	assert_contains(capture.sentence[0], "optimizes glTF files only");
	assert_null(result.data);
	model_destroy(model);
	temp_dir_remove(&folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_file_without_faults_says_nothing),
		cmocka_unit_test(test_each_unknown_extension_is_named_once),
		cmocka_unit_test(test_what_loading_says_is_not_repeated),
		cmocka_unit_test(test_nodes_that_lose_their_motion_are_counted),
		cmocka_unit_test(test_files_of_another_format_are_refused),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
