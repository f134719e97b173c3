/* Character files that limber sketches for a model. */
#include "app/character/sketch/character_sketch.h"
#include "app/character/sketch/sketch_names.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void expect_sketch(
	struct acting *acting, const struct character_sketch_play *play)
{
	char *text = acting_sketch(acting->model, play);

	acting_expect(acting, text);
	free(text);
}

static void test_a_sketch_of_each_model_is_right(void **state)
{
	static const char *const models[] = {"assets/walker.glb",
		"assets/face.glb", "assets/arm.glb",
		"tests/fixtures/gltf/mesh/weights.gltf"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(models); i++) {
		struct acting acting;

		acting_begin(&acting, models[i]);
		expect_sketch(&acting, NULL);
		acting_run_to(&acting, 1.0, 20.0);
		acting_end(&acting);
	}
}

/* The words of each sketch, of which doctor and players see only the gist. */
static void test_sketches_are_as_in_the_reference(void **state)
{
	static const char *const models[][2] = {{"assets/walker.glb", "walker"},
		{"assets/face.glb", "face"}, {"assets/arm.glb", "arm"},
		{"tests/fixtures/gltf/clip/far.gltf", "far"},
		{"tests/fixtures/gltf/mesh/weights.gltf", "weights"}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(models); i++) {
		struct log log = log_to_stderr(LOG_ERROR);
		static char wanted[16384];
		struct model *model;
		char path[128], *text;
		size_t length;
		FILE *file;

		snprintf(path, sizeof(path),
			"tests/golden/sketches/%s.character", models[i][1]);
		file = fopen(path, "r");
		assert_non_null(file);
		length = fread(wanted, 1, sizeof(wanted) - 1, file);
		wanted[length] = '\0';
		fclose(file);
		assert_int_equal(model_load(models[i][0], &log, &model), 0);
		text = acting_sketch(model, NULL);
		if (strcmp(text, wanted) != 0) {
			print_message(
				"%s: limber character %s -o %s writes it anew\n",
				path, models[i][0], path);
		}
		assert_string_equal(text, wanted);
		free(text);
		model_destroy(model);
	}
}

/* The heading of a section has room for 49 characters. */
static void test_names_of_any_length_have_a_sketch(void **state)
{
	static const char *const models[] = {"assets/walker.glb",
		"assets/arm.glb", "tests/fixtures/gltf/mesh/weights.gltf"};
	char name[72];

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(models); i++) {
		struct acting acting;

		acting_begin(&acting, models[i]);
		for (size_t length = 36; length < sizeof(name); length++) {
			memset(name, 'a', length);
			name[length] = '\0';
			name[1] = length % 2 ? ' ' : 'a';
			for (int c = 0; c < acting.model->clip_count; c++) {
				acting.model->clip[c].name = name;
			}
			for (int n = 0; n < acting.model->node_count; n++) {
				acting.model->node[n].name = name;
			}
			expect_sketch(&acting, NULL);
		}
		acting_end(&acting);
	}
}

/* Takes away the ; of lines that a reader may switch on. */
static void switch_on(char *text)
{
	char *to = text;

	for (const char *at = text; *at; at++) {
		bool begins = at == text || at[-1] == '\n';

		if (!(begins && *at == ';' && at[1] != ' ' && at[1] != '\n')) {
			*to++ = *at;
		}
	}
	*to = '\0';
}

static void test_what_a_sketch_suggests_is_right_too(void **state)
{
	static const char *const models[] = {"assets/walker.glb",
		"assets/face.glb", "assets/arm.glb",
		"tests/fixtures/gltf/mesh/weights.gltf",
		"tests/fixtures/gltf/skin/and_morph.gltf"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(models); i++) {
		struct acting acting;
		char *text;

		acting_begin(&acting, models[i]);
		text = acting_sketch(acting.model, NULL);
		switch_on(text);
		acting_expect(&acting, text);
		acting_run_to(&acting, 1.0, 20.0);
		free(text);
		acting_end(&acting);
	}
}

static void test_a_sketch_names_the_node_of_a_morph_if_it_is_the_first(
	void **state)
{
	struct acting acting;
	char *text;

	(void)state;
	acting_begin(&acting, "tests/fixtures/gltf/mesh/weights.gltf");
	for (int i = 0; i < acting.model->node_count; i++) {
		acting.model->node[i].name = i ? "other" : "shape";
	}
	acting.model->node[model_find_morphed(acting.model)].name = "face";
	text = acting_sketch(acting.model, NULL);
	assert_contains(text, "[morph shape]\nnode = face\ntime = 0.6\n");
	free(text);
	/* An earlier node of that name would be taken for it. */
	if (model_find_morphed(acting.model) > 0) {
		acting.model->node[0].name = "face";
		text = acting_sketch(acting.model, NULL);
		assert_contains(text, "[morph shape]\ntime = 0.6\n");
		free(text);
	}
	acting_end(&acting);
}

