/* The units of positions, in scenes of cubes whose largest coordinate is stated. */
#include "app/compare/optimize/optimize_scale.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	TEXT_BYTES = 8192
};

/* The bytes of three floats as base64. */
static void put_base64(char *out, const float value[3])
{
	static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklm"
				     "nopqrstuvwxyz0123456789+/";
	uint8_t byte[12];

	memcpy(byte, value, sizeof(byte));
	for (int i = 0; i < 4; i++) {
		uint32_t bits = (uint32_t)byte[3 * i] << 16 |
			(uint32_t)byte[3 * i + 1] << 8 | byte[3 * i + 2];

		for (int k = 0; k < 4; k++) {
			*out++ = digits[bits >> (18 - 6 * k) & 63];
		}
	}
	*out = '\0';
}

/*
 * A mesh for each size, of one point (size / 2, -size, 0), and the rest of the
 * scene. The points are floats or, where the size is 0, bytes.
 */
static struct gltf_document *document_of(
	const float *size, int count, const char *rest, char *text)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct model_source source = {.name = "scene", .memory_bytes = 1 << 20};
	struct gltf_document *document;
	int at = sprintf(text, "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[");

	for (int i = 0; i < count; i++) {
		char base64[17];

		put_base64(base64, (float[3]){size[i] * 0.5f, -size[i], 0.0f});
		at += sprintf(text + at,
			"%s{\"byteLength\":12,\"uri\":\"data:application/"
			"octet-stream;base64,%s\"}",
			i ? "," : "", base64);
	}
	at += sprintf(text + at, "],\"bufferViews\":[");
	for (int i = 0; i < count; i++) {
		at += sprintf(text + at, "%s{\"buffer\":%d,\"byteLength\":12}",
			i ? "," : "", i);
	}
	at += sprintf(text + at, "],\"accessors\":[");
	for (int i = 0; i < count; i++) {
		at += sprintf(text + at,
			"%s{\"bufferView\":%d,\"componentType\":%d,"
			"\"count\":1,\"type\":\"VEC3\"}",
			i ? "," : "", i, size[i] > 0.0f ? 5126 : 5120);
	}
	at += sprintf(text + at, "],\"meshes\":[");
	for (int i = 0; i < count; i++) {
		at += sprintf(text + at,
			"%s{\"primitives\":[{\"attributes\":{\"POSITION\":"
			"%d}}]}",
			i ? "," : "", i);
	}
	at += sprintf(text + at, "],%s}", rest);
	assert_true(at < TEXT_BYTES);
	source.data = (const uint8_t *)text;
	source.size = (size_t)at;
	assert_int_equal(gltf_document_open(&source, &log, &document), 0);
	return document;
}

/* The units of the meshes, then those of the skins. */
static void check(const float *size, int count, const char *rest,
	const float *wanted, int skins)
{
	static char text[TEXT_BYTES];
	struct gltf_document *document = document_of(size, count, rest, text);
	struct optimize_scale scale;

	assert_int_equal(optimize_scale_find(&scale, document), 0);
	for (int i = 0; i < count + skins; i++) {
		float found = i < count ? scale.mesh[i] : scale.skin[i - count];

		if (found != wanted[i]) {
			fail_msg("%s: unit %d is %g, not %g", rest, i,
				(double)found, (double)wanted[i]);
		}
	}
	optimize_scale_release(&scale);
	assert_null(scale.mesh);
	assert_null(scale.skin);
	gltf_document_close(document);
}

static void check_one(float size, const char *rest, float wanted)
{
	check(&size, 1, rest, &wanted, 0);
}

