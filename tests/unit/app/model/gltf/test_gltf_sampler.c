/* How textures of glTF files are repeated and filtered. */
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>

/* Loads a texture of one pixel with these members of its sampler. */
static int load_sampler(const char *members, struct model **model)
{
	struct log_capture logged;
	char text[1024];

	snprintf(text, sizeof(text),
		"{'asset':{'version':'2.0'},'images':[{'uri':"
		"'data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAA"
		"CQd1PeAAAADElEQVR42mNgZGIGAAAOAAfpkjfUAAAAAElFTkSuQmCC'}],"
		"'textures':[{'source':0,'sampler':0}],'samplers':[{%s}],"
		"'materials':[{'pbrMetallicRoughness':{'baseColorTexture':"
		"{'index':0}}}]}",
		members);
	return model_from_text(text, &logged, model);
}

static void test_each_filter_has_its_number(void **state)
{
	(void)state;
	for (int n = 9720; n < 9995; n++) {
		bool may_magnify = n == 9728 || n == 9729;
		bool may_minify = n >= 9728 && n <= 9987;
		struct model *model;
		char members[64];

		snprintf(members, sizeof(members), "'magFilter':%d", n);
		assert_int_equal(load_sampler(members, &model),
			may_magnify ? 0 : -EINVAL);
		if (may_magnify) {
			assert_int_equal(model->texture[0].nearest, n == 9728);
			assert_true(model->texture[0].mipmap);
			model_destroy(model);
		}
		snprintf(members, sizeof(members), "'minFilter':%d", n);
		assert_int_equal(load_sampler(members, &model),
			may_minify ? 0 : -EINVAL);
		if (may_minify) {
			assert_int_equal(model->texture[0].mipmap, n >= 9984);
			assert_false(model->texture[0].nearest);
			model_destroy(model);
		}
	}
}

static void test_each_way_to_repeat_has_its_number(void **state)
{
	static const struct {
		int number;
		enum model_wrap wrap;
	} cases[] = {{10497, MODEL_REPEAT}, {33071, MODEL_CLAMP},
		{33648, MODEL_MIRROR}};

	(void)state;
	for (int i = 0; i < 9; i++) {
		int number = cases[i / 3].number + i % 3 - 1;
		bool is_known = i % 3 == 1;
		struct model *model;
		char members[64];

		snprintf(members, sizeof(members), "'wrapS':%d", number);
		assert_int_equal(
			load_sampler(members, &model), is_known ? 0 : -EINVAL);
		if (is_known) {
			assert_int_equal(
				model->texture[0].wrap_s, cases[i / 3].wrap);
			assert_int_equal(model->texture[0].wrap_t, MODEL_REPEAT);
			model_destroy(model);
		}
		snprintf(members, sizeof(members), "'wrapT':%d", number);
		assert_int_equal(
			load_sampler(members, &model), is_known ? 0 : -EINVAL);
		if (is_known) {
			assert_int_equal(
				model->texture[0].wrap_t, cases[i / 3].wrap);
			model_destroy(model);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_filter_has_its_number),
		cmocka_unit_test(test_each_way_to_repeat_has_its_number),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
