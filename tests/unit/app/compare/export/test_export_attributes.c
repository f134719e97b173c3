/* Indices and attributes of vertices in exported files. */
#include "app/compare/export/export_bake.h"
#include "tests/support/model/written_glb.h"
#include "tests/support/test.h"

#include <string.h>

/* Writes a list of triangles; its numbers are at the begin of written->binary. */
static void write_indices(
	struct written_glb *written, const uint32_t *index, int count)
{
	struct glb glb;

	glb_begin_memory(&glb);
	assert_int_equal(export_indices(&glb, index, count), 0);
	*written = written_glb_take(&glb);
}

static int number_of(const struct written_glb *written, const char *member)
{
	const json_t *accessors = json_object_get(written->root, "accessors");

	assert_int_equal(json_array_size(accessors), 1);
	return (int)json_integer_value(
		json_object_get(json_array_get(accessors, 0), member));
}

static void expect_types(const struct written_glb *written, const char *wanted)
{
	json_t *accessor;
	char text[64] = "";
	size_t i;

	json_array_foreach(
		json_object_get(written->root, "accessors"), i, accessor)
	{
		snprintf(text + strlen(text), sizeof(text) - strlen(text), "%s ",
			json_string_value(json_object_get(accessor, "type")));
	}
	assert_string_equal(text, wanted);
}

/* 65535 has a meaning of its own in lists of 16 bits. */
static void test_large_indices_have_32_bits(void **state)
{
	for (int at = 0; at < 6; at++) {
		uint32_t index[6] = {3, 1, 4, 1, 5, 9};
		struct written_glb written;
		uint16_t small[6];

		(void)state;
		index[at] = 65534;
		write_indices(&written, index, 6);
		assert_int_equal(number_of(&written, "count"), 6);
		assert_int_equal(
			number_of(&written, "componentType"), GLB_USHORT);
		expect_types(&written, "SCALAR ");
		memcpy(small, written.binary, sizeof(small));
		for (int i = 0; i < 6; i++) {
			assert_int_equal(small[i], index[i]);
		}
		written_glb_release(&written);
		index[at] = 65535;
		write_indices(&written, index, 6);
		assert_int_equal(number_of(&written, "count"), 6);
		assert_int_equal(number_of(&written, "componentType"), GLB_UINT);
		expect_types(&written, "SCALAR ");
		assert_memory_equal(written.binary, index, sizeof(index));
		written_glb_release(&written);
	}
}

/* A triangle without an area stands for none, which glTF does not allow. */
static void test_no_triangles_are_one_of_a_single_vertex(void **state)
{
	static const uint32_t one[3] = {7, 8, 9};
	static const uint16_t nothing[3] = {0};
	struct written_glb written;

	(void)state;
	for (int i = 0; i < 2; i++) {
		write_indices(&written, i == 0 ? one : NULL, 0);
		assert_int_equal(number_of(&written, "count"), 3);
		assert_int_equal(
			number_of(&written, "componentType"), GLB_USHORT);
		assert_memory_equal(written.binary, nothing, sizeof(nothing));
		written_glb_release(&written);
	}
}

/* The vertices of a part are those that it names, in their order. */
static void test_attributes_are_those_of_the_named_vertices(void **state)
{
	static float texcoord[4][2] = {{0, 1}, {2, 3}, {4, 5}, {6, 7}};
	static uint8_t color[4][4] = {{0, 0, 0, 0}, {255, 0, 188, 51},
		{0, 255, 0, 102}, {0, 0, 255, 255}};
	static const int source[3] = {3, 1, 2};
	static const float named[3][2] = {{6, 7}, {2, 3}, {4, 5}};
	static const float shown[3][4] = {
		{0, 0, 1, 1}, {1, 0, 0.5029f, 0.2f}, {0, 1, 0, 0.4f}};
	const struct model_primitive primitive = {
		.vertex_count = 4, .texcoord = texcoord, .color = color};
	json_t *attributes = json_object();
	struct written_glb written;
	float value[3][4];
	struct glb glb;

	(void)state;
	glb_begin_memory(&glb);
	export_attributes(&glb, attributes, &primitive, 3, source);
	assert_int_equal(json_object_size(attributes), 2);
	assert_int_equal(
		json_integer_value(json_object_get(attributes, "TEXCOORD_0")),
		0);
	assert_int_equal(
		json_integer_value(json_object_get(attributes, "COLOR_0")), 1);
	written = written_glb_take(&glb);
	expect_types(&written, "VEC2 VEC4 ");
	assert_memory_equal(written.binary, named, sizeof(named));
	memcpy(value, written.binary + sizeof(named), sizeof(value));
	assert_all_near(value, shown, 12, 1e-4);
	written_glb_release(&written);
	json_decref(attributes);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_large_indices_have_32_bits),
		cmocka_unit_test(test_no_triangles_are_one_of_a_single_vertex),
		cmocka_unit_test(test_attributes_are_those_of_the_named_vertices),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