/* A power of two, or 1 if no more than four bits of sixteen are lost by it. */
static void test_a_unit_is_the_power_of_two_above_the_size(void **state)
{
	static const float pair[][2] = {{1.0f, 1.0f}, {1.001f, 2.0f},
		{2.0f, 2.0f}, {2.5f, 4.0f}, {4.0f, 4.0f}, {1000.0f, 1024.0f},
		{0.5f, 1.0f}, {0.0626f, 1.0f}, {0.0625f, 0.0625f},
		{0.06f, 0.0625f}, {0.03125f, 0.03125f}, {0.02f, 0.03125f},
		{0.001f, 1.0f / 512}};

	(void)state;
	for (size_t i = 0; i < sizeof(pair) / sizeof(pair[0]); i++) {
		check_one(pair[i][0], "\"nodes\":[{\"mesh\":0}]", pair[i][1]);
	}
}

/* The unit ends above a millionth. */
static void test_points_at_the_origin_and_integers_have_no_unit(void **state)
{
	(void)state;
	check_one(1e-30f, "\"nodes\":[{\"mesh\":0}]", 0x1p-20f);
	check_one(0.0f, "\"nodes\":[{\"mesh\":0}]", 0.0f);
}

static void test_a_node_that_cannot_be_scaled_keeps_its_mesh(void **state)
{
	static const char *const fixed[] = {
		"\"nodes\":[{\"mesh\":0,\"children\":[1]},{}]",
		"\"nodes\":[{\"mesh\":0,\"camera\":0}],\"cameras\":[{}]",
		"\"nodes\":[{\"mesh\":0,\"extensions\":{}}]",
		"\"nodes\":[{},{\"mesh\":0}],\"skins\":[{\"joints\":[1]}]",
		"\"nodes\":[{},{\"mesh\":0}],\"animations\":[{\"channels\":["
		"{\"target\":{\"node\":1,\"path\":\"scale\"}}]}]",
		"\"nodes\":[{\"mesh\":0},{}],\"skins\":[{\"joints\":[0]}]",
		"\"nodes\":[{\"mesh\":0}],\"animations\":[{\"channels\":["
		"{\"target\":{\"node\":0,\"path\":\"scale\"}}]}]",
		/* One of two nodes is enough, in either order. */
		"\"nodes\":[{\"mesh\":0},{\"mesh\":0,\"extensions\":{}}]",
		"\"nodes\":[{\"mesh\":0,\"extensions\":{}},{\"mesh\":0}]",
	};
	static const char *const free_nodes[] = {
		"\"nodes\":[{\"mesh\":0},{\"mesh\":0}]",
		"\"nodes\":[{\"children\":[1],\"camera\":0},{\"mesh\":0}],"
		"\"cameras\":[{}]",
		"\"nodes\":[{},{\"mesh\":0}],\"skins\":[{\"joints\":[0]}]",
		"\"nodes\":[{\"mesh\":0}],\"skins\":[{\"joints\":[-1,1,9]}]",
		"\"nodes\":[{\"mesh\":0}],\"animations\":[{\"channels\":["
		"{\"target\":{\"node\":-1,\"path\":\"scale\"}},"
		"{\"target\":{\"node\":1,\"path\":\"scale\"}}]}]",
		"\"nodes\":[{},{\"mesh\":0}],\"animations\":[{\"channels\":["
		"{\"target\":{\"node\":1,\"path\":\"rotation\"}},"
		"{\"target\":{\"node\":0,\"path\":\"scale\"}}]}]",
	};

	(void)state;
	for (size_t i = 0; i < sizeof(fixed) / sizeof(fixed[0]); i++) {
		check_one(3.0f, fixed[i], 0.0f);
		/* Without a scale it fits anyway. */
		check_one(0.8f, fixed[i], 1.0f);
		check_one(1.0f, fixed[i], 1.0f);
	}
	for (size_t i = 0; i < sizeof(free_nodes) / sizeof(free_nodes[0]); i++) {
		check_one(3.0f, free_nodes[i], 4.0f);
	}
}

