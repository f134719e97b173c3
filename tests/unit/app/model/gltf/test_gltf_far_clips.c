/*
 * Which clips of a glTF file let a model far from the origin be moved there
 * (model_origin.h), as the loader finds before it reads them.
 */
#include "tests/unit/app/model/gltf/buffer.h"

#include <string.h>

#define FAR 1e6f

/* The numbers of all cases, as the accessors below count them. */
static const float numbers[] = {
	/* 0, 1: a triangle, and the same far away */
	0, 0, 0, 1, 0, 0, 0, 1, 0, FAR, 0, 0, FAR + 1, 0, 0, FAR, 1, 0,
	/* 2: times */
	0, 1,
	/* 3: from there to here, 4: from here to there */
	FAR, 0, 0, 0, 0, 0, 0, 0, 0, FAR, 0, 0,
	/* 5, 6: such values, between tangents that are unlike them */
	0, 0, 0, FAR, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, FAR, 0, 0, 0, 0,
	0, FAR, 0, 0, FAR, 0, 0, FAR, 0, 0, FAR, 0, 0,
	/* 7: rotations by a half turn */
	0, 0, 0, 1, 0, 0, 1, 0, 0, 0, /* a multiple of three bytes */
};

#define ACCESSOR(offset, count, type)                                   \
	"{'bufferView':0,'byteOffset':" offset ",'componentType':5126," \
	"'count':" count ",'type':'" type "'}"
#define ALL                                                                  \
	"'accessors':[" ACCESSOR("0", "3", "VEC3") "," ACCESSOR("36", "3",   \
		"VEC3") "," ACCESSOR("72", "2", "SCALAR") "," ACCESSOR("80", \
		"2", "VEC3") "," ACCESSOR("104", "2",                        \
		"VEC3") "," ACCESSOR("128", "6", "VEC3") "," ACCESSOR("200", \
		"6", "VEC3") "," ACCESSOR("272", "2", "VEC4") "]"
/* Node 0, which shows the triangle, is a child of the node that is far. */
#define PARENT                                                              \
	"'nodes':[{'mesh':0},{'children':[0],"                              \
	"'translation':[1e6,0,0]}],'meshes':[{'primitives':[{'attributes':" \
	"{'POSITION':0}}]}]"
/* Or the triangle itself is far from it. */
#define VERTICES                                                       \
	"'nodes':[{'mesh':0}],'meshes':[{'primitives':[{'attributes':" \
	"{'POSITION':1}}]}]"
#define LINEAR(output) "{'input':2,'output':" output "}"
#define CUBIC(output) \
	"{'input':2,'output':" output ",'interpolation':'CUBICSPLINE'}"
#define CHANNEL(sampler, node, path) \
	"{'sampler':" sampler ",'target':{'node':" node ",'path':'" path "'}}"
#define CLIP(samplers, channels) \
	"{'samplers':[" samplers "],'channels':[" channels "]}"
#define CLIPS(list) ",'animations':[" list "]"

struct far_case {
	const char *text;
	bool is_moved;
};

static void expect_cases(const struct far_case *cases, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		char text[2048];
		struct model *model;
		const float *at;

		snprintf(text, sizeof(text), "%s,%s", ALL, cases[i].text);
		model = buffer_model(numbers, sizeof(numbers), text);
		at = model->mesh[0].primitive[0].position[0];
		if ((model->origin[0] > 1e5 && at[0] < 1e5f) !=
			cases[i].is_moved) {
			fail_msg("%s: origin %g, corner %g", cases[i].text,
				model->origin[0], (double)at[0]);
		}
		model_destroy(model);
	}
}

#define EXPECT_CASES(cases) \
	expect_cases(cases, sizeof(cases) / sizeof((cases)[0]))

static void test_a_model_stays_where_no_clip_begins(void **state)
{
	static const struct far_case cases[] = {
		{PARENT, true},
		{PARENT CLIPS(
			 CLIP(LINEAR("3"), CHANNEL("0", "1", "translation"))),
			true},
		{PARENT CLIPS(
			 CLIP(LINEAR("4"), CHANNEL("0", "1", "translation"))),
			false},
		{PARENT CLIPS(CLIP(CUBIC("5"), CHANNEL("0", "1", "translation"))),
			true},
		{PARENT CLIPS(CLIP(CUBIC("6"), CHANNEL("0", "1", "translation"))),
			false},
		/* Nodes with a parent may begin anywhere. */
		{PARENT CLIPS(
			 CLIP(LINEAR("4"), CHANNEL("0", "0", "translation"))),
			true},
		/* Sizes are no places. */
		{PARENT CLIPS(CLIP(LINEAR("4"), CHANNEL("0", "1", "scale"))),
			true},
	};

	(void)state;
	EXPECT_CASES(cases);
}

#define TWO LINEAR("3") "," LINEAR("4")

static void test_the_first_channel_of_a_node_counts(void **state)
{
	static const struct far_case cases[] = {
		{PARENT CLIPS(CLIP(TWO, CHANNEL("0", "1", "translation"))), true},
		{PARENT CLIPS(CLIP(TWO, CHANNEL("1", "1", "translation"))),
			false},
		{PARENT CLIPS(CLIP(TWO,
			 CHANNEL("0", "0", "translation") "," CHANNEL(
				 "1", "1", "translation"))),
			false},
		{PARENT CLIPS(
			 CLIP(TWO, CHANNEL("0", "1", "translation")) "," CLIP(
				 TWO, CHANNEL("1", "1", "translation"))),
			true},
		{PARENT CLIPS(
			 CLIP(TWO, CHANNEL("1", "1", "translation")) "," CLIP(
				 TWO, CHANNEL("0", "1", "translation"))),
			false},
		{PARENT CLIPS(
			 CLIP(TWO, CHANNEL("1", "0", "translation")) "," CLIP(
				 TWO, CHANNEL("1", "1", "translation"))),
			false},
		/* Targets without a node are other extensions'. */
		{PARENT CLIPS(CLIP(TWO,
			 "{'sampler':1,'target':{'path':"
			 "'translation'}}")),
			true},
	};

	(void)state;
	EXPECT_CASES(cases);
}

/* Vertices of a node that turns must turn about its own origin. */
static void test_vertices_of_nodes_that_turn_stay(void **state)
{
	static const struct far_case cases[] = {
		{VERTICES, true},
		{VERTICES CLIPS(CLIP(LINEAR("7"), CHANNEL("0", "0", "rotation"))),
			false},
		{VERTICES CLIPS(CLIP(LINEAR("4"), CHANNEL("0", "0", "scale"))),
			false},
		{VERTICES CLIPS(CLIP(LINEAR("7") "," LINEAR("4"),
			 CHANNEL("1", "0", "scale") "," CHANNEL(
				 "0", "0", "rotation"))),
			false},
	};

	(void)state;
	EXPECT_CASES(cases);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_model_stays_where_no_clip_begins),
		cmocka_unit_test(test_the_first_channel_of_a_node_counts),
		cmocka_unit_test(test_vertices_of_nodes_that_turn_stay),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
