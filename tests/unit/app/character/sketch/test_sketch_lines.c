/* What a sketch says of models with few or many clips, shapes and bones. */
#include "app/character/sketch/character_sketch.h"
#include "platform/base/compiler.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	NODES = 24,
	TARGETS = 14,
	CLIPS = CHARACTER_SKETCH_CLIPS + 1
};

struct made {
	struct model_node node[NODES];
	char name[NODES][8];
	int joint[NODES];
	struct model_skin skin;
	struct model_mesh mesh;
	const char *target[TARGETS];
	struct model_clip clip[CLIPS];
	struct model model;
};

/* A model of empty nodes, and clips that move nothing. */
static void begin(struct made *made, int nodes, int clips)
{
	memset(made, 0, sizeof(*made));
	for (int i = 0; i < NODES; i++) {
		snprintf(made->name[i], sizeof(made->name[i]), "j%d", i);
		made->node[i] = (struct model_node){.name = made->name[i],
			.parent = i - 1,
			.in_scene = true,
			.rest = {{0}, {0, 0, 0, 1}, {1, 1, 1}},
			.mesh = -1,
			.skin = -1,
			.camera = -1};
		made->joint[i] = i;
	}
	for (int i = 0; i < CLIPS; i++) {
		made->clip[i] =
			(struct model_clip){.name = "clip", .duration_s = 1};
	}
	for (int i = 0; i < TARGETS; i++) {
		made->target[i] = "shape";
	}
	made->skin =
		(struct model_skin){.joint = made->joint, .joint_count = nodes};
	made->model = (struct model){.path = "model",
		.node = made->node,
		.node_count = nodes,
		.clip = made->clip,
		.clip_count = clips};
}

/* Its first node shows a mesh with so many targets. */
static void add_shapes(struct made *made, int targets)
{
	made->mesh = (struct model_mesh){
		.target_count = targets, .target_name = made->target};
	made->node[0].mesh = 0;
	made->model.mesh = &made->mesh;
	made->model.mesh_count = 1;
}

static void add_skin(struct made *made)
{
	made->model.skin = &made->skin;
	made->model.skin_count = 1;
}

/* Looks for texts in a sketch, and for texts that it lacks; each list ends. */
static void expect(const struct model *model,
	const struct character_sketch_play *play, const char *const *has,
	const char *const *lacks)
{
	char *text = acting_sketch(model, play);

	for (; has && *has; has++) {
		assert_contains(text, *has);
	}
	for (; lacks && *lacks; lacks++) {
		assert_null(strstr(text, *lacks));
	}
	free(text);
}

#define TEXTS(...) ((const char *const[]){__VA_ARGS__, NULL})

static void test_a_parameter_is_the_rate_of_a_single_clip(void **state)
{
	static const struct {
		float rate;
		const char *range;
	} rows[] = {{1, "range = 0 3\nstart = 1\nease"},
		{0, "range = 0 3\nstart = 0\nease"},
		{0.5f, "range = 0 3\nstart = 0.5\nease"},
		{-0.5f, "range = -0.5 3\nstart = -0.5\nease"},
		{2.5f, "range = 0 3\nstart = 2.5\nease"},
		{3, "range = 0 3\nstart = 3\nease"},
		{4, "range = 0 4\nstart = 4\nease"}};
	static struct made made;

	(void)state;
	begin(&made, 1, 1);
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		const struct character_sketch_play play = {
			.rate = rows[i].rate, .repeat = CLIP_LOOP};

		expect(&made.model, &play,
			TEXTS(rows[i].range, "clip = clip\nrate = rate\nfade",
				"choices = rate camera\n", "\n[buttons rate]\n",
				"\nF10 = labels "),
			TEXTS("[buttons clips]", "F10 = row"));
	}
}

static void test_several_clips_have_rates_of_their_own(void **state)
{
	const struct character_sketch_play play = {
		.rate = 2.5f, .repeat = CLIP_LOOP};
	static struct made made;

	(void)state;
	begin(&made, 1, 2);
	expect(&made.model, NULL,
		TEXTS("choices = clips camera\n", "\n[buttons clips]\n",
			"\nF10 = row "),
		TEXTS("rate =", "[parameter rate]", "[buttons rate]",
			"; These are", "F10 = labels"));
	expect(&made.model, &play, TEXTS("\nrate = 2.5\n"),
		TEXTS("[parameter rate]"));
}

static void test_a_sketch_counts_the_clips_that_it_leaves_out(void **state)
{
	static struct made made;
	char wanted[64];

	(void)state;
	snprintf(wanted, sizeof(wanted),
		"\n; These are %d of the model's %d clips.\n", CLIPS - 1, CLIPS);
	begin(&made, 1, CLIPS - 1);
	expect(&made.model, NULL, NULL, TEXTS("; These are"));
	made.model.clip_count = CLIPS;
	expect(&made.model, NULL, TEXTS(wanted), NULL);
}

/* Alone it begins again by itself. */
static void test_a_button_plays_one_of_several_clips_again(void **state)
{
	struct acting acting;
	int count;

	(void)state;
	acting_begin(&acting, "tests/fixtures/gltf/clip/door.gltf");
	count = acting.model->clip_count;
	for (int i = 1; i < 3; i++) {
		char *text;

		acting.model->clip_count = i;
		text = acting_sketch(acting.model, NULL);
		assert_contains(text, "\nrepeat = once\n");
		assert_int_equal(
			strstr(text, "\nENTER long = next, previous ") != NULL,
			i == 2);
		free(text);
	}
	acting.model->clip_count = count;
	acting_end(&acting);
}

