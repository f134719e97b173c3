/* What limber doctor says about a glTF file before the loader evens it out. */
#include "app/model/gltf/gltf.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

/* The buffer of all files here; each part begins at a multiple of 4 bytes. */
static const struct {
	float position[3][3], normal[3][3]; /* at 0 and 36 */
	float weight[3][4], even[3][4];     /* at 72 and 120 */
	float time_s[2];                    /* at 168 */
	int8_t turn[2][4];                  /* at 176 */
	float turn_floats[2][4];            /* at 184 */
	uint8_t zeros[72];                  /* at 216 */
} data = {
	.position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
	.normal = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
	.weight = {{0}, {0.5f, 0.2f, 0.1f, 0.1f}, {0.5f, 0.5f, 0.2f, 0.2f}},
	.even = {{0.25f, 0.25f, 0.25f, 0.25f}, {0, 0, 1.001f, 0}, {0.999f}},
	.time_s = {0, 1},
	.turn = {{0, 0, 0, 127}, {0, 0, 127, 0}},
	.turn_floats = {{0, 0, 0, 1}, {0, 0, 1, 0}},
};

/* An accessor of a component, such as 5126 for floats. */
#define ACCESSOR(at, code, type, count) IN_VIEW(0, at, code, type, count)
#define IN_VIEW(view, at, code, type, count)                                  \
	"{'bufferView':" #view ",'byteOffset':" #at ",'componentType':" #code \
	",'type':'" type "','count':" #count ",'normalized':false}"

/* Accessors 0 to 7 of all files. */
static const char accessors[] =
	"{'bufferView':0,'byteOffset':176,'componentType':5120,"
	"'type':'VEC4','count':2,'normalized':true}," ACCESSOR(0, 5126, "VEC3",
		3) "," ACCESSOR(36, 5126, "VEC3", 3) "," ACCESSOR(72, 5126,
		"VEC4", 3) "," ACCESSOR(120, 5126, "VEC4", 3) "," ACCESSOR(168,
		5126, "SCALAR", 2) "," ACCESSOR(184, 5126, "VEC4",
		2) "," ACCESSOR(216, 5121, "VEC4", 3);

#define TRIANGLE \
	"'meshes':[{'primitives':[{'attributes':{'POSITION':1,'NORMAL':2}}]}]"

static void put_u32(uint8_t *out, size_t value)
{
	for (int i = 0; i < 4; i++) {
		out[i] = (uint8_t)(value >> 8 * i);
	}
}

static size_t put_chunk(uint8_t *out, const void *from, size_t size, size_t type)
{
	put_u32(out, size);
	put_u32(out + 4, type);
	memcpy(out + 8, from, size);
	return 8 + size;
}

/* Writes a .glb with further accessors and members; ' stands for ". */
static size_t write_file(uint8_t *out, const char *more, const char *members)
{
	static char text[8000];
	size_t size = (size_t)snprintf(text, sizeof(text),
		"{'asset':{'version':'2.0'},'buffers':[{'byteLength':%zu}],"
		"'bufferViews':[{'buffer':0,'byteLength':%zu},"
		"{'buffer':0,'byteLength':%zu,'byteStride':14},"
		"{'buffer':0,'byteLength':%zu,'byteStride':16}],"
		"'accessors':[%s%s],%s}   ",
		sizeof(data), sizeof(data), sizeof(data), sizeof(data),
		accessors, more, members);

	assert_true(size < sizeof(text));
	size -= size % 4; /* and as many blanks */
	for (size_t i = 0; i < size; i++) {
		text[i] = (char)(text[i] == '\'' ? '"' : text[i]);
	}
	memcpy(out, "glTF\2\0\0\0", 8);
	put_u32(out + 8, 12 + 8 + size + 8 + sizeof(data));
	out += 12;
	out += put_chunk(out, text, size, 0x4E4F534A);
	put_chunk(out, &data, sizeof(data), 0x004E4942);
	return 12 + 8 + size + 8 + sizeof(data);
}

static void keep(void *context, const char *finding)
{
	char *heard = context;

	snprintf(heard + strlen(heard), 2000 - strlen(heard), "%s\n", finding);
}

/* The findings, each with a newline. */
static const char *examine(const char *more, const char *members)
{
	static _Alignas(8) uint8_t file[9000];
	static char heard[2000];
	const struct examiner examiner = {keep, heard};
	struct model_source source = {.name = "t.glb",
		.data = file,
		.size = write_file(file, more, members),
		.memory_bytes = MODEL_MEMORY_BYTES};
	struct log log = log_to_stderr(LOG_WARNING);

	heard[0] = '\0';
	assert_int_equal(gltf_examine(&source, &examiner, &log), 0);
	return heard;
}

