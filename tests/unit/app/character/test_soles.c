/* Which vertices of a foot are kept as its sole. */
#include "app/character/run/feet.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
	SIDES = 16,
	LEVELS = 6,
	VERTICES = 1 + SIDES * LEVELS + 2, /* whole triangles */
	BONES_MAX = 9
};

static const float turn_rad = 6.283185307f;

/* How high the figure is above its left foot, and where that is. */
static const float height_m = 1.5f;
static const float foot_at[3] = {-1, 0.05f, -2};

/*
 * Two legs below the hips, whose heights have a scale. Bones are added to the
 * left foot, each with the mesh, and 0.2 m before each other.
 */
static const char begin_json[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0]}],\"nodes\":["
	"{\"name\":\"hips\",\"translation\":[-1.2,0.65,-2],"
	"\"scale\":[1,%d,1],\"children\":[1,4,7]},"
	"{\"name\":\"ul\",\"translation\":[0.2,0,0],\"children\":[2]},"
	"{\"name\":\"ll\",\"translation\":[0,-0.3,0.4],\"children\":[3]},"
	"{\"name\":\"fl\",\"translation\":[0,-0.3,-0.4],\"children\":[%s]},"
	"{\"name\":\"ur\",\"translation\":[-0.2,0,0],\"children\":[5]},"
	"{\"name\":\"lr\",\"translation\":[0,-0.3,0.04],\"children\":[6]},"
	"{\"name\":\"fr\",\"translation\":[0,-0.3,-0.04]},"
	"{\"name\":\"head\",\"translation\":[0,0.9,0]}%s],"
	"\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
	"\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":%d,"
	"\"type\":\"VEC3\",\"min\":[-1,-1,-1],\"max\":[1,1,1]}],"
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":%d}],"
	"\"buffers\":[{\"uri\":\"feet.bin\",\"byteLength\":%d}]}";

static const char text[] =
	"[feet both]\nhips = hips\nleft = ul ll fl\nright = ur lr fr\n";

/*
 * Levels of vertices above each other, the wider the higher, around a vertex in
 * the middle, which comes first and is the lowest.
 */
struct cone {
	float at[VERTICES][3];
};

/* In heights of the figure, beside the limits of what is kept. */
static const float levels[LEVELS] = {
	0.0014f, 0.0016f, 0.0074f, 0.0076f, 0.0119f, 0.0121f};

static float radius_of(int level)
{
	return 0.05f + 0.01f * (float)level;
}

static struct cone make_cone(void)
{
	struct cone cone = {0};

	for (int v = 0; v < SIDES * LEVELS; v++) {
		int level = v / SIDES;
		float angle = turn_rad * (float)(v % SIDES) / SIDES;
		float *at = cone.at[v + 1];

		at[0] = radius_of(level) * cosf(angle);
		at[1] = levels[level] * height_m;
		at[2] = radius_of(level) * sinf(angle);
	}
	return cone;
}

/* Returns the left foot, and behind it the right one, of such a figure. */
static const struct character_foot *begin(struct acting *acting, int scale,
	int bones, int count, const void *vertices)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "feet.bin");
	int size = count * (int)sizeof(float[3]);
	char children[64] = "", nodes[1024] = "", json[4096];

	for (int i = 0; i < bones; i++) {
		size_t used = strlen(children), length = strlen(nodes);

		snprintf(children + used, sizeof(children) - used, "%s%d",
			i ? "," : "", 8 + i);
		snprintf(nodes + length, sizeof(nodes) - length,
			",{\"mesh\":0,\"translation\":[0,0,%g]}", 0.2 * i);
	}
	file_write(path.text, vertices, (size_t)size);
	snprintf(json, sizeof(json), begin_json, scale, children, nodes, count,
		size, size);
	path = path_join(&folder, "feet.gltf");
	file_write(path.text, json, strlen(json));
	acting_begin(acting, path.text);
	temp_dir_remove(&folder);
	acting_expect(acting, text);
	return acting->character->feet->foot;
}

/* How often the left foot has the vertex of a bone, with its place. */
static int count_kept(const struct acting *acting, int bone, const float at[3])
{
	const struct character_foot *foot = acting->character->feet->foot;
	int count = 0;

	for (int i = 0; i < foot->sole_count; i++) {
		float place[3], apart[3];

		if (foot->sole[i].node[0] == foot->leg.tip + 1 + bone &&
			memcmp(foot->sole[i].at[0], at, sizeof(place)) == 0) {
			character_sole_place(
				&foot->sole[i], acting->instance, place);
			for (int axis = 0; axis < 3; axis++) {
				apart[axis] =
					place[axis] - foot_at[axis] - at[axis];
			}
			apart[2] -= 0.2f * (float)bone;
			assert_all_near(apart, ((float[3]){0}), 3, 1e-5);
			assert_all_near(place, foot->place[i], 3, 0);
			count++;
		}
	}
	return count;
}

