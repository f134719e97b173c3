/* How errors name a place of a glTF file. */
#include "app/model/gltf/gltf_internal.h"
#include "tests/support/test.h"

#include <string.h>

static void test_a_place_is_cut_where_the_text_ends(void **state)
{
	static const char whole[] = "robot.gltf: /nodes/3/rotation";
	const struct model_source source = {.name = "robot.gltf"};
	struct gltf gltf = {.source = &source};
	const struct gltf_at root = {.gltf = &gltf};
	const struct gltf_at nodes = {
		.gltf = &gltf, .up = &root, .key = "nodes"};
	const struct gltf_at node = {.gltf = &gltf, .up = &nodes, .index = 3};
	const struct gltf_at rotation = {
		.gltf = &gltf, .up = &node, .key = "rotation"};

	(void)state;
	for (size_t size = 1; size <= sizeof(whole) + 2; size++) {
		char text[64];

		memset(text, '#', sizeof(text));
		gltf_path(&rotation, text, size);
		assert_true(strlen(text) < size);
		assert_int_equal(strncmp(whole, text, strlen(text)), 0);
		assert_int_equal(strlen(text),
			size < sizeof(whole) ? size - 1 : sizeof(whole) - 1);
		for (size_t i = size; i < sizeof(text); i++) {
			assert_int_equal(text[i], '#');
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_place_is_cut_where_the_text_ends),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
