#define _DEFAULT_SOURCE /* mknod() */

#include "platform/base/file.h"
#include "platform/base/output_path.h"
#include "tests/support/output_scene.h"
#include "tests/support/test.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

static void test_a_file_appears_when_it_is_complete(void **state)
{
	struct output_scene *scene = *state;
	struct output_file *file = output_scene_begin(scene, scene->path.text);

	fputs("whole", output_file_stream(file));
	assert_int_equal(fflush(output_file_stream(file)), 0);
	assert_int_equal(access(scene->path.text, F_OK), -1);
	assert_int_equal(output_file_commit(file), 0);
	output_scene_expect(scene->path.text, "whole");
	assert_int_equal(temp_dir_count(&scene->folder), 1);
	assert_int_equal(scene->logged.count, 0);
}

static void test_the_old_file_stays_until_the_new_one_is_complete(void **state)
{
	struct output_scene *scene = *state;
	struct output_file *file;

	file_write(scene->path.text, "old", 3);
	file = output_scene_begin(scene, scene->path.text);
	fputs("new", output_file_stream(file));
	assert_int_equal(fflush(output_file_stream(file)), 0);
	output_scene_expect(scene->path.text, "old");
	assert_int_equal(output_file_commit(file), 0);
	output_scene_expect(scene->path.text, "new");
	assert_int_equal(temp_dir_count(&scene->folder), 1);
}

static void test_a_discarded_file_leaves_no_trace(void **state)
{
	struct output_scene *scene = *state;
	struct output_file *file;

	file_write(scene->path.text, "old", 3);
	file = output_scene_begin(scene, scene->path.text);
	fputs("new", output_file_stream(file));
	output_file_discard(file);
	output_file_discard(NULL);
	output_scene_expect(scene->path.text, "old");
	assert_int_equal(temp_dir_count(&scene->folder), 1);
}

static void test_a_published_file_is_seen_as_it_grows(void **state)
{
	struct output_scene *scene = *state;
	struct output_file *file;

	file_write(scene->path.text, "old", 3);
	file = output_scene_begin(scene, scene->path.text);
	fputs("one ", output_file_stream(file));
	output_scene_expect(scene->path.text, "old");
	assert_int_equal(output_file_publish(file), 0);
	output_scene_expect(scene->path.text, "one ");
	fputs("two", output_file_stream(file));
	assert_int_equal(output_file_publish(file), 0);
	output_scene_expect(scene->path.text, "one two");
	output_file_discard(file);
	output_scene_expect(scene->path.text, "one two");
	assert_int_equal(temp_dir_count(&scene->folder), 1);
}

/* Writes more than limit bytes; returns the error of committing it. */
static int write_beyond(struct output_file *file, rlim_t limit)
{
	struct rlimit usual, small;
	int error;

	assert_int_equal(getrlimit(RLIMIT_FSIZE, &usual), 0);
	small = (struct rlimit){limit, usual.rlim_max};
	assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
	for (int i = 0; i < 100000; i++) {
		fputc('x', output_file_stream(file));
	}
	error = output_file_commit(file);
	assert_int_equal(setrlimit(RLIMIT_FSIZE, &usual), 0);
	return error;
}

static void test_a_disk_that_fills_up_keeps_the_old_file(void **state)
{
	struct output_scene *scene = *state;

	file_write(scene->path.text, "old", 3);
	assert_int_equal(
		write_beyond(output_scene_begin(scene, scene->path.text), 50000),
		-EFBIG);
	assert_int_equal(scene->logged.count, 1);
	assert_contains(scene->logged.sentence[0], scene->path.text);
	assert_contains(scene->logged.sentence[0], "too large");
	output_scene_expect(scene->path.text, "old");
	assert_int_equal(temp_dir_count(&scene->folder), 1);
}

static void test_a_file_that_cannot_be_written_is_not_published(void **state)
{
	struct output_scene *scene = *state;
	struct output_file *file;
	struct rlimit usual, none;

	file_write(scene->path.text, "old", 3);
	file = output_scene_begin(scene, scene->path.text);
	assert_int_equal(getrlimit(RLIMIT_FSIZE, &usual), 0);
	none = (struct rlimit){0, usual.rlim_max};
	assert_int_equal(setrlimit(RLIMIT_FSIZE, &none), 0);
	fputs("new", output_file_stream(file));
	assert_int_equal(output_file_publish(file), -EFBIG);
	assert_int_equal(output_file_commit(file), -EFBIG);
	assert_int_equal(setrlimit(RLIMIT_FSIZE, &usual), 0);
	assert_int_equal(scene->logged.count, 1);
	output_scene_expect(scene->path.text, "old");
	assert_int_equal(temp_dir_count(&scene->folder), 1);
}

