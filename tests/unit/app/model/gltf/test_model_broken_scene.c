/* Malformed meshes, skins, nodes, cameras, materials and animations. */
#include "tests/unit/app/model/gltf/broken.h"

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
		{"'buffers':[{'byteLength':12,"
		 "'uri':'data:;base64,AADAfwAAwH8AAMB/'}],"
		 "'bufferViews':[{'buffer':0,'byteLength':12}]," ACCESSORS(ZEROS(
			 "VEC3", "5126",
			 "1") ","
			      "{'bufferView':0,'type':'VEC3',"
			      "'componentType':5126,'count':1}") "," ATTRIBUTES("'POSITION':0,'COLOR_0':1"),
			"/attributes/COLOR_0: element 0 of accessor 1 is not finite"},
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
		{"'nodes':[{'children':[0]}]",
			"/nodes/0: is an ancestor of itself"},
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
		{"'cameras':[{'type':'perspective','perspective':{'yfov':1,"
		 "'znear':1,'aspectRatio':0}}]",
			"/cameras/0/perspective/aspectRatio: is not greater than 0"},
		{"'cameras':[{'type':'perspective','perspective':{'yfov':1}}]",
			"/cameras/0/perspective: has no \"znear\""},
		{"'cameras':[{'type':'orthographic','orthographic':{}}]",
			"/cameras/0/orthographic: has no \"xmag\""},
		{"'cameras':[{'type':'orthographic','orthographic':{'xmag':1}}]",
			"/cameras/0/orthographic: has no \"ymag\""},
		{"'cameras':[{'type':'orthographic','orthographic':{'xmag':1,"
		 "'ymag':0}}]",
			"/cameras/0/orthographic/ymag: is not greater than 0"},
		{"'cameras':[{'type':'orthographic','orthographic':{'xmag':1,"
		 "'ymag':1,'zfar':1}}]",
			"/cameras/0/orthographic: has no \"znear\""},
		{"'cameras':[{'type':'orthographic','orthographic':{'xmag':1,"
		 "'ymag':1,'znear':0}}]",
			"/cameras/0/orthographic: has no \"zfar\""},
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
		{TEXTURED ",'textures':[{'source':0}],'images':[{'name':'bark',"
			  "'uri':'data:;base64,iVBORw0KGgoAAAA='}]",
			"/images/0 (bark): the PNG image is broken"},
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
		-ENOTSUP,
		"/images/0: the image is neither PNG nor JPEG: convert it to one of them");
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
		{CLIP("", "{}"), "/animations/0/channels/0: has no \"target\""},
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
		{CLIP(SAMPLER("0", "3"), CHANNEL("rotation")),
			"/animations/0/samplers/0/output: is a quaternion of length 0"},
		{CLIP(SAMPLER("0", "4"), CHANNEL("scale") "," CHANNEL("scale")),
			"/animations/0/channels/1/target: another channel of this animation has the same node and path"},
	};

	(void)state;
	EXPECT_ALL(broken);
}

/* The bytes 3 0 3 0, for indices that are one too large. */
#define THREES                                                        \
	"'buffers':[{'byteLength':4,'uri':'data:;base64,AwADAA=='}]," \
	"'bufferViews':[{'buffer':0,'byteLength':4}]"

static void test_refuses_indices_that_are_one_too_large(void **state)
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
		cmocka_unit_test(test_refuses_broken_primitives),
		cmocka_unit_test(test_refuses_numbers_that_are_not_finite),
		cmocka_unit_test(test_refuses_broken_targets_and_weights),
		cmocka_unit_test(test_refuses_broken_skins),
		cmocka_unit_test(test_refuses_broken_node_trees),
		cmocka_unit_test(test_refuses_broken_cameras),
		cmocka_unit_test(test_refuses_broken_materials),
		cmocka_unit_test(test_refuses_broken_animations),
		cmocka_unit_test(test_refuses_indices_that_are_one_too_large),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