/*
 * Between two axes every fourth vertex is the outermost one, beginning with the
 * third, and along an axis or between two every second one. Up to 0.15% of the
 * figure's height the former are kept, up to 0.75% and up to 1.2% the latter.
 */
static void test_a_sole_has_the_outermost_vertices_of_three_heights(void **state)
{
	static const int nth[LEVELS] = {4, 0, 2, 0, 2, 0};
	static const int first[LEVELS] = {2};
	struct cone cone = make_cone();
	const struct character_foot *foot;
	struct acting acting;

	(void)state;
	foot = begin(&acting, 1, 1, VERTICES, &cone);
	assert_int_equal(foot->sole_count, 4 + 8 + 8);
	assert_int_equal(count_kept(&acting, 0, cone.at[0]), 0);
	for (int v = 0; v < SIDES * LEVELS; v++) {
		int level = v / SIDES;
		bool kept = nth[level] > 0 &&
			v % SIDES % nth[level] == first[level];

		assert_int_equal(count_kept(&acting, 0, cone.at[v + 1]), kept);
	}
	/* The ends of the foot, along z. */
	assert_near(foot->place[foot->toe][2], radius_of(4) - 2, 1e-5);
	assert_near(foot->place[foot->heel][2], -radius_of(4) - 2, 1e-5);
	assert_near(foot->planted_m, 0.002 * (double)height_m, 1e-6);
	acting_end(&acting);
}

/* A vertex that is the outermost one in several directions is kept once. */
static void test_a_flat_sole_has_the_corners_of_a_polygon(void **state)
{
	struct cone cone = make_cone();
	struct acting acting;

	(void)state;
	for (int v = 0; v < VERTICES; v++) {
		cone.at[v][1] = 0.01f;
	}
	for (int scale = 0; scale < 2; scale++) {
		int last = 1 + SIDES * (LEVELS - 1);

		/* Also in a figure that has no height. */
		assert_int_equal(
			begin(&acting, scale, 1, VERTICES, &cone)->sole_count,
			8);
		for (int side = 0; scale && side < SIDES; side++) {
			assert_int_equal(
				count_kept(&acting, 0, cone.at[last + side]),
				side % 2 == 0);
		}
		acting_end(&acting);
	}
}

/* The left side has three. */
static void test_of_vertices_as_far_out_the_first_is_kept(void **state)
{
	static const float box[][3] = {{-0.04f, 0, 0}, {-0.04f, 0, 0.05f},
		{0.04f, 0, 0.05f}, {-0.04f, 0, -0.05f}, {0.04f, 0, -0.05f},
		{-0.04f, 0, 0.01f}};
	const struct character_foot *foot;
	struct acting acting;

	(void)state;
	assert_int_equal(begin(&acting, 1, 1, 6, box)->sole_count, 5);
	assert_int_equal(count_kept(&acting, 0, box[0]), 1);
	assert_int_equal(count_kept(&acting, 0, box[5]), 0);
	foot = acting.character->feet->foot;
	assert_memory_equal(foot->sole[foot->toe].at, box[2], sizeof(box[2]));
	assert_memory_equal(foot->sole[foot->heel].at, box[4], sizeof(box[4]));
	acting_end(&acting);
}

static void test_a_foot_without_vertices_stands_on_its_last_bone(void **state)
{
	struct cone cone = make_cone();
	const struct character_foot *foot;
	struct acting acting;

	(void)state;
	foot = &begin(&acting, 1, 1, VERTICES, &cone)[1];
	assert_int_equal(foot->sole_count, 1);
	assert_int_equal(foot->sole[0].node[0], foot->leg.tip);
	assert_all_near(foot->sole[0].at[0], ((float[3]){0, 0, 0}), 3, 0);
	acting_end(&acting);
}

/*
 * Squares at one height: each bone has its own corners, and the lines around
 * the foot have the outermost ones of all.
 */