static void test_a_failure_is_reported_once(void **state)
{
	struct output_scene *scene = *state;
	struct output_file *file = output_scene_begin(scene, scene->path.text);

	assert_int_equal(output_file_failed(file, "no picture"), -EIO);
	assert_int_equal(output_file_commit(file), -EIO);
	assert_int_equal(scene->logged.count, 1);
	assert_contains(scene->logged.sentence[0], "no picture");
	assert_int_equal(temp_dir_count(&scene->folder), 0);
}

/* Who writes pictures learns that it failed, and not why. */
static void test_the_first_cause_of_a_failure_is_reported(void **state)
{
	struct output_scene *scene = *state;
	struct output_file *file = output_scene_begin(scene, scene->path.text);
	struct rlimit usual, small;

	assert_int_equal(getrlimit(RLIMIT_FSIZE, &usual), 0);
	small = (struct rlimit){10, usual.rlim_max};
	assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
	fprintf(output_file_stream(file), "more than ten bytes");
	assert_int_not_equal(fflush(output_file_stream(file)), 0);
	assert_int_equal(setrlimit(RLIMIT_FSIZE, &usual), 0);
	assert_int_equal(output_file_failed(file, "no picture"), -EFBIG);
	assert_int_equal(output_file_commit(file), -EFBIG);
	assert_int_equal(scene->logged.count, 1);
	assert_contains(scene->logged.sentence[0], "too large");
	assert_contains(scene->logged.sentence[0], "ulimit -f");
	assert_int_equal(temp_dir_count(&scene->folder), 0);
}

/* Makes a device that is always full in the test's own folder. */
static bool make_full_device(const char *path)
{
	return mknod(path, S_IFCHR | 0666, (dev_t)(1 << 8 | 7)) == 0;
}

static void expect_full(struct output_scene *scene, const char *path)
{
	struct output_file *file = output_scene_begin(scene, path);

	for (int i = 0; i < 100000; i++) {
		fputc('x', output_file_stream(file));
	}
	scene->logged.count = 0;
	assert_int_equal(output_file_commit(file), -ENOSPC);
	assert_int_equal(scene->logged.count, 1);
	assert_contains(scene->logged.sentence[0], "No space left");
}

static void test_a_full_device_stays_where_it_is(void **state)
{
	struct output_scene *scene = *state;
	struct test_path link = path_join(&scene->folder, "link");
	int probe;

	if (!make_full_device(scene->path.text)) {
		skip_because("only root makes device nodes");
	}
	probe = open(scene->path.text, O_WRONLY);
	if (probe < 0) {
		skip_because("the folder's file system has no devices");
	}
	close(probe);
	expect_full(scene, scene->path.text);
	assert_true(S_ISCHR(output_scene_mode(scene->path.text)));
	assert_int_equal(symlink("file", link.text), 0);
	expect_full(scene, link.text);
	assert_true(S_ISLNK(output_scene_mode(link.text)));
	assert_true(S_ISCHR(output_scene_mode(scene->path.text)));
	assert_int_equal(temp_dir_count(&scene->folder), 2);
}

static void test_a_device_is_written_to(void **state)
{
	struct output_scene *scene = *state;
	struct stat before, after;

	assert_int_equal(stat("/dev/null", &before), 0);
	output_scene_write(scene, "/dev/null", "gone");
	assert_int_equal(stat("/dev/null", &after), 0);
	assert_true(S_ISCHR(after.st_mode));
	assert_true(before.st_ino == after.st_ino);
}

static void *read_pipe(void *argument)
{
	return file_read(argument, NULL);
}

static void test_a_named_pipe_is_written_to(void **state)
{
	struct output_scene *scene = *state;
	pthread_t reader;
	void *text;

	assert_int_equal(mkfifo(scene->path.text, 0600), 0);
	assert_int_equal(
		pthread_create(&reader, NULL, read_pipe, scene->path.text), 0);
	output_scene_write(scene, scene->path.text, "through the pipe");
	assert_int_equal(pthread_join(reader, &text), 0);
	assert_string_equal(text, "through the pipe");
	free(text);
	assert_true(S_ISFIFO(output_scene_mode(scene->path.text)));
}

