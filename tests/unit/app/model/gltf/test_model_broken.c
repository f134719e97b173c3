/* Malformed containers, JSON, buffers and accessors; limits of the loader. */
#include "tests/unit/app/model/gltf/broken.h"

static void test_reports_line_and_column_of_malformed_json(void **state)
{
	(void)state;
	expect_code("{\n  'asset': {,}\n}", -EINVAL, "t.gltf: line 2, column");
	expect_code("{", -EINVAL, "t.gltf: line 1, column");
	expect_code("{'asset':{'version':'2.0'}} x", -EINVAL,
		"t.gltf: line 1, column");
	expect_code("{'asset':{'version':'2.0','version':'2.0'}}", -EINVAL,
		"duplicate object key");
	expect_code("{'asset':{'version':'2.0'},'x':1e999}", -EINVAL,
		"real number overflow");
	expect_code("{'asset':'\xff'}", -EINVAL, "unable to decode byte 0xff");
}

static void test_refuses_unknown_formats(void **state)
{
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct model *model;

	(void)state;
	assert_int_equal(model_load_memory("", 0, "e", &log, &model), -EINVAL);
	assert_string_equal(logged.sentence[0],
		"e: the file is empty: export or copy it again");
	expect_code("solid cube", -ENOTSUP,
		"t.gltf: the format is unknown; limber reads .gltf, .glb and .x: export the model as .glb");
	expect_code("[]", -ENOTSUP, "t.gltf: the format is unknown");
	expect_code(" ", -ENOTSUP, "t.gltf: the format is unknown");
}

static void test_refuses_other_versions(void **state)
{
	(void)state;
	expect_code("{'asset':{'version':'1.0'}}", -ENOTSUP,
		"t.gltf: /asset: is glTF 1.0; limber reads glTF 2.0");
	expect_code("{'asset':{'version':1.0},'scenes':{}}", -ENOTSUP,
		"t.gltf: /asset: is glTF 1.0; limber reads glTF 2.0");
	expect_code("{'asset':{'version':1}}", -ENOTSUP,
		"t.gltf: /asset: is glTF 1.0; limber reads glTF 2.0");
	expect_code("{'asset':{'version':'20'}}", -ENOTSUP, "is glTF 20;");
	expect_code("{'asset':{'version':'2.1','minVersion':'2.1'}}", -ENOTSUP,
		"/asset: is glTF 2.1;");
	expect_code(
		"{'asset':{}}", -EINVAL, "t.gltf: /asset: has no \"version\"");
	expect_code("{}", -EINVAL, "t.gltf: /asset: has no \"version\"");
	expect_code("{'asset':[]}", -EINVAL, "/asset: is not an object");
	expect_code("{'asset':{'version':2}}", -EINVAL,
		"/asset/version: is not a string");
}

static void test_refuses_unknown_required_extensions(void **state)
{
	(void)state;
	expect_code("{'asset':{'version':'2.0'},'extensionsRequired':["
		    "'KHR_materials_unlit','KHR_draco_mesh_compression']}",
		-ENOTSUP,
		"t.gltf: /extensionsRequired/1: the model requires KHR_draco_mesh_compression, which limber does not support");
	expect_code("{'asset':{'version':'2.0'},'extensionsRequired':[1]}",
		-EINVAL, "/extensionsRequired/0: is not a string");
}

/* Blender requires its lights. */
static void test_only_warns_of_extensions_that_add_looks(void **state)
{
	static const char *const names[] = {"KHR_lights_punctual",
		"KHR_materials_clearcoat", "KHR_xmp_json_ld"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		struct log_capture logged;
		struct model *model;
		char text[200], warning[200];

		snprintf(text, sizeof(text),
			"{'asset':{'version':'2.0'},'extensionsRequired':['%s']}",
			names[i]);
		snprintf(warning, sizeof(warning),
			"/extensionsRequired/0: the model requires %s, which limber ignores, so that it looks different: export it without",
			names[i]);
		assert_int_equal(model_from_text(text, &logged, &model), 0);
		assert_true(log_capture_has(&logged, LOG_WARNING, warning));
		model_destroy(model);
	}
}

