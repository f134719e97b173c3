/* One model in every encoding of .x files: text, binary, compressed. */
#include "app/model/model.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

static void check_tower_mesh(const struct model *model)
{
	const struct model_mesh *mesh = &model->mesh[0];
	const struct model_primitive *front = &mesh->primitive[0];
	const struct model_primitive *top = &mesh->primitive[1];
	static const float corner[3] = {1, 0, -0.5f};
	static const float ahead[3] = {0, 0, 1};
	static const float up[3] = {0, 1, 0};
	static const uint8_t red[4] = {255, 0, 0, 255};
	static const uint32_t fan[] = {0, 4, 3, 0, 2, 4, 0, 1, 2};

	assert_int_equal(mesh->primitive_count, 2);
	assert_int_equal(front->vertex_count, 6);
	assert_int_equal(top->vertex_count, 3);
	assert_all_near(front->position[1], corner, 3, 0);
	assert_all_near(front->normal[0], ahead, 3, 0);
	assert_all_near(front->normal[5], up, 3, 0);
	assert_memory_equal(front->color[1], red, 4);
	assert_near(front->texcoord[2][1], 0.5, 0);
	assert_int_equal(front->index_count, 12);
	assert_memory_equal(front->index, fan, sizeof(fan));
}

static void check_tower_skin(const struct model *model)
{
	const struct model_primitive *front = &model->mesh[0].primitive[0];
	const struct model_primitive *top = &model->mesh[0].primitive[1];
	const struct model_skin *skin = &model->skin[0];

	assert_int_equal(front->influences, 4);
	/* The file has weights 0.25 and 0.25, a weight 2, and no weight. */
	assert_near(front->weight[2 * 4 + 0], 0.5, 1e-6);
	assert_near(front->weight[2 * 4 + 1], 0.5, 1e-6);
	assert_near(front->weight[4 * 4 + 0], 1, 1e-6);
	assert_int_equal(skin->joint_count, 3);
	assert_int_equal(top->joint[2 * 4], 2);
	assert_near(top->weight[2 * 4], 1, 0);
	assert_string_equal(model->node[skin->joint[1]].name, "Upper");
	assert_string_equal(model->node[skin->joint[2]].name, "Root");
	assert_near(skin->inverse_bind[1][3][1], -1, 0);
}

static const struct model_channel *channel_of(
	const struct model *model, const char *node, enum model_path path)
{
	const struct model_clip *clip = &model->clip[0];

	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];

		if (channel->path == path &&
			!strcmp(model->node[channel->node].name, node)) {
			return channel;
		}
	}
	fail_msg("%s has no such channel", node);
	return NULL;
}

static void check_tower_clip(const struct model *model)
{
	static const float second[3] = {4, 5, -6};
	static const float turned[4] = {0, -0.7071068f, 0, 0.7071068f};
	static const float doubled[3] = {2, 2, 2};
	static const float moved[3] = {1, 2, -3};
	const struct model_channel *channel =
		channel_of(model, "Upper", MODEL_TRANSLATION);

	assert_near(model->clip[0].duration_s, 2, 1e-6);
	/* The file has the keys at 2, 0 and 1 s. */
	assert_near(channel->time_s[1], 1, 1e-6);
	assert_all_near(channel->value + 3, second, 3, 0);
	channel = channel_of(model, "Lower", MODEL_ROTATION);
	assert_near(channel->time_s[1], 0.5, 1e-6);
	assert_all_near(channel->value + 4, turned, 4, 1e-6);
	channel = channel_of(model, "Lower", MODEL_SCALE);
	assert_all_near(channel->value + 3, doubled, 3, 1e-6);
	channel = channel_of(model, "Lower", MODEL_TRANSLATION);
	assert_all_near(channel->value + 3, moved, 3, 1e-6);
}

static void check_tower_materials(const struct model *model)
{
	const struct model_primitive *primitive = model->mesh[0].primitive;
	const struct model_material *brick =
		&model->material[primitive[0].material];
	const struct model_material *glass =
		&model->material[primitive[1].material];

	assert_int_equal(model->material_count, 2);
	assert_string_equal(brick->name, "Brick");
	/* sRGB 0.5 in linear light. */
	assert_near(brick->base_color[0], 0.2140411, 1e-5);
	assert_int_equal(brick->alpha, MODEL_OPAQUE);
	assert_int_equal(glass->alpha, MODEL_BLEND);
	assert_near(glass->base_color[3], 0.5, 0);
}

static void test_all_encodings_load_as_the_same_model(void **state)
{
	static const char *const name[] = {
		"xfile/tower_text.x",
		"xfile/tower_binary.x",
		"xfile/tower_wide.x",
		"xfile/tower_text_packed.x",
		"xfile/tower_binary_packed.x",
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(name); i++) {
		struct log_capture logged;
		struct model *model = model_fixture(name[i], &logged);

		assert_int_equal(logged.count, 0);
		check_tower_mesh(model);
		check_tower_skin(model);
		check_tower_clip(model);
		check_tower_materials(model);
		model_destroy(model);
	}
}

/* The sanitizer sees what is read behind the end. */
static void load_cut(const char *data, size_t size)
{
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct model *model = NULL;
	char *cut = malloc(size);

	assert_non_null(cut);
	memcpy(cut, data, size);
	if (model_load_memory(cut, size, "cut.x", &log, &model)) {
		assert_int_equal(log_capture_count(&logged, LOG_ERROR), 1);
	}
	model_destroy(model);
	free(cut);
}

static void test_truncated_files_are_errors(void **state)
{
	static const char *const name[] = {
		"xfile/tower_text.x",
		"xfile/tower_binary.x",
		"xfile/tower_text_packed.x",
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(name); i++) {
		struct test_path path = fixture_path(name[i]);
		size_t size;
		char *data = file_read(path.text, &size);

		for (size_t cut = 4; cut < size; cut++) {
			load_cut(data, cut);
		}
		free(data);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_all_encodings_load_as_the_same_model),
		cmocka_unit_test(test_truncated_files_are_errors),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