static void test_a_plain_file_has_no_findings(void **state)
{
	(void)state;
	assert_string_equal(examine("", TRIANGLE ",'nodes':[{'mesh':0}]"), "");
}

/* In any direction, along one axis or several. */
static void test_a_far_place_is_told(void **state)
{
	static const struct {
		const char *node, *metres;
	} cases[] = {
		{"'translation':[100,100,100]", NULL},
		{"'translation':[5000,0,0]", "5e+03 m"},
		{"'translation':[0,5000,0]", "5e+03 m"},
		{"'translation':[0,0,-5000]", "5e+03 m"},
		{"'translation':[2000,3000,6000]", "7e+03 m"},
		{"'translation':[-6000,2000,-3000]", "7e+03 m"},
		{"'translation':[0,0,-500]", "500 m"},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		char members[300], wanted[300] = "";

		snprintf(members, sizeof(members),
			TRIANGLE ",'nodes':[{'mesh':0,%s}]", cases[i].node);
		if (cases[i].metres) {
			snprintf(wanted, sizeof(wanted),
				"a place far from the origin (%s): limber poses and draws the model near the origin, where floats are exact, and writes the file's coordinates\n",
				cases[i].metres);
		}
		assert_string_equal(examine("", members), wanted);
	}
}

#define WITHOUT_VIEW "{'componentType':5126,'type':'VEC3','count':3}"
#define SPARSE                                                            \
	"'sparse':{'count':1,'indices':{'bufferView':0,'byteOffset':216," \
	"'componentType':5121},'values':{'bufferView':0}}}"

static void test_odd_accessors_are_counted(void **state)
{
	static const char scene[] = TRIANGLE ",'nodes':[{'mesh':0}]";

	(void)state;
	assert_string_equal(examine("," WITHOUT_VIEW "," WITHOUT_VIEW, scene),
		"accessors without a buffer view (2): limber reads zeros where no sparse value replaces them\n");
	assert_string_equal(
		examine(",{'bufferView':0,'componentType':5126,'type':'VEC3',"
			"'count':3," SPARSE,
			scene),
		"sparse accessors (1): limber replaces the listed values of the base\n");
	assert_string_equal(
		examine(",{'componentType':5126,'type':'VEC3','count':3," SPARSE,
			scene),
		"accessors without a buffer view (1): limber reads zeros where no sparse value replaces them\n"
		"sparse accessors (1): limber replaces the listed values of the base\n");
}

/* By their place or by the bytes between them; only floats need be aligned. */
static void test_floats_that_are_not_aligned_are_counted(void **state)
{
	static const char scene[] = TRIANGLE ",'nodes':[{'mesh':0}]";
	static const char odd[] =
		"): some ARM processors fault on such floats, so limber copies them bytewise\n";
	static const char *const one[] = {ACCESSOR(217, 5126, "VEC3", 3),
		ACCESSOR(218, 5126, "VEC3", 3), ACCESSOR(219, 5126, "VEC3", 3),
		IN_VIEW(1, 216, 5126, "VEC3", 3),
		IN_VIEW(2, 218, 5126, "VEC3", 3)};
	static const char *const none[] = {ACCESSOR(220, 5126, "VEC3", 3),
		ACCESSOR(217, 5121, "VEC4", 3), IN_VIEW(1, 216, 5123, "VEC3", 3),
		IN_VIEW(2, 216, 5126, "VEC3", 3)};
	char all[900] = "";

	(void)state;
	for (int i = 0; i < 4; i++) {
		size_t used = strlen(all);

		snprintf(all + used, sizeof(all) - used, ",%s", none[i]);
		assert_string_equal(examine(all, scene), "");
	}
	for (int i = 0; i < 5; i++) {
		char wanted[200];
		size_t used = strlen(all);

		snprintf(all + used, sizeof(all) - used, ",%s", one[i]);
		snprintf(wanted, sizeof(wanted),
			"accessors of floats that are not aligned to 4 bytes (%d%s",
			i + 1, odd);
		assert_string_equal(examine(all, scene), wanted);
	}
}

#define CLIP(outputs, path)                                             \
	"{'samplers':[" outputs "],'channels':[{'sampler':0,'target':{" \
	"'node':0,'path':'" path "'}}]}"
#define SAMPLER(output) "{'input':5,'output':" #output "}"

