/*
 * What is measured of clips: how they go over the ground, which node carries
 * the figure away, and how high its soles are.
 */
#include "app/character/character_data.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

enum {
	TRACKS_MAX = 4,
	KEYS = 4
};

/* The clip's duration. */
static const float end_s = 2;

/* The figure's nodes; each of the last three shows a triangle. */
enum node {
	OUTER,
	INNER, /* below the former, and above the others */
	FOOT,
	OTHER_FOOT,
	HEAD,
	TIP = HEAD + 3 /* of a leg below the inner node, without vertices */
};

/* The places of a node at the clip's start, quarters, half and end. */
struct track {
	enum node node;
	float at[KEYS + 1][3];
};

static const char *const nodes =
	"{\"name\":\"outer\",\"children\":[1]},"
	"{\"name\":\"inner\",\"children\":[2,3,4,5]},"
	"{\"mesh\":0},{\"mesh\":0},{\"mesh\":0,\"translation\":[0,1,0]},"
	"{\"name\":\"u\",\"children\":[6]},"
	"{\"name\":\"l\",\"children\":[7]},{\"name\":\"f\"}";

static void write_json(const char *path, const struct track *track, int count)
{
	FILE *file = fopen(path, "w");
	int times = (int)sizeof(float[KEYS + 1]);

	assert_non_null(file);
	fprintf(file,
		"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
		"\"scenes\":[{\"nodes\":[0]}],\"nodes\":[%s],"
		"\"meshes\":[{\"primitives\":[{\"attributes\":{"
		"\"POSITION\":0}}]}],\"animations\":[{\"name\":\"go\","
		"\"channels\":[",
		nodes);
	for (int i = 0; i < count; i++) {
		fprintf(file,
			"%s{\"sampler\":%d,\"target\":{\"node\":%d,"
			"\"path\":\"translation\"}}",
			i ? "," : "", i, track[i].node);
	}
	fprintf(file, "],\"samplers\":[");
	for (int i = 0; i < count; i++) {
		fprintf(file, "%s{\"input\":1,\"output\":%d}", i ? "," : "",
			2 + i);
	}
	fprintf(file,
		"]}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,"
		"\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],"
		"\"max\":[1,1,1]},{\"bufferView\":0,\"byteOffset\":36,"
		"\"componentType\":5126,\"count\":%d,\"type\":\"SCALAR\","
		"\"min\":[0],\"max\":[2]}",
		KEYS + 1);
	for (int i = 0; i < count; i++) {
		fprintf(file,
			",{\"bufferView\":0,\"byteOffset\":%d,"
			"\"componentType\":5126,\"count\":%d,\"type\":\"VEC3\"}",
			36 + times * (1 + 3 * i), KEYS + 1);
	}
	fprintf(file,
		"],\"bufferViews\":[{\"buffer\":0,\"byteLength\":%d}],"
		"\"buffers\":[{\"uri\":\"go.bin\",\"byteLength\":%d}]}",
		36 + times * (1 + 3 * count), 36 + times * (1 + 3 * count));
	assert_int_equal(fclose(file), 0);
}

/* Returns what is found of the clip of these tracks. */
static const struct character_clip *begin(struct acting *acting,
	const struct track *track, int count, const char *motion)
{
	struct {
		float triangle[3][3], time_s[KEYS + 1],
			at[TRACKS_MAX][KEYS + 1][3];
	} data = {.triangle = {{0, 0, 0}, {0.1f, 0, 0}, {0, 0.1f, 0}}};
	struct test_path folder = temp_dir_make();
	char text[256];

	for (int i = 0; i <= KEYS; i++) {
		data.time_s[i] = end_s * (float)i / KEYS;
	}
	for (int i = 0; i < count; i++) {
		memcpy(data.at[i], track[i].at, sizeof(data.at[i]));
	}
	file_write(path_join(&folder, "go.bin").text, &data, sizeof(data));
	write_json(path_join(&folder, "go.gltf").text, track, count);
	acting_begin(acting, path_join(&folder, "go.gltf").text);
	temp_dir_remove(&folder);
	snprintf(text, sizeof(text),
		"[state a]\nclip = go\n[motion]\nclips = yes\n%s", motion);
	acting_expect(acting, text);
	return &acting->character->clip[0];
}

/* A node goes to a place over the ground at an even speed. */
static struct track going(enum node node, float x, float z)
{
	struct track track = {.node = node};

	for (int i = 0; i <= KEYS; i++) {
		track.at[i][0] = x * (float)i / KEYS;
		track.at[i][1] = node == HEAD ? 1 : 0;
		track.at[i][2] = z * (float)i / KEYS;
	}
	return track;
}