static void test_replaces_control_characters_in_messages(void **state)
{
	(void)state;
	expect_code("{'asset':{'version':'\\u001b[2J'}}", -ENOTSUP,
		"/asset: is glTF ?[2J;");
}

static void test_refuses_values_of_the_wrong_type(void **state)
{
	static const struct broken broken[] = {
		{"'nodes':{}", "/nodes: is not an array"},
		{"'nodes':[1]", "/nodes/0: is not an object"},
		{"'nodes':[{'name':1}]", "/nodes/0/name: is not a string"},
		{"'nodes':[{'mesh':'0'}]", "/nodes/0/mesh: is not an integer"},
		{"'nodes':[{'mesh':0.5}]", "/nodes/0/mesh: is not an integer"},
		{"'nodes':[{'mesh':1e300}]", "/nodes/0/mesh: is not an integer"},
		{"'nodes':[{'mesh':0}]",
			"/nodes/0/mesh: mesh 0 does not exist (the file has 0)"},
		{"'nodes':[{'mesh':-1}]",
			"/nodes/0/mesh: mesh -1 does not exist"},
		{"'nodes':[{'translation':[1,2]}]",
			"/nodes/0/translation: has 2 numbers instead of 3"},
		{"'nodes':[{'translation':[1,2,null]}]",
			"/nodes/0/translation/2: is not a number"},
		{"'nodes':[{'translation':[1,2,1e39]}]",
			"/nodes/0/translation/2: 1e+39 exceeds the range of a float"},
		{"'materials':[{'doubleSided':1}]",
			"/materials/0/doubleSided: is neither true nor false"},
		{"'materials':[{'pbrMetallicRoughness':[]}]",
			"/materials/0/pbrMetallicRoughness: is not an object"},
	};

	(void)state;
	EXPECT_ALL(broken);
}

static void test_refuses_broken_buffers_and_views(void **state)
{
	static const struct broken broken[] = {
		{"'buffers':[{}]", "/buffers/0: has no \"byteLength\""},
		{"'buffers':[{'byteLength':0}]",
			"/buffers/0/byteLength: 0 is out of range (1 to"},
		{"'buffers':[{'byteLength':4}]",
			"/buffers/0: has no uri, and the file has no binary"},
		{VIEW16 ",'nodes':3", "/nodes: is not an array"},
		{"'bufferViews':[{'byteLength':1}]",
			"/bufferViews/0: has no \"buffer\""},
		{"'bufferViews':[{'buffer':0,'byteLength':1}]",
			"/bufferViews/0/buffer: buffer 0 does not exist"},
		{"'buffers':[{'byteLength':3,'uri':'data:;base64,AAAA'}],"
		 "'bufferViews':[{'buffer':0,'byteLength':3,'byteOffset':1}]",
			"/bufferViews/0: ends at byte 4, but buffer 0 has 3 bytes"},
		{"'buffers':[{'byteLength':3,'uri':'data:;base64,AAAA'}],"
		 "'bufferViews':[{'buffer':0,'byteLength':2147483647,"
		 "'byteOffset':2147483647}]",
			"/bufferViews/0: ends at byte 4294967294"},
		{"'buffers':[{'byteLength':3,'uri':'data:;base64,AAAA'}],"
		 "'bufferViews':[{'buffer':0,'byteLength':0}]",
			"/bufferViews/0/byteLength: 0 is out of range (1 to 2147483647)"},
		{"'buffers':[{'byteLength':3,'uri':'data:;base64,AAAA'}],"
		 "'bufferViews':[{'buffer':0,'byteLength':3,'byteOffset':-1}]",
			"/bufferViews/0/byteOffset: -1 is out of range"},
		{"'buffers':[{'byteLength':3,'uri':'data:;base64,AAAA'}],"
		 "'bufferViews':[{'buffer':0,'byteLength':3,'byteStride':253}]",
			"/bufferViews/0/byteStride: 253 is out of range (4 to 252)"},
		{"'buffers':[{'byteLength':3,'uri':'data:;base64,AAAA'}],"
		 "'bufferViews':[{'buffer':0,'byteLength':3,'byteStride':2}]",
			"/bufferViews/0/byteStride: 2 is out of range (4 to 252)"},
	};

	(void)state;
	EXPECT_ALL(broken);
}

