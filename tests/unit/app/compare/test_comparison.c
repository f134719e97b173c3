/* Comparing the clips of small models, and exporting the techniques. */
#include "app/compare/advice_price.h"
#include "app/compare/comparison.h"
#include "app/compare/comparison_rows.h"
#include "app/compare/export/export.h"
#include "app/model/levels/levels.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* A triangle of size 1 on a node that the clips of far.gltf move. */
enum {
	CLIMB = 1 /* its clip from 0 up to a height */
};

struct compared {
	struct model *model;
	struct comparison_request request;
	struct comparison *comparison;
	struct log_capture said;
	int done, total;
};

static void note_progress(void *context, int done, int total)
{
	struct compared *compared = context;

	assert_int_equal(done, ++compared->done);
	assert_true(compared->total == 0 || compared->total == total);
	compared->total = total;
}

static void begin(struct compared *compared, const char *fixture)
{
	*compared = (struct compared){
		.model = model_fixture(fixture, NULL),
		.request = {.clip = -1,
			.rate_hz = 30.0,
			.bound_px = 0.5f,
			.board = board_profile_find(NULL),
			.width = 48,
			.height = 64,
			.jobs = 1,
			.kernel = &kernel_float,
			.progress = note_progress,
			.progress_context = compared},
	};
	assert_int_equal(levels_make(compared->model), 0);
}

static int compare(struct compared *compared)
{
	const struct log log = log_capture_begin(&compared->said);

	compared->done = compared->total = 0;
	compared->comparison = NULL;
	return comparison_create(compared->model, &compared->request, &log,
		&compared->comparison);
}

static void end(struct compared *compared)
{
	comparison_destroy(compared->comparison);
	model_destroy(compared->model);
}

static void refuse(struct compared *compared, const char *why)
{
	assert_int_equal(compare(compared), -EINVAL);
	assert_null(compared->comparison);
	assert_int_equal(compared->said.count, 1);
	assert_contains(compared->said.sentence[0], compared->model->path);
	assert_contains(compared->said.sentence[0], why);
}

static void test_the_wanted_clip_or_those_that_last_are_compared(void **state)
{
	static const int lasting[] = {0, 2, 3};
	struct compared compared;

	(void)state;
	begin(&compared, "gltf/clip/far.gltf");
	compared.request.clip = 2;
	assert_int_equal(compare(&compared), 0);
	assert_int_equal(compared.comparison->clip_count, 1);
	assert_int_equal(compared.comparison->clip[0].clip, 2);
	assert_false(log_capture_has(
		&compared.said, LOG_WARNING, "clips without a duration"));
	comparison_destroy(compared.comparison);
	compared.request.clip = -1;
	compared.model->clip[1].duration_s = 0.0f;
	assert_int_equal(compare(&compared), 0);
	assert_true(log_capture_has(&compared.said, LOG_WARNING,
		"(1 of 4, the first is clip 1 climb)"));
	assert_int_equal(compared.comparison->clip_count, 3);
	for (int i = 0; i < 3; i++) {
		assert_int_equal(compared.comparison->clip[i].clip, lasting[i]);
	}
	end(&compared);
}

static void test_a_model_without_motion_or_triangles_is_refused(void **state)
{
	struct compared compared;

	(void)state;
	begin(&compared, "gltf/clip/far.gltf");
	for (int i = 0; i < compared.model->clip_count; i++) {
		compared.model->clip[i].duration_s = 0.0f;
	}
	refuse(&compared, "none of its clips has a duration");
	for (int i = 0; i < compared.model->node_count; i++) {
		compared.model->node[i].mesh = -1;
	}
	refuse(&compared, "it shows no triangles");
	end(&compared);
}

/* Each clip is prepared, and then measured once for each row. */
static void test_progress_counts_all_jobs(void **state)
{
	struct compared compared;

	(void)state;
	begin(&compared, "gltf/clip/far.gltf");
	compared.model->clip_count = 2;
	assert_int_equal(compare(&compared), 0);
	assert_int_equal(
		compared.total, (compared.comparison->row_count + 1) * 2);
	assert_int_equal(compared.done, compared.total);
	end(&compared);
}

