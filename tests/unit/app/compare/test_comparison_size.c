/*
 * Comparing the clips of a model that has no size at rest: its scale is found
 * from all clips, and only once.
 */
#include "app/compare/comparison.h"
#include "app/compare/optimize/optimize_measure.h"
#include "app/model/levels/levels.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	CLIPS = 32,
	GROWN_AFTER = 1 /* jobs */
};

static const float time_s[] = {0.0f, 2.0f};
static const float grows[] = {0, 0, 0, 100, 100, 100};
static const float grows_more[] = {0, 0, 0, 1e6f, 1e6f, 1e6f};

/* A triangle with morph targets whose clips let it grow from nothing. */
struct grown {
	struct model *model;
	struct model_clip *own;
	int own_count;
	struct model_channel channel[CLIPS][2];
	struct model_clip clip[CLIPS];
};

static void begin(struct grown *grown, int count)
{
	struct model *model = model_fixture("gltf/clip/cubic.gltf", NULL);
	const struct model_channel *weights = model->clip[0].channel;

	*grown = (struct grown){.model = model,
		.own = model->clip,
		.own_count = model->clip_count};
	while (weights->path != MODEL_WEIGHTS) {
		weights++;
	}
	for (int c = 0; c < count; c++) {
		grown->channel[c][0] = *weights;
		grown->channel[c][1] = (struct model_channel){
			.node = weights->node,
			.path = MODEL_SCALE,
			.interpolation = MODEL_LINEAR,
			.width = 3,
			.key_count = 2,
			.time_s = time_s,
			.value = grows,
		};
		grown->clip[c] = (struct model_clip){
			.name = "grow",
			.duration_s = 2.0f,
			.channel_count = 2,
			.channel = grown->channel[c],
		};
	}
	memset(model->node[weights->node].rest.scale, 0, sizeof(float[3]));
	model->clip = grown->clip;
	model->clip_count = count;
	assert_int_equal(levels_make(model), 0);
}

static void end(struct grown *grown)
{
	grown->model->clip = grown->own;
	grown->model->clip_count = grown->own_count;
	model_destroy(grown->model);
}

/* Kernels keep no state and get no context: the count is the test's. */
static int morphs;

static void count_morph(int count, const float (*base)[3],
	const struct morph_term *term, int term_count, bool use_normals,
	float (*out)[3])
{
	morphs++;
	kernel_float.morph_targets(
		count, base, term, term_count, use_normals, out);
}

static struct comparison *compare(struct grown *grown,
	const struct kernel *kernel,
	void (*progress)(void *context, int done, int total))
{
	const struct log log = log_to_nowhere();
	const struct comparison_request request = {
		.clip = -1,
		.rate_hz = 30.0,
		.bound_px = 0.5f,
		.board = board_profile_find(NULL),
		.width = 48,
		.height = 64,
		.jobs = 1,
		.kernel = kernel,
		.progress = progress,
		.progress_context = grown,
	};
	struct comparison *comparison;

	assert_int_equal(
		comparison_create(grown->model, &request, &log, &comparison), 0);
	return comparison;
}

static int count_morphs(int clips)
{
	struct kernel counting = kernel_float;
	struct grown grown;

	counting.morph_targets = count_morph;
	begin(&grown, clips);
	morphs = 0;
	comparison_destroy(compare(&grown, &counting, NULL));
	end(&grown);
	return morphs;
}

static void test_twice_as_many_clips_take_twice_as_many_poses(void **state)
{
	int few, some, many;

	(void)state;
	few = count_morphs(CLIPS / 4);
	some = count_morphs(CLIPS / 2);
	many = count_morphs(CLIPS);
	assert_true(few > 0);
	assert_int_equal(many - some, 2 * (some - few));
}

static void grow_more(void *context, int done, int total)
{
	struct grown *grown = context;

	(void)total;
	if (done == GROWN_AFTER) {
		grown->channel[0][1].value = grows_more;
	}
}

/* So a clip that changes later does not change it. */
static void test_clips_take_over_the_scale_of_the_first(void **state)
{
	struct comparison *comparison;
	struct grown grown;

	(void)state;
	begin(&grown, 4);
	comparison = compare(&grown, &kernel_float, grow_more);
	assert_near(comparison->unit_scale, 1.0 / 4096.0, 0);
	for (int c = 0; c < comparison->clip_count; c++) {
		assert_near(comparison->clip[c].screen.unit, 1.0 / 4096.0, 0);
	}
	comparison_destroy(comparison);
	end(&grown);
}

/* The search plays a clip that stands still by itself. */
static void test_the_scale_of_a_search_is_that_of_all_clips(void **state)
{
	const struct log log = log_to_nowhere();
	struct optimize_measure_view view = {
		.width = 48, .height = 64, .share = 1};
	struct bounds box;
	struct grown grown;
	float px;

	(void)state;
	begin(&grown, 2);
	grown.clip[0].duration_s = 0.0f;
	grown.clip[0].channel_count = 0;
	assert_int_equal(
		optimize_measure_unit(grown.model, &view, &log, &box, &px), 0);
	assert_near(view.unit_scale, 1.0 / 4096.0, 0);
	end(&grown);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_twice_as_many_clips_take_twice_as_many_poses),
		cmocka_unit_test(test_clips_take_over_the_scale_of_the_first),
		cmocka_unit_test(test_the_scale_of_a_search_is_that_of_all_clips),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
