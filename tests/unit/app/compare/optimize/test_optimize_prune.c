/* Which parts of a glTF file are used, and what numbers they then have. */
#include "app/compare/optimize/optimize_prune.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The JSON has ' for ". */
static json_t *parse(const char *text)
{
	char json[2048];
	json_t *root;

	assert_true(strlen(text) < sizeof(json));
	strcpy(json, text);
	for (char *at = strchr(json, '\''); at; at = strchr(at, '\'')) {
		*at = '"';
	}
	root = json_loads(json, 0, NULL);
	assert_non_null(root);
	return root;
}

static void expect_pruned(const char *before, const char *after)
{
	json_t *root = parse(before), *wanted = parse(after);

	assert_int_equal(optimize_prune(root), 0);
	if (!json_equal(root, wanted)) {
		char *text = json_dumps(root, JSON_COMPACT);

		print_error("pruned: %s\n", text);
		free(text);
	}
	assert_true(json_equal(root, wanted));
	json_decref(root);
	json_decref(wanted);
}

/* The first of each part is not used; all others move down by one. */
static void test_levels_skins_and_cameras_of_nodes_are_followed(void **state)
{
	(void)state;
	expect_pruned("{'scenes':[{'nodes':[1]}],"
		      "'nodes':[{},{'mesh':1,'skin':1,'children':[2],"
		      "'extensions':{'MSFT_lod':{'ids':[3,4]}}},{},{'mesh':2},{},"
		      "{'camera':1},{},{}],"
		      "'meshes':[{},{'name':'full'},{'name':'coarse'}],"
		      "'skins':[{'joints':[0]},{'joints':[6],'skeleton':7}],"
		      "'cameras':[{},{'name':'seen'}]}",
		"{'scenes':[{'nodes':[0]}],"
		"'nodes':[{'mesh':0,'skin':0,'children':[1],"
		"'extensions':{'MSFT_lod':{'ids':[2,3]}}},{},{'mesh':1},{},"
		"{'camera':0},{},{}],"
		"'meshes':[{'name':'full'},{'name':'coarse'}],"
		"'skins':[{'joints':[5],'skeleton':6}],"
		"'cameras':[{'name':'seen'}]}");
}

static void test_nodes_that_move_a_used_one_stay(void **state)
{
	(void)state;
	expect_pruned("{'scenes':[{'nodes':[]}],"
		      "'nodes':[{'children':[1,5]},{'children':[3]},{},"
		      "{'camera':0},{},{'mesh':0}],"
		      "'cameras':[{}],'meshes':[{}]}",
		"{'scenes':[{'nodes':[]}],"
		"'nodes':[{'children':[1,3]},{'children':[2]},"
		"{'camera':0},{'mesh':0}],"
		"'cameras':[{}],'meshes':[{}]}");
}

static void test_a_parent_may_come_behind_its_first_child(void **state)
{
	(void)state;
	expect_pruned("{'scenes':[{'nodes':[]}],'nodes':[{'camera':0},{},"
		      "{'name':'carrier','children':[0]}],'cameras':[{}]}",
		"{'scenes':[{'nodes':[]}],'nodes':[{'camera':0},"
		"{'name':'carrier','children':[0]}],'cameras':[{}]}");
}

static void test_without_scenes_all_nodes_are_used(void **state)
{
	(void)state;
	expect_pruned("{'nodes':[{},{'mesh':1}],'meshes':[{},{'name':'b'}],"
		      "'materials':[{}]}",
		"{'nodes':[{},{'mesh':0}],'meshes':[{'name':'b'}]}");
}

static void test_numbers_of_parts_that_are_missing_stay(void **state)
{
	static const char odd[] =
		"{'scenes':[{'nodes':[0,1,-1]}],"
		"'nodes':[{'mesh':1,'skin':-1,'children':[1,-1,7]}],"
		"'meshes':[{'name':'used by none'}]}";

	(void)state;
	expect_pruned(odd,
		"{'scenes':[{'nodes':[0,1,-1]}],"
		"'nodes':[{'mesh':1,'skin':-1,'children':[1,-1,7]}]}");
}

