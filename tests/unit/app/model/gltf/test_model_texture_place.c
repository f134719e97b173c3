/* Whether textures of a material lie at the same place of a mesh. */
#include "platform/base/compiler.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <stdio.h>

#define ONE_PIXEL                                                        \
	"'images':[{'uri':'data:image/png;base64,"                       \
	"iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42mNgZG" \
	"IGAAAOAAfpkjfUAAAAAElFTkSuQmCC'}],"

/* Each number of a transform counts; the base colour has (2, 4) and (0, 0). */
static void test_a_map_at_another_place_is_ignored(void **state)
{
	static const struct {
		const char *transform;
		bool is_same;
	} rows[] = {
		{"'scale':[2,4]", true},
		{"'scale':[2,4],'offset':[0,0],'rotation':0", true},
		{"'scale':[2,4],'texCoord':0", true},
		{"'scale':[2,4],'texCoord':1", false},
		{"'scale':[3,4]", false},
		{"'scale':[2,5]", false},
		{"'scale':[2,4],'offset':[1,0]", false},
		{"'scale':[2,4],'offset':[0,1]", false},
		{"'scale':[2,4],'rotation':1", false},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct log_capture logged;
		struct model *model;
		char text[1024];

		snprintf(text, sizeof(text),
			"{'asset':{'version':'2.0'}," ONE_PIXEL
			"'textures':[{'source':0}],'materials':[{"
			"'normalTexture':{'index':0,'extensions':{"
			"'KHR_texture_transform':{%s}}},"
			"'pbrMetallicRoughness':{'baseColorTexture':{'index':0,"
			"'extensions':{'KHR_texture_transform':{"
			"'scale':[2,4]}}}}}]}",
			rows[i].transform);
		assert_int_equal(model_from_text(text, &logged, &model), 0);
		assert_int_equal(model->material[0].normal_texture,
			rows[i].is_same ? 0 : -1);
		assert_int_equal(log_capture_count(&logged, LOG_WARNING),
			rows[i].is_same ? 0 : 1);
		model_destroy(model);
	}
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_map_at_another_place_is_ignored),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