static void test_threads_find_the_same_errors(void **state)
{
	struct compared one, three;

	(void)state;
	begin(&one, "gltf/skin/and_morph.gltf");
	begin(&three, "gltf/skin/and_morph.gltf");
	three.request.jobs = 3;
	assert_int_equal(compare(&one), 0);
	assert_int_equal(compare(&three), 0);
	assert_int_equal(one.comparison->row_count, three.comparison->row_count);
	for (int r = 0; r < one.comparison->row_count; r++) {
		const struct comparison_row *a = &one.comparison->row[r];
		const struct comparison_row *b = &three.comparison->row[r];

		assert_string_equal(a->name, b->name);
		assert_near(a->total.peak_px, b->total.peak_px, 0);
		assert_near(a->total.board.cycles, b->total.board.cycles, 0);
		assert_int_equal(a->total.memory_bytes, b->total.memory_bytes);
	}
	end(&one);
	end(&three);
}

/* AN4044 has 20 keys, evenly spaced; a fitted morph keeps to its bound. */
static void test_morphs_have_keys_by_number_or_by_error(void **state)
{
	struct compared compared;
	int even = 0, fitted = 0;

	(void)state;
	begin(&compared, "gltf/clip/cubic.gltf");
	assert_int_equal(compare(&compared), 0);
	for (int r = 0; r < compared.comparison->row_count; r++) {
		const struct comparison_row *row = &compared.comparison->row[r];
		const struct fit_keys *keys = &row->cell[0].keys;

		if (row->kind == COMPARISON_MORPH_EVEN) {
			assert_int_equal(keys->count, 20);
			for (int k = 0; k < 20; k++) {
				assert_near(
					keys->time_s[k], k * 2.0 / 19.0, 1e-6);
			}
			even++;
		} else if (row->kind == COMPARISON_MORPH && row->listed) {
			assert_true(row->total.peak_px <= 0.5f);
			assert_true(keys->count >= 2);
			fitted++;
		}
	}
	assert_int_equal(even, 1);
	assert_int_equal(fitted, 1);
	end(&compared);
}

/* Whether the corners of the only triangle are in the opposite order. */
static bool is_turned(const struct model *model)
{
	const uint32_t *index = model->mesh[0].primitive[0].index;

	return (index[1] + 3 - index[0]) % 3 == 2;
}

static struct comparison_row *find_kind(
	struct comparison *comparison, enum comparison_kind kind)
{
	struct comparison_row *row = comparison->row;

	while (row->kind != kind) {
		row++;
	}
	return row;
}

static void test_a_morph_of_a_mirroring_clip_is_seen_from_outside(void **state)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct compared compared;
	struct model *morph;

	(void)state;
	begin(&compared, "gltf/clip/mirror.gltf");
	compared.request.clip = 0;
	assert_int_equal(compare(&compared), 0);
	assert_int_equal(compared.said.count, 0);
	assert_int_equal(
		export_load(compared.comparison,
			find_kind(compared.comparison, COMPARISON_MORPH), &log,
			&morph),
		0);
	assert_false(is_turned(compared.model));
	assert_true(is_turned(morph));
	model_destroy(morph);
	end(&compared);
}

static void test_a_morph_that_turns_inside_out_is_not_recommended(void **state)
{
	struct compared compared;
	struct comparison *comparison;

	(void)state;
	begin(&compared, "gltf/clip/mirror.gltf");
	compared.request.clip = 1;
	assert_int_equal(compare(&compared), 0);
	comparison = compared.comparison;
	assert_true(log_capture_has(&compared.said, LOG_WARNING,
		"clip 1 turning turns a surface inside out"));
	assert_true(
		find_kind(comparison, COMPARISON_MORPH)->total.peak_px <= 0.5f);
	for (int r = 0; r < comparison->row_count; r++) {
		assert_int_equal(advice_fits_error(comparison, r),
			!comparison_rows_is_morph(&comparison->row[r]));
		assert_int_equal(comparison_rows_show_inside(comparison, r, 0),
			comparison_rows_is_morph(&comparison->row[r]));
	}
	assert_false(
		comparison_rows_is_morph(&comparison->row[comparison->advised]));
	end(&compared);
}