static void test_meshes_of_a_skin_have_its_unit(void **state)
{
	static const float size[] = {3.0f, 9.0f, 0.01f, 100.0f};

	(void)state;
	/* Two meshes share skin 1; skin 0 has one; the last has none. */
	check(size, 4,
		"\"nodes\":[{\"mesh\":0,\"skin\":1},{\"mesh\":1,\"skin\":1},"
		"{\"mesh\":2,\"skin\":0},{\"mesh\":3},{}],"
		"\"skins\":[{\"joints\":[4]},{\"joints\":[4]}]",
		(const float[]){16.0f, 16.0f, 0x1p-6f, 128.0f, 0x1p-6f, 16.0f},
		2);
	/* A mesh with two skins connects the meshes of both. */
	check(size, 3,
		"\"nodes\":[{\"mesh\":0,\"skin\":0},{\"mesh\":1,\"skin\":1},"
		"{\"mesh\":2,\"skin\":0},{\"mesh\":2,\"skin\":1},{}],"
		"\"skins\":[{\"joints\":[4]},{\"joints\":[4]}]",
		(const float[]){16.0f, 16.0f, 16.0f, 16.0f, 16.0f}, 2);
	/* A skinned node may have children: the skin takes the unit. */
	check(size, 1,
		"\"nodes\":[{\"mesh\":0,\"skin\":0,\"children\":[1]},{}],"
		"\"skins\":[{\"joints\":[1]}]",
		(const float[]){4.0f, 4.0f}, 1);
	/* A mesh with and without a skin has two places for a unit, so none. */
	check(size, 2,
		"\"nodes\":[{\"mesh\":0,\"skin\":0},{\"mesh\":0},"
		"{\"mesh\":1,\"skin\":0},{}],\"skins\":[{\"joints\":[3]}]",
		(const float[]){0.0f, 0.0f, 0.0f}, 1);
	check((const float[]){3.0f, 0.0f}, 2,
		"\"nodes\":[{\"mesh\":0,\"skin\":0},{\"mesh\":1,\"skin\":0},{}],"
		"\"skins\":[{\"joints\":[2]}]",
		(const float[]){0.0f, 0.0f, 0.0f}, 1);
}

/* Levels of a skinned mesh have its unit; a scaled node has no extension. */
static void test_levels_of_detail_share_a_unit(void **state)
{
	static const float size[] = {0.5f, 3.0f, 5.0f};

	(void)state;
	check(size, 3,
		"\"nodes\":[{\"mesh\":0,\"skin\":0,\"extensions\":{\"MSFT_lod\":"
		"{\"ids\":[2]}}},{\"mesh\":2},{\"mesh\":1,\"skin\":0},{}],"
		"\"skins\":[{\"joints\":[3]}]",
		(const float[]){4.0f, 4.0f, 8.0f, 4.0f}, 1);
	check(size, 3,
		"\"nodes\":[{\"mesh\":0,\"extensions\":{\"MSFT_lod\":"
		"{\"ids\":[2]}}},{\"mesh\":2},{\"mesh\":1}]",
		(const float[]){0.0f, 0.0f, 8.0f}, 0);
	/* Whatever its number, and with a skin of its own. */
	check(size, 3,
		"\"nodes\":[{\"mesh\":1,\"skin\":0,\"extensions\":{\"MSFT_lod\":"
		"{\"ids\":[1]}}},{\"mesh\":0,\"skin\":1},{\"mesh\":2},{}],"
		"\"skins\":[{\"joints\":[3]},{\"joints\":[3]}]",
		(const float[]){4.0f, 4.0f, 8.0f, 4.0f, 4.0f}, 2);
	/* A level alone cannot be scaled either. */
	check(size, 3,
		"\"nodes\":[{\"extensions\":{\"MSFT_lod\":{\"ids\":[1]}}},"
		"{\"mesh\":1},{\"mesh\":2}]",
		(const float[]){1.0f, 0.0f, 8.0f}, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_unit_is_the_power_of_two_above_the_size),
		cmocka_unit_test(
			test_points_at_the_origin_and_integers_have_no_unit),
		cmocka_unit_test(
			test_a_node_that_cannot_be_scaled_keeps_its_mesh),
		cmocka_unit_test(test_meshes_of_a_skin_have_its_unit),
		cmocka_unit_test(test_levels_of_detail_share_a_unit),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
