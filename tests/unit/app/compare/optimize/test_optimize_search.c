/* The search for the fewest keys, and the coarsest numbers, within a bound. */
#include "app/compare/optimize/optimize.h"
#include "app/compare/optimize/optimize_measure.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
	KEYS = 60,
	CLIPS = 2
};

/* A triangle whose node turns about +Z in two clips. */
static const char text[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
	"\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
	"\"animations\":["
	"{\"name\":\"a\",\"samplers\":[{\"input\":1,\"output\":2}],\"channels\":"
	"[{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"rotation\"}}]},"
	"{\"name\":\"b\",\"samplers\":[{\"input\":1,\"output\":3}],\"channels\":"
	"[{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"rotation\"}}]}],"
	"\"accessors\":["
	"{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\","
	"\"min\":[-1,0,0],\"max\":[1,1,0]},"
	"{\"bufferView\":0,\"byteOffset\":36,\"componentType\":5126,"
	"\"count\":60,\"type\":\"SCALAR\",\"min\":[0],\"max\":[2.95]},"
	"{\"bufferView\":0,\"byteOffset\":276,\"componentType\":5126,"
	"\"count\":60,\"type\":\"VEC4\"},"
	"{\"bufferView\":0,\"byteOffset\":1236,\"componentType\":5126,"
	"\"count\":60,\"type\":\"VEC4\"}],"
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":2196}],"
	"\"buffers\":[{\"uri\":\"data.bin\",\"byteLength\":2196}]}";

struct data {
	float position[3][3], time_s[KEYS], rotation[CLIPS][KEYS][4];
};

/* The angle at a key, in radians. */
typedef float angle(int clip, int key);

struct searched {
	struct test_path folder;
	struct model *model, *found;
	struct optimize_result result;
	int steps;
};

static void count_step(void *context, int done, int total)
{
	(void)done;
	(void)total;
	++*(int *)context;
}

static void begin(struct searched *searched, angle *at, float bound_px)
{
	const struct log log = log_to_stderr(LOG_ERROR);
	const struct optimize_request request = {.bound_px = bound_px,
		.width = 480,
		.height = 640,
		.memory_bytes = MODEL_MEMORY_BYTES,
		.progress = count_step,
		.progress_context = &searched->steps};
	struct data data = {.position = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
	struct test_path path, small;

	searched->steps = 0;
	searched->folder = temp_dir_make();
	for (int k = 0; k < CLIPS * KEYS; k++) {
		float half = 0.5f * at(k / KEYS, k % KEYS);

		data.time_s[k % KEYS] = 0.05f * (float)(k % KEYS);
		data.rotation[k / KEYS][k % KEYS][2] = sinf(half);
		data.rotation[k / KEYS][k % KEYS][3] = cosf(half);
	}
	path = path_join(&searched->folder, "data.bin");
	file_write(path.text, &data, sizeof(data));
	path = path_join(&searched->folder, "model.gltf");
	file_write(path.text, text, strlen(text));
	assert_int_equal(model_load(path.text, &log, &searched->model), 0);
	assert_int_equal(optimize_model(searched->model, &request, &log,
				 &searched->result),
		0);
	small = path_join(&searched->folder, "small.glb");
	file_write(
		small.text, searched->result.data, searched->result.after.file);
	assert_int_equal(model_load(small.text, &log, &searched->found), 0);
}

static void end(struct searched *searched)
{
	free(searched->result.data);
	model_destroy(searched->model);
	model_destroy(searched->found);
	temp_dir_remove(&searched->folder);
}

static float clip_px(const struct searched *searched, int clip)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	const struct optimize_measure_view view = {480, 640, 1.0, 0.0f};
	struct bounds box = bounds_empty();
	float px;

	assert_int_equal(optimize_measure(searched->model, searched->found,
				 clip, view, &box, &log, &px),
		0);
	return px;
}

static int kept(const struct searched *searched, int clip)
{
	assert_int_equal(searched->found->clip_count, CLIPS);
	assert_int_equal(searched->found->clip[clip].channel_count, 1);
	return searched->found->clip[clip].channel[0].key_count;
}

static float wave(int clip, int key)
{
	float k = (float)key;

	return clip == 0 ? sinf(0.1f * k) + 0.3f * sinf(0.37f * k)
			 : 0.8f * sinf(0.04f * k + 1.0f);
}

static float line(int clip, int key)
{
	return (clip == 0 ? 0.02f : -0.01f) * (float)key;
}

/* Each clip has a bend of its own, and keeps the keys that it needs. */
static void test_each_clip_uses_the_bound(void **state)
{
	static const float bounds[] = {0.6f, 1.3f, 3.0f, 6.6f, 10.0f, 33.0f};
	int before[CLIPS] = {KEYS, KEYS};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(bounds); i++) {
		struct searched searched;
		float most_px = 0.0f;

		begin(&searched, wave, bounds[i]);
		for (int c = 0; c < CLIPS; c++) {
			float px = clip_px(&searched, c);

			assert_true(px <= bounds[i]);
			assert_true(px >= 0.8f * bounds[i]);
			assert_true(kept(&searched, c) <= before[c]);
			before[c] = kept(&searched, c);
			most_px = px > most_px ? px : most_px;
		}
		assert_near(searched.result.peak_px, most_px, 1e-3);
		/* A few files are built, and two clips of each measured. */
		assert_true(searched.steps < 18);
		end(&searched);
	}
	assert_true(before[0] <= 12 && before[1] <= 4);
}

/* The fewest bits miss strict bounds, and yet keys can be left out. */
static void test_keys_on_a_line_are_left_out_whatever_the_bits(void **state)
{
	static const float bounds[] = {
		0.002f, 0.006f, 0.02f, 0.05f, 1.0f, 30.0f};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(bounds); i++) {
		struct searched searched;

		begin(&searched, line, bounds[i]);
		assert_true(searched.result.peak_px <= bounds[i]);
		assert_true(searched.result.peak_px <= 0.5f * bounds[i]);
		assert_int_equal(kept(&searched, 0), 2);
		assert_int_equal(kept(&searched, 1), 2);
		assert_true(searched.steps < 26);
		end(&searched);
	}
}

/* Where all rounding misses the bound, all keys stay as they are. */
static void test_nothing_is_lost_where_the_bound_allows_nothing(void **state)
{
	struct searched searched;

	(void)state;
	begin(&searched, wave, 0.002f);
	assert_near(searched.result.peak_px, 0, 0);
	assert_int_equal(kept(&searched, 0), KEYS);
	assert_int_equal(kept(&searched, 1), KEYS);
	end(&searched);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_clip_uses_the_bound),
		cmocka_unit_test(
			test_keys_on_a_line_are_left_out_whatever_the_bits),
		cmocka_unit_test(
			test_nothing_is_lost_where_the_bound_allows_nothing),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