static void test_a_sole_has_the_flat_part_of_each_bone(void **state)
{
	static const float square[][3] = {{0.04f, 0, 0.05f}, {0.04f, 0, -0.05f},
		{-0.04f, 0, 0.05f}, {-0.04f, 0, -0.05f}, {0, 0, 0}, {0, 0, 0}};

	(void)state;
	for (int bones = 1; bones <= BONES_MAX; bones++) {
		/* Four points a bone, as long as there is room for them. */
		int count = bones < 8 ? 4 * bones : CHARACTER_SOLE_MAX;
		const struct character_foot *foot;
		struct acting acting;

		assert_int_equal(
			begin(&acting, 1, bones, 6, square)->sole_count, count);
		for (int i = 0; i < 4 * bones; i++) {
			assert_int_equal(
				count_kept(&acting, i / 4, square[i % 4]),
				i < count);
		}
		foot = &acting.character->feet->foot[0];
		assert_near(foot->place[foot->heel][2], -0.05 - 2, 1e-5);
		assert_near(foot->place[foot->toe][2],
			0.05 - 2 + 0.2 * (count / 4 - 1), 1e-5);
		acting_end(&acting);
	}
}

/* A skin on the first node; the foot's and the toes' joints are its last. */
static const char skin_json[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[{\"mesh\":0,\"skin\":0},"
	"{\"name\":\"hips\",\"translation\":[0,0.6,0],\"children\":[2,6]},"
	"{\"name\":\"ul\",\"translation\":[0.2,0,0],\"children\":[3]},"
	"{\"name\":\"ll\",\"translation\":[0,-0.3,0.04],\"children\":[4]},"
	"{\"name\":\"fl\",\"translation\":[0,-0.3,-0.04],\"children\":[5]},"
	"{\"name\":\"toes\"},"
	"{\"name\":\"ur\",\"translation\":[-0.2,0,0],\"children\":[7]},"
	"{\"name\":\"lr\",\"translation\":[0,-0.3,0.04],\"children\":[8]},"
	"{\"name\":\"fr\",\"translation\":[0,-0.3,-0.04]}],"
	"\"skins\":[{\"joints\":[3,4,5]}],"
	"\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,"
	"\"JOINTS_0\":1,\"WEIGHTS_0\":2}}]}],"
	"\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":9,"
	"\"type\":\"VEC3\",\"min\":[-1,-1,-1],\"max\":[1,1,1]},"
	"{\"bufferView\":1,\"componentType\":5121,\"count\":9,"
	"\"type\":\"VEC4\"},{\"bufferView\":2,\"componentType\":5126,"
	"\"count\":9,\"type\":\"VEC4\"}],"
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":108},"
	"{\"buffer\":0,\"byteOffset\":108,\"byteLength\":36},"
	"{\"buffer\":0,\"byteOffset\":144,\"byteLength\":144}],"
	"\"buffers\":[{\"uri\":\"skin.bin\",\"byteLength\":288}]}";

enum {
	SKINNED = 9
};

/* Both squares are of both joints; the last vertex is of the shin. */
static void test_a_vertex_belongs_to_the_bone_that_moves_it_most(void **state)
{
	struct {
		float at[SKINNED][3];
		uint8_t joint[SKINNED][4];
		float weight[SKINNED][4];
	} skin = {.weight = {{0}}};
	struct test_path folder = temp_dir_make();
	const struct character_foot *foot;
	struct acting acting;

	(void)state;
	for (int v = 0; v < SKINNED; v++) {
		bool toes = v / 4 == 1;

		skin.at[v][0] = v & 1 ? 0.04f : -0.04f;
		skin.at[v][2] = (v & 2 ? 0.05f : -0.05f) + (toes ? 0.2f : 0);
		skin.joint[v][0] = v == 8 ? 0 : 1;
		skin.joint[v][1] = 2;
		skin.weight[v][0] = toes ? 0.25f : 0.75f;
		skin.weight[v][1] = toes ? 0.75f : 0.25f;
	}
	skin.at[8][2] = -0.3f;
	file_write(path_join(&folder, "skin.bin").text, &skin, sizeof(skin));
	file_write(path_join(&folder, "skin.gltf").text, skin_json,
		strlen(skin_json));
	acting_begin(&acting, path_join(&folder, "skin.gltf").text);
	temp_dir_remove(&folder);
	acting_expect(&acting, text);
	foot = acting.character->feet->foot;
	assert_int_equal(foot->sole_count, 8);
	for (int i = 0; i < 8; i++) {
		int toes = i / 4;

		assert_int_equal(foot->sole[i].node[0], foot->leg.tip + toes);
		assert_int_equal(
			foot->sole[i].node[1], foot->leg.tip + 1 - toes);
	}
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_sole_has_the_outermost_vertices_of_three_heights),
		cmocka_unit_test(test_a_flat_sole_has_the_corners_of_a_polygon),
		cmocka_unit_test(test_of_vertices_as_far_out_the_first_is_kept),
		cmocka_unit_test(
			test_a_foot_without_vertices_stands_on_its_last_bone),
		cmocka_unit_test(test_a_sole_has_the_flat_part_of_each_bone),
		cmocka_unit_test(
			test_a_vertex_belongs_to_the_bone_that_moves_it_most),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
