#define _GNU_SOURCE /* fopencookie() */

#include "tests/unit/app/embed/embed_scene.h"

#include <sys/wait.h>
#include <unistd.h>

/* Prints a first part of so many vertices, which all lie at one place. */
static void print_large(struct embed_scene *s, int vertices)
{
	size_t count = (size_t)vertices;
	float(*position)[3] = calloc(count, sizeof(*position));

	assert_non_null(position);
	s->mesh[0].target_count = 0;
	s->pair[0].vertex_count = vertices;
	s->pair[0].position = position;
	embed_scene_print(s, 0);
	free(position);
}

static void indices_are_wide_above_65536_vertices(void **state)
{
	struct embed_scene s;
	size_t narrow;

	(void)state;
	embed_scene_begin(&s);
	print_large(&s, 65536);
	assert_contains(s.text, "\ntypedef uint16_t t_index_t;\n");
	narrow = s.size.rom_bytes;
	print_large(&s, 65537);
	assert_contains(s.text, "\ntypedef uint32_t t_index_t;\n");
	/* A vertex, and two bytes more for each of 15 indices. */
	assert_int_equal(s.size.rom_bytes, narrow + 28 + 15 * 2);
	embed_scene_end(&s);
}

static void joints_are_wide_above_256(void **state)
{
	static int joint[257];
	static mat4 bind[257];
	struct embed_scene s;
	size_t narrow;

	(void)state;
	embed_scene_begin(&s);
	s.skin[0].joint = joint;
	s.skin[0].inverse_bind = bind;
	s.skin[0].joint_count = 256;
	embed_scene_print(&s, 0);
	assert_contains(s.text, "static const uint8_t t_joint[12]");
	narrow = s.size.rom_bytes;
	s.skin[0].joint_count = 257;
	embed_scene_print(&s, 0);
	assert_contains(s.text, "static const uint16_t t_joint[12]");
	/* A joint more, and a byte more for each of 12 influences. */
	assert_int_equal(s.size.rom_bytes, narrow + 50 + 12);
	/* The skinned part's joints follow those of the first skin. */
	assert_contains(s.text, "7, 3, 9, 3, 0, 4, 257, 1, 84, 0, 0},");
	embed_scene_end(&s);
}

static void takes_names_that_are_c_identifiers(void **state)
{
	static const char *const good[] = {"a", "_", "Az_09",
		"a23456789012345678901234567890123456789012"
		"345678901234567890123"};
	static const char *const bad[] = {"", "0a", "9", "a-b", "a.b", "a b",
		"\303\244",
		"a234567890123456789012345678901234567890123456789012345678901"
		"234"};
	struct embed_scene s;

	(void)state;
	embed_scene_begin(&s);
	for (size_t i = 0; i < sizeof(good) / sizeof(*good); i++) {
		char function[100];

		assert_int_equal(embed_scene_print_as(&s, good[i], 0), 0);
		snprintf(function, sizeof(function), "\nvoid %s_pose(struct ",
			good[i]);
		assert_contains(s.text, function);
		assert_null(strstr(s.text, "embedded"));
		assert_null(strstr(s.text, "EMBEDDED"));
	}
	assert_int_equal(embed_scene_print_as(&s, "Az_09", 0), 0);
	assert_contains(s.text, "#if AZ_09_JOINTS > 0\n");
	for (size_t i = 0; i < sizeof(bad) / sizeof(*bad); i++) {
		assert_int_equal(embed_scene_print_as(&s, bad[i], 0), -EINVAL);
		assert_contains(s.logged.sentence[0],
			"not a C identifier of at most 63 characters");
	}
	embed_scene_end(&s);
}

static void refuses_what_the_player_cannot_show(void **state)
{
	static const float matrix[4][4];
	struct embed_scene s;

	(void)state;
	embed_scene_begin(&s);
	s.node[3].file_index = 7;
	s.node[3].matrix = matrix;
	assert_int_equal(embed_scene_print_as(&s, "t", 0), -EINVAL);
	assert_contains(
		s.logged.sentence[0], "a.glb: node 7 has a sheared matrix");
	assert_contains(s.logged.sentence[0], ": apply the scale");
	/* The one behind the last node is not the model's. */
	s.node[3].matrix = NULL;
	s.node[4].matrix = matrix;
	embed_scene_print(&s, 0);
	embed_scene_end(&s);
	embed_scene_begin(&s);
	for (int n = 0; n < 4; n++) {
		s.node[n].in_scene = false;
	}
	assert_int_equal(embed_scene_print_as(&s, "t", 0), -EINVAL);
	assert_contains(s.logged.sentence[0],
		"nothing to draw: export it with its meshes");
	embed_scene_end(&s);
}

static void expect_too_large(struct embed_scene *s)
{
	assert_int_equal(embed_scene_print_as(s, "t", 0), -EFBIG);
	assert_contains(s->logged.sentence[0], "too large to be C source");
	assert_string_equal(s->text, "");
}

/*
 * The player has 16 bits for keys, for a key's width and for where a channel
 * writes. Widths of weights have a table; the others are 3 or 4.
 */