static void test_a_socket_stays_where_it_is(void **state)
{
	struct output_scene *scene = *state;
	struct sockaddr_un address = {.sun_family = AF_UNIX};
	int fd = socket(AF_UNIX, SOCK_STREAM, 0);

	assert_true(fd >= 0);
	assert_true(strlen(scene->path.text) < sizeof(address.sun_path));
	strcpy(address.sun_path, scene->path.text);
	assert_int_equal(
		bind(fd, (struct sockaddr *)&address, sizeof(address)), 0);
	output_scene_expect_refusal(
		scene, scene->path.text, ENXIO, "cannot be written");
	close(fd);
	assert_true(S_ISSOCK(output_scene_mode(scene->path.text)));
}

/* Opens a file as a shell's ">>" opens standard output. */
static void test_an_open_descriptor_is_written_from_its_position(void **state)
{
	struct output_scene *scene = *state;
	char path[32];
	int fd;

	file_write(scene->path.text, "before ", 7);
	fd = open(scene->path.text, O_WRONLY | O_APPEND);
	assert_true(fd >= 0);
	snprintf(path, sizeof(path), "/dev/fd/%d", fd);
	output_scene_write(scene, path, "between ");
	snprintf(path, sizeof(path), "/proc/self/fd/%d", fd);
	output_scene_write(scene, path, "between ");
	assert_int_equal(write(fd, "after", 5), 5);
	close(fd);
	output_scene_expect(scene->path.text, "before between between after");
	assert_int_equal(temp_dir_count(&scene->folder), 1);
	output_scene_expect_refusal(scene, path, EBADF, "cannot be written");
}

static void test_standard_output_is_recognized(void **state)
{
	static const struct {
		const char *path;
		int descriptor;
	} cases[] = {
		{"/dev/stdout", 1},
		{"/dev/stderr", 2},
		{"/dev/fd/17", 17},
		{"/proc/self/fd/3", 3},
		{"/dev/fd/", -1},
		{"/dev/fd/1x", -1},
		{"/dev/fd/99999999999", -1},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		char *target;
		int descriptor;

		assert_int_equal(
			output_path_follow(cases[i].path, &target, &descriptor),
			0);
		assert_int_equal(descriptor, cases[i].descriptor);
		free(target);
	}
}

static void test_two_writers_do_not_interfere(void **state)
{
	struct output_scene *scene = *state;
	struct output_file *first = output_scene_begin(scene, scene->path.text);
	struct output_file *second = output_scene_begin(scene, scene->path.text);

	for (int i = 0; i < 10000; i++) {
		fputc('1', output_file_stream(first));
		fputc('2', output_file_stream(second));
	}
	fputs("second", output_file_stream(second));
	assert_int_equal(output_file_commit(first), 0);
	assert_int_equal(output_file_commit(second), 0);
	assert_int_equal(temp_dir_count(&scene->folder), 1);
	{
		size_t size;
		char *text = file_read(scene->path.text, &size);

		assert_int_equal(size, 10006);
		assert_int_equal(strspn(text, "2"), 10000);
		free(text);
	}
}

static void *write_often(void *argument)
{
	struct output_scene *scene = argument;
	struct log quiet = log_to_nowhere();

	for (int i = 0; i < 50; i++) {
		struct output_file *file;

		if (output_file_create(scene->path.text, &quiet, &file) != 0) {
			return scene;
		}
		for (int k = 0; k < 5000; k++) {
			fputc('a' + i % 26, output_file_stream(file));
		}
		if (output_file_commit(file) != 0) {
			return scene;
		}
	}
	return NULL;
}

static void test_writers_at_the_same_time_leave_one_whole_file(void **state)
{
	struct output_scene *scene = *state;
	pthread_t thread[4];
	char *text;

	for (int i = 0; i < 4; i++) {
		assert_int_equal(
			pthread_create(&thread[i], NULL, write_often, scene), 0);
	}
	for (int i = 0; i < 4; i++) {
		void *problem;

		assert_int_equal(pthread_join(thread[i], &problem), 0);
		assert_null(problem);
	}
	text = file_read(scene->path.text, NULL);
	assert_int_equal(strlen(text), 5000);
	assert_int_equal(strspn(text, (char[]){text[0], '\0'}), 5000);
	free(text);
	assert_int_equal(temp_dir_count(&scene->folder), 1);
}

static void note_read(const char *path)
{
	FILE *read = file_open(path);

	assert_non_null(read);
	fclose(read);
}