/* Clips in which a sketch has to write numbers in place of names. */
static void test_a_sketch_holds_any_names(void **state)
{
	static const char *const names[] = {"", "0", "a ;b] \"c\"", "0",
		"Armature|walk, \xc3\xa9 # = [1] and a name that is longer than a line"};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (int i = 0; i < 5; i++) {
		acting.model->clip[i].name = names[i];
	}
	expect_sketch(&acting, NULL);
	assert_int_equal(acting.character->machine.state_count, 5);
	for (int i = 0; i < 5; i++) {
		const struct character_state *one =
			&acting.character->machine.state[i];

		assert_ptr_equal(one->entry[0].of->clip, &acting.model->clip[i]);
	}
	acting_end(&acting);
}

/* Targets without a name of their own, and one that is called as a number. */
static void test_a_sketch_names_each_target(void **state)
{
	const char *names[] = {"", "smile", "smile", "0"};
	struct model_mesh mesh = {.target_count = 4, .target_name = names};
	char *text = NULL;
	size_t size = 0;
	FILE *out = open_memstream(&text, &size);

	(void)state;
	assert_non_null(out);
	for (int i = 0; i < 4; i++) {
		sketch_write_target(out, &mesh, i);
		fputc(' ', out);
	}
	fclose(out);
	assert_string_equal(text, "00 smile 2 0 ");
	free(text);
}

static bool has_morph_button(const struct acting *acting)
{
	const struct character_binding *one = acting->character->binding;

	while (one && one->action->verb != CHARACTER_MORPH) {
		one = one->next;
	}
	return one;
}

static void find_ball(const char *text, float place[3])
{
	const char *line = strstr(text, ";place = ");

	assert_non_null(line);
	assert_int_equal(sscanf(line, ";place = %f %f %f", &place[0], &place[1],
				 &place[2]),
		3);
}

/* Of the walker with a root that is moved and scaled. */
static char *sketch_moved(const float shift[3], float scale)
{
	struct acting acting;
	char *text;

	acting_begin(&acting, "assets/walker.glb");
	for (int n = 0; n < acting.model->node_count; n++) {
		struct transform *rest = &acting.model->node[n].rest;

		for (int axis = 0; axis < 3; axis++) {
			rest->translation[axis] *= scale;
			rest->translation[axis] +=
				acting.model->node[n].parent < 0 ? shift[axis]
								 : 0.0f;
		}
	}
	text = acting_sketch(acting.model, NULL);
	acting_end(&acting);
	return text;
}

static void test_a_sketch_fits_models_anywhere_and_of_any_size(void **state)
{
	static const float none[3] = {0}, far[3] = {1000.0f, 0.0f, -2000.0f};
	static const float scale[] = {0.004f, 100.0f};
	float near[3], place[3];
	char *text = sketch_moved(none, 1.0f);

	(void)state;
	find_ball(text, near);
	free(text);
	text = sketch_moved(far, 1.0f);
	find_ball(text, place);
	free(text);
	for (int axis = 0; axis < 3; axis++) {
		assert_near(place[axis], near[axis] + far[axis], 0.02);
	}
	for (size_t i = 0; i < ARRAY_COUNT(scale); i++) {
		text = sketch_moved(none, scale[i]);
		find_ball(text, place);
		assert_near(place[1], near[1] * scale[i], 0.02 * scale[i]);
		free(text);
	}
}

/* Shapes that a clip moves are left to the clip. */
static void test_a_sketch_leaves_animated_shapes_alone(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "tests/fixtures/gltf/clip/cubic.gltf");
	expect_sketch(&acting, NULL);
	assert_false(has_morph_button(&acting));
	acting_end(&acting);
	acting_begin(&acting, "tests/fixtures/gltf/mesh/weights.gltf");
	expect_sketch(&acting, NULL);
	assert_true(has_morph_button(&acting));
	acting_end(&acting);
}

static void expect_moved(struct acting *acting, int part, enum button button,
	int freedom, float sign)
{
	const float *value =
		&acting->character->part[part].freedom[freedom].value;

	assert_near(*value, 0, 0);
	acting_tap(acting, button, 0.5, 20.0);
	assert_true(*value * sign > 10.0f);
}

