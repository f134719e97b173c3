/* How far a clip carries the root, and where each foot is ahead. */
#include "app/character/character_data.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

/* The root and its left foot move, which hang below the first node or are it. */
static const char model[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[%s]}],\"nodes\":["
	"{\"name\":\"Root\",\"children\":[1,2,3]},"
	"{\"name\":\"L\"},{\"name\":\"R\"},"
	"{\"name\":\"Top\",\"translation\":[0,1,0]},"
	"{\"name\":\"Turned\",%s"
	"\"rotation\":[0,0.70710678,0,0.70710678]}],"
	"\"animations\":[{\"name\":\"go\",\"channels\":["
	"{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"translation\"}},"
	"{\"sampler\":1,\"target\":{\"node\":1,\"path\":\"translation\"}}],"
	"\"samplers\":[{\"input\":0,\"output\":1},{\"input\":2,\"output\":3}]}],"
	"\"accessors\":["
	"{\"bufferView\":0,\"componentType\":5126,\"count\":2,"
	"\"type\":\"SCALAR\",\"min\":[0],\"max\":[2]},"
	"{\"bufferView\":1,\"componentType\":5126,\"count\":2,"
	"\"type\":\"VEC3\"},"
	"{\"bufferView\":2,\"componentType\":5126,\"count\":4,"
	"\"type\":\"SCALAR\",\"min\":[0],\"max\":[2]},"
	"{\"bufferView\":3,\"componentType\":5126,\"count\":4,"
	"\"type\":\"VEC3\"}],"
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":8},"
	"{\"buffer\":0,\"byteOffset\":8,\"byteLength\":24},"
	"{\"buffer\":0,\"byteOffset\":32,\"byteLength\":16},"
	"{\"buffer\":0,\"byteOffset\":48,\"byteLength\":48}],"
	"\"buffers\":[{\"byteLength\":96,\"uri\":\"m.bin\"}]}";

struct keys {
	float root_s[2], root[2][3], foot_s[4], foot[4][3];
};

static void begin(struct acting *acting, bool turned, const struct keys *keys)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "m.bin");
	char text[sizeof(model) + 32];

	file_write(path.text, keys, sizeof(*keys));
	path = path_join(&folder, "m.gltf");
	snprintf(text, sizeof(text), model, turned ? "4" : "0,4",
		turned ? "\"children\":[0]," : "");
	file_write(path.text, text, strlen(text));
	acting_begin(acting, path.text);
	temp_dir_remove(&folder);
	acting_expect(acting,
		"[motion]\nroot = Root\nfeet = L R\n[state a]\nclip = go\n");
}

/* A quarter turn about y takes x to -z, and z to x. */
static void test_a_clip_carries_the_root_over_the_ground(void **state)
{
	static const struct keys keys = {.root_s = {0, 2},
		.root = {{0.1f, 0, 0.1f}, {0.4f, 0.5f, 1.1f}},
		.foot_s = {0, 0.5f, 1, 2}};
	static const float carried[2][2] = {{0.3f, 1}, {1, -0.3f}};

	(void)state;
	for (int turned = 0; turned < 2; turned++) {
		struct acting acting;
		const struct character_clip *clip;

		begin(&acting, turned, &keys);
		clip = &acting.character->clip[0];
		assert_all_near(clip->carried_m, carried[turned], 2, 1e-5);
		assert_all_near(clip->travel, ((float[]){0.3f, 0, 1}), 3, 1e-5);
		for (int axis = 0; axis < 2; axis++) {
			assert_near(clip->ground_m_per_s[axis],
				carried[turned][axis] / 2, 1e-5);
		}
		assert_int_equal(clip->mark_count, 0);
		acting_end(&acting);
	}
}

/* One foot goes along an axis by so much, at first or later. */
static void expect_marks(int axis, float range_m, const float times_s[2],
	bool ahead_first, const double marks[2])
{
	struct keys keys = {
		.root_s = {0, 2}, .foot_s = {0, times_s[0], times_s[1], 2}};
	const struct character_clip *clip;
	struct acting acting;

	keys.foot[1][axis] = (ahead_first ? 0.5f : -0.5f) * range_m;
	keys.foot[2][axis] = -keys.foot[1][axis];
	begin(&acting, false, &keys);
	clip = &acting.character->clip[0];
	assert_int_equal(clip->mark_count, marks ? 2 : 0);
	for (int i = 0; marks && i < 2; i++) {
		assert_near(clip->mark[i], marks[i], 1e-5);
	}
	acting_end(&acting);
}

/* A range below a twentieth of the height, of 1 m, is no step. */
static void test_marks_are_where_a_foot_is_ahead_most(void **state)
{
	static const float middle[2] = {0.5f, 1.5f};
	static const float early[2] = {2.0f / CHARACTER_SAMPLES, 1.5f};
	static const float late[2] = {0.5f, 2 - 2.0f / CHARACTER_SAMPLES};

	(void)state;
	for (int axis = 0; axis < 3; axis += 2) {
		expect_marks(axis, 0.4f, middle, true, (double[]){0.5, 1.5});
		expect_marks(axis, 0.4f, middle, false, (double[]){1.5, 2.5});
		expect_marks(axis, 0.4f, early, true,
			(double[]){(double)early[0], 1.5});
		expect_marks(axis, 0.4f, early, false,
			(double[]){1.5, 2 + (double)early[0]});
		expect_marks(axis, 0.4f, late, false,
			(double[]){(double)late[1], 2.5});
		expect_marks(axis, 0.052f, middle, true, (double[]){0.5, 1.5});
		expect_marks(axis, 0.048f, middle, true, NULL);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_clip_carries_the_root_over_the_ground),
		cmocka_unit_test(test_marks_are_where_a_foot_is_ahead_most),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
