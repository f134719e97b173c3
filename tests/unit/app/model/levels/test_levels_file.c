/* Levels of detail that were written to a file and are read again. */
#include "app/model/levels/levels.h"
#include "app/model/levels/levels_file.h"
#include "app/model/model.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static struct model *load(void)
{
	struct log log = log_to_nowhere();
	struct model *model;

	assert_int_equal(model_load("assets/walker.glb", &log, &model), 0);
	return model;
}

struct bytes {
	char *data;
	size_t size;
};

static struct bytes write_levels(void)
{
	struct model *model = load();
	struct bytes bytes;
	FILE *out = open_memstream(&bytes.data, &bytes.size);

	assert_non_null(out);
	assert_int_equal(levels_write(model, out), 0);
	assert_int_equal(fclose(out), 0);
	model_destroy(model);
	return bytes;
}

static void test_no_file_is_written_of_levels_that_the_budget_refused(
	void **state)
{
	static char data[1 << 18];
	int refused = 0, written = 0;

	(void)state;
	/* From a budget that the model fills to one with room for all. */
	for (size_t kib = 0; kib <= 2048; kib += 256) {
		struct model *model = load();
		FILE *out = fmemopen(data, sizeof(data), "w");
		int error;

		assert_non_null(out);
		model->budget->limit_bytes =
			model->budget->used_bytes + kib * 1024;
		error = levels_write(model, out);
		assert_int_equal(error, error ? -ENOMEM : 0);
		assert_int_equal(model->budget->exceeded, error != 0);
		assert_true(error || model->mesh[0].primitive[0].lod_count > 0);
		assert_false(error && written);
		refused += error != 0;
		written += error == 0;
		model_destroy(model);
		fclose(out);
	}
	assert_true(refused > 0);
	assert_true(written > 0);
}

static void assert_same_lists(
	const struct model_primitive *a, const struct model_primitive *b)
{
	assert_int_equal(a->lod_count, b->lod_count);
	for (int i = 0; i < a->lod_count; i++) {
		const struct model_lod *one = &a->lod[i], *other = &b->lod[i];

		assert_true(one->error_m == other->error_m);
		assert_int_equal(one->shadow_only, other->shadow_only);
		assert_int_equal(one->index_count, other->index_count);
		assert_memory_equal(one->index, other->index,
			(size_t)one->index_count * sizeof(*one->index));
	}
}

static void test_read_levels_are_the_made_ones(void **state)
{
	struct bytes bytes = write_levels();
	struct model *made = load(), *read = load();
	int lists = 0;

	(void)state;
	assert_int_equal(levels_make(made), 0);
	assert_int_equal(
		levels_read(read, (const uint8_t *)bytes.data, bytes.size), 0);
	for (int m = 0; m < made->mesh_count; m++) {
		for (int p = 0; p < made->mesh[m].primitive_count; p++) {
			assert_same_lists(&made->mesh[m].primitive[p],
				&read->mesh[m].primitive[p]);
			lists += made->mesh[m].primitive[p].lod_count;
		}
	}
	assert_true(lists > 4);
	model_destroy(made);
	model_destroy(read);
	free(bytes.data);
}

/* Changes one number of what levels are made from; the model has all of it. */
static void change(struct model *model, int what)
{
	struct model_primitive *body = &model->mesh[0].primitive[2];
	struct model_primitive *face = &model->mesh[1].primitive[0];
	struct model_deltas *deltas = &face->target[0].position;

	switch (what) {
	case 0:
		body->position[7][1] += 0.001f;
		break;
	case 1:
		body->normal[7][1] += 0.001f;
		break;
	case 2:
		body->texcoord[7][1] += 0.001f;
		break;
	case 3:
		body->color[7][1] ^= 1;
		break;
	case 4:
		body->joint[7] ^= 1;
		break;
	case 5:
		body->weight[7] += 0.001f;
		break;
	case 6:
		deltas->unit *= 2.0f;
		break;
	case 7:
		((uint8_t *)deltas->value)[0] ^= 1;
		break;
	case 8:
		face->target[1].normal = face->target[0].normal;
		break;
	case 9:
		body->index[7] ^= 1;
		break;
	case 10:
		body->lod[0].index[7] ^= 1;
		break;
	case 11:
		body->lod_count--;
		break;
	default:
		body->texcoord = NULL;
		break;
	}
}