/* A clip of an hour is sampled: an even morph needs no other moments. */
static void test_a_clip_of_an_hour_is_compared_in_part(void **state)
{
	struct compared compared;
	const struct comparison *comparison;
	bool even = false;

	(void)state;
	begin(&compared, "gltf/clip/far.gltf");
	compared.request.clip = CLIMB;
	compared.model->clip[CLIMB].duration_s = 3600.0f;
	assert_int_equal(compare(&compared), 0);
	comparison = compared.comparison;
	assert_true(comparison->sampling.share < 0.3);
	for (int r = 0; r < comparison->row_count; r++) {
		const struct comparison_row *row = &comparison->row[r];

		assert_in_range(row->cell[0].error.samples, 50000, 100000);
		assert_int_not_equal(row->kind, COMPARISON_MORPH);
		even = even || row->kind == COMPARISON_MORPH_EVEN;
	}
	assert_true(even);
	end(&compared);
}

/* All morphs draw the same triangles; other rows are drawn themselves. */
static void test_each_row_has_a_prediction_of_drawing(void **state)
{
	struct compared compared;
	double morph = 0.0;

	(void)state;
	begin(&compared, "gltf/skin/and_morph.gltf");
	assert_int_equal(compare(&compared), 0);
	for (int r = 0; r < compared.comparison->row_count; r++) {
		const struct comparison_row *row = &compared.comparison->row[r];
		double cycles = row->cell[0].board.draw.cycles;

		assert_true(cycles > 1e5 && cycles < 1e7);
		if (row->kind == COMPARISON_MORPH ||
			row->kind == COMPARISON_MORPH_EVEN) {
			morph = morph > 0.0 ? morph : cycles;
			assert_near(cycles, morph, 0);
		}
	}
	assert_true(morph > 0.0);
	end(&compared);
}

/* Compares the climb alone, between two heights above the rest pose. */
static void climb(struct compared *compared, float low, float high)
{
	struct model_channel *channel = compared->model->clip[CLIMB].channel;
	float *value = (float *)(uintptr_t)channel->value;

	assert_int_equal(channel->key_count, 2);
	value[1] = low;
	value[4] = high;
	compared->request.clip = CLIMB;
	assert_int_equal(compare(compared), 0);
}

static void test_a_way_of_six_times_the_size_is_far(void **state)
{
	struct compared compared;

	(void)state;
	begin(&compared, "gltf/clip/far.gltf");
	climb(&compared, 0.0f, 4.9f);
	assert_int_equal(compared.said.count, 0);
	comparison_destroy(compared.comparison);
	climb(&compared, 0.0f, 6.0f);
	assert_int_equal(compared.said.count, 1);
	assert_true(log_capture_has(&compared.said, LOG_WARNING,
		"its clips go 7 times as far as it is large"));
	end(&compared);
}

/* A rest pose that would double the picture is left out of it. */
static void test_the_picture_contains_a_rest_pose_that_is_near(void **state)
{
	struct compared compared;

	(void)state;
	begin(&compared, "gltf/clip/far.gltf");
	climb(&compared, 1.9f, 2.9f);
	assert_near(compared.comparison->box.low[1], 0.0, 1e-6);
	assert_near(compared.comparison->box.high[1], 3.9, 1e-5);
	comparison_destroy(compared.comparison);
	climb(&compared, 2.1f, 3.1f);
	assert_near(compared.comparison->box.low[1], 2.1, 1e-5);
	assert_near(compared.comparison->box.high[1], 4.1, 1e-5);
	assert_near(compared.comparison->clip[0].screen.box.low[1], 2.1, 1e-5);
	end(&compared);
}

/* Not of its rest pose, which is in the second one's picture no more. */
static void test_a_prediction_of_drawing_is_of_the_clip(void **state)
{
	struct compared compared;
	double first;

	(void)state;
	begin(&compared, "gltf/clip/far.gltf");
	climb(&compared, 0.0f, 1.0f);
	first = compared.comparison->row[0].cell[0].board.draw.cycles;
	comparison_destroy(compared.comparison);
	climb(&compared, 2.1f, 3.1f);
	assert_near(compared.comparison->row[0].cell[0].board.draw.cycles,
		first, 0.001 * first);
	end(&compared);
}

