/* The samplers and channels of a rewritten animation whose keys all stay. */
#include "platform/base/compiler.h"
#include "tests/support/test.h"
#include "tests/unit/app/compare/optimize/build/rewrite_bench.h"

enum {
	KEYS = 3
};

/* A channel, whose times and values are those of a letter. */
struct channel {
	int node;
	char times, values;
	const char *interpolation; /* or NULL */
};

static const float times[2][KEYS] = {{0, 1, 2}, {0, 1, 3}};
static const float values[2][KEYS][3] = {
	{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}, {{0, 1, 2}, {3, 4, 5}, {6, 7, 9}}};

/* An animation of translations; all arrays are in the file twice. */
static void begin_channels(
	struct file *file, const struct channel *channel, int count)
{
	json_t *samplers = json_array(), *channels = json_array();
	json_t *nodes;

	begin(file, 8192);
	nodes = json_object_get(file->root, "nodes");
	for (int i = 0; i < count; i++) {
		json_t *sampler = json_pack("{s:i, s:i}", "input",
			add(file, times[channel[i].times - 'A'], KEYS, FLOAT,
				"SCALAR"),
			"output",
			add(file, values[channel[i].values - 'A'], KEYS, FLOAT,
				"VEC3"));

		if (channel[i].interpolation) {
			json_object_set_new(sampler, "interpolation",
				json_string(channel[i].interpolation));
		}
		json_array_append_new(samplers, sampler);
		json_array_append_new(channels,
			json_pack("{s:i, s:{s:i, s:s}}", "sampler", i, "target",
				"node", channel[i].node, "path", "translation"));
		json_array_append_new(nodes, json_object());
	}
	json_object_set_new(file->root, "animations",
		json_pack("[{s:o, s:o}]", "samplers", samplers, "channels",
			channels));
	rebuild(file, (struct optimize_plan){0});
}

static const json_t *animation_of(const struct file *file)
{
	return json_array_get(json_object_get(gltf_document_json(file->document),
				      "animations"),
		0);
}

static const json_t *element(const json_t *object, const char *list, int index)
{
	return json_array_get(json_object_get(object, list), (size_t)index);
}

/* The nodes of the channels, in their order, and their samplers. */
static void expect_channels(const struct file *file, const int *node,
	const int *sampler, int count, int samplers)
{
	const json_t *animation = animation_of(file);

	assert_int_equal(
		json_array_size(json_object_get(animation, "channels")), count);
	assert_int_equal(json_array_size(json_object_get(animation, "samplers")),
		samplers);
	for (int i = 0; i < count; i++) {
		const json_t *channel = element(animation, "channels", i);

		assert_int_equal(
			index_of(json_object_get(channel, "target"), "node"),
			node[i]);
		assert_int_equal(index_of(channel, "sampler"), sampler[i]);
	}
}

/* A player looks for a key once for channels that follow each other. */
static void test_channels_of_the_same_times_follow_each_other(void **state)
{
	static const struct channel mixed[] = {{4, 'B', 'A', NULL},
		{3, 'A', 'A', NULL}, {2, 'B', 'B', NULL}, {1, 'A', 'B', NULL},
		{0, 'B', 'A', NULL}};
	float found[NUMBERS_MAX];
	struct file file;

	(void)state;
	begin_channels(&file, mixed, 5);
	/* The last one has the sampler of the first. */
	expect_channels(&file, (const int[]){4, 2, 0, 3, 1},
		(const int[]){0, 1, 0, 2, 3}, 5, 4);
	for (int i = 0; i < 4; i++) {
		static const char letters[4][2] = {
			{'B', 'A'}, {'B', 'B'}, {'A', 'A'}, {'A', 'B'}};
		const json_t *sampler =
			element(animation_of(&file), "samplers", i);

		read_array(&file, sampler, "input", found);
		assert_all_near(found, times[letters[i][0] - 'A'], KEYS, 0);
		read_array(&file, sampler, "output", found);
		assert_all_near(
			found, values[letters[i][1] - 'A'][0], 3 * KEYS, 0);
		assert_null(json_object_get(sampler, "interpolation"));
	}
	end(&file);
}