static void test_a_file_that_was_read_is_only_edited(void **state)
{
	struct output_scene *scene = *state;
	const char *path = scene->path.text;
	struct output_file *begun = output_scene_begin(scene, path), *file;

	file_write(path, "read", 4);
	note_read(path);
	output_scene_expect_refusal(
		scene, path, ETXTBSY, "limber reads this file");
	/* It was begun before. */
	fputs("other", output_file_stream(begun));
	assert_int_not_equal(fflush(output_file_stream(begun)), 0);
	assert_int_equal(output_file_commit(begun), -ETXTBSY);
	output_scene_expect(path, "read");
	assert_int_equal(output_file_edit(NULL, path, &scene->log, &file), 0);
	fputs("edited", output_file_stream(file));
	assert_int_equal(output_file_commit(file), 0);
	output_scene_expect(path, "edited");
	assert_int_equal(temp_dir_count(&scene->folder), 1);
}

static void test_a_file_that_is_read_after_the_first_bytes_stays(void **state)
{
	struct output_scene *scene = *state;
	const char *path = scene->path.text;
	struct output_file *file = output_scene_begin(scene, path);

	fputs("first", output_file_stream(file));
	assert_int_equal(fflush(output_file_stream(file)), 0);
	file_write(path, "read", 4);
	note_read(path);
	assert_int_equal(output_file_publish(file), -ETXTBSY);
	assert_int_equal(output_file_commit(file), -ETXTBSY);
	output_scene_expect(path, "read");
	assert_int_equal(temp_dir_count(&scene->folder), 1);
}

static void test_a_scratch_file_is_read_again(void **state)
{
	FILE *file = output_file_scratch();
	char text[16] = "";

	(void)state;
	assert_non_null(file);
	assert_int_equal(fputs("a ", file) < 0, 0);
	assert_int_equal(fflush(file), 0);
	assert_int_equal(fputs("scratch", file) < 0, 0);
	rewind(file);
	assert_int_equal(fread(text, 1, sizeof(text), file), 9);
	assert_string_equal(text, "a scratch");
	assert_int_equal(fclose(file), 0);
}

/* What flushing standard output returns when it is this file. */
static int flush_to(const char *path, const struct log *log)
{
	int kept, fd = open(path, O_WRONLY), error;

	fflush(stdout);
	kept = dup(STDOUT_FILENO);
	assert_true(fd >= 0 && kept >= 0);
	assert_true(dup2(fd, STDOUT_FILENO) >= 0);
	putchar(' ');
	error = output_file_flush_stdout(log);
	clearerr(stdout);
	assert_true(dup2(kept, STDOUT_FILENO) >= 0);
	close(kept);
	close(fd);
	return error;
}

static void test_standard_output_that_is_full_is_reported(void **state)
{
	struct output_scene *scene = *state;

	assert_int_equal(flush_to("/dev/null", &scene->log), 0);
	assert_int_equal(scene->logged.count, 0);
	assert_int_equal(flush_to("/dev/full", &scene->log), -ENOSPC);
	assert_int_equal(scene->logged.count, 1);
	assert_contains(scene->logged.sentence[0],
		"standard output: cannot be written: No space left");
	assert_int_equal(flush_to("/dev/null", &scene->log), 0);
}

int main(void)
{
#define CASE(name)                       \
	cmocka_unit_test_setup_teardown( \
		name, output_scene_setup, output_scene_teardown)
	const struct CMUnitTest tests[] = {
		CASE(test_a_file_appears_when_it_is_complete),
		CASE(test_the_old_file_stays_until_the_new_one_is_complete),
		CASE(test_a_discarded_file_leaves_no_trace),
		CASE(test_a_published_file_is_seen_as_it_grows),
		CASE(test_a_disk_that_fills_up_keeps_the_old_file),
		CASE(test_a_file_that_cannot_be_written_is_not_published),
		CASE(test_a_failure_is_reported_once),
		CASE(test_the_first_cause_of_a_failure_is_reported),
		CASE(test_a_full_device_stays_where_it_is),
		CASE(test_a_device_is_written_to),
		CASE(test_a_named_pipe_is_written_to),
		CASE(test_a_socket_stays_where_it_is),
		CASE(test_an_open_descriptor_is_written_from_its_position),
		cmocka_unit_test(test_standard_output_is_recognized),
		cmocka_unit_test(test_a_scratch_file_is_read_again),
		CASE(test_standard_output_that_is_full_is_reported),
		CASE(test_a_file_that_was_read_is_only_edited),
		CASE(test_a_file_that_is_read_after_the_first_bytes_stays),
		CASE(test_two_writers_do_not_interfere),
		CASE(test_writers_at_the_same_time_leave_one_whole_file),
	};
#undef CASE

	return cmocka_run_group_tests(tests, NULL, NULL);
}