/* Beside clips, they are one of the things that the arrows choose. */
static void test_buttons_and_the_tour_show_shapes(void **state)
{
	static const struct {
		int targets;
		const char *tour;
		const char *behind;
	} rows[] = {{1, "period = 2\ntour = 0 morph shape next\ntour = 1 ",
			    "tour = 2 "},
		{12, "tour = 12 morph shape next\n", "tour = 13 "},
		{13, "tour = 12 morph shape next\n", "tour = 13 "}};
	static struct made made;

	(void)state;
	begin(&made, 1, 2);
	add_shapes(&made, 3);
	expect(&made.model, NULL,
		TEXTS("choices = clips shapes camera\n",
			"\n[buttons shapes]\nwhen = arrows is shapes\n"),
		TEXTS("period", "tour ="));
	made.model.clip_count = 0;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		made.mesh.target_count = rows[i].targets;
		expect(&made.model, NULL,
			TEXTS(rows[i].tour, "\nLEFT = morph shape previous ",
				"[morph shape]\nnode = j0\n"),
			TEXTS(rows[i].behind, "[buttons shapes]"));
	}
}

/* Shapes move the model: its parts are suggestions. */
static void test_parts_of_a_model_with_shapes_stay(void **state)
{
	static struct made made;
	struct model_mesh meshes[2];

	(void)state;
	begin(&made, 3, 0);
	add_shapes(&made, 2);
	meshes[0] = made.mesh;
	meshes[1] = (struct model_mesh){.primitive_count = 0};
	made.model.mesh = meshes;
	made.model.mesh_count = 2;
	made.node[1].mesh = made.node[2].mesh = 1;
	expect(&made.model, NULL, TEXTS("\n;[part j1]\n"),
		TEXTS("\n[part j1]\n", "[buttons part1]"));
}

/* A row of bones from node 0, each one length away along an axis. */
static void add_row(struct made *made, int bones, int axis, float length)
{
	begin(made, bones, 0);
	add_skin(made);
	for (int i = 1; i < bones; i++) {
		made->node[i].rest.translation[axis] = length;
	}
}

static void test_a_chain_may_begin_with_the_first_node(void **state)
{
	static struct made made;

	(void)state;
	add_row(&made, 3, 1, 1);
	expect(&made.model, NULL, TEXTS(";bones = j2 3\n", ";chain = j2 3\n"),
		NULL);
	add_row(&made, 1, 1, 1);
	expect(&made.model, NULL, NULL, TEXTS("[spring", "[target"));
}

static void test_six_chains_are_enough(void **state)
{
	static struct made made;

	(void)state;
	add_row(&made, 15, 1, 1);
	for (int i = 1; i < 15; i++) {
		made.node[i].parent = i % 2 ? 0 : i - 1;
	}
	expect(&made.model, NULL,
		TEXTS(";[spring swing6]\n;bones = j12 2\n",
			";[reach reach6]\n;chain = j12 2\n"),
		TEXTS("swing7", "reach7"));
}

/* 0.18 of the longest side aside, 0.3 before, and at 0.6 of the height. */
static void test_a_ball_is_beside_bones_of_any_direction(void **state)
{
	static const char *const wanted[] = {
		"\n;place = 2.72 0.00 1.20\n;radius = 0.12\n",
		"\n;place = 0.72 2.40 1.20\n;radius = 0.12\n",
		"\n;place = 0.72 0.00 3.20\n;radius = 0.12\n"};
	static struct made made;

	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		add_row(&made, 5, axis, 1);
		expect(&made.model, NULL, TEXTS(wanted[axis]), NULL);
	}
}

/* A hundredth of the longest side can be told, down to a billionth. */
static void test_places_in_small_models_have_more_decimals(void **state)
{
	static const struct {
		float side;
		int decimals;
	} rows[] = {{10, 2}, {1, 2}, {0.99f, 3}, {0.1f, 3}, {0.0945f, 4},
		{0.02f, 4}, {2e-7f, 9}, {2e-8f, 9}, {2e-9f, 9}};
	static struct made made;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		char *text;
		const char *place;

		add_row(&made, 2, 1, rows[i].side);
		text = acting_sketch(&made.model, NULL);
		place = strstr(text, "\n;place = ");
		assert_non_null(place);
		place = strchr(place, '.') + 1;
		assert_int_equal((int)strcspn(place, " "), rows[i].decimals);
		free(text);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_parameter_is_the_rate_of_a_single_clip),
		cmocka_unit_test(test_several_clips_have_rates_of_their_own),
		cmocka_unit_test(
			test_a_sketch_counts_the_clips_that_it_leaves_out),
		cmocka_unit_test(test_a_button_plays_one_of_several_clips_again),
		cmocka_unit_test(test_buttons_and_the_tour_show_shapes),
		cmocka_unit_test(test_parts_of_a_model_with_shapes_stay),
		cmocka_unit_test(test_a_chain_may_begin_with_the_first_node),
		cmocka_unit_test(test_six_chains_are_enough),
		cmocka_unit_test(test_a_ball_is_beside_bones_of_any_direction),
		cmocka_unit_test(test_places_in_small_models_have_more_decimals),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
