/* The bits and keys with which all clips together keep within the bound. */
#include "app/compare/optimize/optimize.h"
#include "app/compare/optimize/optimize_measure.h"
#include "app/model/gltf/document/gltf_document.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
	BYTE_WEIGHTS = 5121,
	SHORTS = 5122,
	SHORT_WEIGHTS = 5123,
	FLOATS = 5126
};

/* A model that is loaded from its text and numbers, and what becomes of it. */
struct settled {
	struct model *model;
	struct optimize_result result;
	struct gltf_document *document; /* of the result */
	int steps;
};

static void count_step(void *context, int done, int total)
{
	(void)done;
	(void)total;
	++*(int *)context;
}

static void load(const char *text, const void *data, size_t size,
	const struct test_path *folder, struct model **out)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct test_path path = path_join(folder, "data.bin");

	file_write(path.text, data, size);
	path = path_join(folder, "model.gltf");
	file_write(path.text, text, strlen(text));
	assert_int_equal(model_load(path.text, &log, out), 0);
}

static void begin(struct settled *settled, const char *text, const void *data,
	size_t size, float bound_px)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	const struct optimize_request request = {.bound_px = bound_px,
		.width = 480,
		.height = 640,
		.memory_bytes = MODEL_MEMORY_BYTES,
		.progress = count_step,
		.progress_context = &settled->steps};
	struct test_path folder = temp_dir_make();
	struct model_source source = {
		.name = "small.glb", .memory_bytes = MODEL_MEMORY_BYTES};

	settled->steps = 0;
	load(text, data, size, &folder, &settled->model);
	assert_int_equal(
		optimize_model(settled->model, &request, &log, &settled->result),
		0);
	source.data = settled->result.data;
	source.size = settled->result.after.file;
	assert_int_equal(
		gltf_document_open(&source, &log, &settled->document), 0);
	temp_dir_remove(&folder);
}

static void end(struct settled *settled)
{
	gltf_document_close(settled->document);
	free(settled->result.data);
	model_destroy(settled->model);
}

/* The type of the numbers to which a member of the result refers. */
static int type_of(
	const struct settled *settled, const json_t *object, const char *member)
{
	const json_t *index = json_object_get(object, member);

	assert_true(json_is_integer(index));
	return gltf_document_array(
		settled->document, (int)json_integer_value(index))
		.component;
}

static const json_t *element(const json_t *object, const char *list, int index)
{
	return json_array_get(json_object_get(object, list), (size_t)index);
}

static const json_t *attributes_of(const struct settled *settled)
{
	const json_t *root = gltf_document_json(settled->document);

	return json_object_get(
		element(element(root, "meshes", 0), "primitives", 0),
		"attributes");
}

#define FLOAT_ARRAY(view, count, type)           \
	"{\"bufferView\":0,\"byteOffset\":" view \
	",\"componentType\":5126,\"count\":" count ",\"type\":\"" type "\"}"

#define CHANNEL(sampler, node, path)                          \
	"{\"sampler\":" sampler ",\"target\":{\"node\":" node \
	",\"path\":\"" path "\"}}"

/* A triangle between a joint that stays and one that turns by 90 degrees. */
static const char bent_text[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0,1,2]}],"
	"\"nodes\":[{\"mesh\":0,\"skin\":0},{},{}],"
	"\"skins\":[{\"joints\":[1,2]}],"
	"\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,"
	"\"WEIGHTS_0\":1,\"JOINTS_0\":2}}]}],"
	"\"animations\":[{\"samplers\":[{\"input\":3,\"output\":4}],"
	"\"channels\":[" CHANNEL("0", "1",
		"rotation") "]}],"
			    "\"accessors\":[" FLOAT_ARRAY(
				    "0", "3", "VEC3") "," FLOAT_ARRAY("36", "3",
				    "VEC4") ","
					    "{\"bufferView\":0,\"byteOffset\":160,\"componentType\":5121,"
					    "\"count\":3,\"type\":\"VEC4\"}," FLOAT_ARRAY(
						    "84", "3",
						    "SCALAR") "," FLOAT_ARRAY("96",
						    "3",
						    "VEC4") "],"
							    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":172}],"
							    "\"buffers\":[{\"uri\":\"data.bin\",\"byteLength\":172}]}";

static const struct {
	float position[3][3], weight[3][4], time_s[3], turn[3][4];
	float unused[4];
	uint8_t joint[3][4];
} bent = {
	.position = {{-1.01f, 0, 0}, {1.01f, 0.3f, 0}, {0.33f, 1.7f, 0}},
	.weight = {{0.3f, 0.7f}, {0.5f, 0.5f}, {0.6f, 0.4f}},
	.time_s = {0, 0.5f, 1},
	.turn = {{0, 0, 0, 1}, {0, 0, 0.70710678f, 0.70710678f}, {0, 0, 0, 1}},
	.joint = {{0, 1}, {0, 1}, {0, 1}},
};

