/* Nodes and clips of exported files. */
#include "app/compare/export/export_bake.h"
#include "tests/support/model/bones.h"
#include "tests/support/model/written_glb.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	CLIPS_MAX = 2,
	CHANNELS_MAX = 3
};

static const float times[4] = {0.0f, 0.125f, 0.25f, 0.5f};
static const float values[40] = {1, 2, 3, 4};

/* A root and two nodes on it; clips without channels. */
struct fixture {
	struct bones bones;
	struct model_clip clip[CLIPS_MAX];
	struct model_channel channel[CLIPS_MAX][CHANNELS_MAX];
	struct comparison_clip compared[CLIPS_MAX];
	struct comparison comparison;
	struct written_glb written;
};

static void begin(struct fixture *f)
{
	memset(f, 0, sizeof(*f));
	bones_begin(&f->bones);
	bones_add(&f->bones, -1, 1, 2, 3);
	bones_add(&f->bones, 0, 4, 5, 6);
	bones_add(&f->bones, 0, 7, 8, 9);
	f->bones.model.clip = f->clip;
	f->bones.model.clip_count = CLIPS_MAX;
	for (int i = 0; i < CLIPS_MAX; i++) {
		f->clip[i] = (struct model_clip){
			.name = i == 0 ? "a" : "b", .channel = f->channel[i]};
		f->compared[i].clip = i;
	}
	f->comparison = (struct comparison){
		.model = &f->bones.model, .clip = f->compared};
}

static void end(struct fixture *f)
{
	written_glb_release(&f->written);
	bones_end(&f->bones);
}

/* A channel with that many of the times, whose end the clip lasts to. */
static struct model_channel *add_channel(
	struct fixture *f, int clip, int node, enum model_path path, int keys)
{
	struct model_channel *channel =
		&f->channel[clip][f->clip[clip].channel_count++];
	float *duration_s = &f->clip[clip].duration_s;

	*channel = (struct model_channel){.node = node,
		.path = path,
		.interpolation = MODEL_LINEAR,
		.width = path == MODEL_ROTATION ? 4
			: path == MODEL_WEIGHTS ? 2
						: 3,
		.key_count = keys,
		.time_s = times,
		.value = values};
	*duration_s =
		times[keys - 1] > *duration_s ? times[keys - 1] : *duration_s;
	return channel;
}

static void write_clips(struct fixture *f, bool targets)
{
	struct glb glb;

	glb_begin_memory(&glb);
	export_clips(&glb, &f->comparison, targets);
	f->written = written_glb_take(&glb);
}

/* "count type" of all accessors, one after the other. */
static void expect_accessors(const struct fixture *f, const char *wanted)
{
	char text[400] = "";
	json_t *accessor;
	size_t i;

	json_array_foreach(
		json_object_get(f->written.root, "accessors"), i, accessor)
	{
		snprintf(text + strlen(text), sizeof(text) - strlen(text),
			"%d %s%s ",
			(int)json_integer_value(
				json_object_get(accessor, "count")),
			json_string_value(json_object_get(accessor, "type")),
			json_integer_value(json_object_get(
				accessor, "componentType")) == GLB_FLOAT
				? ""
				: "!");
	}
	assert_string_equal(text, wanted);
}

static void test_channels_of_all_paths_and_interpolations(void **state)
{
	static const int16_t packed[4][4] = {{0, 0, 0, 32767}};
	struct model_channel *turn;
	struct fixture f;

	(void)state;
	begin(&f);
	f.comparison.clip_count = 2;
	add_channel(&f, 0, 1, MODEL_SCALE, 4)->interpolation = MODEL_STEP;
	add_channel(&f, 0, 2, MODEL_WEIGHTS, 4)->interpolation =
		MODEL_CUBICSPLINE;
	turn = add_channel(&f, 1, 2, MODEL_ROTATION, 4);
	turn->value = NULL;
	turn->packed = packed;
	add_channel(&f, 1, 0, MODEL_TRANSLATION, 3)->interpolation =
		MODEL_CUBICSPLINE;
	write_clips(&f, true);
	written_glb_expect(&f.written, "animations",
		"[{'channels':["
		"{'sampler':0,'target':{'node':1,'path':'scale'}},"
		"{'sampler':1,'target':{'node':2,'path':'weights'}}],"
		"'name':'a','samplers':["
		"{'input':0,'interpolation':'STEP','output':1},"
		"{'input':0,'interpolation':'CUBICSPLINE','output':2}]},"
		"{'channels':["
		"{'sampler':0,'target':{'node':2,'path':'rotation'}},"
		"{'sampler':1,'target':{'node':0,'path':'translation'}}],"
		"'name':'b','samplers':["
		"{'input':3,'interpolation':'LINEAR','output':4},"
		"{'input':5,'interpolation':'CUBICSPLINE','output':6}]}]");
	/* Three values a key of a spline, two weights a value. */
	expect_accessors(&f,
		"4 SCALAR 4 VEC3 24 SCALAR 4 SCALAR 4 VEC4! 3 SCALAR 9 VEC3 ");
	end(&f);
}

