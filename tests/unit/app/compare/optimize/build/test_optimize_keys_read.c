/* What is read of the channels of a file's animations. */
#include "app/compare/optimize/build/optimize_keys.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	NODES = 3 /* that have been measured */
};

static const struct optimize_reach_node measured[NODES] = {
	{.move_px = 1.0f}, {.move_px = 2.0f}, {.move_px = 3.0f}};

/* A file, and its first animation as read. */
struct animation {
	char *text;
	struct gltf_document *document;
	struct optimize_reach reach;
	struct optimize_plan plan;
	struct optimize_build build;
	struct optimize_keys keys;
};

static int read_text(struct animation *a, const char *text, size_t size)
{
	static const float key_px[2] = {0.5f, 0.25f};
	const struct log log = log_to_nowhere();
	const struct model_source source = {.name = "t.gltf",
		.data = (const uint8_t *)text,
		.size = size,
		.memory_bytes = MODEL_MEMORY_BYTES};
	json_t *root;

	assert_int_equal(gltf_document_open(&source, &log, &a->document), 0);
	root = gltf_document_json(a->document);
	a->reach = (struct optimize_reach){.node_count = NODES,
		.node = (struct optimize_reach_node *)measured};
	a->plan = (struct optimize_plan){.key_px = key_px};
	a->build = (struct optimize_build){.document = a->document,
		.root = root,
		.reach = &a->reach,
		.plan = &a->plan};
	return optimize_keys_read(&a->build,
		json_array_get(json_object_get(root, "animations"), 0), 1,
		&a->keys);
}

static void read_fixture(struct animation *a, const char *name)
{
	size_t size;

	a->text = file_read(fixture_path(name).text, &size);
	assert_int_equal(read_text(a, a->text, size), 0);
}

static void end(struct animation *a)
{
	optimize_keys_release(&a->keys);
	gltf_document_close(a->document);
	free(a->text);
}

/* glTF's integers are fractions of the largest one, and none is below -1. */
static void test_integers_are_read_as_fractions(void **state)
{
	static const struct {
		enum model_path path;
		int width;
		float unit, value[8];
	} expected[] = {
		{MODEL_ROTATION, 4, 127, {0, 0, 0, 1, 0, 0, -1, 0}},
		{MODEL_ROTATION, 4, 32767, {0, 0, 0, 1, 0, -1, 0, 0}},
		{MODEL_WEIGHTS, 2, 255, {0, 1, 0.2f, 0.4f}},
		{MODEL_WEIGHTS, 2, 65535, {0, 1, 0.2f, 0.4f}},
	};
	struct animation a = {0};

	(void)state;
	read_fixture(&a, "gltf/clip/normalized.gltf");
	assert_int_equal(a.keys.count, 4);
	assert_near(a.keys.end_s, 1, 0);
	assert_near(a.keys.bound_px, 0.25, 0);
	for (int c = 0; c < 4; c++) {
		const struct optimize_channel *channel = &a.keys.channel[c];
		const struct optimize_track *track = &channel->track;

		assert_int_equal(channel->number, c);
		assert_int_equal(track->path, expected[c].path);
		assert_int_equal(track->width, expected[c].width);
		assert_int_equal(track->key_count, 2);
		assert_int_equal(track->interpolation, MODEL_LINEAR);
		assert_near(track->bound_px, 0.25, 0);
		assert_near(channel->unit, expected[c].unit, 0);
		assert_all_near(track->value, expected[c].value,
			2 * (size_t)track->width, 1e-6);
		/* The last node has not been measured. */
		assert_true(track->reach == (c < NODES ? &measured[c] : NULL));
	}
	end(&a);
}

static void test_paths_and_interpolations_go_by_their_names(void **state)
{
	static const struct {
		enum model_path path;
		enum model_interpolation interpolation;
		float time_s, value;
	} expected[] = {
		{MODEL_TRANSLATION, MODEL_STEP, 0.5f, 1},
		{MODEL_SCALE, MODEL_LINEAR, 1.25f, 2},
		{MODEL_TRANSLATION, MODEL_CUBICSPLINE, 0, 4},
	};
	struct animation a = {0};

	(void)state;
	read_fixture(&a, "gltf/clip/single_key.gltf");
	assert_int_equal(a.keys.count, 3);
	assert_near(a.keys.end_s, 1.25, 0);
	for (int c = 0; c < 3; c++) {
		const struct optimize_track *track = &a.keys.channel[c].track;

		assert_int_equal(track->path, expected[c].path);
		assert_int_equal(
			track->interpolation, expected[c].interpolation);
		assert_int_equal(track->width, 3);
		assert_int_equal(track->key_count, 1);
		assert_near(track->time_s[0], expected[c].time_s, 0);
		assert_near(optimize_track_value(track, 0)[0],
			expected[c].value, 0);
		assert_near(a.keys.channel[c].unit, 1, 0);
	}
	end(&a);
}

/* Times of 0, 0 and 1; a line, and a spline with tangents. */
static const char twice_at_0[] =
	"{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{}],"
	"\"animations\":[{\"samplers\":[{\"input\":0,\"output\":1},"
	"{\"input\":0,\"output\":2,\"interpolation\":\"CUBICSPLINE\"}],"
	"\"channels\":["
	"{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"translation\"}},"
	"{\"sampler\":1,\"target\":{\"node\":0,\"path\":\"scale\"}}]}],"
	"\"accessors\":["
	"{\"bufferView\":0,\"componentType\":5126,\"count\":3,"
	"\"type\":\"SCALAR\"},"
	"{\"bufferView\":0,\"byteOffset\":12,\"componentType\":5126,"
	"\"count\":3,\"type\":\"VEC3\"},"
	"{\"bufferView\":0,\"byteOffset\":48,\"componentType\":5126,"
	"\"count\":9,\"type\":\"VEC3\"}],"
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":156}],"
	"\"buffers\":[{\"byteLength\":156,"
	"\"uri\":\"data:application/octet-stream;base64,"
	"AAAAAAAAAAAAAIA/AAAQQQAAEEEAABBBAACAPwAAAEAAAEBAAACAQAAAoEAAAMBA"
	"AAAQQQAAEEEAABBBAAAQQQAAEEEAABBBAAAQQQAAEEEAABBBAACAPwAAAEAAAEBA"
	"AACAQAAAoEAAAMBAAADgQAAAAEEAABBBAAAgQQAAMEEAAEBBAABQQQAAYEEAAHBB"
	"AACAQQAAiEEAAJBB"
	"\"}]}";

/* No moment shows the first of two keys at the start. */
static void test_keys_that_no_moment_shows_are_left_out(void **state)
{
	struct animation a = {0};
	float wanted[18];

	(void)state;
	for (int i = 0; i < 18; i++) {
		wanted[i] = (float)(i + 1);
	}
	assert_int_equal(read_text(&a, twice_at_0, strlen(twice_at_0)), 0);
	assert_int_equal(a.keys.count, 2);
	for (int c = 0; c < 2; c++) {
		const struct optimize_track *track = &a.keys.channel[c].track;

		assert_int_equal(track->key_count, 2);
		assert_int_equal(track->width, 3);
		assert_near(track->time_s[0], 0, 0);
		assert_near(track->time_s[1], 1, 0);
		assert_all_near(track->value, wanted, c ? 18 : 6, 0);
	}
	end(&a);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_integers_are_read_as_fractions),
		cmocka_unit_test(test_paths_and_interpolations_go_by_their_names),
		cmocka_unit_test(test_keys_that_no_moment_shows_are_left_out),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