/* A mesh whose primitive has the materials 1, 2 and, with that, 3. */
#define MESH(first, second)                                              \
	"'scenes':[{'nodes':[0]}],'nodes':[{'mesh':0}],"                 \
	"'meshes':[{'primitives':[{'material':" first ",'extensions':{'" \
	"KHR_materials_variants':{'mappings':[{'material':" second "}]}}}]}],"

static void test_variants_and_levels_of_materials_are_followed(void **state)
{
	(void)state;
	expect_pruned(
		"{" MESH("1", "2") "'materials':[{'name':'a'},{'name':'b'},"
				   "{'extensions':{'MSFT_lod':{'ids':[3]}}},"
				   "{'name':'d'}]}",
		"{" MESH("0", "1") "'materials':[{'name':'b'},"
				   "{'extensions':{'MSFT_lod':{'ids':[2]}}},"
				   "{'name':'d'}]}");
}

/* Textures may stand in an object of an extension, but not in extras. */
static void test_textures_are_found_in_extensions(void **state)
{
	(void)state;
	expect_pruned(
		"{" MESH("0",
			"0") "'materials':[{'normalTexture':{'index':1},'extras':{"
			     "'aTexture':{'index':0}},'extensions':{'KHR_materials_x':{"
			     "'in':{'one':{'deepTexture':{'index':2}}}}}}],"
			     "'textures':[{'source':0},{'source':1,'sampler':1},"
			     "{'sampler':2,'extensions':{'EXT_texture_webp':{"
			     "'source':2}}}],"
			     "'images':[{},{'name':'png'},{'name':'webp'}],"
			     "'samplers':[{},{'wrapS':1},{'wrapS':2}]}",
		"{" MESH("0",
			"0") "'materials':[{'normalTexture':{'index':0},'extras':{"
			     "'aTexture':{'index':0}},'extensions':{'KHR_materials_x':{"
			     "'in':{'one':{'deepTexture':{'index':1}}}}}}],"
			     "'textures':[{'source':0,'sampler':0},"
			     "{'sampler':1,'extensions':{'EXT_texture_webp':{"
			     "'source':1}}}],"
			     "'images':[{'name':'png'},{'name':'webp'}],"
			     "'samplers':[{'wrapS':1},{'wrapS':2}]}");
}

/* However deep an extension nests its objects, and if one has only that name. */
static void test_textures_are_found_at_any_depth(void **state)
{
	static const char *const nested[][2] = {
		{"'Texture':{'index':%d}", ""},
		{"'a':{'aTexture':{'index':%d}", "}"},
		{"'a':{'b':{'aTexture':{'index':%d}", "}}"},
		{"'a':{'b':{'c':{'aTexture':{'index':%d}", "}}}"},
		{"'a':{'b':{'c':{'d':{'aTexture':{'index':%d}", "}}}}"},
		{"'a':{'b':{'c':{'d':{'e':{'aTexture':{'index':%d}", "}}}}}"},
	};
	static const char *const format[2] = {
		"{" MESH("0", "0") "'materials':[{'extensions':{%s%s}}],"
				   "'textures':[{},{'name':'used'}]}",
		"{" MESH("0", "0") "'materials':[{'extensions':{%s%s}}],"
				   "'textures':[{'name':'used'}]}"};

	(void)state;
	for (size_t i = 0; i < sizeof(nested) / sizeof(*nested); i++) {
		char text[2][1024], object[256];

		for (int after = 0; after < 2; after++) {
			snprintf(object, sizeof(object), nested[i][0],
				after ? 0 : 1);
			snprintf(text[after], sizeof(text[after]),
				format[after], object, nested[i][1]);
		}
		expect_pruned(text[0], text[1]);
	}
}