static void test_times_are_stored_once_while_they_are_the_same(void **state)
{
	static const float others[4] = {0.0f, 0.125f, 0.25f, 0.5f};
	struct fixture f;

	(void)state;
	begin(&f);
	f.comparison.clip_count = 1;
	add_channel(&f, 0, 0, MODEL_SCALE, 4);
	add_channel(&f, 0, 1, MODEL_SCALE, 4)->time_s = others;
	add_channel(&f, 0, 2, MODEL_SCALE, 4)->time_s = others;
	write_clips(&f, true);
	expect_accessors(&f, "4 SCALAR 4 VEC3 4 SCALAR 4 VEC3 4 VEC3 ");
	end(&f);
}

static void test_only_clips_that_are_compared_are_written(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	add_channel(&f, 0, 0, MODEL_SCALE, 1);
	add_channel(&f, 1, 1, MODEL_SCALE, 1);
	f.comparison.clip_count = 1;
	f.compared[0].clip = 1;
	write_clips(&f, true);
	written_glb_expect(&f.written, "animations",
		"[{'channels':["
		"{'sampler':0,'target':{'node':1,'path':'scale'}}],"
		"'name':'b','samplers':["
		"{'input':0,'interpolation':'LINEAR','output':1}]}]");
	end(&f);
}

#define STILL(sampler, node)                            \
	"{'sampler':" sampler ",'target':{'node':" node \
	",'path':'translation'}}"

/*
 * Without its weights, a clip ends with its last other key, or is missing: the
 * first node whose translation it leaves alone keeps its duration.
 */
static void test_clips_without_weights_keep_their_duration(void **state)
{
	static const float still[8] = {0.0f, 0.5f, 4, 5, 6, 4, 5, 6};
	struct fixture f;
	size_t size;

	(void)state;
	begin(&f);
	f.comparison.clip_count = 1;
	add_channel(&f, 0, 0, MODEL_TRANSLATION, 3);
	add_channel(&f, 0, 1, MODEL_SCALE, 3);
	add_channel(&f, 0, 2, MODEL_WEIGHTS, 4);
	write_clips(&f, false);
	written_glb_expect(&f.written, "animations",
		"[{'channels':[" STILL("0",
			"0") ","
			     "{'sampler':1,'target':{'node':1,'path':'scale'}}," STILL(
				     "2",
				     "1") "],'name':'a','samplers':["
					  "{'input':0,'interpolation':'LINEAR','output':1},"
					  "{'input':0,'interpolation':'LINEAR','output':2},"
					  "{'input':3,'interpolation':'STEP','output':4}]}]");
	expect_accessors(&f, "3 SCALAR 3 VEC3 3 VEC3 2 SCALAR 2 VEC3 ");
	size = (size_t)f.written.data[8] | (size_t)f.written.data[9] << 8;
	assert_memory_equal(
		f.written.data + size - sizeof(still), still, sizeof(still));
	end(&f);
}

static void test_a_clip_that_ends_in_time_needs_no_node(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.comparison.clip_count = 1;
	add_channel(&f, 0, 0, MODEL_SCALE, 4);
	add_channel(&f, 0, 2, MODEL_WEIGHTS, 4);
	write_clips(&f, false);
	written_glb_expect(&f.written, "animations",
		"[{'channels':["
		"{'sampler':0,'target':{'node':0,'path':'scale'}}],"
		"'name':'a','samplers':["
		"{'input':0,'interpolation':'LINEAR','output':1}]}]");
	end(&f);
}

/* The first node, in two keys at its rest translation. */
static void test_a_clip_of_weights_alone_holds_the_first_node(void **state)
{
	static const float still[8] = {0.0f, 0.25f, 1, 2, 3, 1, 2, 3};
	struct fixture f;

	(void)state;
	begin(&f);
	f.comparison.clip_count = 1;
	add_channel(&f, 0, 2, MODEL_WEIGHTS, 3);
	write_clips(&f, false);
	written_glb_expect(&f.written, "animations",
		"[{'channels':[" STILL("0",
			"0") "],'name':'a','samplers':["
			     "{'input':0,'interpolation':'STEP','output':1}]}]");
	expect_accessors(&f, "2 SCALAR 2 VEC3 ");
	assert_memory_equal(f.written.binary, still, sizeof(still));
	end(&f);
}

