/* Malformed glTF ends with one sentence that names the place. */
#include "app/model/model.h"
#include "tests/support/model_fixture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct broken {
	const char *text;     /* what follows the asset; ' stands for " */
	const char *sentence; /* what follows "t.gltf: " */
};

static void expect_code(const char *text, int code, const char *sentence)
{
	struct log_capture heard;
	struct model *model;
	int error = model_from_text(text, &heard, &model);

	if (error != code || !heard.count ||
		!strstr(heard.sentence[heard.count - 1], sentence)) {
		fail_msg("%s\n gives %d: %s\n not %d: %s", text, error,
			heard.count ? heard.sentence[heard.count - 1] : "",
			code, sentence);
	}
	assert_null(model);
	assert_int_equal(log_capture_count(&heard, LOG_ERROR), 1);
	assert_int_equal(strncmp(heard.sentence[heard.count - 1],
				 "t.gltf: ", strlen("t.gltf: ")),
		0);
}

static void expect_all(const struct broken *broken, size_t count)
{
	size_t i;

	for (i = 0; i < count; i++) {
		char text[2048];

		assert_true(strlen(broken[i].text) < sizeof(text) - 64);
		snprintf(text, sizeof(text), "{'asset':{'version':'2.0'},%s}",
			broken[i].text);
		expect_code(text, -EINVAL, broken[i].sentence);
	}
}

#define EXPECT_ALL(table) expect_all(table, sizeof(table) / sizeof((table)[0]))

/* Pieces. Accessors without a bufferView are zeros. */
#define VIEW16                                                    \
	"'buffers':[{'byteLength':16,'uri':'data:;base64,"        \
	"AAAAAAAAAAAAAAAAAAAAAA=='}],'bufferViews':[{'buffer':0," \
	"'byteLength':16}]"
#define NAN_VIEW                                                      \
	"'buffers':[{'byteLength':4,'uri':'data:;base64,AADAfw=='}]," \
	"'bufferViews':[{'buffer':0,'byteLength':4}]"
#define ZEROS(type, component, count) \
	"{'type':'" type "','componentType':" component ",'count':" count "}"
#define ACCESSORS(list)    "'accessors':[" list "]"
#define VEC3               ZEROS("VEC3", "5126", "3")
#define VEC4               ZEROS("VEC4", "5126", "3")
#define PRIMITIVE(members) "'meshes':[{'primitives':[{" members "}]}]"
#define ATTRIBUTES(list)   PRIMITIVE("'attributes':{" list "}")

static void test_names_line_and_column_of_wrong_json(void **state)
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

static void test_refuses_what_is_no_model(void **state)
{
	struct log_capture heard;
	struct log log = log_capture_begin(&heard);
	struct model *model;

	(void)state;
	assert_int_equal(model_load_memory("", 0, "e", &log, &model), -EINVAL);
	assert_string_equal(heard.sentence[0], "e: the file is empty");
	expect_code("solid cube", -ENOTSUP, "t.gltf: the format is unknown");
	expect_code("[]", -ENOTSUP, "t.gltf: the format is unknown");
	expect_code(" ", -ENOTSUP, "t.gltf: the format is unknown");
}