/* Two primitives with a material and none, and a target of the first. */
#define COORDINATES(attributes, material)                                   \
	"{'scenes':[{'nodes':[0]}],'nodes':[{'mesh':0}],"                   \
	"'meshes':[{'primitives':[{'material':0,'attributes':{" attributes  \
	"},'targets':[{" attributes "}]},{'attributes':{" attributes "}}]}" \
	"],'materials':[{" material "}]}"

#define ALL                                                       \
	"'POSITION':0,'TANGENT':1,'TEXCOORD_0':2,'TEXCOORD_1':3," \
	"'TEXCOORD_2':4,'TEXCOORD_3':5,'TEXCOORD_31':6,'TEXCOORD_32':7"

static void test_coordinates_that_no_texture_reads_go(void **state)
{
	(void)state;
	expect_pruned(COORDINATES(ALL, ""),
		COORDINATES("'POSITION':0,'TEXCOORD_0':2", ""));
#define SETS                                                                   \
	"'emissiveTexture':{'texCoord':31},'extensions':{'KHR_materials_x':{'" \
	"yTexture':{'texCoord':1,'extensions':{'KHR_texture_transform':{"      \
	"'texCoord':3}}}}}"
	expect_pruned(COORDINATES(ALL, SETS),
		COORDINATES("'POSITION':0,'TEXCOORD_0':2,'TEXCOORD_1':3,"
			    "'TEXCOORD_3':5,'TEXCOORD_31':6",
			SETS));
#define DEEP "'extensions':{'a':{'b':{'c':{'d':{'eTexture':{'texCoord':1}}}}}}"
	expect_pruned(COORDINATES(ALL, DEEP),
		COORDINATES("'POSITION':0,'TEXCOORD_0':2,'TEXCOORD_1':3", DEEP));
}

static void test_attributes_of_similar_names_stay(void **state)
{
#define SIMILAR                                                        \
	"'POSITION':0,'TEXCOORD':1,'TEXCOORD-2':1,'TEXCOORD3_4':1,"    \
	"'TEXCOORD_':1,'TEXCOORD_X':1,'_TEXCOORD_2':1,'texcoord_2':1," \
	"'TANGENTS':1"
	(void)state;
	expect_pruned(COORDINATES(SIMILAR, ""), COORDINATES(SIMILAR, ""));
}

static void test_tangents_stay_for_maps_of_normals(void **state)
{
	static const char *const names[] = {
		"normalTexture", "clearcoatNormalTexture"};

	(void)state;
	for (int i = 0; i < 2; i++) {
		char before[2048], after[2048];

		snprintf(before, sizeof(before),
			COORDINATES("'TANGENT':1,'TEXCOORD_1':3", "'%s':{}"),
			names[i]);
		snprintf(after, sizeof(after),
			COORDINATES("'TANGENT':1", "'%s':{}"), names[i]);
		expect_pruned(before, after);
	}
}

/* A channel's node is the number; -1: it has none. */
static void test_channels_of_unused_nodes_go(void **state)
{
	(void)state;
	expect_pruned("{'scenes':[{'nodes':[1]}],'nodes':[{},{}],'animations':["
		      "{'name':'kept','channels':[{'target':{'path':'weights'}},"
		      "{'target':{'node':1}},{'target':{'node':2}},"
		      "{'target':{'node':-1}},{'target':{'node':0}}]},"
		      "{'channels':[{'target':{'node':2}}]}]}",
		"{'scenes':[{'nodes':[0]}],'nodes':[{}],'animations':["
		"{'name':'kept','channels':[{'target':{'node':0}}]}]}");
	expect_pruned("{'scenes':[{'nodes':[1]}],'nodes':[{},{}],"
		      "'animations':[{'channels':[{'target':{'node':2}}]}]}",
		"{'scenes':[{'nodes':[0]}],'nodes':[{}]}");
}

