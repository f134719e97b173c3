/* Clips of different nodes: layers that a sketch suggests, and their play. */
#include "app/character/sketch/character_sketch.h"
#include "app/character/sketch/sketch_layers.h"
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

enum {
	MANY = 15
};

/* What a sketch says of the first clips of a model, each of a node of its own. */
static void expect_layers(int clips, const char *first, int count)
{
	static const char title[] =
		"; Clips that move other nodes than the first one can play with it.\n";
	struct model_node node[MANY] = {{0}};
	struct model_channel channel[MANY] = {{0}};
	struct model_clip clip[MANY];
	char name[MANY][8];
	struct model model = {.node = node,
		.node_count = MANY,
		.clip = clip,
		.clip_count = clips};
	char *text = NULL, *at;
	size_t size = 0;
	FILE *out = open_memstream(&text, &size);

	for (int i = 0; i < MANY; i++) {
		snprintf(name[i], sizeof(name[i]), "c%d", i);
		channel[i].node = i;
		clip[i] = (struct model_clip){.name = name[i],
			.channel_count = 1,
			.channel = &channel[i]};
	}
	assert_non_null(out);
	assert_int_equal(sketch_write_layers(&model, 0, out), 0);
	assert_int_equal(fclose(out), 0);
	at = text;
	if (count > 0) {
		assert_memory_equal(at, title, strlen(title));
		at += strlen(title);
		assert_memory_equal(at, first, strlen(first));
	}
	for (int i = 0; i < count; i++) {
		at = strstr(at, "\n;nodes = moved\n\n");
		assert_non_null(at);
		at += strlen("\n;nodes = moved\n\n");
	}
	assert_string_equal(at, "");
	free(text);
}

static void test_twelve_layers_are_enough(void **state)
{
	static const char first[] = ";[layer c1]\n;clip = c1\n";

	(void)state;
	expect_layers(0, first, 0);
	expect_layers(1, first, 0);
	expect_layers(2, first, 1);
	expect_layers(13, first, 12);
	expect_layers(14, first, 12);
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
		cmocka_unit_test(test_twelve_layers_are_enough),
		cmocka_unit_test(test_a_layer_of_moved_nodes_leaves_others_alone),
		cmocka_unit_test(test_a_layer_may_move_what_its_clip_moves),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