/* Of 12 channels the even ones come first, as the first one does. */
static void test_channels_of_the_same_times_keep_their_order(void **state)
{
	struct channel channel[12];
	int node[12], sampler[12];
	struct file file;

	(void)state;
	for (int i = 0; i < 12; i++) {
		channel[i] = (struct channel){
			11 - i, i % 2 ? 'B' : 'A', i % 4 < 2 ? 'A' : 'B', NULL};
		node[i] = 11 - (i < 6 ? 2 * i : 2 * i - 11);
		sampler[i] = i < 6 ? i % 2 : 2 + i % 2;
	}
	begin_channels(&file, channel, 12);
	expect_channels(&file, node, sampler, 12, 4);
	end(&file);
}

/* Steps between the same keys are another motion. */
static void test_samplers_are_shared_by_channels_of_equal_keys(void **state)
{
	static const struct channel steps[] = {{0, 'A', 'A', "STEP"},
		{1, 'A', 'A', NULL}, {2, 'A', 'A', "STEP"},
		{3, 'A', 'A', "LINEAR"}};
	struct file file;

	(void)state;
	begin_channels(&file, steps, 4);
	expect_channels(&file, (const int[]){0, 1, 2, 3},
		(const int[]){0, 1, 0, 1}, 4, 2);
	assert_string_equal(json_string_value(json_object_get(
				    element(animation_of(&file), "samplers", 0),
				    "interpolation")),
		"STEP");
	assert_null(json_object_get(
		element(animation_of(&file), "samplers", 1), "interpolation"));
	end(&file);
}

/* One channel of a path, of three keys with one number or four. */
static struct gltf_document_array rewrite(const char *path, const char *type,
	const float *value, float out[NUMBERS_MAX])
{
	struct gltf_document_array array;
	struct file file;

	begin(&file, 4096);
	json_object_set_new(file.root, "animations",
		json_pack("[{s:[{s:i, s:i}], s:[{s:i, s:{s:i, s:s}}]}]",
			"samplers", "input",
			add(&file, times[0], KEYS, FLOAT, "SCALAR"), "output",
			add(&file, value, KEYS, FLOAT, type), "channels",
			"sampler", 0, "target", "node", 0, "path", path));
	rebuild(&file, (struct optimize_plan){.rotations = true});
	array = read_array(&file, element(animation_of(&file), "samplers", 0),
		"output", out);
	end(&file);
	return array;
}

/* Wherever a number is that an integer cannot hold. */
static void test_keys_are_integers_within_1(void **state)
{
	static const struct {
		float value;
		int component;
		float one;
	} cases[] = {{0.0f, USHORT, 65535.0f}, {1.0f, USHORT, 65535.0f},
		{1.001f, FLOAT, 1.0f}, {-0.5f, SHORT, 32767.0f},
		{-1.0f, SHORT, 32767.0f}, {-1.001f, FLOAT, 1.0f},
		{1.75f, FLOAT, 1.0f}, {-1.75f, FLOAT, 1.0f}};

	(void)state;
	for (int i = 0; i < (int)ARRAY_COUNT(cases) * KEYS; i++) {
		float weight[KEYS] = {0.25f, 0.5f, 0.25f}, found[NUMBERS_MAX];
		float wanted = cases[i / KEYS].value * cases[i / KEYS].one;

		weight[i % KEYS] = cases[i / KEYS].value;
		assert_int_equal(
			rewrite("weights", "SCALAR", weight, found).component,
			cases[i / KEYS].component);
		assert_near(found[i % KEYS], wanted, 0.5);
	}
}

/* Rotations are signed, also where no number is below 0. */
static void test_keys_of_rotations_are_signed(void **state)
{
	static const float turn[KEYS][4] = {
		{0, 0, 0, 1}, {0, 0, 0.6f, 0.8f}, {0, 0, 0, 1}};
	float found[NUMBERS_MAX];

	(void)state;
	assert_int_equal(
		rewrite("rotation", "VEC4", turn[0], found).component, SHORT);
	assert_near(found[6], 19660, 0);
	assert_near(found[7], 26214, 0);
	assert_int_equal(
		rewrite("translation", "VEC3", values[0][0], found).component,
		FLOAT);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_channels_of_the_same_times_follow_each_other),
		cmocka_unit_test(
			test_channels_of_the_same_times_keep_their_order),
		cmocka_unit_test(
			test_samplers_are_shared_by_channels_of_equal_keys),
		cmocka_unit_test(test_keys_are_integers_within_1),
		cmocka_unit_test(test_keys_of_rotations_are_signed),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