/* Node 1 ends the first clip, node 3 the last one; node 2 ends none. */
static void test_clips_keep_their_numbers_and_durations(void **state)
{
	(void)state;
	expect_pruned("{'scenes':[{'nodes':[0]}],"
		      "'nodes':[{},{'name':'a'},{'name':'b'},{'name':'c'}],"
		      "'accessors':[{'max':[1]},{'max':[2.5]}],"
		      "'animations':["
		      "{'name':'hidden','samplers':[{'input':0},{'input':1}],"
		      "'channels':[{'sampler':0,'target':{'node':2}},"
		      "{'sampler':1,'target':{'node':1}}]},"
		      "{'name':'seen','samplers':[{'input':0}],"
		      "'channels':[{'sampler':0,'target':{'node':0}},"
		      "{'sampler':0,'target':{'node':2}}]},"
		      "{'name':'longer','samplers':[{'input':0},{'input':1}],"
		      "'channels':[{'sampler':0,'target':{'node':0}},"
		      "{'sampler':1,'target':{'node':3}}]}]}",
		"{'scenes':[{'nodes':[0]}],"
		"'nodes':[{},{'name':'a'},{'name':'c'}],"
		"'accessors':[{'max':[1]},{'max':[2.5]}],"
		"'animations':["
		"{'name':'hidden','samplers':[{'input':0},{'input':1}],"
		"'channels':[{'sampler':1,'target':{'node':1}}]},"
		"{'name':'seen','samplers':[{'input':0}],"
		"'channels':[{'sampler':0,'target':{'node':0}}]},"
		"{'name':'longer','samplers':[{'input':0},{'input':1}],"
		"'channels':[{'sampler':0,'target':{'node':0}},"
		"{'sampler':1,'target':{'node':2}}]}]}");
}

/* Of nodes that end a clip at the same time the first stays, with its mesh. */
static void test_the_end_of_a_clip_keeps_one_node_and_what_it_has(void **state)
{
	(void)state;
	expect_pruned(
		"{'scenes':[{'nodes':[3]}],'nodes':[{'name':'last','mesh':1},"
		"{'children':[0]},{'name':'as late'},{'name':'seen'}],"
		"'meshes':[{},{'name':'its own'}],"
		"'accessors':[{'max':[1]},{'max':[2]}],"
		"'animations':[{'samplers':[{'input':0},{'input':1}],"
		"'channels':[{'sampler':0,'target':{'node':3}},"
		"{'sampler':1,'target':{'node':0}},"
		"{'sampler':1,'target':{'node':2}}]}]}",
		"{'scenes':[{'nodes':[2]}],'nodes':[{'name':'last','mesh':0},"
		"{'children':[0]},{'name':'seen'}],"
		"'meshes':[{'name':'its own'}],"
		"'accessors':[{'max':[1]},{'max':[2]}],"
		"'animations':[{'samplers':[{'input':0},{'input':1}],"
		"'channels':[{'sampler':0,'target':{'node':2}},"
		"{'sampler':1,'target':{'node':0}}]}]}");
	/* A used node that ends as late suffices. */
	expect_pruned("{'scenes':[{'nodes':[1]}],'nodes':[{},{}],"
		      "'accessors':[{'max':[2]}],"
		      "'animations':[{'samplers':[{'input':0}],"
		      "'channels':[{'sampler':0,'target':{'node':0}},"
		      "{'sampler':0,'target':{'node':1}}]}]}",
		"{'scenes':[{'nodes':[0]}],'nodes':[{}],"
		"'accessors':[{'max':[2]}],"
		"'animations':[{'samplers':[{'input':0}],"
		"'channels':[{'sampler':0,'target':{'node':0}}]}]}");
}

