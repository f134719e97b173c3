/* What limber doctor says about meshes that a game engine would not show. */
#include "app/model/examine/examine.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

enum {
	MOST = 4
};

static char heard[800];

static void keep(void *context, const char *finding)
{
	(void)context;
	snprintf(heard + strlen(heard), sizeof(heard) - strlen(heard), "%s\n",
		finding);
}

/* Examines nodes with meshes of these names, of which the last is hidden. */
static void expect(const char *const *names, int count, const char *wanted)
{
	const struct examiner examiner = {keep, NULL};
	struct log log = log_to_stderr(LOG_WARNING);
	struct model_node node[MOST + 1];
	struct model model = {.node = node, .node_count = count + 1};

	for (int i = 0; i <= count; i++) {
		node[i] = (struct model_node){
			.name = i < count ? names[i] : "Tree_LOD0",
			.parent = -1,
			.in_scene = i < count,
			.mesh = 0,
			.skin = -1,
		};
	}
	heard[0] = '\0';
	assert_int_equal(examine_spare(&model, &examiner, &log), 0);
	assert_string_equal(heard, wanted);
}

static void test_levels_beside_a_finer_one_are_counted(void **state)
{
	static const char wanted[] =
		"levels of detail as nodes of their own (2), such as Tree_LOD1: "
		"limber draws them and the finest level at once; export that "
		"one alone, as limber makes its own levels\n";

	(void)state;
	expect((const char *const[]){"Tree_LOD0", "Tree_LOD1", "Tree_LOD2"}, 3,
		wanted);
	expect((const char *const[]){"Tree_LOD2", "Tree_LOD1", "Tree_LOD3"}, 3,
		"levels of detail as nodes of their own (2), such as Tree_LOD2: "
		"limber draws them and the finest level at once; export that "
		"one alone, as limber makes its own levels\n");
	expect((const char *const[]){"tree lod0", "TreeLOD1"}, 2, "");
	expect((const char *const[]){"lod0", "lod01"}, 2,
		"levels of detail as nodes of their own (1), such as lod01: "
		"limber draws them and the finest level at once; export that "
		"one alone, as limber makes its own levels\n");
}

static void test_other_names_are_no_levels(void **state)
{
	(void)state;
	expect((const char *const[]){"Tree_LOD1", "Bush_LOD0"}, 2, "");
	expect((const char *const[]){"melod0", "melod1"}, 2, "");
	expect((const char *const[]){"Wheel0", "Wheel1", "LOD", "1"}, 4, "");
}

/* A level stands alone, behind what is no letter, or in capitals. */
static void test_a_level_is_told_by_its_spelling(void **state)
{
	static const struct {
		const char *name[2];
		bool coarse; /* the second one */
	} cases[] = {
		{{"a_lod0", "a_lod1"}, true},
		{{"1 Lod0", "1 Lod1"}, true},
		{{"LoD0", "LoD1"}, true},
		{{"TreeLOD0", "TreeLOD1"}, true},
		{{"TreeLOD9", "TreeLOD10"}, true},
		{{"TreeLOD1", "TreeLOD1"}, false},
		{{"TreeLOd0", "TreeLOd1"}, false},
		{{"TreeLoD0", "TreeLoD1"}, false},
		{{"1alod0", "1alod1"}, false},
		{{"od0", "od1"}, false},
		{{"d0", "d1"}, false},
		{{"0", "1"}, false},
		{{"", ""}, false},
		{{"a_lod", "a_lod"}, false},
		{{"a_lod0x", "a_lod1x"}, false},
		{{"a_lod0", "b_lod1"}, false},
		{{"a_lod0", "aa_lod1"}, false},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		char wanted[300];

		snprintf(wanted, sizeof(wanted),
			"levels of detail as nodes of their own (1), such as "
			"%s: limber draws them and the finest level at once; "
			"export that one alone, as limber makes its own "
			"levels\n",
			cases[i].name[1]);
		expect(cases[i].name, 2, cases[i].coarse ? wanted : "");
	}
}

static void test_shapes_for_collisions_are_counted(void **state)
{
	(void)state;
	expect((const char *const[]){"Tree", "UCX_Tree_00", "tree COLLISION",
		       "BoxCollider"},
		4,
		"shapes for collisions (3), such as UCX_Tree_00: limber draws "
		"them over the model; export it without them\n");
	expect((const char *const[]){"Collar", "Coll", "UCX"}, 3, "");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_levels_beside_a_finer_one_are_counted),
		cmocka_unit_test(test_other_names_are_no_levels),
		cmocka_unit_test(test_a_level_is_told_by_its_spelling),
		cmocka_unit_test(test_shapes_for_collisions_are_counted),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
