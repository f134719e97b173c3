/* Parts that are attached to nodes which mirror, or which hang below such. */
#include "app/anim/math/matrix.h"
#include "app/anim/math/vec.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double rate_hz = 50.0;

/*
 * Hand and Box turn; the two nodes above them may mirror along one axis. One of
 * these is the model's first node.
 */
static const char hand_first[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0,2]}],\"nodes\":["
	"{\"name\":\"Arm\",\"children\":[1],\"scale\":%s,"
	"\"rotation\":[0.1826,0.3651,0.5477,0.7303]},"
	"{\"name\":\"Hand\",\"translation\":[0.1,0.5,0.2]},"
	"{\"name\":\"Shelf\",\"children\":[3],\"scale\":%s,"
	"\"rotation\":[0.5,-0.5,0.1,0.7]},"
	"{\"name\":\"Box\",\"translation\":[0.4,0.3,-0.6],"
	"\"rotation\":[0,0.6,0,0.8]}]}";

static const char box_first[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0,2]}],\"nodes\":["
	"{\"name\":\"Shelf\",\"children\":[1],\"scale\":%s,"
	"\"rotation\":[0.5,-0.5,0.1,0.7]},"
	"{\"name\":\"Box\",\"translation\":[0.4,0.3,-0.6],"
	"\"rotation\":[0,0.6,0,0.8]},"
	"{\"name\":\"Arm\",\"children\":[3],\"scale\":%s,"
	"\"rotation\":[0.1826,0.3651,0.5477,0.7303]},"
	"{\"name\":\"Hand\",\"translation\":[0.1,0.5,0.2]}]}";

static const char text[] =
	"[part Hand]\nheading = 0 -90 90 45\npitch = 0 -45 45 45\n[part Box]\n"
	"[buttons]\nUP = attach Box Hand\n"
	"DOWN = move Hand heading 1, move Hand pitch 1\n";

static int node_of(const struct acting *acting, const char *name)
{
	int node = model_find_node(acting->model, name);

	assert_true(node >= 0);
	return node;
}

/* The box's corner, in the axes of the hand. */
static void find_corner(struct acting *acting, const float corner[3],
	float world[3], float in_hand[3])
{
	mat4 *hand = &acting->instance->world[node_of(acting, "Hand")];
	float offset[3];

	matrix_apply(
		acting->instance->world[node_of(acting, "Box")], corner, world);
	for (int i = 0; i < 3; i++) {
		offset[i] = world[i] - (*hand)[3][i];
	}
	for (int axis = 0; axis < 3; axis++) {
		in_hand[axis] = 0;
		for (int i = 0; i < 3; i++) {
			in_hand[axis] += (*hand)[axis][i] * offset[i];
		}
	}
}