/* What the clip does with the ground, if a root carries the figure. */
static void expect(const struct acting *acting, int root, const float way[2])
{
	const struct character_clip *clip = &acting->character->clip[0];

	assert_int_equal(acting->character->motion.root, root);
	for (int axis = 0; axis < 2; axis++) {
		float carried = root < 0 ? 0 : way[axis];

		assert_near(clip->carried_m[axis], carried, 1e-4);
		assert_near(clip->ground_m_per_s[axis], carried / end_s, 1e-4);
	}
}

/* The figure's longest side is its height, of 1.1 m. */
static void test_what_goes_farther_than_it_is_long_is_carried(void **state)
{
	static const struct {
		float way[2];
		bool far;
	} ways[] = {{{1.05f, 0}, false}, {{1.15f, 0}, true},
		{{0, 1.05f}, false}, {{0, -1.15f}, true}, {{0.9f, 0.7f}, true},
		{{0.9f, 0.5f}, false}, {{-0.5f, 0.9f}, false},
		{{0.7f, -0.9f}, true}, {{0.2f, 0.2f}, false}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(ways); i++) {
		for (int node = OUTER; node <= INNER; node++) {
			const float *way = ways[i].way;
			struct track track =
				going((enum node)node, way[0], way[1]);
			struct acting acting;

			begin(&acting, &track, 1, "");
			expect(&acting, ways[i].far ? node : -1, way);
			acting_end(&acting);
		}
	}
}

/* Whichever of both the file moves first. */
static void test_the_uppermost_node_carries(void **state)
{
	struct track tracks[2] = {going(OUTER, 3, -1), {.node = INNER}};
	struct acting acting;

	(void)state;
	tracks[1].at[2][0] = 0.1f;
	for (int i = 0; i < 2; i++) {
		struct track first = tracks[0];

		begin(&acting, tracks, 2, "");
		expect(&acting, OUTER, (const float[2]){3, -1});
		acting_end(&acting);
		tracks[0] = tracks[1];
		tracks[1] = first;
	}
}

/* Up to 3% of the way, along it or beside it. */
static void test_the_node_that_carries_goes_nearly_as_far_as_all(void **state)
{
	static const struct {
		float way[2], rest[2];
		enum node carrier;
	} cases[] = {{{4, 0}, {0.1f, 0}, OUTER}, {{4, 0}, {-0.1f, 0}, OUTER},
		{{4, 0}, {0.16f, 0}, INNER}, {{4, 0}, {-0.16f, 0}, INNER},
		{{4, 0}, {0, 0.1f}, OUTER}, {{4, 0}, {0, -0.16f}, INNER},
		{{0, 4}, {0, 0.1f}, OUTER}, {{0, 4}, {0, 0.16f}, INNER},
		{{0, 4}, {0, -0.16f}, INNER}, {{0, 4}, {0.16f, 0}, INNER},
		{{0, 4}, {-0.1f, 0}, OUTER}, {{3, 2.6f}, {0.1f, 0}, OUTER},
		{{3, 2.6f}, {0.1f, -0.1f}, INNER}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const float *way = cases[i].way, *rest = cases[i].rest;
		struct track tracks[2] = {
			going(OUTER, way[0] - rest[0], way[1] - rest[1]),
			going(INNER, rest[0], rest[1])};
		float carried[2] = {way[0], way[1]};
		struct acting acting;

		begin(&acting, tracks, 2, "");
		if (cases[i].carrier == OUTER) {
			carried[0] -= rest[0];
			carried[1] -= rest[1];
		}
		expect(&acting, cases[i].carrier, carried);
		acting_end(&acting);
	}
}

/* Else others would stay behind. */
static void test_a_node_that_carries_a_part_moves_no_ground(void **state)
{
	struct track tracks[3] = {
		going(FOOT, 4, 0), going(OTHER_FOOT, 4, 0), going(HEAD, 4, 0)};
	struct acting acting;

	(void)state;
	begin(&acting, tracks, 3, "");
	expect(&acting, -1, NULL);
	acting_end(&acting);
}

/* A foot is on the ground for half of the clip, and lifted for the other. */
static struct track stepping(enum node node, float x, float z)
{
	static const float ways[2][KEYS + 1] = {
		{1, 0, -1, 0, 1}, {-1, 0, 1, 0, -1}};
	bool first = node == FOOT;
	struct track track = {.node = node};

	for (int i = 0; i <= KEYS; i++) {
		track.at[i][0] = x * ways[!first][i];
		track.at[i][2] = z * ways[!first][i];
	}
	track.at[first ? 3 : 1][1] = 0.5f;
	return track;
}

