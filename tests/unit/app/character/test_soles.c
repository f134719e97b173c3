/* Which vertices of a foot are kept as its sole. */
#include "app/character/run/feet.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	SIDES = 16,
	VERTICES = 18, /* whole triangles */
	KEPT = 8
};

static const float radius_m = 0.1f, turn_rad = 6.283185307f;

/* Two legs; the left foot has the vertices of feet.bin around its tip. */
static const char json[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0]}],\"nodes\":["
	"{\"name\":\"hips\",\"translation\":[0,0.6,0],\"children\":[1,4]},"
	"{\"name\":\"ul\",\"translation\":[0.2,0,0],\"children\":[2]},"
	"{\"name\":\"ll\",\"translation\":[0,-0.3,0.04],\"children\":[3]},"
	"{\"name\":\"fl\",\"translation\":[0,-0.3,-0.04],\"mesh\":0},"
	"{\"name\":\"ur\",\"translation\":[-0.2,0,0],\"children\":[5]},"
	"{\"name\":\"lr\",\"translation\":[0,-0.3,0.04],\"children\":[6]},"
	"{\"name\":\"fr\",\"translation\":[0,-0.3,-0.04]}],"
	"\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
	"\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":18,"
	"\"type\":\"VEC3\",\"min\":[-0.1,0,-0.1],\"max\":[0.1,0,0.1]}],"
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":216}],"
	"\"buffers\":[{\"uri\":\"feet.bin\",\"byteLength\":216}]}";

static const char text[] =
	"[feet both]\nhips = hips\nleft = ul ll fl\nright = ur lr fr\n";

static float angle_of(int side)
{
	return turn_rad * (float)side / SIDES;
}

static void write_model(const struct test_path *folder)
{
	float at[VERTICES][3] = {{0}};

	for (int v = 0; v < VERTICES; v++) {
		at[v][0] = radius_m * cosf(angle_of(v % SIDES));
		at[v][2] = radius_m * sinf(angle_of(v % SIDES));
	}
	file_write(path_join(folder, "feet.bin").text, at, sizeof(at));
	file_write(path_join(folder, "feet.gltf").text, json, strlen(json));
}

/* Returns true if the foot has a point at this corner of the polygon. */
static bool is_kept(const struct character_foot *foot, int side)
{
	for (int i = 0; i < foot->sole_count; i++) {
		float x = foot->place[i][0] - 0.2f, z = foot->place[i][2];

		if (hypotf(x - radius_m * cosf(angle_of(side)),
			    z - radius_m * sinf(angle_of(side))) < 1e-4f) {
			return true;
		}
	}
	return false;
}

/* Every second corner is the outermost one in one of the eight directions. */
static void test_a_sole_has_the_outermost_vertices_in_eight_directions(
	void **state)
{
	struct test_path folder = temp_dir_make();
	const struct character_foot *foot;
	struct acting acting;

	(void)state;
	write_model(&folder);
	acting_begin(&acting, path_join(&folder, "feet.gltf").text);
	acting_expect(&acting, text);
	foot = acting.character->feet->foot;
	assert_int_equal(foot[0].sole_count, KEPT);
	for (int side = 0; side < SIDES; side++) {
		assert_int_equal(is_kept(&foot[0], side), side % 2 == 0);
	}
	/* The ends of the foot, along z. */
	assert_near(foot[0].place[foot[0].toe][2], radius_m, 1e-4);
	assert_near(foot[0].place[foot[0].heel][2], -radius_m, 1e-4);
	/* A foot without vertices stands on its last bone. */
	assert_int_equal(foot[1].sole_count, 1);
	acting_end(&acting);
	temp_dir_remove(&folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_sole_has_the_outermost_vertices_in_eight_directions),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
