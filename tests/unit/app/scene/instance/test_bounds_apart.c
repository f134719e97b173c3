/* The boxes of clips that move a part far away from the rest of a model. */
#include "app/scene/instance/bounds.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/small_model.h"
#include "tests/support/model/triangle_file.h"
#include "tests/support/test.h"

#include <string.h>

/* Two triangles of size 1, one of which hangs on the other. */
struct pair {
	struct model_channel channel[2];
	struct model_clip clip;
	float value[2][6];
	struct model *model;
	struct instance *instance;
};

/* Lets the clip move a node evenly. */
static void move(struct pair *pair, int node, enum model_path path,
	const float from[3], const float to[3])
{
	static const float time_s[] = {0, 1};
	float *value = pair->value[pair->clip.channel_count];

	memcpy(value, from, 3 * sizeof(from[0]));
	memcpy(value + 3, to, 3 * sizeof(to[0]));
	pair->channel[pair->clip.channel_count++] =
		(struct model_channel){.node = node,
			.path = path,
			.interpolation = MODEL_LINEAR,
			.width = 3,
			.key_count = 2,
			.time_s = time_s,
			.value = value};
}

static void begin_of_size(struct pair *pair, float size, int node,
	enum model_path path, const float from[3], const float to[3])
{
	struct test_path folder = temp_dir_make();
	struct test_path file = path_join(&folder, "pair.gltf");
	struct log log = log_to_stderr(LOG_WARNING);

	*pair = (struct pair){.model = NULL};
	triangle_file_write(
		file.text, "{\"mesh\":0,\"children\":[1]},{\"mesh\":0}");
	assert_int_equal(model_load(file.text, &log, &pair->model), 0);
	for (int i = 0; i < 3; i++) {
		pair->model->node[0].rest.scale[i] = size;
	}
	temp_dir_remove(&folder);
	pair->clip = (struct model_clip){
		.name = "clip", .duration_s = 1, .channel = pair->channel};
	move(pair, node, path, from, to);
	pair->model->clip = &pair->clip;
	pair->model->clip_count = 1;
	pair->instance = small_model_instance(pair->model);
	assert_near(pair->instance->unit_scale, 1.0, 0.0);
}

static void begin(struct pair *pair, int node, enum model_path path,
	const float from[3], const float to[3])
{
	begin_of_size(pair, 1, node, path, from, to);
}

static void end(struct pair *pair)
{
	instance_destroy(pair->instance);
	model_destroy(pair->model);
}

static void test_a_part_that_flies_away_leaves_the_others_in_view(void **state)
{
	static const struct {
		float from[3], to[3], low[3], high[3];
	} rows[] = {/* A rocket rises from its pad, or comes back to it. */
		{{0, 0, 0}, {0, 500, 0}, {0, 0, 0}, {1, 7, 0}},
		{{0, 500, 0}, {0, 0, 0}, {0, 0, 0}, {1, 7, 0}},
		{{0, 0, 0}, {-80, 0, 0}, {-6, 0, 0}, {1, 1, 0}},
		/* A part is hidden below the ground, which stays. */
		{{0, 0, 0}, {0, -900, 0}, {0, 0, 0}, {1, 1, 0}},
		/* So it is all the time, but not at rest. */
		{{0, -900, 0}, {0, -900, 0}, {0, 0, 0}, {1, 1, 0}},
		/* A lift. */
		{{0, 0, 0}, {0, 4.5f, 0}, {0, 0, 0}, {1, 5.5f, 0}}};

	(void)state;
	for (size_t i = 0; i < 2 * ARRAY_COUNT(rows); i++) {
		size_t row = i / 2;
		float size = i % 2 ? 2.5f : 1, low[3], high[3];
		struct pair pair;
		struct bounds box;

		begin_of_size(&pair, size, 1, MODEL_TRANSLATION, rows[row].from,
			rows[row].to);
		for (int axis = 0; axis < 3; axis++) {
			low[axis] = size * rows[row].low[axis];
			high[axis] = size * rows[row].high[axis];
		}
		box = bounds_of_clip(pair.instance, 0);
		assert_all_near(box.low, low, 3, 1e-3);
		assert_all_near(box.high, high, 3, 1e-3);
		/* The instance shows the clip's start. */
		assert_near(pair.instance->world[1][3][1],
			size * rows[row].from[1], 1e-4);
		end(&pair);
	}
}

static void test_what_moves_or_grows_as_a_whole_is_all_shown(void **state)
{
	struct pair pair;
	struct bounds box;

	(void)state;
	begin(&pair, 0, MODEL_TRANSLATION, (const float[]){0, 0, 0},
		(const float[]){0, 500, 0});
	box = bounds_of_clip(pair.instance, 0);
	assert_near(box.high[1], 501, 1e-3);
	end(&pair);
	begin(&pair, 1, MODEL_SCALE, (const float[]){1, 1, 1},
		(const float[]){90, 90, 90});
	box = bounds_of_clip(pair.instance, 0);
	assert_near(box.high[1], 90, 1e-3);
	end(&pair);
}

static const float origin[3] = {0, 0, 0};

/* A part that grows to twice the model's size is still one that flies away. */
static void test_a_part_of_twice_the_size_flies_away(void **state)
{
	static const struct {
		float size, way, high;
	} rows[] = {{1.95f, 80, 7}, {2.05f, 80, 82.05f}, {1.95f, 9.5f, 7},
		{2.05f, 9.5f, 11.55f}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		const float size = rows[i].size;
		struct pair pair;
		struct bounds box;

		begin(&pair, 1, MODEL_TRANSLATION, origin,
			(const float[]){rows[i].way, 0, 0});
		move(&pair, 1, MODEL_SCALE, (const float[]){1, 1, 1},
			(const float[]){size, size, size});
		box = bounds_of_clip(pair.instance, 0);
		assert_near(box.high[0], rows[i].high, 1e-3);
		end(&pair);
	}
}

/* What stays may move by its own size to any side. */
static void test_a_part_stays_within_its_size_of_where_it_was(void **state)
{
	(void)state;
	for (int i = 0; i < 12; i++) {
		float by = i % 2 ? 1.05f : 0.95f;
		float to[3] = {0, 0, 0}, flown[3] = {0, 0, 0};
		int axis = i / 4, other = (axis + 1) % 3;
		struct pair pair;
		struct bounds box;

		to[axis] = i / 2 % 2 ? by : -by;
		flown[other] = 80;
		begin(&pair, 0, MODEL_TRANSLATION, origin, to);
		move(&pair, 1, MODEL_TRANSLATION, origin, flown);
		box = bounds_of_clip(pair.instance, 0);
		/* Triangles have no size along z. */
		assert_near(box.high[other],
			i % 2 ? (other == 2 ? 80 : 81) : (other == 2 ? 6 : 7),
			1e-3);
		end(&pair);
	}
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_part_that_flies_away_leaves_the_others_in_view),
		cmocka_unit_test(
			test_what_moves_or_grows_as_a_whole_is_all_shown),
		cmocka_unit_test(test_a_part_of_twice_the_size_flies_away),
		cmocka_unit_test(
			test_a_part_stays_within_its_size_of_where_it_was),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
