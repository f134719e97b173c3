/* model_file.h: a model reads only files in its own folder. */
#include "app/model/model_file.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* TOP/outside.bin, TOP/models/inside.bin, TOP/models/sub/deep.bin. */
struct tree {
	struct test_path top, models, model;
	struct log_capture logged;
	struct log log;
};

static void make_folder(const char *path)
{
	assert_int_equal(mkdir(path, 0755), 0);
}

static int setup(void **state)
{
	static struct tree tree;
	struct test_path sub;

	tree.top = temp_dir_make();
	tree.models = path_join(&tree.top, "models");
	tree.model = path_join(&tree.models, "model.gltf");
	sub = path_join(&tree.models, "sub");
	make_folder(tree.models.text);
	make_folder(sub.text);
	file_write(path_join(&tree.top, "outside.bin").text, "secret", 6);
	file_write(path_join(&tree.models, "inside.bin").text, "inside", 6);
	file_write(path_join(&sub, "deep.bin").text, "deep", 4);
	tree.log = log_capture_begin(&tree.logged);
	*state = &tree;
	return 0;
}

static int teardown(void **state)
{
	struct tree *tree = *state;

	temp_dir_remove(&tree->top);
	return 0;
}

static int read_beside(struct tree *tree, const char *name, char out[16])
{
	struct model_source source = {
		.name = tree->model.text, .has_folder = true};
	struct model_file file;
	int error;

	tree->log = log_capture_begin(&tree->logged);
	error = model_file_read_beside(
		&source, name, "HERE", NULL, &tree->log, &file);
	if (!error) {
		assert_true(file.size < 16);
		snprintf(out, 16, "%s", (const char *)file.data);
		model_file_release(&file);
		assert_null(file.data);
	} else {
		assert_null(file.data);
		assert_int_equal(log_capture_count(&tree->logged, LOG_ERROR), 1);
		assert_contains(tree->logged.sentence[0], "HERE: ");
	}
	return error;
}

static void expect_content(
	struct tree *tree, const char *name, const char *content)
{
	char text[16];

	assert_int_equal(read_beside(tree, name, text), 0);
	assert_string_equal(text, content);
}

static void expect_refusal(
	struct tree *tree, const char *name, int code, const char *part)
{
	char text[16];

	assert_int_equal(read_beside(tree, name, text), code);
	assert_contains(tree->logged.sentence[0], part);
}

static void test_reads_files_of_the_folder(void **state)
{
	expect_content(*state, "inside.bin", "inside");
	expect_content(*state, "./inside.bin", "inside");
	expect_content(*state, "sub/deep.bin", "deep");
	expect_content(*state, "sub//deep.bin", "deep");
}

static void test_names_a_missing_file(void **state)
{
	expect_refusal(*state, "gone.bin", -ENOENT,
		"gone.bin: No such file or directory: copy it to the model's folder");
}

static void test_refuses_paths_outside_the_folder(void **state)
{
	struct tree *tree = *state;
	struct test_path outside = path_join(&tree->top, "outside.bin");

	expect_refusal(
		tree, "../outside.bin", -EACCES, "the path contains \"..\"");
	expect_refusal(tree, "sub/../../outside.bin", -EACCES,
		"the path contains \"..\"");
	expect_refusal(tree, "sub/..", -EACCES, "the path contains \"..\"");
	expect_refusal(tree, outside.text, -EACCES, "the path is absolute");
	expect_refusal(tree, "..\\outside.bin", -EACCES, "backslash");
	expect_refusal(tree, "a\nb", -EACCES, "control character");
	expect_refusal(tree, "", -EACCES, "the path is empty");
}

static void test_reads_names_that_begin_or_end_with_dots(void **state)
{
	struct tree *tree = *state;

	file_write(path_join(&tree->models, "..x").text, "x", 1);
	file_write(path_join(&tree->models, "x..").text, "y", 1);
	expect_content(tree, "..x", "x");
	expect_content(tree, "x..", "y");
}

static void test_refuses_links_outside_the_folder(void **state)
{
	struct tree *tree = *state;
	struct test_path link = path_join(&tree->models, "link.bin");
	struct test_path folder = path_join(&tree->models, "folder");

	assert_int_equal(symlink("../outside.bin", link.text), 0);
	assert_int_equal(symlink("..", folder.text), 0);
	expect_refusal(
		tree, "link.bin", -EACCES, "leads outside the model's folder");
	expect_refusal(tree, "folder/outside.bin", -EACCES,
		"leads outside the model's folder");
}