/* Node 0 is a matrix; the clip moves node 1, and then node 2 as well. */
static void test_a_clip_of_weights_alone_stays_if_a_node_can_hold_it(
	void **state)
{
	static const float matrix[4][4] = {{0}};

	(void)state;
	for (int held = 0; held < 2; held++) {
		struct fixture f;

		begin(&f);
		f.comparison.clip_count = 1;
		f.bones.node[0].matrix = matrix;
		add_channel(&f, 0, 2, MODEL_WEIGHTS, 4);
		if (!held) {
			f.bones.node[1].matrix = matrix;
			f.bones.node[2].matrix = matrix;
		}
		write_clips(&f, false);
		written_glb_expect(&f.written, "animations",
			held ? "[{'channels':[" STILL("0",
				       "1") "],'name':'a',"
					    "'samplers':[{'input':0,'interpolation':'STEP',"
					    "'output':1}]}]"
			     : "");
		end(&f);
	}
}

static void test_a_clip_without_duration_goes_with_its_weights(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.comparison.clip_count = 2;
	add_channel(&f, 0, 2, MODEL_WEIGHTS, 1);
	write_clips(&f, false);
	written_glb_expect(&f.written, "animations", "");
	end(&f);
}

/* Only the scene's roots are in it, unless joints show the meshes. */
static void test_nodes_keep_what_they_are(void **state)
{
	static const float matrix[4][4] = {{1, 2}, {3}, {4}, {5, 0, 0, 6}};
	static const int mesh[4] = {-1, 0, 1, -1};

	(void)state;
	for (int skins = 0; skins < 2; skins++) {
		json_t *levels = json_array();
		struct fixture f;
		struct glb glb;

		begin(&f);
		bones_add(&f.bones, -1, 0, 0, 0);
		f.bones.node[3].in_scene = false;
		f.bones.node[1].skin = 0;
		f.bones.node[3].skin = 1;
		f.bones.node[2].matrix = matrix;
		glb_begin_memory(&glb);
		glb_set(&glb, "meshes", json_pack("[{},{}]"));
		export_nodes(&glb, &f.bones.model, mesh, skins, false, levels);
		f.written = written_glb_take(&glb);
#define REST "'rotation':[0.0,0.0,0.0,1.0],'scale':[1.0,1.0,1.0],"
#define NODES(skin)                                                         \
	"[{'children':[1,2],'name':''," REST "'translation':[1.0,2.0,3.0]}" \
	",{'mesh':0,'name':''," REST skin "'translation':[4.0,5.0,6.0]}"    \
	",{'matrix':[1.0,2.0,0.0,0.0,3.0,0.0,0.0,0.0,4.0,0.0,0.0,0.0,5.0,"  \
	"0.0,0.0,6.0],'mesh':1,'name':''},"                                 \
	"{'name':''," REST "'translation':[0.0,0.0,0.0]}]"
		written_glb_expect(&f.written, "nodes",
			skins ? NODES("'skin':0,") : NODES(""));
		written_glb_expect(&f.written, "scenes",
			skins ? "[{'nodes':[0]}]" : "[{'nodes':[0,3]}]");
		assert_true(json_is_integer(
			json_object_get(f.written.root, "scene")));
		assert_int_equal(json_integer_value(json_object_get(
					 f.written.root, "scene")),
			0);
		json_decref(levels);
		end(&f);
	}
}

/* Nodes 1 and 2 show a mesh with two targets; all weights of node 2 are 0. */
static void test_targets_keep_their_weights_at_rest(void **state)
{
	static const int mesh[3] = {-1, 0, 0};
	struct model_mesh two = {.target_count = 2};
	float weights[4] = {0.0f, 0.5f, 0.0f, 0.0f};

	(void)state;
	for (int targets = 0; targets < 2; targets++) {
		struct fixture f;
		struct glb glb;

		begin(&f);
		f.bones.model.mesh = &two;
		f.bones.model.mesh_count = 1;
		f.bones.model.rest_weights = weights;
		for (int i = 0; i < 3; i++) {
			f.bones.node[i].mesh = mesh[i];
		}
		f.bones.node[2].weight_offset = 2;
		glb_begin_memory(&glb);
		glb_set(&glb, "meshes", json_pack("[{}]"));
		export_nodes(&glb, &f.bones.model, mesh, false, targets, NULL);
		f.written = written_glb_take(&glb);
		written_glb_expect(&f.written, "nodes",
			targets ? "[{'children':[1,2],'name':''," REST
				  "'translation':[1.0,2.0,3.0]}"
				  ",{'mesh':0,'name':''," REST
				  "'translation':[4.0,5.0,6.0],"
				  "'weights':[0.0,0.5]}"
				  ",{'mesh':0,'name':''," REST
				  "'translation':[7.0,8.0,9.0]}]"
				: "[{'children':[1,2],'name':''," REST
				  "'translation':[1.0,2.0,3.0]}"
				  ",{'mesh':0,'name':''," REST
				  "'translation':[4.0,5.0,6.0]}"
				  ",{'mesh':0,'name':''," REST
				  "'translation':[7.0,8.0,9.0]}]");
		end(&f);
	}
}