static void test_refuses_broken_accessors(void **state)
{
	static const struct broken broken[] = {
		{ACCESSORS("{}"), "/accessors/0: has no \"count\""},
		{ACCESSORS(ZEROS("VEC3", "5126", "0")),
			"/accessors/0/count: 0 is out of range (1 to"},
		{ACCESSORS(ZEROS("VEC3", "5126", "-1")),
			"/accessors/0/count: -1 is out of range (1 to"},
		{ACCESSORS(ZEROS("VEC5", "5126", "1")),
			"/accessors/0: type \"VEC5\" is not defined by glTF 2.0"},
		{ACCESSORS(ZEROS("VEC3", "5124", "1")),
			"/accessors/0: componentType 5124 is not defined by glTF 2.0"},
		{ACCESSORS("{'type':'VEC3','count':1}"),
			"/accessors/0: has no \"componentType\""},
		{VIEW16 "," ACCESSORS("{'bufferView':1,'type':'VEC3',"
				      "'componentType':5126,'count':1}"),
			"/accessors/0/bufferView: bufferView 1 does not exist"},
		{VIEW16 "," ACCESSORS("{'bufferView':0,'type':'VEC3',"
				      "'componentType':5126,'count':2}"),
			"/accessors/0: needs 24 bytes of its bufferView, which has 16"},
		{VIEW16 "," ACCESSORS("{'bufferView':0,'type':'VEC3',"
				      "'byteOffset':5,"
				      "'componentType':5126,'count':1}"),
			"/accessors/0: needs 17 bytes of its bufferView"},
		{VIEW16 "," ACCESSORS("{'bufferView':0,'type':'MAT3',"
				      "'componentType':5121,'count':2}"),
			"/accessors/0: needs 24 bytes of its bufferView"},
		{"'buffers':[{'byteLength':3,'uri':'data:;base64,AAAA'}],"
		 "'bufferViews':[{'buffer':0,'byteLength':3,'byteStride':4}]"
		 "," ACCESSORS("{'bufferView':0,'type':'VEC3',"
			       "'componentType':5126,'count':1}"),
			"/accessors/0: elements of 12 bytes are larger than the byteStride of 4"},
	};

	(void)state;
	EXPECT_ALL(broken);
}

#define SPARSE(members)                                               \
	VIEW16 "," ACCESSORS("{'type':'SCALAR','componentType':5126," \
			     "'count':3,'sparse':{" members "}}")

static void test_refuses_broken_sparse_accessors(void **state)
{
	static const struct broken broken[] = {
		{SPARSE(""), "/accessors/0/sparse: has no \"count\""},
		{SPARSE("'count':4"),
			"/accessors/0/sparse/count: 4 is out of range (1 to 3)"},
		{SPARSE("'count':1"),
			"/accessors/0/sparse/indices: has no \"bufferView\""},
		{SPARSE("'count':1,'indices':{'bufferView':0}"),
			"/accessors/0/sparse/indices: has no \"componentType\""},
		{SPARSE("'count':1,'indices':{'bufferView':0,"
			"'componentType':5126}"),
			"/accessors/0/sparse/indices: componentType 5126 is not an unsigned integer"},
		{SPARSE("'count':2,'indices':{'bufferView':0,"
			"'componentType':5121}"),
			"/accessors/0/sparse/indices: index 0 does not come after index 0"},
		{SPARSE("'count':1,'indices':{'bufferView':0,"
			"'byteOffset':16,'componentType':5121}"),
			"/accessors/0/sparse/indices: needs 17 bytes"},
		{SPARSE("'count':1,'indices':{'bufferView':0,"
			"'componentType':5121}"),
			"/accessors/0/sparse/values: has no \"bufferView\""},
		{SPARSE("'count':1,'indices':{'bufferView':0,"
			"'componentType':5121},'values':{'bufferView':0,"
			"'byteOffset':13}"),
			"/accessors/0/sparse/values: needs 17 bytes"},
		{NAN_VIEW "," ACCESSORS(
			 "{'type':'SCALAR','componentType':5126,'count':3,"
			 "'sparse':{'count':1,'indices':{'bufferView':0,"
			 "'componentType':5121,'byteOffset':2}}}"),
			"/accessors/0/sparse/indices: index 192 is out of range (the accessor has 3 elements)"},
	};

	(void)state;
	EXPECT_ALL(broken);
}

