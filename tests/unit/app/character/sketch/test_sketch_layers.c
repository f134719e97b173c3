/* Clips of different nodes: layers that a sketch suggests, and their play. */
#include "app/character/sketch/character_sketch.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

static const double rate_hz = 50.0;

/* A clip "late" of two triangles, and a clip "other" of the first one. */
static void begin(struct acting *acting)
{
	acting_begin(acting, "tests/fixtures/gltf/clip/late_start.gltf");
	assert_int_equal(acting->model->clip_count, 2);
	assert_int_equal(acting->model->clip[0].channel_count, 2);
	assert_int_equal(acting->model->clip[1].channel_count, 1);
}

static void test_clips_of_the_same_node_are_no_layers(void **state)
{
	struct acting acting;
	char *text;

	(void)state;
	begin(&acting);
	text = acting_sketch(acting.model, NULL);
	assert_null(strstr(text, "[layer"));
	free(text);
	acting_end(&acting);
}

static void test_a_sketch_suggests_clips_of_other_nodes_as_layers(void **state)
{
	struct acting acting;
	char *text, *layer;

	(void)state;
	begin(&acting);
	acting.model->clip[0].channel_count = 1;
	acting.model->clip[1].channel[0].node =
		!acting.model->clip[0].channel[0].node;
	text = acting_sketch(acting.model, NULL);
	layer = strstr(
		text, "\n;[layer other]\n;clip = other\n;nodes = moved\n\n");
	assert_non_null(layer);
	while ((layer = strstr(layer, "\n;")) && layer[2] != ' ') {
		memmove(layer + 1, layer + 2, strlen(layer + 1));
	}
	acting_expect(&acting, text);
	assert_int_equal(acting.character->layer_count, 1);
	free(text);
	acting_end(&acting);
}

/* Where the second triangle is after two seconds in which both clips play. */
static float place_beside(const char *nodes)
{
	struct acting acting;
	char text[100];
	float x;

	begin(&acting);
	snprintf(text, sizeof(text),
		"[state a]\nclip = late\n[layer b]\nclip = other\n%s", nodes);
	acting_expect(&acting, text);
	acting_run_to(&acting, 2.0, rate_hz);
	x = acting.instance->world[1][3][0];
	acting_end(&acting);
	return x;
}

static void test_a_layer_of_moved_nodes_leaves_others_alone(void **state)
{
	(void)state;
	assert_near(place_beside(""), 5, 1e-5);
	assert_near(place_beside("nodes = all\n"), 5, 1e-5);
	assert_near(place_beside("nodes = moved\n"), 1.5, 0.02);
}

/* The weight of a node in the mask of the only layer. */
static float weight_of(const struct acting *acting, const char *node)
{
	int at = model_find_node(acting->model, node);

	assert_true(at >= 0);
	return acting->character->layer[0].mask[at];
}

/* The nodes that the clip moves and, with a mask, those of both. */
static void test_a_layer_may_move_what_its_clip_moves(void **state)
{
	const struct model_clip *clip;
	struct acting acting;
	int moved = 0;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	clip = &acting.model->clip[model_find_clip(acting.model, "wave")];
	acting_expect(&acting, "[layer a]\nclip = wave\nnodes = moved\n");
	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_node *node =
			&acting.model->node[clip->channel[i].node];

		assert_near(weight_of(&acting, node->name), 1, 0);
	}
	for (int i = 0; i < acting.model->node_count; i++) {
		moved += acting.character->layer[0].mask[i] > 0;
	}
	assert_in_range(moved, 1, acting.model->node_count - 1);
	acting_expect(&acting,
		"[layer a]\nclip = wave\nnodes = moved\nmask = shoulder.L\n");
	assert_near(weight_of(&acting, "upper_arm.R"), 0, 0);
	acting_expect(&acting, "[layer a]\nclip = rest\nnodes = moved\n");
	assert_near(weight_of(&acting, "upper_arm.R"), 0, 0);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_clips_of_the_same_node_are_no_layers),
		cmocka_unit_test(
			test_a_sketch_suggests_clips_of_other_nodes_as_layers),
		cmocka_unit_test(test_a_layer_of_moved_nodes_leaves_others_alone),
		cmocka_unit_test(test_a_layer_may_move_what_its_clip_moves),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
