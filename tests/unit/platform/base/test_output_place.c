#define _DEFAULT_SOURCE /* setgroups() */

#include "platform/base/output_path.h"
#include "tests/support/output_scene.h"
#include "tests/support/test.h"

#include <errno.h>
#include <grp.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

static void test_a_link_stays_and_its_target_is_replaced(void **state)
{
	struct output_scene *scene = *state;
	struct test_path link = path_join(&scene->folder, "link");
	struct test_path second = path_join(&scene->folder, "second");

	file_write(scene->path.text, "old", 3);
	assert_int_equal(symlink("file", link.text), 0);
	assert_int_equal(symlink(link.text, second.text), 0);
	output_scene_write(scene, second.text, "new");
	assert_true(S_ISLNK(output_scene_mode(second.text)));
	assert_true(S_ISLNK(output_scene_mode(link.text)));
	assert_true(S_ISREG(output_scene_mode(scene->path.text)));
	output_scene_expect(scene->path.text, "new");
	assert_int_equal(temp_dir_count(&scene->folder), 3);
}

static void test_a_link_to_nothing_gets_its_target(void **state)
{
	struct output_scene *scene = *state;
	struct test_path link = path_join(&scene->folder, "link");

	assert_int_equal(symlink("file", link.text), 0);
	output_scene_write(scene, link.text, "new");
	assert_true(S_ISLNK(output_scene_mode(link.text)));
	output_scene_expect(scene->path.text, "new");
	assert_int_equal(temp_dir_count(&scene->folder), 2);
}

/* The temporary file is in the folder of the target, not of the link. */
static void test_a_link_into_another_folder_is_followed(void **state)
{
	struct output_scene *scene = *state;
	struct test_path other = path_join(&scene->folder, "other");
	struct test_path target = path_join(&other, "target");
	struct test_path link = path_join(&scene->folder, "link");
	struct output_file *file;

	assert_int_equal(mkdir(other.text, 0700), 0);
	file_write(target.text, "old", 3);
	assert_int_equal(symlink("other/target", link.text), 0);
	file = output_scene_begin(scene, link.text);
	assert_int_equal(temp_dir_count(&scene->folder), 2);
	assert_int_equal(temp_dir_count(&other), 2);
	fputs("new", output_file_stream(file));
	assert_int_equal(output_file_commit(file), 0);
	output_scene_expect(target.text, "new");
	assert_true(S_ISLNK(output_scene_mode(link.text)));
	assert_int_equal(temp_dir_count(&other), 1);
}

static void test_a_circle_of_links_is_refused(void **state)
{
	struct output_scene *scene = *state;
	struct test_path link = path_join(&scene->folder, "link");

	assert_int_equal(symlink("file", link.text), 0);
	assert_int_equal(symlink("link", scene->path.text), 0);
	output_scene_expect_refusal(
		scene, link.text, ELOOP, "cannot be written");
	assert_int_equal(temp_dir_count(&scene->folder), 2);
}

static void test_a_link_is_read_from_its_own_folder(void **state)
{
	struct output_scene *scene = *state;
	static const char *const links[] = {"/nowhere/file", "beside", "../up"};

	for (int i = 0; i < 3; i++) {
		struct test_path link = path_join(&scene->folder, "link");
		struct test_path wanted = path_join(&scene->folder, links[i]);
		char *target;
		int descriptor;

		assert_int_equal(symlink(links[i], link.text), 0);
		assert_int_equal(
			output_path_follow(link.text, &target, &descriptor), 0);
		assert_string_equal(
			target, links[i][0] == '/' ? links[i] : wanted.text);
		assert_int_equal(descriptor, -1);
		free(target);
		assert_int_equal(unlink(link.text), 0);
	}
}

/* Linux follows 40 links, too. */
static void test_a_chain_of_40_links_is_followed(void **state)
{
	struct output_scene *scene = *state;
	char name[32] = "end";
	struct test_path link = path_join(&scene->folder, name);
	char *target;
	int descriptor;

	for (int i = 1; i <= 41; i++) {
		char next[32];

		snprintf(next, sizeof(next), "link-%d", i);
		link = path_join(&scene->folder, next);
		assert_int_equal(symlink(name, link.text), 0);
		memcpy(name, next, sizeof(name));
		if (i <= 40) {
			output_scene_write(scene, link.text, next);
			assert_int_equal(temp_dir_count(&scene->folder), i + 1);
			output_scene_expect(
				path_join(&scene->folder, "end").text, next);
		}
	}
	assert_int_equal(
		output_path_follow(link.text, &target, &descriptor), -ELOOP);
	assert_null(target);
	output_scene_expect_refusal(
		scene, link.text, ELOOP, "cannot be written");
}