/* A face may have 52 shapes; buttons reach all, but expressions are many lines. */
static void test_a_sketch_says_how_many_targets_it_leaves_out(void **state)
{
	static const char *name[14] = {"a", "b", "c", "d", "e", "f", "g", "h",
		"i", "j", "k", "l", "m", "n"};
	struct model_mesh mesh = {.target_count = 12, .target_name = name};
	struct model_node node = {
		.name = "face", .parent = -1, .in_scene = true, .skin = -1};
	struct model model = {.path = "face.glb",
		.node_count = 1,
		.node = &node,
		.mesh_count = 1,
		.mesh = &mesh};
	char *text = acting_sketch(&model, NULL);

	(void)state;
	assert_contains(text, ";[expression face11]\n;targets = l 1\n");
	assert_null(strstr(text, "; These are"));
	free(text);
	mesh.target_count = 14;
	text = acting_sketch(&model, NULL);
	assert_contains(text, "\n; These are 12 of the mesh's 14 targets.\n");
	assert_null(strstr(text, "face12"));
	free(text);
}

/* Models without clips and shapes, of rigid parts and of bones. */
static void test_a_sketch_of_a_still_model_moves_its_parts(void **state)
{
	static const char *const models[] = {
		"assets/arm.glb", "tests/fixtures/gltf/skin/unsorted.gltf"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(models); i++) {
		struct acting acting;

		acting_begin(&acting, models[i]);
		expect_sketch(&acting, NULL);
		assert_true(acting.character->part_count > 1);
		expect_moved(&acting, 0, BUTTON_RIGHT, CHARACTER_HEADING, 1.0f);
		expect_moved(&acting, 0, BUTTON_UP, CHARACTER_PITCH, -1.0f);
		acting_tap(&acting, BUTTON_F9, 0.1, 20.0);
		expect_moved(&acting, 1, BUTTON_DOWN, CHARACTER_PITCH, 1.0f);
		acting_end(&acting);
	}
}

static void test_a_sketch_begins_as_it_is_told(void **state)
{
	const struct character_sketch_play play = {
		.clip = 3, .rate = -2, .repeat = CLIP_PING_PONG};
	const struct character_state *first;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	expect_sketch(&acting, &play);
	first = &acting.character->machine.state[0];
	assert_string_equal(first->name, acting.model->clip[3].name);
	assert_near(*first->rate, -2, 0);
	assert_int_equal(first->repeat, CLIP_PING_PONG);
	acting_end(&acting);
}

/* The first one is the one that was asked for. */
static void test_a_sketch_of_very_many_clips_is_short_enough(void **state)
{
	enum {
		CLIPS = CHARACTER_SKETCH_CLIPS + 10
	};
	const struct character_sketch_play play = {
		.clip = CLIPS - 1, .rate = 2, .repeat = CLIP_PING_PONG};
	const struct character_machine *machine;
	struct model_clip *clips = calloc(CLIPS, sizeof(*clips)), *own;
	struct acting acting;
	int own_count;

	(void)state;
	assert_non_null(clips);
	acting_begin(&acting, "assets/walker.glb");
	own = acting.model->clip;
	own_count = acting.model->clip_count;
	for (int i = 0; i < CLIPS; i++) {
		clips[i] = own[0];
		clips[i].name = "";
	}
	acting.model->clip = clips;
	acting.model->clip_count = CLIPS;
	expect_sketch(&acting, &play);
	machine = &acting.character->machine;
	assert_int_equal(machine->state_count, CHARACTER_SKETCH_CLIPS);
	assert_ptr_equal(machine->state[0].entry[0].of->clip, &clips[CLIPS - 1]);
	assert_ptr_equal(machine->state[1].entry[0].of->clip, &clips[0]);
	acting.model->clip = own;
	acting.model->clip_count = own_count;
	acting_end(&acting);
	free(clips);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_sketch_of_each_model_is_right),
		cmocka_unit_test(test_sketches_are_as_in_the_reference),
		cmocka_unit_test(test_names_of_any_length_have_a_sketch),
		cmocka_unit_test(test_what_a_sketch_suggests_is_right_too),
		cmocka_unit_test(
			test_a_sketch_names_the_node_of_a_morph_if_it_is_the_first),
		cmocka_unit_test(test_a_sketch_names_each_target),
		cmocka_unit_test(test_a_sketch_holds_any_names),
		cmocka_unit_test(
			test_a_sketch_fits_models_anywhere_and_of_any_size),
		cmocka_unit_test(test_a_sketch_leaves_animated_shapes_alone),
		cmocka_unit_test(
			test_a_sketch_says_how_many_targets_it_leaves_out),
		cmocka_unit_test(test_a_sketch_of_a_still_model_moves_its_parts),
		cmocka_unit_test(test_a_sketch_begins_as_it_is_told),
		cmocka_unit_test(
			test_a_sketch_of_very_many_clips_is_short_enough),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