static void refuses_numbers_that_need_more_than_16_bits(void **state)
{
	static float many[INT16_MAX + 1];
	struct embed_scene s;

	(void)state;
	embed_scene_begin(&s);
	s.channel[3] = (struct model_channel){.node = 0,
		.path = MODEL_WEIGHTS,
		.width = 1,
		.key_count = INT16_MAX,
		.time_s = many,
		.value = many};
	s.node[0].weight_offset = INT16_MAX;
	embed_scene_print(&s, 0);
	assert_contains(s.text, ", 32767, 32767, 1, 3, 0},\n");
	s.channel[3].key_count++;
	expect_too_large(&s);
	s.channel[3].key_count = 1;
	s.channel[3].width = INT16_MAX;
	embed_scene_print(&s, 0);
	s.channel[3].width++;
	expect_too_large(&s);
	s.channel[3].width = 1;
	s.node[0].weight_offset++;
	expect_too_large(&s);
	/* A node's own channels do not depend on where its weights are. */
	s.clip[0].channel_count = 2;
	embed_scene_print(&s, 0);
	embed_scene_end(&s);
}

static void refuses_tables_beyond_a_limit_before_it_writes(void **state)
{
	struct embed_scene s;

	(void)state;
	embed_scene_begin(&s);
	/* 4 bytes an index: one more than 256 MiB, and more than an int. */
	s.pair[0].index_count = 64 * 1024 * 1024;
	expect_too_large(&s);
	s.pair[0].index_count = INT32_MAX;
	expect_too_large(&s);
	s.pair[0].index_count = 3;
	s.mesh[0].target_count = INT32_MAX / 5;
	expect_too_large(&s);
	embed_scene_end(&s);
}

/* What an element takes at least, and so many that they take 256 MiB. */
static int beyond(int bytes)
{
	return (256 << 20) / bytes + 1;
}

/* Each count by itself; nothing of what it counts is read. */
static void refuses_each_table_that_is_too_large(void **state)
{
	struct embed_scene s;

	(void)state;
	for (int table = 0; table < 6; table++) {
		embed_scene_begin(&s);
		switch (table) {
		case 0:
			s.pair[0].vertex_count = beyond(28);
			s.mesh[0].target_count = 0;
			break;
		case 1:
			s.skinned[0].index_count = beyond(4);
			break;
		case 2:
			s.skinned[0].vertex_count = 1000;
			s.skinned[0].influences = beyond(6 * 1000);
			break;
		case 3:
			s.pair[0].vertex_count = 10;
			s.mesh[0].target_count = beyond(4 * 6 * (10 + 4));
			break;
		case 4:
			s.skin[1].joint_count = beyond(50);
			break;
		default:
			s.model.weight_count = beyond(4);
			break;
		}
		expect_too_large(&s);
		embed_scene_end(&s);
	}
}

static ssize_t end_well(void *unused, const char *text, size_t size)
{
	(void)unused;
	(void)text;
	_exit(size == 0);
}

/* Whether a child begins to write, which ends it; no table is read. */
static bool is_written(struct embed_scene *s, int clip)
{
	const cookie_io_functions_t calls = {.write = end_well};
	pid_t child = fork();
	int status = -1;

	if (child == 0) {
		struct log log = log_to_nowhere();
		FILE *out = fopencookie(NULL, "w", calls);

		setvbuf(out, NULL, _IONBF, 0);
		(void)embed_print(&s->model, clip, "t", &log, out, &s->size);
		_exit(2);
	}
	assert_int_equal(waitpid(child, &status, 0), child);
	return status == 0;
}

/*
 * Beside bytes of other tables, indices of 4 bytes that fill 256 MiB, which all
 * count exactly, and one index more.
 */
static void expect_limit(struct embed_scene *s, int clip, int bytes)
{
	s->pair[0].index_count = ((256 << 20) - bytes) / 4;
	assert_true(is_written(s, clip));
	s->pair[0].index_count++;
	assert_false(is_written(s, clip));
}

static void tables_may_fill_the_limit(void **state)
{
	/* Vertices, indices but for the first part's, targets, nodes, parts. */
	const int parts = 28 * 13 + 4 * 12 + 4 * 84 + 42 * 4 + 60 * 4;
	struct embed_scene s;

	(void)state;
	embed_scene_begin(&s);
	s.model.skin_count = 0;
	s.model.weight_count = 0;
	s.node[1].skin = -1;
	expect_limit(&s, -1, parts);
	embed_scene_end(&s);
	/* Joints, influences, weights, channels, times, values. */
	embed_scene_begin(&s);
	s.skin[1].joint_count = 3;
	expect_limit(&s, 0,
		parts + 50 * 4 + 6 * 12 + 4 * 4 + 16 * 4 + 4 * 6 + 4 * 23);
	embed_scene_end(&s);
}

/* Counting may take longer than anyone waits for. */
static void counts_no_further_than_the_limit(void **state)
{
	struct embed_scene s;

	(void)state;
	embed_scene_begin(&s);
	s.pair[1].index_count = beyond(4);
	s.mesh[1].primitive_count = INT32_MAX;
	s.mesh[1].primitive = NULL;
	expect_too_large(&s);
	embed_scene_end(&s);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(indices_are_wide_above_65536_vertices),
		cmocka_unit_test(joints_are_wide_above_256),
		cmocka_unit_test(takes_names_that_are_c_identifiers),
		cmocka_unit_test(refuses_what_the_player_cannot_show),
		cmocka_unit_test(refuses_numbers_that_need_more_than_16_bits),
		cmocka_unit_test(refuses_tables_beyond_a_limit_before_it_writes),
		cmocka_unit_test(refuses_each_table_that_is_too_large),
		cmocka_unit_test(tables_may_fill_the_limit),
		cmocka_unit_test(counts_no_further_than_the_limit),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
