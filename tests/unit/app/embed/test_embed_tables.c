#include "tests/unit/app/embed/embed_scene.h"

static void writes_the_vertices_of_each_part_in_order(void **state)
{
	struct embed_scene s;

	(void)state;
	embed_scene_begin(&s);
	embed_scene_print(&s, 0);
	assert_contains(s.text,
		"\nstatic const float t_position[13][3] = {\n\t{0, 1, 2},\n"
		"\t{10, 11, 12},\n\t{20, 21, 22},\n\t{0, 1, 2},\n"
		"\t{10, 11, 12},\n\t{20, 21, 22},\n\t{30, 31, 32},\n"
		"\t{10, 11, 12},\n\t{20, 21, 22},\n\t{30, 31, 32},\n"
		"\t{10, 11, 12},\n\t{20, 21, 22},\n\t{30, 31, 32},\n};\n");
	assert_contains(s.text,
		"\nstatic const float t_normal[13][3] = {\n\t{0, 0, 0},\n"
		"\t{0, 0, 0},\n\t{0, 0, 0},\n\t{-0, -1, -2},\n"
		"\t{-10, -11, -12},\n\t{-20, -21, -22},\n"
		"\t{-30, -31, -32},\n\t{0, 0, 0},\n\t{0, 0, 0},\n"
		"\t{0, 0, 0},\n\t{0, 0, 0},\n\t{0, 0, 0},\n\t{0, 0, 0},\n};\n");
	assert_contains(s.text,
		"\nstatic const uint8_t t_color[13][4] = {\n"
		"\t{255, 255, 255, 255}, {255, 255, 255, 255},"
		" {255, 255, 255, 255},\n"
		"\t{0, 1, 2, 3}, {40, 41, 42, 43}, {80, 81, 82, 83},"
		" {120, 121, 122, 123},\n"
		"\t{255, 255, 255, 255}, {255, 255, 255, 255},"
		" {255, 255, 255, 255},\n"
		"\t{255, 255, 255, 255}, {255, 255, 255, 255},"
		" {255, 255, 255, 255},\n};\n");
	assert_contains(s.text,
		"\nstatic const t_index_t t_index[15] = {\n\t0, 1, 2,\n"
		"\t0, 1, 2, 2, 1, 3,\n\t0, 1, 2,\n\t0, 1, 2,\n};\n");
	embed_scene_end(&s);
}

static void writes_influences_of_skinned_parts_alone(void **state)
{
	struct embed_scene s;

	(void)state;
	embed_scene_begin(&s);
	embed_scene_print(&s, 0);
	assert_contains(s.text,
		"\nstatic const uint8_t t_joint[12] = {\n"
		"\t0, 1, 0, 1, 0, 1, 0, 1,\n\t0, 1, 0, 1,\n};\n");
	assert_contains(s.text,
		"\nstatic const float t_weight[12] = {\n"
		"\t0.25, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25,\n"
		"\t0.25, 0.25, 0.25, 0.25,\n};\n");
	embed_scene_end(&s);
}

static void writes_displacements_target_by_target(void **state)
{
	struct embed_scene s;

	(void)state;
	embed_scene_begin(&s);
	embed_scene_print(&s, 0);
	assert_contains(s.text,
		"\nstatic const float t_target[84] = {\n"
		"\t0, 1, 2, 0, 0, 0,\n\t10, 11, 12, 0, 0, 0,\n"
		"\t20, 21, 22, 0, 0, 0,\n\t100, 101, 102, 0, 0, 0,\n"
		"\t110, 111, 112, 0, 0, 0,\n\t120, 121, 122, 0, 0, 0,\n"
		"\t200, 201, 202, 0, 0, 0,\n\t210, 211, 212, 0, 0, 0,\n"
		"\t220, 221, 222, 0, 0, 0,\n\t230, 231, 232, 0, 0, 0,\n"
		"\t300, 301, 302, 0, 0, 0,\n\t310, 311, 312, 0, 0, 0,\n"
		"\t320, 321, 322, 0, 0, 0,\n\t330, 331, 332, 0, 0, 0,\n};\n");
	embed_scene_end(&s);
}