static void test_levels_of_another_model_are_refused(void **state)
{
	struct bytes bytes = write_levels();

	(void)state;
	for (int what = 0; what <= 12; what++) {
		struct model *model = load();
		int lists;

		change(model, what);
		lists = model->mesh[0].primitive[2].lod_count;
		assert_int_equal(levels_read(model, (const uint8_t *)bytes.data,
					 bytes.size),
			-EINVAL);
		assert_int_equal(model->mesh[0].primitive[2].lod_count, lists);
		model_destroy(model);
	}
	free(bytes.data);
}

static void test_a_file_that_ends_early_is_refused(void **state)
{
	struct bytes bytes = write_levels();
	struct model *model = load();

	(void)state;
	for (size_t size = 0; size < bytes.size;
		size += size < 64 ? 1 : bytes.size / 61) {
		uint8_t *cut = malloc(size + 1);

		assert_non_null(cut);
		memcpy(cut, bytes.data, size);
		assert_int_equal(levels_read(model, cut, size), -EINVAL);
		free(cut);
	}
	model_destroy(model);
	free(bytes.data);
}

/* Gives a model the lists of another load of its file. */
static void restore_lists(struct model *model, const struct model *loaded)
{
	for (int m = 0; m < model->mesh_count; m++) {
		for (int p = 0; p < model->mesh[m].primitive_count; p++) {
			const struct model_primitive *from =
				&loaded->mesh[m].primitive[p];

			model->mesh[m].primitive[p].lod = from->lod;
			model->mesh[m].primitive[p].lod_count = from->lod_count;
		}
	}
}

/* Whatever is read fits the model: the sanitizers watch the rest. */
static void test_wrong_numbers_never_lead_outside_the_model(void **state)
{
	static const uint32_t wrong[] = {0, 1, 2, 3, 0xffff, 0x10000,
		0x7fffffff, 0x80000000, 0xffffffff};
	struct bytes bytes = write_levels();
	struct model *model = load(), *own = load();
	int accepted = 0;

	(void)state;
	for (size_t at = 0; at + 4 <= bytes.size;
		at += at < 40 ? 4 : (bytes.size / 197) & ~(size_t)3) {
		for (size_t i = 0; i < sizeof(wrong) / sizeof(*wrong); i++) {
			char good[4];

			memcpy(good, bytes.data + at, 4);
			memcpy(bytes.data + at, &wrong[i], 4);
			if (levels_read(model, (const uint8_t *)bytes.data,
				    bytes.size) == 0) {
				const struct model_primitive *primitive =
					&model->mesh[0].primitive[0];

				for (int k = 0;
					k < primitive->lod[0].index_count; k++) {
					assert_true(primitive->lod[0].index[k] <
						(uint32_t)primitive->vertex_count);
				}
				accepted++;
				restore_lists(model, own);
			}
			memcpy(bytes.data + at, good, 4);
		}
	}
	assert_true(accepted > 0);
	model_destroy(model);
	model_destroy(own);
	free(bytes.data);
}

/*
 * Levels are optional: whether the budget refuses the file (spare 0) or the
 * lists in it, the model plays without them, and a warning says so.
 */
static void test_levels_beyond_the_budget_are_left_out_with_a_warning(
	void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "robot.levels");
	struct test_path robot = path_join(&folder, "robot.glb");
	struct bytes bytes = write_levels();

	(void)state;
	file_write(path.text, bytes.data, bytes.size);
	for (size_t spare = 0; spare <= bytes.size; spare += bytes.size) {
		struct log_capture logged;
		struct log log = log_capture_begin(&logged);
		struct model *model = load();
		int lists = model->mesh[0].primitive[0].lod_count;

		model->path = robot.text;
		model->budget->limit_bytes = model->budget->used_bytes + spare;
		assert_int_equal(levels_prepare(model, &log), 0);
		assert_false(model->budget->exceeded);
		assert_int_equal(model->mesh[0].primitive[0].lod_count, lists);
		assert_int_equal(logged.count, 1);
		assert_int_equal(logged.level[0], LOG_WARNING);
		assert_contains(logged.sentence[0], path.text);
		assert_contains(logged.sentence[0], "allow more with --memory");
		model_destroy(model);
	}
	temp_dir_remove(&folder);
	free(bytes.data);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_no_file_is_written_of_levels_that_the_budget_refused),
		cmocka_unit_test(test_read_levels_are_the_made_ones),
		cmocka_unit_test(test_levels_of_another_model_are_refused),
		cmocka_unit_test(test_a_file_that_ends_early_is_refused),
		cmocka_unit_test(test_wrong_numbers_never_lead_outside_the_model),
		cmocka_unit_test(
			test_levels_beyond_the_budget_are_left_out_with_a_warning),
	};

	return cmocka_run_group_tests_name("levels_file", tests, NULL, NULL);
}