/* The box neither jumps when it is attached nor moves in the hand that turns. */
static void check_file(const char *json)
{
	static const float corner[4][3] = {
		{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
	float before[4][3], at[4][3], held[4][3], now[3], later[3];
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "held.gltf");
	struct acting acting;

	file_write(path.text, json, strlen(json));
	acting_begin(&acting, path.text);
	acting_expect(&acting, text);
	acting_run_to(&acting, 0.1, rate_hz);
	for (int i = 0; i < 4; i++) {
		find_corner(&acting, corner[i], before[i], held[i]);
	}
	acting_tap(&acting, BUTTON_UP, 1.0 / rate_hz, rate_hz);
	acting_run_to(&acting, 0.5, rate_hz);
	for (int i = 0; i < 4; i++) {
		find_corner(&acting, corner[i], at[i], later);
		for (int axis = 0; axis < 3; axis++) {
			assert_near(at[i][axis], before[i][axis], 1e-4);
		}
	}
	acting_tap(&acting, BUTTON_DOWN, 0.8, rate_hz);
	for (int i = 0; i < 4; i++) {
		find_corner(&acting, corner[i], now, later);
		for (int axis = 0; axis < 3; axis++) {
			assert_near(later[axis], held[i][axis], 1e-4);
		}
	}
	vec_subtract(now, at[3], later);
	assert_true(vec_length(later) > 0.1f);
	acting_end(&acting);
	temp_dir_remove(&folder);
}

static void check(const char *arm, const char *shelf)
{
	char json[2048];

	snprintf(json, sizeof(json), hand_first, arm, shelf);
	check_file(json);
	snprintf(json, sizeof(json), box_first, shelf, arm);
	check_file(json);
}

static void test_a_part_stays_in_a_hand_that_turns(void **state)
{
	(void)state;
	check("[1,1,1]", "[1,1,1]");
}

static void test_a_part_stays_in_a_mirrored_hand(void **state)
{
	(void)state;
	check("[-1,1,1]", "[1,1,1]");
	check("[1,-1,1]", "[1,1,1]");
	check("[1,1,-1]", "[1,1,1]");
}

static void test_a_part_that_its_parent_mirrors_stays_in_a_hand(void **state)
{
	(void)state;
	check("[1,1,1]", "[-1,1,1]");
	check("[-1,1,1]", "[1,-1,1]");
}

/* What hangs on a node has the node's scale. */
static void test_a_part_stays_in_a_hand_of_any_size(void **state)
{
	(void)state;
	check("[2,2,2]", "[1,1,1]");
	check("[1,1,1]", "[0.5,0.5,0.5]");
	check("[2,2,2]", "[0.25,0.25,0.25]");
	check("[-0.5,0.5,0.5]", "[3,3,3]");
}

/*
 * A model whose z axis is up below its root, with a box 1.2 m above the ground
 * whose lowest vertex, the first one, is 0.2 m below its pivot. A table has the
 * same triangle, whose height at the origin is 0.45 m.
 */
static const char shelf[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0]}],\"nodes\":["
	"{\"name\":\"Root\",\"children\":[1,2,3],"
	"\"rotation\":[-0.70710678,0,0,0.70710678]},"
	"{\"name\":\"Hand\",\"translation\":[0.3,0,1.5]},"
	"{\"name\":\"Table\",\"mesh\":0,\"translation\":[0,0,0.5]},"
	"{\"name\":\"Box\",\"mesh\":0,\"translation\":[0,0,1.2]}],"
	"\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
	"\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,"
	"\"type\":\"VEC3\",\"min\":[-0.1,-0.1,-0.2],\"max\":[0.1,0.1,0.3]}],"
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
	"\"buffers\":[{\"byteLength\":36,\"uri\":\"data:application/"
	"octet-stream;base64,"
	"zczMPQAAAADNzEy+zczMvc3MzD3NzMy9zczMvc3MzL2amZk+\"}]}";

/* It is upright as in the model, and not at its height there. */
static void test_a_part_from_a_shelf_lies_on_the_ground(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "shelf.gltf");
	struct acting acting;
	const mat4 *box;
	float bearing;

	(void)state;
	file_write(path.text, shelf, strlen(shelf));
	acting_begin(&acting, path.text);
	acting_expect(&acting,
		"[part Hand]\nbank = 0 -90 90 45\npitch = 0 -45 45 30\n"
		"[part Box]\n[buttons]\nUP = attach Box Hand\n"
		"DOWN = move Hand bank 1, move Hand pitch 1\nLEFT = drop Box\n");
	box = (const mat4 *)&acting.instance->world[node_of(&acting, "Box")];
	acting_run_to(&acting, 0.1, rate_hz);
	acting_tap(&acting, BUTTON_UP, 1.0 / rate_hz, rate_hz);
	acting_tap(&acting, BUTTON_DOWN, 1.0, rate_hz);
	assert_true((*box)[2][1] < 0.9f);
	bearing = atan2f((*box)[0][2], (*box)[0][0]);
	assert_true(fabsf(bearing) > 0.5f);
	acting_tap(&acting, BUTTON_LEFT, 1.0 / rate_hz, rate_hz);
	acting_run_to(&acting, acting.now_s + 2.0, rate_hz);
	assert_near((*box)[2][1], 1.0, 1e-5);
	assert_near(vec_length((*box)[0]), 1.0, 1e-5);
	assert_near((*box)[3][1], 0.2, 1e-5);
	assert_near(atan2f((*box)[0][2], (*box)[0][0]), bearing, 0.15);
	acting_tap(&acting, BUTTON_LEFT, 1.0 / rate_hz, rate_hz);
	assert_near((*box)[3][1], 0.2, 1e-5);
	acting_end(&acting);
	temp_dir_remove(&folder);
}

/* Writes the model with the box in another place. */
static void write_shelf(const struct test_path *path, const char *place)
{
	static const char usual[] = "0,0,1.2]}";
	const char *rest = strstr(shelf, usual);
	char file[sizeof(shelf) + 16];

	snprintf(file, sizeof(file), "%.*s%s]}%s", (int)(rest - shelf), shelf,
		place, rest + sizeof(usual) - 1);
	file_write(path->text, file, strlen(file));
}