/* Each accessor claims about 2^32 bytes, which overflows 32 bits. */
static void test_limits_the_size_of_an_accessor(void **state)
{
	(void)state;
	expect_code("{'asset':{'version':'2.0'}," ACCESSORS(
			    ZEROS("MAT4", "5126", "67108864")) "}",
		-EFBIG,
		"/accessors/0: has 67108864 elements; limber reads up to 4194304");
	expect_code("{'asset':{'version':'2.0'}," ACCESSORS(
			    ZEROS("VEC4", "5126", "268435456")) "}",
		-EFBIG, "/accessors/0: has 268435456 elements");
	expect_code("{'asset':{'version':'2.0'}," ACCESSORS(
			    ZEROS("VEC3", "5126", "357913942")) "}",
		-EFBIG, "/accessors/0: has 357913942 elements");
	expect_code("{'asset':{'version':'2.0'}," ACCESSORS(
			    ZEROS("SCALAR", "5126", "4294967297")) "}",
		-EINVAL, "/accessors/0/count: 4294967297 is out of range");
}

/* A small JSON text must not make the loader allocate much memory. */
static void test_limits_the_memory_of_a_model(void **state)
{
	(void)state;
	expect_code("{'asset':{'version':'2.0'}," ACCESSORS(ZEROS("VEC3",
			    "5126", "9000000")) ",'meshes':[{"
						"'primitives':[{'attributes':{'"
						"POSITION':0}},"
						"{'attributes':{'POSITION':0}},"
						"{'attributes':{"
						"'POSITION':0}}]}]}",
		-ENOMEM,
		"/meshes/0/primitives/1: the model needs more than 256 MiB of memory");
}

static void test_limits_the_number_of_json_values(void **state)
{
	/* It counts 1, and each comma and opening bracket: here five in all. */
	static const char begin[] = "{'asset':{'version':'2.0'},'x':[";
	size_t count = sizeof(begin) - 1 + 1048576 - 5;
	char *text = malloc(count + 2);

	(void)state;
	assert_non_null(text);
	strcpy(text, begin);
	memset(text + strlen(text), '[', count + 1 - strlen(text));
	text[count + 1] = '\0';
	expect_code(
		text, -EFBIG, "t.gltf: the JSON has more than 1048576 values");
	text[count] = '\0';
	expect_code(text, -EINVAL, "maximum parsing depth reached");
	free(text);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_reports_line_and_column_of_malformed_json),
		cmocka_unit_test(test_refuses_unknown_formats),
		cmocka_unit_test(test_refuses_other_versions),
		cmocka_unit_test(test_refuses_unknown_required_extensions),
		cmocka_unit_test(test_only_warns_of_extensions_that_add_looks),
		cmocka_unit_test(test_replaces_control_characters_in_messages),
		cmocka_unit_test(test_refuses_values_of_the_wrong_type),
		cmocka_unit_test(test_refuses_broken_buffers_and_views),
		cmocka_unit_test(test_refuses_broken_accessors),
		cmocka_unit_test(test_refuses_broken_sparse_accessors),
		cmocka_unit_test(test_limits_the_size_of_an_accessor),
		cmocka_unit_test(test_limits_the_memory_of_a_model),
		cmocka_unit_test(test_limits_the_number_of_json_values),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