/* The error of a run, whose numbers must have these types. */
static float expect_types(float bound_px, const int types[3])
{
	struct settled settled;
	const json_t *attributes, *clip;
	float peak_px;

	begin(&settled, bent_text, &bent, sizeof(bent), bound_px);
	attributes = attributes_of(&settled);
	clip = element(gltf_document_json(settled.document), "animations", 0);
	assert_int_equal(type_of(&settled, attributes, "WEIGHTS_0"), types[0]);
	assert_int_equal(type_of(&settled, attributes, "POSITION"), types[1]);
	assert_int_equal(
		type_of(&settled, element(clip, "samplers", 0), "output"),
		types[2]);
	peak_px = settled.result.peak_px;
	end(&settled);
	return peak_px;
}

/*
 * The error of each level of precision is that of a run which may use it. Any
 * bound below twice that error takes the next level.
 */
static void test_numbers_take_half_of_the_bound(void **state)
{
	static const int types[4][3] = {
		{BYTE_WEIGHTS, SHORTS, SHORTS},
		{SHORT_WEIGHTS, SHORTS, SHORTS},
		{SHORT_WEIGHTS, FLOATS, SHORTS},
		{FLOATS, FLOATS, FLOATS},
	};
	float peak_px = expect_types(5.0f, types[0]);

	(void)state;
	/* Half a 255th of the way of a quarter turn. */
	assert_in_range(peak_px * 100.0f, 20, 100);
	for (int level = 0; level < 3; level++) {
		float next_px;

		assert_near(expect_types(2.0f * peak_px, types[level]), peak_px,
			1e-6);
		next_px = expect_types(1.999f * peak_px, types[level + 1]);
		assert_true(next_px < 0.9f * peak_px);
		peak_px = next_px;
	}
	assert_near(peak_px, 0, 1e-4);
}

/* Optimizes the bent model, whose file states an error, unless that is NULL. */
static void expect_stated(json_t *stated, float earlier_px, float stated_px)
{
	const float bound_px = 2.0f;
	json_t *root = json_loads(bent_text, 0, NULL), *asset;
	struct settled settled;
	char *text;

	if (stated) {
		json_object_set_new(json_object_get(root, "asset"), "extras",
			json_pack("{s:o}", "limber_error_px", stated));
	}
	text = json_dumps(root, 0);
	assert_non_null(text);
	begin(&settled, text, &bent, sizeof(bent), bound_px);
	assert_near(settled.result.earlier_px, earlier_px, 0);
	assert_true(settled.result.peak_px <=
		(earlier_px < bound_px ? bound_px - earlier_px : 0.0f));
	asset = json_object_get(gltf_document_json(settled.document), "asset");
	assert_near(
		json_number_value(json_object_get(
			json_object_get(asset, "extras"), "limber_error_px")),
		stated_px, 1e-6);
	end(&settled);
	free(text);
	json_decref(root);
}

/* A later run may add what is left, but no error can be below 0 or endless. */
static void test_a_stated_error_counts_if_it_can_be_one(void **state)
{
	(void)state;
	expect_stated(NULL, 0, 2);
	expect_stated(json_real(-1), 0, 2);
	expect_stated(json_integer(0), 0, 2);
	expect_stated(json_real(0.5), 0.5, 2);
	expect_stated(json_integer(1), 1, 2);
	expect_stated(json_integer(2), 2, 2);
	expect_stated(json_integer(3), 3, 3);
	expect_stated(json_integer(999999), 999999, 999999);
	expect_stated(json_integer(1000000), 0, 2);
	expect_stated(json_real(1e9), 0, 2);
	expect_stated(json_string("1"), 0, 2);
}

static void test_an_exact_run_states_that_it_is_exact(void **state)
{
	struct settled settled;
	const json_t *asset;

	(void)state;
	begin(&settled, bent_text, &bent, sizeof(bent), 0.0f);
	asset = json_object_get(gltf_document_json(settled.document), "asset");
	assert_true(json_is_real(json_object_get(
		json_object_get(asset, "extras"), "limber_error_px")));
	assert_near(settled.result.peak_px, 0, 0);
	assert_int_equal(
		type_of(&settled, attributes_of(&settled), "POSITION"), FLOATS);
	end(&settled);
}

/*
 * A large triangle, and a small one on node 1, which is beside its place in
 * both clips. In the second its parent is 50 times as large, so that an error
 * is many times what a key seems to cause.
 */
#define FIRST_CLIP                                            \
	"{\"samplers\":[{\"input\":2,\"output\":3},"          \
	"{\"input\":2,\"output\":5}],\"channels\":[" CHANNEL( \
		"0", "1", "translation") "," CHANNEL("1", "2", "scale") "]}"