static void test_refuses_other_versions(void **state)
{
	(void)state;
	expect_code("{'asset':{'version':'1.0'}}", -ENOTSUP,
		"t.gltf: /asset: is glTF 1.0; limber reads glTF 2.0");
	expect_code("{'asset':{'version':'20'}}", -ENOTSUP, "is glTF 20;");
	expect_code("{'asset':{'version':'2.1','minVersion':'2.1'}}", -ENOTSUP,
		"/asset: is glTF 2.1;");
	expect_code("{'asset':{}}", -EINVAL, "t.gltf: /asset: has no \"version\"");
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

static void test_keeps_control_characters_off_the_terminal(void **state)
{
	(void)state;
	expect_code("{'asset':{'version':'\\u001b[2J'}}", -ENOTSUP,
		"/asset: is glTF ?[2J;");
}

static void test_refuses_values_of_wrong_kinds(void **state)
{
	static const struct broken broken[] = {
		{"'nodes':{}", "/nodes: is not an array"},
		{"'nodes':[1]", "/nodes/0: is not an object"},
		{"'nodes':[{'name':1}]", "/nodes/0/name: is not a string"},
		{"'nodes':[{'mesh':'0'}]",
			"/nodes/0/mesh: is not an integer"},
		{"'nodes':[{'mesh':0.5}]",
			"/nodes/0/mesh: is not an integer"},
		{"'nodes':[{'mesh':1e300}]",
			"/nodes/0/mesh: is not an integer"},
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

static void test_refuses_broken_primitives(void **state)
{
	static const struct broken broken[] = {
		{PRIMITIVE("'mode':7"),
			"/meshes/0/primitives/0/mode: 7 is out of range (0 to 6)"},
		{PRIMITIVE("'attributes':[]"),
			"/meshes/0/primitives/0/attributes: is not an object"},
		{ACCESSORS(VEC3 "," VEC3 "," VEC3 "," VEC3
				"," VEC3) "," ATTRIBUTES("'POSITION':7"),
			"/meshes/0/primitives/0/attributes/POSITION: accessor 7 does not exist (the file has 5)"},
		{ACCESSORS(VEC4) "," ATTRIBUTES("'POSITION':0"),
			"/meshes/0/primitives/0/attributes/POSITION: accessor 0 is VEC4 instead of VEC3"},
		{ACCESSORS(VEC3 "," ZEROS("VEC3", "5126", "4")) "," ATTRIBUTES(
			 "'POSITION':0,'NORMAL':1"),
			"/meshes/0/primitives/0/attributes/NORMAL: has 4 elements, but POSITION has 3"},
		{ACCESSORS(ZEROS("VEC3", "5125", "3")) "," ATTRIBUTES(
			 "'POSITION':0"),
			"/attributes/POSITION: componentType 5125 is allowed for indices only"},
		{ACCESSORS(VEC3) "," PRIMITIVE("'attributes':{'POSITION':0},"
					       "'material':0"),
			"/meshes/0/primitives/0/material: material 0 does not exist"},
		{ACCESSORS(VEC3 "," ZEROS("SCALAR", "5126", "3")) "," PRIMITIVE(
			 "'attributes':{'POSITION':0},'indices':1"),
			"/meshes/0/primitives/0/indices: accessor 1 does not hold unsigned integers"},
		{NAN_VIEW "," ACCESSORS(VEC3
			 ",{'bufferView':0,'type':'SCALAR',"
			 "'componentType':5121,'count':3}") "," PRIMITIVE("'attributes':{'POSITION':0},'indices':1"),
			"/meshes/0/primitives/0/indices: index 2 refers to vertex 192, but there are only 3"},
		{NAN_VIEW "," ACCESSORS(
			 "{'type':'VEC3','componentType':5126,'count':3,"
			 "'sparse':{'count':1,'indices':{'bufferView':0,"
			 "'componentType':5121},'values':{'bufferView':0}}}"),
			"/accessors/0/sparse/values: needs 12 bytes"},
	};

	(void)state;
	EXPECT_ALL(broken);
}

static void test_refuses_numbers_that_are_not_finite(void **state)
{
	static const struct broken broken[] = {
		{NAN_VIEW ",'nodes':[{}]," ACCESSORS(
			 "{'bufferView':0,'type':'SCALAR',"
			 "'componentType':5126,'count':1}," VEC3) ",'animations':[{'samplers':[{'input':0,'output':1}],"
								  "'channels':[{'sampler':0,'target':{'node':0,"
								  "'path':'scale'}}]}]",
			"/animations/0/samplers/0/input: element 0 of accessor 0 is not finite"},
	};

	(void)state;
	EXPECT_ALL(broken);
}

static void test_refuses_broken_targets_and_weights(void **state)
{
	static const struct broken broken[] = {
		{ACCESSORS(VEC3 "," ZEROS("VEC3", "5126", "2")) "," PRIMITIVE(
			 "'attributes':{'POSITION':0},"
			 "'targets':[{},{'POSITION':1}]"),
			"/meshes/0/primitives/0/targets/1/POSITION: has 2 elements, but POSITION has 3"},
		{ACCESSORS(VEC3) ",'meshes':[{'primitives':["
				 "{'attributes':{'POSITION':0},'targets':[{}]},"
				 "{'attributes':{'POSITION':0}}]}]",
			"/meshes/0/primitives/1: has 0 targets, but the mesh's first primitive has 1"},
		{ACCESSORS(VEC3) ",'meshes':[{'weights':[1,2],'primitives':["
				 "{'attributes':{'POSITION':0},'targets':[{}]}]"
				 "}]",
			"/meshes/0/weights: has 2 numbers instead of 1"},
		{ACCESSORS(VEC3) ",'nodes':[{'mesh':0,'weights':[]}]"
				 "," PRIMITIVE("'attributes':{'POSITION':0},'"
					       "targets':[{}]"),
			"/nodes/0/weights: has 0 numbers instead of 1"},
	};

	(void)state;
	EXPECT_ALL(broken);
}

#define JOINTS(type, component) \
	ACCESSORS(VEC3 "," ZEROS(type, component, "3") "," VEC4)
#define SKINNED "'attributes':{'POSITION':0,'JOINTS_0':1,'WEIGHTS_0':2}"

static void test_refuses_broken_skins(void **state)
{
	static const struct broken broken[] = {
		{"'skins':[{}]", "/skins/0: has no joints"},
		{"'skins':[{'joints':[0]}]",
			"/skins/0/joints/0: node 0 does not exist"},
		{"'nodes':[{}],'skins':[{'joints':[0],'skeleton':1}]",
			"/skins/0/skeleton: node 1 does not exist"},
		{"'nodes':[{},{}]," ACCESSORS(ZEROS(
			 "MAT4", "5126", "1")) ",'skins':[{'joints':[0,1],'"
					       "inverseBindMatrices':0}]",
			"/skins/0/inverseBindMatrices: has 1 matrices for 2 joints"},
		{"'nodes':[{}]," ACCESSORS(
			 ZEROS("MAT4", "5121", "1")) ",'skins':[{'joints':[0],'"
						     "inverseBindMatrices':0}]",
			"/skins/0/inverseBindMatrices: does not hold floats"},
		{"'nodes':[{'skin':0}]", "/nodes/0/skin: skin 0 does not"},
		{JOINTS("VEC4", "5121") "," ATTRIBUTES(
			 "'POSITION':0,'JOINTS_0':1"),
			"/attributes: has JOINTS_0 without WEIGHTS_0"},
		{JOINTS("VEC4", "5121") "," ATTRIBUTES(
			 "'POSITION':0,'WEIGHTS_0':2"),
			"/attributes: has WEIGHTS_0 without JOINTS_0"},
		{JOINTS("VEC4", "5121") "," ATTRIBUTES(
			 "'POSITION':0,'JOINTS_0':1,'WEIGHTS_0':2,"
			 "'JOINTS_1':1"),
			"/attributes: has JOINTS_1 without WEIGHTS_1"},
		{JOINTS("VEC4", "5126") "," PRIMITIVE(SKINNED),
			"/attributes/JOINTS_0: does not hold unsigned bytes or shorts"},
		{ACCESSORS(VEC3 "," ZEROS(
			 "VEC4", "5121", "2") "," VEC4) "," PRIMITIVE(SKINNED),
			"/attributes/JOINTS_0: has 2 elements, but POSITION has 3"},
		{JOINTS("VEC3", "5121") "," PRIMITIVE(SKINNED),
			"/attributes/JOINTS_0: accessor 1 is VEC3 instead of VEC4"},
		{NAN_VIEW "," ACCESSORS(ZEROS("VEC3", "5126",
			 "1") ",{'bufferView':0,'type':'VEC4','"
			      "componentType':5121,"
			      "'normalized':false,'count':1}"
			      ",{'bufferView':0,'type':'VEC4','"
			      "componentType':5121,"
			      "'normalized':true,'count':1}") ",'nodes':[{'mesh':0,'skin':0},{'mesh':0,'skin':1}],"
							      "'skins':[{'joints':[0,1]},{'joints':[1]}]," PRIMITIVE(
								      SKINNED),
			"/meshes/0/primitives/0: a vertex uses joint 192, but skin 1 has 1"},
	};

	(void)state;
	EXPECT_ALL(broken);
}

static void test_refuses_broken_node_trees(void **state)
{
	static const struct broken broken[] = {
		{"'nodes':[{'children':[1]}]",
			"/nodes/0/children/0: node 1 does not exist"},
		{"'nodes':[{'children':[0]}]", "/nodes/0: is an ancestor of itself"},
		{"'nodes':[{},{'children':[2]},{'children':[3,0]},"
		 "{'children':[1]}]",
			": is an ancestor of itself"},
		{"'nodes':[{'children':[2]},{'children':[2]},{}]",
			"/nodes/1/children/0: node 2 is already a child of node 0"},
		{"'nodes':[{'children':[1,1]},{}]",
			"/nodes/0/children/1: node 1 is already a child of node 0"},
		{"'nodes':[{'rotation':[0,0,0,0]}]",
			"/nodes/0/rotation: is a quaternion of length 0"},
		{"'nodes':[{'matrix':[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"
		 "'scale':[1,1,1]}]",
			"/nodes/0: has a matrix and also a"},
		{"'nodes':[{'matrix':[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,2]}]",
			"/nodes/0/matrix: the last row is not 0 0 0 1"},
		{"'nodes':[{'matrix':[1]}]",
			"/nodes/0/matrix: has 1 numbers instead of 16"},
		{"'scene':1,'scenes':[{}]",
			"/scene: scene 1 does not exist (the file has 1)"},
		{"'scenes':[{'nodes':[0]}]",
			"/scenes/0/nodes/0: node 0 does not exist"},
	};

	(void)state;
	EXPECT_ALL(broken);
}

static void test_refuses_broken_cameras(void **state)
{
	static const struct broken broken[] = {
		{"'cameras':[{}]", "/cameras/0: has no \"type\""},
		{"'cameras':[{'type':'fish'}]",
			"/cameras/0/type: \"fish\" is not defined by glTF 2.0"},
		{"'cameras':[{'type':'perspective'}]",
			"/cameras/0/perspective: has no \"yfov\""},
		{"'cameras':[{'type':'perspective','perspective':{'yfov':0}}]",
			"/cameras/0/perspective/yfov: is not greater than 0"},
		{"'cameras':[{'type':'perspective','perspective':{'yfov':1,"
		 "'znear':1,'zfar':1}}]",
			"/cameras/0/perspective/zfar: is not greater than znear"},
		{"'cameras':[{'type':'perspective','perspective':{'yfov':1,"
		 "'znear':1,'aspectRatio':-1}}]",
			"/cameras/0/perspective/aspectRatio: is not greater than 0"},
		{"'cameras':[{'type':'orthographic','orthographic':{'xmag':1,"
		 "'ymag':1,'znear':-1,'zfar':1}}]",
			"/cameras/0/orthographic/znear: is negative"},
	};

	(void)state;
	EXPECT_ALL(broken);
}

#define TEXTURED                                                    \
	"'materials':[{'pbrMetallicRoughness':{'baseColorTexture':" \
	"{'index':0}}}]"

static void test_refuses_broken_materials(void **state)
{
	static const struct broken broken[] = {
		{"'materials':[{'alphaMode':'GLOW'}]",
			"/materials/0/alphaMode: \"GLOW\" is not defined by glTF 2.0"},
		{TEXTURED,
			"/materials/0/pbrMetallicRoughness/baseColorTexture/index: texture 0 does not exist"},
		{TEXTURED ",'textures':[{'source':0}]",
			"/textures/0/source: image 0 does not exist"},
		{TEXTURED ",'textures':[{'sampler':0}]",
			"/textures/0/sampler: sampler 0 does not exist"},
		{TEXTURED ",'textures':[{'sampler':0}],'samplers':[{'wrapS':"
			  "1}]",
			"/samplers/0/wrapS: wrap mode 1 is not defined by glTF 2.0"},
		{TEXTURED ",'textures':[{'sampler':0}],'samplers':[{"
			  "'magFilter':1}]",
			"/samplers/0/magFilter: 1 is out of range (9728 to 9729)"},
		{TEXTURED ",'textures':[{'source':0}],'images':[{}]",
			"/images/0: has neither a uri nor a bufferView"},
		{TEXTURED ",'textures':[{'source':0}],'images':[{'uri':"
			  "'data:;base64,iVBORw0KGgoAAAA='}]",
			"/images/0: the PNG image is broken: the file is truncated"},
		{TEXTURED ",'textures':[{'source':0}],'images':[{"
			  "'bufferView':0}]",
			"/images/0/bufferView: bufferView 0 does not exist"},
	};

	(void)state;
	EXPECT_ALL(broken);
	expect_code(
		"{'asset':{'version':'2.0'}," TEXTURED
		",'textures':[{'source':0}],'images':[{'bufferView':0}]," VIEW16
		"}",
		-ENOTSUP, "/images/0: the image is neither PNG nor JPEG");
}

#define CLIP(samplers, channels)                                              \
	"'nodes':[{},{}]," ACCESSORS(ZEROS(                                   \
		"SCALAR", "5126", "1") "," VEC3 "," ZEROS("SCALAR", "5126",   \
		"2") "," ZEROS("VEC4", "5126", "1") "," ZEROS("VEC3", "5126", \
		"1")) ",'animations':[{'samplers':[" samplers                 \
		      "],'channels':[" channels "]}]"
#define CHANNEL(path)          "{'sampler':0,'target':{'node':0,'path':'" path "'}}"
#define SAMPLER(input, output) "{'input':" input ",'output':" output "}"

static void test_refuses_broken_animations(void **state)
{
	static const struct broken broken[] = {
		{CLIP("", "{}"),
			"/animations/0/channels/0: has no \"target\""},
		{CLIP("", "{'target':{'node':0}}"),
			"/animations/0/channels/0: has no \"sampler\""},
		{CLIP("", CHANNEL("scale")),
			"/animations/0/channels/0/sampler: sampler 0 does not exist"},
		{CLIP("{}",
			 "{'sampler':0,'target':{'node':2,'path':"
			 "'scale'}}"),
			"/animations/0/channels/0/target/node: node 2 does not exist (the file has 2)"},
		{CLIP("{}", "{'sampler':0,'target':{'node':0}}"),
			"/animations/0/channels/0/target: has no \"path\""},
		{CLIP("{}", CHANNEL("colour")),
			"/animations/0/channels/0/target/path: \"colour\" is not defined by glTF 2.0"},
		{CLIP("{}", CHANNEL("weights")),
			"/animations/0/channels/0/target: node 0 has no morph targets"},
		{CLIP("{}", CHANNEL("scale")),
			"/animations/0/samplers/0: has no \"input\""},
		{CLIP(SAMPLER("0", "9"), CHANNEL("scale")),
			"/animations/0/samplers/0/output: accessor 9 does not exist"},
		{CLIP(SAMPLER("1", "1"), CHANNEL("scale")),
			"/animations/0/samplers/0/input: accessor 1 is VEC3 instead of SCALAR"},
		{"'nodes':[{}]," ACCESSORS(ZEROS("SCALAR", "5121",
			 "1") "," VEC3) ",'animations':[{'samplers':[" SAMPLER("0",
			 "1") "],'channels':[" CHANNEL("scale") "]}]",
			"/animations/0/samplers/0/input: does not hold floats"},
		{CLIP(SAMPLER("0", "3"), CHANNEL("scale")),
			"/animations/0/samplers/0/output: accessor 3 is VEC4 instead of VEC3"},
		{CLIP(SAMPLER("0", "1"), CHANNEL("scale")),
			"/animations/0/samplers/0/output: has 9 numbers, but 1 keys need 3"},
		{CLIP("{'input':0,'output':4,'interpolation':'CUBICSPLINE'}",
			 CHANNEL("scale")),
			"/animations/0/samplers/0/output: has 3 numbers, but 1 keys need 9"},
		{CLIP("{'input':0,'output':4,'interpolation':'SLOW'}",
			 CHANNEL("scale")),
			"/animations/0/samplers/0/interpolation: \"SLOW\" is not defined by glTF 2.0"},
		{CLIP(SAMPLER("2", "4"), CHANNEL("scale")),
			"/animations/0/samplers/0/input: key 1 at 0 s does not come after key 0 at 0 s"},
		{CLIP(SAMPLER("0", "3"), CHANNEL("rotation")),
			"/animations/0/samplers/0/output: is a quaternion of length 0"},
		{CLIP(SAMPLER("0", "4"), CHANNEL("scale") "," CHANNEL("scale")),
			"/animations/0/channels/1/target: another channel of this animation has the same node and path"},
	};

	(void)state;
	EXPECT_ALL(broken);
}

/* Each claims 2^32 bytes or close to it, which 32 bits do not hold. */
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

/* A few bytes of JSON must not claim the machine's memory. */
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
	size_t count = 1100000;
	char *text = malloc(count + 64);

	(void)state;
	assert_non_null(text);
	strcpy(text, "{'asset':{'version':'2.0'},'x':[");
	memset(text + strlen(text), '[', count);
	text[count] = '\0';
	expect_code(text, -EFBIG, "t.gltf: has more than 1048576 JSON values");
	text[100000] = '\0';
	expect_code(text, -EINVAL, "maximum parsing depth reached");
	free(text);
}

/* The bytes 3 0 3 0, for numbers that are just one too large. */
#define THREES                                                        \
	"'buffers':[{'byteLength':4,'uri':'data:;base64,AwADAA=='}]," \
	"'bufferViews':[{'buffer':0,'byteLength':4}]"

static void test_refuses_numbers_that_are_one_too_large(void **state)
{
	static const struct broken broken[] = {
		{THREES "," ACCESSORS(VEC3
			 ",{'bufferView':0,'type':'SCALAR',"
			 "'componentType':5121,'count':3}") "," PRIMITIVE("'attributes':{'POSITION':0},'indices':1"),
			"/indices: index 0 refers to vertex 3, but there are only 3"},
		{THREES "," ACCESSORS(
			 "{'type':'SCALAR','componentType':5126,'count':3,"
			 "'sparse':{'count':1,'indices':{'bufferView':0,"
			 "'componentType':5121}}}"),
			"/sparse/indices: index 3 is out of range (the accessor has 3 elements)"},
		{THREES "," ACCESSORS(ZEROS("VEC3", "5126",
			 "1") ",{'bufferView':0,'type':'VEC4',"
			      "'componentType':5121,'count':1}"
			      ",{'bufferView':0,'type':'VEC4',"
			      "'componentType':5121,'count':1}") ",'nodes':[{'mesh':0,'skin':0},{},{}],"
								 "'skins':[{'joints':[0,1,2]}]," PRIMITIVE(
									 SKINNED),
			"a vertex uses joint 3, but skin 0 has 3"},
	};

	(void)state;
	EXPECT_ALL(broken);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_names_line_and_column_of_wrong_json),
		cmocka_unit_test(test_refuses_what_is_no_model),
		cmocka_unit_test(test_refuses_other_versions),
		cmocka_unit_test(test_refuses_unknown_required_extensions),
		cmocka_unit_test(test_keeps_control_characters_off_the_terminal),
		cmocka_unit_test(test_refuses_values_of_wrong_kinds),
		cmocka_unit_test(test_refuses_broken_buffers_and_views),
		cmocka_unit_test(test_refuses_broken_accessors),
		cmocka_unit_test(test_refuses_broken_sparse_accessors),
		cmocka_unit_test(test_refuses_broken_primitives),
		cmocka_unit_test(test_refuses_numbers_that_are_not_finite),
		cmocka_unit_test(test_refuses_broken_targets_and_weights),
		cmocka_unit_test(test_refuses_broken_skins),
		cmocka_unit_test(test_refuses_broken_node_trees),
		cmocka_unit_test(test_refuses_broken_cameras),
		cmocka_unit_test(test_refuses_broken_materials),
		cmocka_unit_test(test_refuses_broken_animations),
		cmocka_unit_test(test_limits_the_size_of_an_accessor),
		cmocka_unit_test(test_limits_the_memory_of_a_model),
		cmocka_unit_test(test_limits_the_number_of_json_values),
		cmocka_unit_test(test_refuses_numbers_that_are_one_too_large),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
