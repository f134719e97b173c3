/* Which files an export writes, and under which names. */
#include "app/compare/export/export.h"
#include "app/model/model_file.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
	KEYS = 2
};

struct bench {
	struct log_capture capture;
	struct log log;
	struct test_path folder;
	struct model *model;
	float time_s[KEYS];
	struct comparison_clip clip;
	struct comparison_cell cell;
	struct comparison comparison;
};

static void begin(struct bench *bench, const char *model)
{
	memset(bench, 0, sizeof(*bench));
	bench->log = log_capture_begin(&bench->capture);
	bench->folder = temp_dir_make();
	bench->model = model_fixture(model, NULL);
	bench->time_s[1] = bench->model->clip[0].duration_s;
	bench->cell.keys = (struct fit_keys){KEYS, bench->time_s};
	bench->comparison = (struct comparison){.model = bench->model,
		.box = {{-8, -8, -8}, {8, 8, 8}},
		.clip_count = 1,
		.clip = &bench->clip};
}

static struct comparison_row *add_row(
	struct bench *bench, enum comparison_kind kind)
{
	struct comparison_row *row =
		&bench->comparison.row[bench->comparison.row_count++];

	row->kind = kind;
	row->listed = true;
	row->cell = &bench->cell;
	row->total.key_count = KEYS;
	return row;
}

static void end(struct bench *bench)
{
	temp_dir_remove(&bench->folder);
	model_destroy(bench->model);
}

static int export(struct bench *bench)
{
	return export_comparison(
		&bench->comparison, bench->folder.text, &bench->log);
}

static void expect_files(
	struct bench *bench, const char *const *names, int count)
{
	for (int i = 0; i < count; i++) {
		struct test_path path = path_join(&bench->folder, names[i]);

		if (access(path.text, R_OK) != 0) {
			fail_msg("%s is missing", names[i]);
		}
		assert_true(export_names(names[i]));
	}
	assert_int_equal(temp_dir_count(&bench->folder), count);
}

/* Of a listed row each, but of the model itself. */
static void test_files_are_named_for_their_rows(void **state)
{
	static const char *const names[] = {"skin-1.glb", "skin-4.glb",
		"skin.glb", "morph-2.glb", "morph-even-2.glb", "rigid.glb"};
	struct bench bench;

	(void)state;
	begin(&bench, "gltf/skin/and_morph.gltf");
	add_row(&bench, COMPARISON_ORIGINAL)->max_influences = 1;
	add_row(&bench, COMPARISON_ORIGINAL)->max_influences = 4;
	add_row(&bench, COMPARISON_ORIGINAL)->max_influences = 2;
	bench.comparison.row[2].listed = false;
	add_row(&bench, COMPARISON_ORIGINAL)->targets = true;
	add_row(&bench, COMPARISON_ORIGINAL)->targets = false;
	add_row(&bench, COMPARISON_MORPH);
	add_row(&bench, COMPARISON_MORPH_EVEN);
	add_row(&bench, COMPARISON_RIGID);
	assert_int_equal(export(&bench), 0);
	assert_int_equal(bench.capture.count, 0);
	expect_files(&bench, names, (int)ARRAY_COUNT(names));
	end(&bench);
}

/* Whom the user's mask lets do so may read and change the files. */
static void test_a_new_folder_is_for_whom_the_mask_allows(void **state)
{
	mode_t mask = umask(027);
	struct test_path folder = temp_dir_make();
	struct test_path made = path_join(&folder, "made");
	struct log log = log_to_nowhere();
	struct stat found;

	(void)state;
	assert_int_equal(export_make_folder(made.text, &log), 0);
	umask(mask);
	assert_int_equal(stat(made.text, &found), 0);
	assert_int_equal(found.st_mode & 0777, 0750);
	temp_dir_remove(&folder);
}

static void test_other_names_are_none_of_an_export(void **state)
{
	static const char *const others[] = {"skin", "skin-1", "skin-1.gltf",
		"my-skin-1.glb", "rigid", "rigid.png", "morph.glb",
		"walker.glb", "rigid.glb.txt", ""};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(others); i++) {
		assert_false(export_names(others[i]));
	}
}

/* A model that lies 100 km away is exported where it is. */
static void test_an_exported_model_stays_where_it_is(void **state)
{
	struct bench bench;
	struct test_path path;
	struct model *loaded;

	(void)state;
	begin(&bench, "gltf/skin/and_morph.gltf");
	bench.model->origin[1] = 1e5;
	add_row(&bench, COMPARISON_ORIGINAL)->max_influences = 1;
	assert_int_equal(export(&bench), 0);
	path = path_join(&bench.folder, "skin-1.glb");
	assert_int_equal(model_load(path.text, &bench.log, &loaded), 0);
	assert_near(loaded->origin[1], 1e5, 100.0);
	model_destroy(loaded);
	end(&bench);
}

static void test_a_file_that_limber_could_not_load_is_left_out(void **state)
{
	(void)state;
	for (size_t more = 0; more < 2; more++) {
		struct bench bench;

		begin(&bench, "gltf/skin/and_morph.gltf");
		add_row(&bench, COMPARISON_ORIGINAL)->max_influences = 1;
		bench.comparison.row[0].total.file_bytes =
			(size_t)MODEL_FILE_BYTES_MAX + more;
		assert_int_equal(export(&bench), 0);
		assert_int_equal(temp_dir_count(&bench.folder), more ? 0 : 1);
		assert_int_equal(
			log_capture_has(&bench.capture, LOG_WARNING,
				"skin-1.glb is not written: it would have 256 MiB, and limber reads up to 256 MiB"),
			more);
		end(&bench);
	}
}

/* The folder's name as "FOLDER/./././", of that length. */
static void lengthen(char *name, size_t length)
{
	for (size_t i = strlen(name); i < length; i++) {
		name[i] = name[i - 1] == '/' ? '.' : '/';
		name[i + 1] = '\0';
	}
}

/* A path has up to 4,095 characters, of which "/skin-1.glb" takes 11. */
static void test_a_name_that_is_too_long_is_reported(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench, "gltf/skin/and_morph.gltf");
	add_row(&bench, COMPARISON_ORIGINAL)->max_influences = 1;
	for (size_t length = 4083; length <= 4087; length++) {
		char folder[PATH_MAX];
		int error;

		strcpy(folder, bench.folder.text);
		lengthen(folder, length);
		bench.log = log_capture_begin(&bench.capture);
		error = export_comparison(&bench.comparison, folder, &bench.log);
		assert_int_equal(error, -ENAMETOOLONG);
		/* Else the file itself cannot be created, beside another. */
		assert_int_equal(
			strncmp(bench.capture.sentence[0], "--export ", 9) == 0,
			length > 4084);
	}
	end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_files_are_named_for_their_rows),
		cmocka_unit_test(test_a_new_folder_is_for_whom_the_mask_allows),
		cmocka_unit_test(test_other_names_are_none_of_an_export),
		cmocka_unit_test(test_an_exported_model_stays_where_it_is),
		cmocka_unit_test(
			test_a_file_that_limber_could_not_load_is_left_out),
		cmocka_unit_test(test_a_name_that_is_too_long_is_reported),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