/* The box of a file, dropped onto the table, lies at that height after 2 s. */
static void expect_drop(const char *path, double lies_at)
{
	struct acting acting;

	acting_begin(&acting, path);
	acting_expect(&acting, "[part Box]\n[buttons]\nUP = drop Box Table\n");
	acting_run_to(&acting, 0.1, rate_hz);
	acting_tap(&acting, BUTTON_UP, 2.0, rate_hz);
	assert_near(acting.instance->world[node_of(&acting, "Box")][3][1],
		lies_at, 1e-5);
	acting_end(&acting);
}

/* Only what it has below its pivot holds it. */
static void test_a_part_falls_onto_a_table_or_beside_it(void **state)
{
	static const struct {
		const char *place;
		double lies_at;
	} rows[] = {{"0,0,1.2", 0.65}, {"0,0,0.46", 0.65}, {"0,0,0.44", 0.2},
		{"0.11,0,1.2", 0.2}, {"-0.11,0,1.2", 0.2}, {"0,0.06,1.2", 0.2},
		{"0,-0.06,1.2", 0.2}};
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "shelf.gltf");

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		write_shelf(&path, rows[i].place);
		expect_drop(path.text, rows[i].lies_at);
	}
	temp_dir_remove(&folder);
}

/*
 * The same box and table, without a root, and a skin that may move the table's
 * triangle: then its heights at rest do not say where it is.
 */
static const char skinned_table[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":["
	"{\"name\":\"Table\",\"mesh\":0%s,\"translation\":[0,0.5,0],"
	"\"rotation\":[-0.70710678,0,0,0.70710678]},"
	"{\"name\":\"Box\",\"mesh\":0,\"translation\":[0,1.2,0],"
	"\"rotation\":[-0.70710678,0,0,0.70710678]}],"
	"\"skins\":[{\"joints\":[1]}],"
	"\"meshes\":[{\"primitives\":[{\"attributes\":"
	"{\"POSITION\":0,\"JOINTS_0\":1,\"WEIGHTS_0\":2}}]}],"
	"\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,"
	"\"type\":\"VEC3\",\"min\":[-0.1,-0.1,-0.2],\"max\":[0.1,0.1,0.3]},"
	"{\"bufferView\":1,\"componentType\":5121,\"count\":3,"
	"\"type\":\"VEC4\"},"
	"{\"bufferView\":2,\"componentType\":5121,\"normalized\":true,"
	"\"count\":3,\"type\":\"VEC4\"}],"
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":36},"
	"{\"buffer\":0,\"byteOffset\":36,\"byteLength\":12},"
	"{\"buffer\":0,\"byteOffset\":48,\"byteLength\":12}],"
	"\"buffers\":[{\"byteLength\":60,\"uri\":\"data:application/"
	"octet-stream;base64,"
	"zczMPQAAAADNzEy+zczMvc3MzD3NzMy9zczMvc3MzL2amZk+"
	"AAAAAAAAAAAAAAAA/wAAAP8AAAD/AAAA\"}]}";

static void test_no_part_falls_onto_a_table_that_a_skin_moves(void **state)
{
	static const struct {
		const char *skin;
		double lies_at;
	} rows[] = {{"", 0.65}, {",\"skin\":0", 0.2}};
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "table.gltf");

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		char file[sizeof(skinned_table) + 16];

		snprintf(file, sizeof(file), skinned_table, rows[i].skin);
		file_write(path.text, file, strlen(file));
		expect_drop(path.text, rows[i].lies_at);
	}
	temp_dir_remove(&folder);
}

static const char first_hand[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":["
	"{\"name\":\"Hand\",\"translation\":[0,1,0]},"
	"{\"name\":\"Box\",\"translation\":[0.5,1,0.25]}]}";

/* A quarter turn about y takes x to -z, and z to x. */
static void test_the_first_node_holds_a_part(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "hand.gltf");
	struct acting acting;
	float at[3];

	(void)state;
	file_write(path.text, first_hand, strlen(first_hand));
	acting_begin(&acting, path.text);
	assert_int_equal(node_of(&acting, "Hand"), 0);
	acting_expect(&acting,
		"[part Hand]\nheading = 0 -90 90 90\n[part Box]\n"
		"[buttons]\nUP = attach Box Hand\n"
		"LEFT hold = move Hand heading 1\n");
	acting_tap(&acting, BUTTON_UP, 0.1, rate_hz);
	acting_tap(&acting, BUTTON_LEFT, 2.0, rate_hz);
	acting_place(&acting, "Box", at);
	assert_all_near(at, ((float[]){0.25f, 1, -0.5f}), 3, 1e-5);
	acting_end(&acting);
	temp_dir_remove(&folder);
}