static void test_integer_outputs_of_all_samplers_are_counted(void **state)
{
	static const char rest[] = TRIANGLE ",'nodes':[{'mesh':0}],";
	char members[1000];

	(void)state;
	snprintf(members, sizeof(members),
		"%s'animations':[" CLIP("%s", "rotation") "]", rest, SAMPLER(6));
	assert_string_equal(examine("", members), "");
	snprintf(members, sizeof(members),
		"%s'animations':[" CLIP("%s,%s,%s", "rotation") "," CLIP(
			"%s", "rotation") "]",
		rest, SAMPLER(0), SAMPLER(6), SAMPLER(0), SAMPLER(0));
	assert_string_equal(examine("", members),
		"samplers with integer outputs (3): limber converts them to -1..1 or 0..1\n");
}

/* Findings about clips and skins come first. */
static void test_findings_of_all_formats_are_among_them(void **state)
{
	(void)state;
	assert_string_equal(
		examine("",
			"'meshes':[{'primitives':[{'attributes':{"
			"'POSITION':1}}]}],'nodes':[{'mesh':0}],"
			"'animations':[{'name':'a','samplers':[{'input':5,"
			"'output':6,'interpolation':'STEP'}],'channels':[{"
			"'sampler':0,'target':{'node':0,"
			"'path':'rotation'}}]}]"),
		"clip a: STEP channels (1): limber interpolates each channel in its own mode\n"
		"primitives without normals (1): limber lights the posed triangles with flat normals, as glTF requires\n");
}

#define SKINNED                                                 \
	"'meshes':[{'primitives':[{'attributes':{'POSITION':1," \
	"'NORMAL':2,'JOINTS_0':7,'WEIGHTS_0':4}}]}],"           \
	"'nodes':[{'mesh':0,'skin':0},{}],'skins':[{'joints':[1]}"

static void test_skins_without_matrices_are_counted(void **state)
{
	(void)state;
	assert_string_equal(examine("", SKINNED "]"),
		"skins without inverse bind matrices (1): limber uses identity matrices\n");
	assert_string_equal(
		examine(",{'componentType':5126,'type':'MAT4','count':1}",
			SKINNED ",{'joints':[1]},{'joints':[1],"
				"'inverseBindMatrices':8}]"),
		"skins without inverse bind matrices (2): limber uses identity matrices\n"
		"accessors without a buffer view (1): limber reads zeros where no sparse value replaces them\n");
}

static void test_nodes_are_counted_by_what_they_have(void **state)
{
	(void)state;
	assert_string_equal(
		examine("",
			TRIANGLE ",'nodes':[{'mesh':0},{'children':[0,2]},"
				 "{'children':[3,4]},{},{}]"),
		"nodes that come before their parents in the file (1): limber sorts the nodes, so that a parent's matrix is always computed first\n");
	assert_string_equal(examine("",
				    TRIANGLE ",'nodes':[{'mesh':0},{},{},"
					     "{'children':[1,2]}]"),
		"nodes that come before their parents in the file (2): limber sorts the nodes, so that a parent's matrix is always computed first\n");
	assert_string_equal(examine("",
				    "'meshes':[{'primitives':[{'attributes':{"
				    "'POSITION':1,'NORMAL':2},'targets':[{"
				    "'POSITION':1}]}]}],'nodes':[{'mesh':0,"
				    "'weights':[1]},{'mesh':0},{'mesh':0,"
				    "'weights':[0]}]"),
		"nodes with morph weights of their own (2): limber uses them instead of those of the mesh\n");
	assert_string_equal(
		examine("",
			TRIANGLE ",'nodes':[{'camera':0},{'mesh':0},"
				 "{'camera':0},{'camera':0}],'cameras':[{"
				 "'type':'perspective','perspective':{"
				 "'yfov':0.7,'znear':0.1}}]"),
		"cameras (3): limber looks at the whole model from outside instead; [scene] of a character file says from which side\n");
}

static void test_scenes_that_are_not_shown_are_counted(void **state)
{
	(void)state;
	assert_string_equal(examine("",
				    TRIANGLE ",'nodes':[{'mesh':0}],"
					     "'scenes':[{'nodes':[0]}]"),
		"");
	assert_string_equal(
		examine("",
			TRIANGLE ",'nodes':[{'mesh':0}],'scenes':["
				 "{'nodes':[0]},{'nodes':[0]},{'nodes':[0]}]"),
		"scenes beside the one that is shown (2): limber shows the file's default scene, or the first one if it names none\n");
}

#define PART(weights)                                         \
	"{'attributes':{'POSITION':1,'NORMAL':2,'JOINTS_0':7" \
	",'WEIGHTS_0':" #weights "}}"
#define WEIGHED(parts)                                                 \
	"'meshes':[{'primitives':[" parts "]}],'nodes':[{'mesh':0,"    \
	"'skin':0},{}],'skins':[{'joints':[1],'inverseBindMatrices':8" \
	"}]"
#define BINDS ",{'componentType':5126,'type':'MAT4','count':1}"
#define EMPTY                                                            \
	"accessors without a buffer view (1): limber reads zeros where " \
	"no sparse value replaces them\n"