/* Only nodes that exist can end a clip. */
static void test_a_channel_of_a_missing_node_ends_no_clip(void **state)
{
	(void)state;
	expect_pruned("{'scenes':[{'nodes':[0]}],'nodes':[{},{'name':'last'}],"
		      "'accessors':[{'max':[1]},{'max':[2]}],"
		      "'animations':[{'samplers':[{'input':0},{'input':1}],"
		      "'channels':[{'sampler':0,'target':{'node':1}},"
		      "{'sampler':1,'target':{'node':2}}]}]}",
		"{'scenes':[{'nodes':[0]}],'nodes':[{},{'name':'last'}],"
		"'accessors':[{'max':[1]},{'max':[2]}],"
		"'animations':[{'samplers':[{'input':0},{'input':1}],"
		"'channels':[{'sampler':0,'target':{'node':1}}]}]}");
}

#define SCALARS(count) "{'type':'SCALAR','count':" #count "}"

/* Three times, three numbers, four, and three vectors. */
#define STILL(clips)                                                                   \
	"{'scenes':[{'nodes':[0]}],'nodes':[{}],'accessors':[" SCALARS(3) "," SCALARS( \
		3) "," SCALARS(4) ","                                                  \
				  "{'type':'VEC3','count':3}],'animations':[" clips    \
				  "{'name':'walk','channels':[{'target':{'node':0}}]}]}"

#define STILL_CLIP(name, input, output, channel)                    \
	"{'name':'" name "','samplers':[{'input':" input ","        \
	"'output':" output "}],'channels':[{'sampler':0,'target':{" \
	"'path':'" channel "'}}]},"

/* Clips that move nothing, such as those of materials, keep a channel. */
static void test_clips_without_nodes_keep_their_numbers(void **state)
{
	(void)state;
	expect_pruned(STILL(STILL_CLIP("a", "0", "1", "pointer") STILL_CLIP(
			      "b", "0", "2", "pointer") STILL_CLIP("c", "0",
			      "3", "scale") STILL_CLIP("d", "0", "9", "scale")),
		STILL(STILL_CLIP("a", "0", "1", "weights") STILL_CLIP("b", "0",
			"0", "weights") STILL_CLIP("c", "0", "0", "weights")
				STILL_CLIP("d", "0", "0", "weights")));
}

static void test_clips_without_nodes_and_times_go(void **state)
{
	(void)state;
	expect_pruned(STILL(STILL_CLIP("a", "3", "1", "pointer") STILL_CLIP("b",
			      "-1", "1", "pointer") STILL_CLIP("c", "9", "1",
			      "scale") STILL_CLIP("d", "0.5", "1", "scale")),
		STILL(""));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_levels_skins_and_cameras_of_nodes_are_followed),
		cmocka_unit_test(test_nodes_that_move_a_used_one_stay),
		cmocka_unit_test(test_a_parent_may_come_behind_its_first_child),
		cmocka_unit_test(test_without_scenes_all_nodes_are_used),
		cmocka_unit_test(test_numbers_of_parts_that_are_missing_stay),
		cmocka_unit_test(
			test_variants_and_levels_of_materials_are_followed),
		cmocka_unit_test(test_textures_are_found_in_extensions),
		cmocka_unit_test(test_textures_are_found_at_any_depth),
		cmocka_unit_test(test_coordinates_that_no_texture_reads_go),
		cmocka_unit_test(test_attributes_of_similar_names_stay),
		cmocka_unit_test(test_tangents_stay_for_maps_of_normals),
		cmocka_unit_test(test_channels_of_unused_nodes_go),
		cmocka_unit_test(test_clips_keep_their_numbers_and_durations),
		cmocka_unit_test(
			test_the_end_of_a_clip_keeps_one_node_and_what_it_has),
		cmocka_unit_test(test_a_channel_of_a_missing_node_ends_no_clip),
		cmocka_unit_test(test_clips_without_nodes_keep_their_numbers),
		cmocka_unit_test(test_clips_without_nodes_and_times_go),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