#define SECOND_CLIP                                           \
	"{\"samplers\":[{\"input\":2,\"output\":4},"          \
	"{\"input\":2,\"output\":6}],\"channels\":[" CHANNEL( \
		"0", "1", "translation") "," CHANNEL("1", "0", "scale") "]}"
#define NESTED(clips)                                                          \
	"{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0,2]}],"     \
	"\"nodes\":[{\"children\":[1]},{\"mesh\":0},{\"mesh\":1}],"            \
	"\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]},"    \
	"{\"primitives\":[{\"attributes\":{\"POSITION\":1}}]}],"               \
	"\"animations\":[" clips "],"                                          \
	"\"accessors\":[" FLOAT_ARRAY("0", "3", "VEC3") "," FLOAT_ARRAY(       \
		"36", "3", "VEC3") "," FLOAT_ARRAY("72", "2",                  \
		"SCALAR") "," FLOAT_ARRAY("80", "2",                           \
		"VEC3") "," FLOAT_ARRAY("104", "2",                            \
		"VEC3") "," FLOAT_ARRAY("128", "2",                            \
		"VEC3") "," FLOAT_ARRAY("152", "2",                            \
		"VEC3") "],"                                                   \
			"\"bufferViews\":[{\"buffer\":0,\"byteLength\":176}]," \
			"\"buffers\":[{\"uri\":\"data.bin\",\"byteLength\":176}]}"

/* Clips must not depend on their order. */
static const char *const nested_text[2] = {
	NESTED(FIRST_CLIP "," SECOND_CLIP), NESTED(SECOND_CLIP "," FIRST_CLIP)};

struct nested {
	float small[3][3], large[3][3], time_s[2];
	float first[2][3], second[2][3]; /* places of node 1, by clip */
	float growth[2][3], scale[2][3];
};

/* Node 1 is beside its place by so many pixels of a view without clips. */
static struct nested nested_by(int order, float first_px, float second_px)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct optimize_measure_view view = {480, 640, 1.0, 0.0f};
	struct test_path folder = temp_dir_make();
	struct nested nested = {
		.small = {{-0.02f, 0, 0}, {0.02f, 0, 0}, {0, 0.13f, 0}},
		.large = {{-1, -10, 0}, {1, -10, 0}, {0, 10, 0}},
		.time_s = {0, 1},
		.growth = {{1, 1, 1}, {0.9f, 0.9f, 0.9f}},
		.scale = {{50, 50, 50}, {50, 50, 50}},
	};
	struct model *model;
	struct bounds box;
	float px;

	load(nested_text[order], &nested, sizeof(nested), &folder, &model);
	assert_int_equal(
		optimize_measure_unit(model, &view, &log, &box, &px), 0);
	nested.first[0][1] = nested.first[1][1] = first_px / px;
	nested.second[0][1] = nested.second[1][1] = second_px / px;
	model_destroy(model);
	temp_dir_remove(&folder);
	return nested;
}

/*
 * Alone, the first clip can do without its channel, at a cost of 0.92 pixels.
 * The search tries smaller errors next, so that node 1 moves and the second
 * clip has to keep its channel, for whatever key_px. Together, both clips would
 * do without: then the second has 0.9 / error times what it had, twice. If it
 * still does without its channel, all numbers stay as they are.
 */
static void test_clips_that_exceed_the_bound_together_keep_more(void **state)
{
	static const struct {
		float second_px; /* its error is about 38 times that */
		int type;        /* of positions */
		float least_px, most_px;
	} cases[] = {
		{0.01f, SHORTS, 0.9f, 1.0f}, /* both do without */
		{0.03f, FLOATS, 0.0f, 0.0f}, {0.065f, FLOATS, 0.0f, 0.0f},
		{0.09f, SHORTS, 0.001f, 0.02f}, /* kept in the last round */
		{0.2f, SHORTS, 0.001f, 0.02f},  /* kept in the one before */
	};

	(void)state;
	for (size_t i = 0; i < 2 * ARRAY_COUNT(cases); i++) {
		int order = (int)(i % 2);
		struct nested nested =
			nested_by(order, 0.98f, cases[i / 2].second_px);
		struct settled settled;
		float peak_px;

		begin(&settled, nested_text[order], &nested, sizeof(nested),
			1.0f);
		peak_px = settled.result.peak_px;
		assert_int_equal(
			type_of(&settled, attributes_of(&settled), "POSITION"),
			cases[i / 2].type);
		assert_true(peak_px >= cases[i / 2].least_px);
		assert_true(peak_px <= cases[i / 2].most_px);
		end(&settled);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_numbers_take_half_of_the_bound),
		cmocka_unit_test(test_a_stated_error_counts_if_it_can_be_one),
		cmocka_unit_test(test_an_exact_run_states_that_it_is_exact),
		cmocka_unit_test(
			test_clips_that_exceed_the_bound_together_keep_more),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