/* What the first node holds near the ground does not lie there yet. */
static void test_the_first_node_lets_a_part_go(void **state)
{
	static const char low_hand[] =
		"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
		"\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":["
		"{\"name\":\"Hand\",\"translation\":[0,1,0]},"
		"{\"name\":\"Box\",\"translation\":[0.5,0,0]}]}";
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "hand.gltf");
	struct acting acting;

	(void)state;
	file_write(path.text, low_hand, strlen(low_hand));
	acting_begin(&acting, path.text);
	acting_expect(&acting,
		"[part Box]\n[buttons]\nUP = attach Box Hand\n"
		"DOWN = drop Box\n");
	acting_tap(&acting, BUTTON_UP, 0.1, rate_hz);
	assert_int_equal(acting.character->part[0].holder, 0);
	acting_tap(&acting, BUTTON_DOWN, 0.1, rate_hz);
	assert_int_equal(acting.character->part[0].holder, CHARACTER_GROUND);
	acting_end(&acting);
	temp_dir_remove(&folder);
}

/* That is as far as the action says, 0.5 m here, and no farther. */
static void test_a_hand_reaches_so_far(void **state)
{
	static const struct {
		const char *place, *reach;
		bool held;
	} rows[] = {{"0.5,1,0", "", true}, {"0.5,1,0", " 0.5", true},
		{"0.5,1,0", " 0.49", false}, {"0,0.5,0", " 0.5", true},
		{"0,1,-0.51", " 0.5", false}, {"0,1,0", " 0.5", true}};
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "hand.gltf");

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		char file[512], character[256];
		struct acting acting;

		snprintf(file, sizeof(file),
			"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
			"\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":["
			"{\"name\":\"Hand\",\"translation\":[0,1,0]},"
			"{\"name\":\"Box\",\"translation\":[%s]}]}",
			rows[i].place);
		file_write(path.text, file, strlen(file));
		acting_begin(&acting, path.text);
		snprintf(character, sizeof(character),
			"[part Box]\n[buttons]\nUP = attach Box Hand%s\n",
			rows[i].reach);
		acting_expect(&acting, character);
		acting_tap(&acting, BUTTON_UP, 0.1, rate_hz);
		assert_int_equal(acting.character->part[0].holder,
			rows[i].held ? 0 : -1);
		acting_end(&acting);
	}
	temp_dir_remove(&folder);
}

/* A pivot that stands a little too high or low for the ground keeps its height. */
static void test_a_part_near_the_ground_comes_back_to_its_height(void **state)
{
	static const struct {
		const char *place;
		double lies_at;
	} rows[] = {{"0,0,0.181", 0.181}, {"0,0,0.219", 0.219},
		{"0,0,0.178", 0.2}, {"0,0,0.222", 0.2}};
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "shelf.gltf");

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct acting acting;
		const mat4 *box;

		write_shelf(&path, rows[i].place);
		acting_begin(&acting, path.text);
		acting_expect(&acting,
			"[part Hand]\nbank = 0 -90 90 45\n[part Box]\n"
			"[buttons]\nUP = attach Box Hand\n"
			"DOWN = move Hand bank 1\nLEFT = drop Box\n");
		box = (const mat4 *)&acting.instance
			      ->world[node_of(&acting, "Box")];
		acting_run_to(&acting, 0.1, rate_hz);
		acting_tap(&acting, BUTTON_UP, 1.0, rate_hz);
		acting_tap(&acting, BUTTON_DOWN, 1.0, rate_hz);
		acting_tap(&acting, BUTTON_LEFT, 1.0 / rate_hz, rate_hz);
		acting_run_to(&acting, acting.now_s + 2.0, rate_hz);
		assert_near((*box)[3][1], rows[i].lies_at, 1e-5);
		acting_end(&acting);
	}
	temp_dir_remove(&folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_part_stays_in_a_hand_that_turns),
		cmocka_unit_test(test_a_part_stays_in_a_mirrored_hand),
		cmocka_unit_test(
			test_a_part_that_its_parent_mirrors_stays_in_a_hand),
		cmocka_unit_test(test_a_part_stays_in_a_hand_of_any_size),
		cmocka_unit_test(test_a_part_from_a_shelf_lies_on_the_ground),
		cmocka_unit_test(test_a_part_falls_onto_a_table_or_beside_it),
		cmocka_unit_test(
			test_no_part_falls_onto_a_table_that_a_skin_moves),
		cmocka_unit_test(test_the_first_node_holds_a_part),
		cmocka_unit_test(test_the_first_node_lets_a_part_go),
		cmocka_unit_test(test_a_hand_reaches_so_far),
		cmocka_unit_test(
			test_a_part_near_the_ground_comes_back_to_its_height),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