/* A thousandth more or less than 1 is taken as rounding. */
static void test_weights_are_counted_by_their_sum(void **state)
{
	(void)state;
	assert_string_equal(examine(BINDS, WEIGHED(PART(4))), EMPTY);
	assert_string_equal(examine(BINDS, WEIGHED(PART(3))),
		"vertices without a weight above 0 (1): limber attaches them to their first joint, because they would collapse into the origin\n"
		"vertices whose weights do not sum to 1 (2): limber divides them by their sum\n" EMPTY);
	assert_string_equal(
		examine(BINDS, WEIGHED(PART(4) "," PART(3) "," PART(3))),
		"vertices without a weight above 0 (2): limber attaches them to their first joint, because they would collapse into the origin\n"
		"vertices whose weights do not sum to 1 (4): limber divides them by their sum\n" EMPTY);
}

/* Their sum is that of both sets. */
static void test_weights_of_two_sets_are_left_alone(void **state)
{
	(void)state;
	assert_string_equal(
		examine(BINDS,
			WEIGHED("{'attributes':{'POSITION':1,'NORMAL':2,"
				"'JOINTS_0':7,'WEIGHTS_0':3,'JOINTS_1':7,"
				"'WEIGHTS_1':3}}")),
		"primitives with a second set of joints and weights (1): limber uses all eight influences of a vertex\n" EMPTY);
}

#define EXTENDED(names) \
	TRIANGLE ",'nodes':[{'mesh':0}],'extensionsUsed':[" names "]"

static void test_ignored_extensions_are_named(void **state)
{
	(void)state;
	assert_string_equal(examine("",
				    EXTENDED("'KHR_texture_transform',"
					     "'MSFT_lod',"
					     "'KHR_materials_unlit'")),
		"");
	assert_string_equal(examine("", EXTENDED("'KHR_a'")),
		"extensions that limber ignores (1), so that what they add is not shown: KHR_a\n");
	assert_string_equal(
		examine("", EXTENDED("'KHR_a','MSFT_lod',7,'KHR_bc'")),
		"extensions that limber ignores (2), so that what they add is not shown: KHR_a, KHR_bc\n");
}

#define GLASS(members) \
	"{'extensions':{'KHR_materials_transmission':{" members "}}}"

/* Others are blended; a texture would say which part of a surface is. */
static void test_opaque_glass_is_counted(void **state)
{
	(void)state;
	assert_string_equal(
		examine("",
			TRIANGLE
			",'nodes':[{'mesh':0}],'materials':[{}," GLASS("'transmissionFactor':1") "," GLASS(
				"'transmissionTexture':{'index':0}") "]"),
		"materials whose transmission has a texture (1): limber draws them opaque; let them blend by alphaMode BLEND instead\n");
}

#define X49 "KHR_xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx"

/* The names have 255 bytes together; one that does not fit is left out. */
static void test_the_list_of_extensions_is_limited(void **state)
{
	static const char begin[] =
		"extensions that limber ignores (6), so that what they add is not shown: " X49
		", " X49 ", " X49 ", " X49 ", ";

	(void)state;
	for (int i = 0; i < 2; i++) {
		const char *bytes =
			"KHR_yyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyy";
		char members[900], wanted[500];

		bytes += i == 0; /* 4 * (49 + 2) + 51 are 255 */
		snprintf(members, sizeof(members),
			EXTENDED("'" X49 "','" X49 "','" X49 "','" X49
				 "','%s','K'"),
			bytes);
		snprintf(wanted, sizeof(wanted), "%s%s\n", begin,
			i == 0 ? bytes : "K");
		assert_string_equal(examine("", members), wanted);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_plain_file_has_no_findings),
		cmocka_unit_test(test_a_far_place_is_told),
		cmocka_unit_test(test_odd_accessors_are_counted),
		cmocka_unit_test(test_floats_that_are_not_aligned_are_counted),
		cmocka_unit_test(
			test_integer_outputs_of_all_samplers_are_counted),
		cmocka_unit_test(test_findings_of_all_formats_are_among_them),
		cmocka_unit_test(test_skins_without_matrices_are_counted),
		cmocka_unit_test(test_nodes_are_counted_by_what_they_have),
		cmocka_unit_test(test_scenes_that_are_not_shown_are_counted),
		cmocka_unit_test(test_weights_are_counted_by_their_sum),
		cmocka_unit_test(test_weights_of_two_sets_are_left_alone),
		cmocka_unit_test(test_ignored_extensions_are_named),
		cmocka_unit_test(test_the_list_of_extensions_is_limited),
		cmocka_unit_test(test_opaque_glass_is_counted),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