static void writes_nodes_and_skins(void **state)
{
	struct embed_scene s;

	(void)state;
	embed_scene_begin(&s);
	embed_scene_print(&s, 0);
	assert_contains(s.text,
		"\nstatic const int16_t t_parent[4] = {\n\t-1, 0, 1, 1,\n};\n");
	assert_contains(s.text,
		"\nstatic const float t_rest[4][10] = {"
		"\n\t{\n\t0, 0.5, -0,\n\t0, 0, 0, 1,\n\t1, 2, 3,},"
		"\n\t{\n\t1, 1.5, -1,\n\t0, 0, 1, 1,\n\t1, 2, 4,},"
		"\n\t{\n\t2, 2.5, -2,\n\t0, 0, 2, 1,\n\t1, 2, 5,},"
		"\n\t{\n\t3, 3.5, -3,\n\t0, 0, 3, 1,\n\t1, 2, 6,},\n};\n");
	assert_contains(s.text,
		"\nstatic const float t_rest_weight[4] = {\n"
		"\t0, 0.25, 0.5, 0.75,\n};\n");
	assert_contains(s.text,
		"\nstatic const int16_t t_joint_node[3] = {"
		"\n\t3,\n\t1, 0,\n};\n");
	assert_contains(s.text,
		"\nstatic const float t_bind[3][12] = {\n"
		"\t{\n\t0, 1, 2,\n\t4, 5, 6,\n\t8, 9, 10,\n\t12, 13, 14,},\n"
		"\t{\n\t100, 101, 102,\n\t104, 105, 106,\n\t108, 109, 110,"
		"\n\t112, 113, 114,},\n"
		"\t{\n\t200, 201, 202,\n\t204, 205, 206,\n\t208, 209, 210,"
		"\n\t212, 213, 214,},\n};\n");
	embed_scene_end(&s);
}

static void writes_the_keys_of_each_channel(void **state)
{
	struct embed_scene s;

	(void)state;
	embed_scene_begin(&s);
	embed_scene_print(&s, 0);
	assert_contains(s.text,
		"\nstatic const float t_time[6] = {\n\t0, 1.5,\n\t0, 1.5,\n"
		"\t0,\n\t1.5,\n};\n");
	/* A packed rotation is written as floats, a cubic one with tangents. */
	assert_contains(s.text,
		"\nstatic const float t_value[23] = {\n\t0, 1, 2, 3, 4, 5,\n"
		"\t0, 0, 0, 1,\n\t0, 1, 0, 0,\n\t6, 7, 8, 9, 10, 11,\n"
		"\t12, 13, 14,\n};\n");
	/* Weights name their place, other paths their node. */
	assert_contains(s.text,
		"} t_clip[4] = {\n\t{0, 0, 3, 2, 3, 0, 0},\n"
		"\t{2, 6, 1, 2, 4, 1, 1},\n\t{4, 14, 2, 1, 2, 3, 2},\n"
		"\t{5, 20, 2, 1, 3, 2, 1},\n};\n");
	embed_scene_end(&s);
}

static void parts_name_where_their_data_begin(void **state)
{
	struct embed_scene s;

	(void)state;
	embed_scene_begin(&s);
	embed_scene_print(&s, 0);
	assert_contains(s.text,
		"} t_part[4] = {"
		"\n\t{{0.5, 0.25, 0.125, 0.100000001}, "
		"0, 3, 0, 3, 0, 0, -1, 0, 0, 2, 2},"
		"\n\t{{1, 1, 1, 1}, 3, 4, 3, 6, 0, 0, -1, 0, 36, 2, 2},"
		"\n\t{{1, 1, 1, 1}, 7, 3, 9, 3, 0, 4, 1, 1, 84, 0, 0},"
		"\n\t{{1, 1, 1, 1}, 10, 3, 12, 3, 12, 0, -1, 3, 84, 0, 0},"
		"\n};\n");
	embed_scene_end(&s);
}

/* A part without influences goes with its node, whatever skin that has. */
static void parts_without_influences_have_no_skin(void **state)
{
	struct embed_scene s;

	(void)state;
	embed_scene_begin(&s);
	s.skinned[0].influences = 0;
	embed_scene_print(&s, 0);
	assert_contains(s.text, " 7, 3, 9, 3, 0, 0, -1, 1, 84, 0, 0},\n");
	assert_contains(s.text, " t_joint[1] = {\n\t0,\n};\n");
	embed_scene_end(&s);
}