/* A model that is moved along any axis hangs on a node that moves it back. */
static void test_a_far_model_has_a_node_for_its_origin(void **state)
{
	static const char *const moved[] = {
		"[5.0,0.0,0.0]", "[0.0,5.0,0.0]", "[0.0,0.0,5.0]"};
	static const int mesh[3] = {-1, -1, -1};

	(void)state;
	for (int axis = 0; axis <= 3; axis++) {
		char wanted[512];
		struct fixture f;
		struct glb glb;

		begin(&f);
		if (axis < 3) {
			f.bones.model.origin[axis] = 5.0;
		}
		glb_begin_memory(&glb);
		export_nodes(&glb, &f.bones.model, mesh, false, false, NULL);
		export_origin(&glb, &f.bones.model);
		f.written = written_glb_take(&glb);
		snprintf(wanted, sizeof(wanted),
			"[{'children':[1,2],'name':''," REST
			"'translation':[1.0,2.0,3.0]},{'name':''," REST
			"'translation':[4.0,5.0,6.0]},{'name':''," REST
			"'translation':[7.0,8.0,9.0]}%s%s%s]",
			axis < 3 ? ",{'children':[0],'name':'origin',"
				   "'translation':"
				 : "",
			axis < 3 ? moved[axis] : "", axis < 3 ? "}" : "");
		written_glb_expect(&f.written, "nodes", wanted);
		written_glb_expect(&f.written, "scenes",
			axis < 3 ? "[{'nodes':[3]}]" : "[{'nodes':[0]}]");
		end(&f);
	}
}

/* Whichever target has one. */
static void test_any_weight_at_rest_keeps_all_of_a_node(void **state)
{
	static const char *const wanted[] = {"'weights':[0.5,0.0,0.0]",
		"'weights':[0.0,0.5,0.0]", "'weights':[0.0,0.0,0.5]"};
	static const int mesh[3] = {0, -1, -1};
	struct model_mesh three = {.target_count = 3};

	(void)state;
	for (int t = 0; t < 3; t++) {
		float weights[3] = {0.0f, 0.0f, 0.0f};
		char nodes[512];
		struct fixture f;
		struct glb glb;

		weights[t] = 0.5f;
		begin(&f);
		f.bones.model.mesh = &three;
		f.bones.model.mesh_count = 1;
		f.bones.model.rest_weights = weights;
		f.bones.node[0].mesh = 0;
		f.bones.node[1].mesh = f.bones.node[2].mesh = -1;
		glb_begin_memory(&glb);
		glb_set(&glb, "meshes", json_pack("[{}]"));
		export_nodes(&glb, &f.bones.model, mesh, false, true, NULL);
		f.written = written_glb_take(&glb);
		snprintf(nodes, sizeof(nodes),
			"[{'children':[1,2],'mesh':0,'name':''," REST
			"'translation':[1.0,2.0,3.0],%s},{'name':''," REST
			"'translation':[4.0,5.0,6.0]},{'name':''," REST
			"'translation':[7.0,8.0,9.0]}]",
			wanted[t]);
		written_glb_expect(&f.written, "nodes", nodes);
		end(&f);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_channels_of_all_paths_and_interpolations),
		cmocka_unit_test(
			test_times_are_stored_once_while_they_are_the_same),
		cmocka_unit_test(test_only_clips_that_are_compared_are_written),
		cmocka_unit_test(test_clips_without_weights_keep_their_duration),
		cmocka_unit_test(test_a_clip_that_ends_in_time_needs_no_node),
		cmocka_unit_test(
			test_a_clip_of_weights_alone_holds_the_first_node),
		cmocka_unit_test(
			test_a_clip_of_weights_alone_stays_if_a_node_can_hold_it),
		cmocka_unit_test(
			test_a_clip_without_duration_goes_with_its_weights),
		cmocka_unit_test(test_nodes_keep_what_they_are),
		cmocka_unit_test(test_targets_keep_their_weights_at_rest),
		cmocka_unit_test(test_a_far_model_has_a_node_for_its_origin),
		cmocka_unit_test(test_any_weight_at_rest_keeps_all_of_a_node),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