static void test_paths_that_are_no_files_are_refused(void **state)
{
	struct output_scene *scene = *state;
	struct test_path below = path_join(&scene->path, "below");
	struct test_path nowhere = path_join(&scene->folder, "none/file");
	char name[300] = "";

	memset(name, 'n', sizeof(name) - 1);
	file_write(scene->path.text, "old", 3);
	output_scene_expect_refusal(
		scene, scene->folder.text, EISDIR, "directory");
	output_scene_expect_refusal(scene, below.text, ENOTDIR, "folder");
	output_scene_expect_refusal(
		scene, nowhere.text, ENOENT, "create its folder");
	output_scene_expect_refusal(scene, "", ENOENT, "cannot be written");
	output_scene_expect_refusal(
		scene, name, ENAMETOOLONG, "give a shorter name");
	output_scene_expect(scene->path.text, "old");
}

/* Runs as an ordinary user, because root may write everywhere. */
static int try_locked_places(struct output_scene *scene)
{
	struct test_path fresh = path_join(&scene->folder, "fresh");
	struct output_file *file;

	if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) {
		return 1;
	}
	if (output_file_create(scene->path.text, &scene->log, &file) != -EACCES) {
		return 2;
	}
	if (output_file_create(fresh.text, &scene->log, &file) != -EACCES) {
		return 3;
	}
	return scene->logged.count == 2 &&
			strstr(scene->logged.sentence[1], "may write")
		? 0
		: 4;
}

static int in_a_child(
	struct output_scene *scene, int (*run)(struct output_scene *scene))
{
	pid_t child = fork();
	int status;

	assert_true(child >= 0);
	if (child == 0) {
		_exit(run(scene));
	}
	assert_int_equal(waitpid(child, &status, 0), child);
	assert_true(WIFEXITED(status));
	return WEXITSTATUS(status);
}

static void test_a_folder_without_permission_is_refused(void **state)
{
	struct output_scene *scene = *state;

	file_write(scene->path.text, "old", 3);
	assert_int_equal(chmod(scene->path.text, 0444), 0);
	assert_int_equal(chmod(scene->folder.text, 0555), 0);
	assert_int_equal(in_a_child(scene, try_locked_places), 0);
	assert_int_equal(chmod(scene->folder.text, 0777), 0);
	output_scene_expect(scene->path.text, "old");
	assert_int_equal(temp_dir_count(&scene->folder), 1);
}

/* Makes a read-only file in a writable folder. */
static int try_locked_file(struct output_scene *scene)
{
	struct output_file *file;

	if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) {
		return 1;
	}
	return output_file_create(scene->path.text, &scene->log, &file) == -EACCES
		? 0
		: 2;
}

static void test_a_read_only_file_is_not_replaced(void **state)
{
	struct output_scene *scene = *state;

	file_write(scene->path.text, "old", 3);
	assert_int_equal(chmod(scene->path.text, 0444), 0);
	assert_int_equal(chmod(scene->folder.text, 0777), 0);
	assert_int_equal(in_a_child(scene, try_locked_file), 0);
	output_scene_expect(scene->path.text, "old");
	assert_int_equal(temp_dir_count(&scene->folder), 1);
}

static void test_a_new_file_has_the_permissions_of_the_umask(void **state)
{
	static const mode_t masks[] = {0000, 0022, 0077, 0027};
	struct output_scene *scene = *state;
	mode_t usual = umask(0);

	for (size_t i = 0; i < ARRAY_COUNT(masks); i++) {
		umask(masks[i]);
		output_scene_write(scene, scene->path.text, "new");
		assert_int_equal(output_scene_mode(scene->path.text) & 07777,
			0666 & ~masks[i]);
		assert_int_equal(unlink(scene->path.text), 0);
	}
	umask(usual);
}

static void test_a_replaced_file_keeps_its_permissions(void **state)
{
	static const mode_t modes[] = {0600, 0640, 0755, 0666};
	struct output_scene *scene = *state;
	mode_t usual = umask(0077);

	for (size_t i = 0; i < ARRAY_COUNT(modes); i++) {
		file_write(scene->path.text, "old", 3);
		assert_int_equal(chmod(scene->path.text, modes[i]), 0);
		output_scene_write(scene, scene->path.text, "new");
		assert_int_equal(
			output_scene_mode(scene->path.text) & 07777, modes[i]);
	}
	umask(usual);
}

/* Replaces a file of another owner, as a member of these groups. */
static int replace_in_groups(
	struct output_scene *scene, size_t count, const gid_t *groups)
{
	struct output_file *file;

	if (setgroups(count, groups) != 0 || setgid(65533) != 0 ||
		setuid(65533) != 0) {
		return 1;
	}
	if (output_file_create(scene->path.text, &scene->log, &file) != 0) {
		return 2;
	}
	fputs("new", output_file_stream(file));
	return output_file_commit(file) == 0 ? 0 : 3;
}