static void test_each_listed_row_but_the_model_becomes_a_file(void **state)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct test_path folder = temp_dir_make();
	struct test_path out = path_join(&folder, "out");
	struct compared compared;
	char names[3][32];

	(void)state;
	begin(&compared, "gltf/skin/and_morph.gltf");
	assert_int_equal(compare(&compared), 0);
	assert_int_equal(
		export_comparison(compared.comparison, out.text, &log), 0);
	for (int r = 0; r < compared.comparison->row_count; r++) {
		const struct comparison_row *row = &compared.comparison->row[r];

		if (row->kind == COMPARISON_MORPH && row->listed) {
			snprintf(names[0], sizeof(names[0]), "morph-%d.glb",
				row->total.key_count);
		}
	}
	strcpy(names[1], "morph-even-20.glb");
	strcpy(names[2], "skin.glb");
	for (int i = 0; i < 3; i++) {
		struct test_path path = path_join(&out, names[i]);
		struct model *model;

		assert_int_equal(model_load(path.text, &log, &model), 0);
		assert_int_equal(model->clip_count, 1);
		model_destroy(model);
	}
	assert_int_equal(access(path_join(&out, "rigid.glb").text, F_OK), 0);
	assert_int_equal(temp_dir_count(&out), 4);
	end(&compared);
	temp_dir_remove(&folder);
}

static void test_a_file_too_large_to_load_is_not_written(void **state)
{
	struct log_capture said;
	const struct log log = log_capture_begin(&said);
	struct test_path folder = temp_dir_make();
	struct compared compared;
	struct comparison_total *total;

	(void)state;
	begin(&compared, "gltf/skin/and_morph.gltf");
	assert_int_equal(compare(&compared), 0);
	total = &find_kind(compared.comparison, COMPARISON_MORPH_EVEN)->total;
	total->file_bytes = 256u << 20;
	assert_int_equal(
		export_comparison(compared.comparison, folder.text, &log), 0);
	assert_int_equal(temp_dir_count(&folder), 4);
	assert_int_equal(
		unlink(path_join(&folder, "morph-even-20.glb").text), 0);
	total->file_bytes = (256u << 20) + 1;
	assert_int_equal(said.count, 0);
	assert_int_equal(
		export_comparison(compared.comparison, folder.text, &log), 0);
	assert_int_equal(temp_dir_count(&folder), 3);
	assert_true(log_capture_has(&said, LOG_WARNING,
		"morph-even-20.glb is not written: it would have 256 MiB"));
	end(&compared);
	temp_dir_remove(&folder);
}

static void test_a_folder_for_files_is_made_or_used(void **state)
{
	struct log_capture said;
	const struct log log = log_capture_begin(&said);
	struct test_path folder = temp_dir_make();
	struct test_path made = path_join(&folder, "made");
	struct test_path file = path_join(&folder, "file");
	struct test_path lost = path_join(&folder, "lost/made");
	struct stat found;

	(void)state;
	assert_int_equal(export_make_folder(made.text, &log), 0);
	assert_int_equal(stat(made.text, &found), 0);
	assert_true(S_ISDIR(found.st_mode));
	assert_int_equal(export_make_folder(made.text, &log), 0);
	assert_int_equal(said.count, 0);
	file_write(file.text, "", 0);
	assert_int_equal(export_make_folder(file.text, &log), -ENOTDIR);
	assert_int_equal(export_make_folder(lost.text, &log), -ENOENT);
	assert_int_equal(log_capture_count(&said, LOG_ERROR), 2);
	assert_contains(said.sentence[0], "the folder cannot be made");
	assert_contains(said.sentence[0], strerror(ENOTDIR));
	assert_contains(said.sentence[1], lost.text);
	temp_dir_remove(&folder);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_the_wanted_clip_or_those_that_last_are_compared),
		cmocka_unit_test(
			test_a_model_without_motion_or_triangles_is_refused),
		cmocka_unit_test(test_progress_counts_all_jobs),
		cmocka_unit_test(test_threads_find_the_same_errors),
		cmocka_unit_test(test_morphs_have_keys_by_number_or_by_error),
		cmocka_unit_test(
			test_a_morph_of_a_mirroring_clip_is_seen_from_outside),
		cmocka_unit_test(
			test_a_morph_that_turns_inside_out_is_not_recommended),
		cmocka_unit_test(test_a_clip_of_an_hour_is_compared_in_part),
		cmocka_unit_test(test_each_row_has_a_prediction_of_drawing),
		cmocka_unit_test(test_a_way_of_six_times_the_size_is_far),
		cmocka_unit_test(
			test_the_picture_contains_a_rest_pose_that_is_near),
		cmocka_unit_test(test_a_prediction_of_drawing_is_of_the_clip),
		cmocka_unit_test(
			test_each_listed_row_but_the_model_becomes_a_file),
		cmocka_unit_test(test_a_file_too_large_to_load_is_not_written),
		cmocka_unit_test(test_a_folder_for_files_is_made_or_used),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
