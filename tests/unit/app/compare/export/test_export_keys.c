/* Key frames that are loaded to predict what drawing them costs. */
#include "app/compare/export/export_keys.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

enum {
	CLIPS_MAX = 33
};

struct bench {
	struct model *model;
	struct comparison_clip clip[CLIPS_MAX];
	struct comparison_cell cell[CLIPS_MAX];
	struct comparison comparison;
};

/* All clips are the same, which lasts a second or two and shows one triangle. */
static void begin(struct bench *bench, const char *name, int clip_count)
{
	*bench = (struct bench){.model = model_fixture(name, NULL)};
	bench->comparison = (struct comparison){.model = bench->model,
		.box = {{-8, -8, -8}, {8, 8, 24}},
		.vertex_count = 3,
		.clip_count = clip_count,
		.clip = bench->clip,
		.sampling = {.drawn_frames = 4}};
	for (int c = 0; c < clip_count; c++) {
		bench->clip[c].clip = bench->model->clip_count - 1;
	}
}

static void end(struct bench *bench)
{
	model_destroy(bench->model);
}

/* Up to 64 key frames of together 2 Mi vertices, two of each clip. */
static void test_many_key_frames_are_drawn_as_the_model(void **state)
{
	static const struct {
		int clips, vertices;
		bool differ;
	} cases[] = {{1, 3, true}, {32, 3, true}, {33, 3, false},
		{1, 1 << 20, true}, {1, (1 << 20) + 1, false},
		{2, 1 << 19, true}, {2, (1 << 19) + 1, false},
		{32, 1 << 15, true}, {32, (1 << 15) + 1, false}};
	struct bench bench;

	(void)state;
	begin(&bench, "gltf/clip/door.gltf", 1);
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		bench.comparison.clip_count = cases[i].clips;
		bench.comparison.vertex_count = cases[i].vertices;
		assert_int_equal(
			export_keys_differ(&bench.comparison), cases[i].differ);
	}
	end(&bench);
}

/* Facets, which any part may have. */
static void test_key_frames_of_parts_without_normals_differ(void **state)
{
	static float normal[3][3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
	struct bench bench;

	(void)state;
	begin(&bench, "gltf/clip/door.gltf", 1);
	assert_true(bench.model->mesh_count > 2);
	for (int m = -1; m < bench.model->mesh_count; m++) {
		for (int other = 0; other < bench.model->mesh_count; other++) {
			struct model_mesh *mesh = &bench.model->mesh[other];

			assert_int_equal(mesh->primitive_count, 1);
			mesh->primitive[0].normal = other == m ? NULL : normal;
		}
		assert_int_equal(export_keys_differ(&bench.comparison), m >= 0);
	}
	for (int p = 0; p < 2; p++) {
		struct model_primitive two[2] = {*bench.model->mesh[0].primitive,
			*bench.model->mesh[0].primitive};
		struct model_mesh *mesh = &bench.model->mesh[0], kept = *mesh;

		two[p].normal = NULL;
		two[1 - p].normal = normal;
		bench.model->mesh[bench.model->mesh_count - 1].primitive[0].normal =
			normal;
		mesh->primitive = two;
		mesh->primitive_count = 2;
		assert_true(export_keys_differ(&bench.comparison));
		mesh->primitive_count = 1;
		assert_int_equal(export_keys_differ(&bench.comparison), p == 0);
		*mesh = kept;
	}
	end(&bench);
}

static struct model *load(struct bench *bench)
{
	struct log log = log_to_stderr(LOG_ERROR);
	float own_s[3] = {0.0f, 0.25f, 0.5f};
	struct comparison_row row = {.kind = COMPARISON_MORPH,
		.cell = bench->cell,
		.total = {.key_count = 3 * bench->comparison.clip_count}};
	struct model *loaded;

	for (int c = 0; c < bench->comparison.clip_count; c++) {
		bench->cell[c].keys = (struct fit_keys){3, own_s};
	}
	assert_int_equal(
		export_keys_load(&bench->comparison, &row, &log, &loaded), 0);
	for (int c = 0; c < bench->comparison.clip_count; c++) {
		assert_ptr_equal(bench->cell[c].keys.time_s, own_s);
	}
	assert_int_equal(loaded->clip_count, bench->comparison.clip_count);
	return loaded;
}

/* Keys at both ends of each clip and in the middles of so many parts. */
static void expect_keys(
	const struct bench *bench, const struct model *loaded, int parts)
{
	int count = parts + 2;

	assert_int_equal(loaded->mesh[0].target_count,
		count * bench->comparison.clip_count);
	for (int c = 0; c < loaded->clip_count; c++) {
		const struct model_channel *channel = loaded->clip[c].channel;
		float duration_s =
			bench->model->clip[bench->clip[c].clip].duration_s;

		assert_int_equal(channel->path, MODEL_WEIGHTS);
		assert_int_equal(channel->key_count, count);
		assert_near(channel->time_s[0], 0.0, 0.0);
		assert_near(channel->time_s[count - 1], duration_s, 0.0);
		for (int i = 0; i < parts; i++) {
			assert_near(channel->time_s[i + 1],
				duration_s * (2.0 * i + 1.0) / (2.0 * parts),
				1e-6);
		}
	}
}

/* Those that the row has are left alone. */
static void test_keys_are_at_the_ends_and_in_the_middles_of_parts(void **state)
{
	(void)state;
	for (int clips = 1; clips < 4; clips++) {
		struct bench bench;
		struct model *loaded;

		begin(&bench, "gltf/clip/frame_one.gltf", clips);
		loaded = load(&bench);
		expect_keys(&bench, loaded, 4);
		model_destroy(loaded);
		end(&bench);
	}
}

/* Those of all clips are at most 64: 10 clips may have 6 keys, and 12 have 5. */
static void test_many_clips_have_keys_at_their_ends_alone(void **state)
{
	static const struct {
		int frames, clips, vertices, parts;
	} cases[] = {{4, 10, 3, 4}, {4, 11, 3, 0}, {3, 12, 3, 3}, {3, 13, 3, 0},
		{4, 1, (1 << 21) / 6, 4}, {4, 1, (1 << 21) / 6 + 1, 0}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct bench bench;
		struct model *loaded;

		begin(&bench, "gltf/clip/frame_one.gltf", cases[i].clips);
		bench.comparison.vertex_count = cases[i].vertices;
		bench.comparison.sampling.drawn_frames = cases[i].frames;
		loaded = load(&bench);
		expect_keys(&bench, loaded, cases[i].parts);
		model_destroy(loaded);
		end(&bench);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_many_key_frames_are_drawn_as_the_model),
		cmocka_unit_test(test_key_frames_of_parts_without_normals_differ),
		cmocka_unit_test(
			test_keys_are_at_the_ends_and_in_the_middles_of_parts),
		cmocka_unit_test(test_many_clips_have_keys_at_their_ends_alone),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