static void states_counts_and_bytes(void **state)
{
	struct embed_scene s;

	(void)state;
	embed_scene_begin(&s);
	embed_scene_print(&s, 0);
	assert_contains(s.text,
		"/*\n * a.glb, clip go as C: 13 vertices in 4 parts, 4 nodes, "
		"3 joints, 4 channels.\n");
	assert_contains(s.text, "0 to 1.5000 seconds\n");
	assert_contains(s.text,
		"\n#define T_NODES 4\n#define T_JOINTS 3\n#define T_PARTS 4\n"
		"#define T_CHANNELS 4\n#define T_VERTICES 13\n");
	assert_contains(s.text,
		"\n/* The state: 968 bytes. */\nstruct t_state {\n"
		"\tfloat local[4][10], world[4][12];\n\tfloat weight[4];\n"
		"\tfloat palette[3][12], normals[3][12];\n"
		"\tfloat position[13][3], normal[13][3];\n};\n");
	/* Nodes, weights, joints twice, vertices twice. */
	assert_int_equal(s.size.ram_bytes,
		4 * (10 + 12) * 4 + 4 * 4 + 3 * 24 * 4 + 13 * 6 * 4);
	/*
	 * Positions and normals, colours; joints, weights; targets; indices;
	 * parents, rest, weights; joints; times, values, channels; parts; the
	 * player's identity.
	 */
	assert_int_equal(s.size.rom_bytes,
		13 * 24 + 13 * 4 + 12 * 1 + 12 * 4 + 84 * 4 + 15 * 2 + 4 * 2 +
			4 * 40 + 4 * 4 + 3 * 2 + 3 * 48 + 6 * 4 + 23 * 4 +
			4 * 16 + 4 * 60 + 48);
	embed_scene_end(&s);
}

static void fills_tables_that_would_be_empty(void **state)
{
	struct embed_scene s;

	(void)state;
	embed_scene_begin(&s);
	s.mesh[0].target_count = 0;
	s.model.skin_count = 0;
	s.node[1].skin = -1;
	s.model.weight_count = 0;
	embed_scene_print(&s, -1);
	assert_contains(s.text,
		"a.glb as C: 13 vertices in 4 parts, 4 nodes, 0 joints");
	assert_contains(s.text, "0 to 0.0000 seconds\n");
	assert_contains(s.text, " t_joint[1] = {\n\t0,\n};\n");
	assert_contains(s.text, " t_weight[1] = {\n\t0,\n};\n");
	assert_contains(s.text, " t_target[6] = {\n\t0,\n};\n");
	assert_contains(s.text, " t_time[1] = {\n\t0,\n};\n");
	assert_contains(s.text, " t_value[1] = {\n\t0,\n};\n");
	assert_contains(s.text, " t_rest_weight[1] = {\n\t0,\n};\n");
	assert_contains(s.text, "} t_clip[1] = {\n\t{0},\n};\n");
	assert_null(strstr(s.text, "int16_t t_joint_node["));
	assert_null(strstr(s.text, "float t_bind["));
	assert_contains(s.text, "\tfloat weight[1];\n");
	assert_contains(s.text, "\tfloat palette[1][12], normals[1][12];\n");
	assert_int_equal(s.size.ram_bytes,
		4 * (10 + 12) * 4 + 1 * 4 + 1 * 24 * 4 + 13 * 6 * 4);
	assert_int_equal(s.size.rom_bytes,
		13 * 24 + 13 * 4 + 1 + 4 + 24 + 15 * 2 + 4 * 2 + 4 * 40 + 4 +
			4 + 4 + 16 + 4 * 60 + 48);
	embed_scene_end(&s);
}

/* Three of four parts have no normals; what is unlit does not need any. */
static void counts_the_parts_that_light_leaves_dark(void **state)
{
	struct embed_scene s;

	(void)state;
	embed_scene_begin(&s);
	embed_scene_print(&s, 0);
	assert_int_equal(s.size.dark_parts, 3);
	s.material[0].unlit = true;
	embed_scene_print(&s, 0);
	assert_int_equal(s.size.dark_parts, 1);
	embed_scene_end(&s);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(writes_the_vertices_of_each_part_in_order),
		cmocka_unit_test(writes_influences_of_skinned_parts_alone),
		cmocka_unit_test(writes_displacements_target_by_target),
		cmocka_unit_test(writes_nodes_and_skins),
		cmocka_unit_test(writes_the_keys_of_each_channel),
		cmocka_unit_test(parts_name_where_their_data_begin),
		cmocka_unit_test(parts_without_influences_have_no_skin),
		cmocka_unit_test(states_counts_and_bytes),
		cmocka_unit_test(fills_tables_that_would_be_empty),
		cmocka_unit_test(counts_the_parts_that_light_leaves_dark),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