static void test_follows_links_within_the_folder(void **state)
{
	struct tree *tree = *state;
	struct test_path link = path_join(&tree->models, "link.bin");

	assert_int_equal(symlink("sub/deep.bin", link.text), 0);
	expect_content(tree, "link.bin", "deep");
}

/* models-old begins like models, but is another folder. */
static void test_refuses_a_folder_whose_name_begins_alike(void **state)
{
	struct tree *tree = *state;
	struct test_path other = path_join(&tree->top, "models-old");
	struct test_path link = path_join(&tree->models, "old");

	make_folder(other.text);
	file_write(path_join(&other, "x.bin").text, "x", 1);
	assert_int_equal(symlink("../models-old", link.text), 0);
	expect_refusal(
		tree, "old/x.bin", -EACCES, "leads outside the model's folder");
}

static void test_reads_beside_a_model_named_without_a_folder(void **state)
{
	struct model_source source = {.name = "model.gltf", .has_folder = true};
	struct log log = log_to_nowhere();
	struct model_file file;

	(void)state;
	assert_int_equal(model_file_read_beside(
				 &source, "Makefile", "", NULL, &log, &file),
		0);
	model_file_release(&file);
}

static void test_refuses_references_of_a_model_in_memory(void **state)
{
	struct tree *tree = *state;
	struct model_source source = {.name = tree->model.text};
	struct model_file file;

	assert_int_equal(model_file_read_beside(&source, "inside.bin", "HERE",
				 NULL, &tree->log, &file),
		-EACCES);
	assert_contains(tree->logged.sentence[0],
		"HERE: the model was not loaded from a folder");
}

static void test_refuses_what_is_not_a_regular_file(void **state)
{
	struct tree *tree = *state;
	struct test_path pipe = path_join(&tree->models, "pipe");

	assert_int_equal(mkfifo(pipe.text, 0600), 0);
	expect_refusal(tree, "pipe", -EINVAL, "not a regular file");
	expect_refusal(tree, "sub", -EISDIR, "this is a folder");
}

static void test_refuses_a_file_above_the_size_limit(void **state)
{
	struct tree *tree = *state;
	struct test_path huge = path_join(&tree->models, "huge");

	file_write(huge.text, "", 0);
	assert_int_equal(
		truncate(huge.text, (off_t)MODEL_FILE_BYTES_MAX + 1), 0);
	expect_refusal(tree, "huge", -EFBIG, "268435457 bytes");
}

static void test_reads_an_empty_file(void **state)
{
	struct tree *tree = *state;

	file_write(path_join(&tree->models, "empty").text, "", 0);
	expect_content(tree, "empty", "");
}

/* Files of /proc have 0 bytes by their entry, and yet text to read. */
static void test_refuses_a_file_whose_size_nobody_knows(void **state)
{
	struct tree *tree = *state;
	struct model_file file;

	tree->log = log_capture_begin(&tree->logged);
	assert_int_equal(
		model_file_read("/proc/self/status", NULL, &tree->log, &file),
		-EINVAL);
	assert_null(file.data);
	assert_int_equal(tree->logged.count, 1);
	assert_contains(tree->logged.sentence[0],
		"/proc/self/status: the system does not tell the size");
}

#define WITH_TREE(test) cmocka_unit_test_setup_teardown(test, setup, teardown)

int main(void)
{
	const struct CMUnitTest tests[] = {
		WITH_TREE(test_reads_files_of_the_folder),
		WITH_TREE(test_names_a_missing_file),
		WITH_TREE(test_refuses_paths_outside_the_folder),
		WITH_TREE(test_reads_names_that_begin_or_end_with_dots),
		WITH_TREE(test_refuses_links_outside_the_folder),
		WITH_TREE(test_follows_links_within_the_folder),
		WITH_TREE(test_refuses_a_folder_whose_name_begins_alike),
		cmocka_unit_test(
			test_reads_beside_a_model_named_without_a_folder),
		WITH_TREE(test_refuses_references_of_a_model_in_memory),
		WITH_TREE(test_refuses_what_is_not_a_regular_file),
		WITH_TREE(test_refuses_a_file_above_the_size_limit),
		WITH_TREE(test_reads_an_empty_file),
		WITH_TREE(test_refuses_a_file_whose_size_nobody_knows),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