/* A foot goes back by two steps' halves in half of the clip. */
static void test_a_clip_on_the_spot_goes_as_its_feet_step(void **state)
{
	static const float steps[][2] = {
		{0.3f, 0}, {0, 0.4f}, {-0.3f, 0}, {0.3f, -0.2f}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(steps); i++) {
		struct track tracks[2] = {
			stepping(FOOT, steps[i][0], steps[i][1]),
			stepping(OTHER_FOOT, steps[i][0], steps[i][1])};
		const struct character_clip *clip;
		struct acting acting;

		clip = begin(&acting, tracks, 2, "");
		assert_int_equal(acting.character->motion.root, -1);
		for (int axis = 0; axis < 2; axis++) {
			assert_near(clip->ground_m_per_s[axis],
				2 * steps[i][axis], 1e-3);
			assert_near(clip->carried_m[axis], 0, 0);
		}
		assert_null(clip->sole_m);
		acting_end(&acting);
	}
}

/*
 * Feet that step while nodes go on. The ground goes as the feet do, but without
 * the way of nodes that the root does not carry.
 */
static void test_a_clip_that_walks_away_goes_as_its_feet_step(void **state)
{
	static const struct {
		float outer[2], inner[2], step[2], ground[2], carried[2];
		const char *motion;
		int root;
	} cases[] = {
		/* Along each axis, less far than the figure is long. */
		{{0.8f, 0}, {0, 0}, {0.3f, 0}, {0.6f, 0}, {0.8f, 0}, "", OUTER},
		{{0, -0.8f}, {0, 0}, {0, 0.3f}, {0, 0.6f}, {0, -0.8f}, "", OUTER},
		{{0, 0}, {0, 0.8f}, {0, 0.3f}, {0, 0.6f}, {0, 0.8f}, "", INNER},
		/* The root that the file names goes a part of the way. */
		{{0, 0.4f}, {0, 0.8f}, {0, 0.7f}, {0, 1.4f - 0.4f}, {0, 0.4f},
			"root = outer\n", OUTER},
		{{0.4f, 0}, {0.8f, 0}, {0.7f, 0}, {1.4f - 0.4f, 0}, {0.4f, 0},
			"root = outer\n", OUTER},
		{{0, 0}, {0, 0.8f}, {0, 0.7f}, {0, 1.4f - 0.4f}, {0, 0},
			"root = outer\n", OUTER},
		/* Too little of a way for the clip to leave. */
		{{0, 0.1f}, {0, 0}, {0, 0.7f}, {0, 1.4f - 0.05f}, {0, 0.1f},
			"root = outer\n", OUTER},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const float *step = cases[i].step;
		struct track tracks[4] = {
			going(OUTER, cases[i].outer[0], cases[i].outer[1]),
			going(INNER, cases[i].inner[0], cases[i].inner[1]),
			stepping(FOOT, step[0], step[1]),
			stepping(OTHER_FOOT, step[0], step[1])};
		const struct character_clip *clip;
		struct acting acting;

		clip = begin(&acting, tracks, 4, cases[i].motion);
		assert_int_equal(acting.character->motion.root, cases[i].root);
		assert_all_near(clip->ground_m_per_s, cases[i].ground, 2, 1e-3);
		assert_all_near(clip->carried_m, cases[i].carried, 2, 1e-4);
		acting_end(&acting);
	}
}

/* The soles of the rest pose, which comes last, are those at rest. */
static void test_soles_are_as_high_as_the_clip_lifts_them(void **state)
{
	struct track track = {.node = OUTER};
	const struct character_clip *clip;
	struct acting acting;

	(void)state;
	for (int i = 0; i <= KEYS; i++) {
		track.at[i][1] = 0.5f + 0.3f * (float)i;
	}
	clip = begin(&acting, &track, 1,
		"[feet a]\nhips = inner\nleft = u l f\nright = u l f\n");
	assert_int_equal(acting.character->clip_count, 2);
	for (int i = 0; i < CHARACTER_SAMPLES; i++) {
		assert_near(clip->sole_m[0][i],
			0.5f + 0.3f * KEYS * (float)i / CHARACTER_SAMPLES, 1e-5);
		assert_near(clip[1].sole_m[0][i], 0, 1e-6);
	}
	/* In the end the figure is at rest. */
	for (int axis = 0; axis < 3; axis++) {
		assert_near(acting.instance->world[TIP][3][axis], 0, 0);
	}
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_what_goes_farther_than_it_is_long_is_carried),
		cmocka_unit_test(test_the_uppermost_node_carries),
		cmocka_unit_test(
			test_the_node_that_carries_goes_nearly_as_far_as_all),
		cmocka_unit_test(test_a_node_that_carries_a_part_moves_no_ground),
		cmocka_unit_test(test_a_clip_on_the_spot_goes_as_its_feet_step),
		cmocka_unit_test(
			test_a_clip_that_walks_away_goes_as_its_feet_step),
		cmocka_unit_test(test_soles_are_as_high_as_the_clip_lifts_them),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