static int replace_as_a_stranger(struct output_scene *scene)
{
	return replace_in_groups(scene, 0, NULL);
}

static int replace_as_a_member(struct output_scene *scene)
{
	return replace_in_groups(scene, 1, (const gid_t[]){65534});
}

static void test_a_group_that_cannot_stay_gets_the_rights_of_others(void **state)
{
	static const mode_t modes[][3] = {
		{0676, 0666, 0676}, {0667, 0677, 0667}, {0472, 0422, 0472}};
	struct output_scene *scene = *state;

	if (geteuid() != 0) {
		skip_because("only root gives files away");
	}
	assert_int_equal(chmod(scene->folder.text, 0777), 0);
	for (size_t i = 0; i < 2 * ARRAY_COUNT(modes); i++) {
		const mode_t *mode = modes[i / 2];

		file_write(scene->path.text, "old", 3);
		assert_int_equal(chown(scene->path.text, 65534, 65534), 0);
		assert_int_equal(chmod(scene->path.text, mode[0]), 0);
		assert_int_equal(in_a_child(scene,
					 i % 2 ? replace_as_a_member
					       : replace_as_a_stranger),
			0);
		assert_int_equal(output_scene_mode(scene->path.text) & 07777,
			mode[1 + i % 2]);
		assert_int_equal(unlink(scene->path.text), 0);
	}
}

static void test_a_replaced_file_keeps_its_owner(void **state)
{
	struct output_scene *scene = *state;
	struct stat status;

	file_write(scene->path.text, "old", 3);
	if (chown(scene->path.text, 65534, 65534) != 0) {
		skip_because("only root gives files away");
	}
	output_scene_write(scene, scene->path.text, "new");
	assert_int_equal(stat(scene->path.text, &status), 0);
	assert_int_equal(status.st_uid, 65534);
	assert_int_equal(status.st_gid, 65534);
}

/* Makes links at former names of the temporary file. */
static void test_a_planted_link_is_not_written_through(void **state)
{
	static const char *const names[] = {"file.part", "file.tmp", "file~"};
	struct output_scene *scene = *state;
	struct test_path victim = path_join(&scene->folder, "victim");

	file_write(victim.text, "safe", 4);
	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		struct test_path link = path_join(&scene->folder, names[i]);

		assert_int_equal(symlink("victim", link.text), 0);
	}
	output_scene_write(scene, scene->path.text, "new");
	output_scene_expect(victim.text, "safe");
	output_scene_expect(scene->path.text, "new");
	assert_int_equal(temp_dir_count(&scene->folder), 5);
}

static void test_temporary_names_differ(void **state)
{
	char *name[50];

	(void)state;
	for (int i = 0; i < 50; i++) {
		name[i] = output_path_temporary("folder/file", 0);
		assert_non_null(name[i]);
		assert_memory_equal(name[i], "folder/file.", 12);
		for (int k = 0; k < i; k++) {
			assert_string_not_equal(name[i], name[k]);
		}
	}
	for (int i = 0; i < 50; i++) {
		free(name[i]);
	}
}

static void test_a_long_name_gets_a_shorter_temporary_one(void **state)
{
	struct output_scene *scene = *state;
	struct test_path path;
	char name[256];

	memset(name, 'n', 255);
	name[255] = '\0';
	path = path_join(&scene->folder, name);
	output_scene_write(scene, path.text, "new");
	output_scene_expect(path.text, "new");
	assert_int_equal(temp_dir_count(&scene->folder), 1);
}

int main(void)
{
#define CASE(name)                       \
	cmocka_unit_test_setup_teardown( \
		name, output_scene_setup, output_scene_teardown)
	const struct CMUnitTest tests[] = {
		CASE(test_a_link_stays_and_its_target_is_replaced),
		CASE(test_a_link_to_nothing_gets_its_target),
		CASE(test_a_link_into_another_folder_is_followed),
		CASE(test_a_circle_of_links_is_refused),
		CASE(test_a_link_is_read_from_its_own_folder),
		CASE(test_a_chain_of_40_links_is_followed),
		CASE(test_paths_that_are_no_files_are_refused),
		CASE(test_a_folder_without_permission_is_refused),
		CASE(test_a_read_only_file_is_not_replaced),
		CASE(test_a_new_file_has_the_permissions_of_the_umask),
		CASE(test_a_replaced_file_keeps_its_permissions),
		CASE(test_a_group_that_cannot_stay_gets_the_rights_of_others),
		CASE(test_a_replaced_file_keeps_its_owner),
		CASE(test_a_planted_link_is_not_written_through),
		cmocka_unit_test(test_temporary_names_differ),
		CASE(test_a_long_name_gets_a_shorter_temporary_one),
	};
#undef CASE

	return cmocka_run_group_tests(tests, NULL, NULL);
}
