/* How straight a way is that carries a model away. */
#include "app/character/sketch/sketch_motion.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	TOP, /* it carries all, as the node below it does */
	CRATE,
	LID,
	NODES,
	CLIPS = 2,
	CHANNELS = 2,
	KEYS = 9 /* at every eighth of two seconds */
};

struct film {
	struct model_node node[NODES];
	float position[1][3];
	struct model_primitive primitive;
	struct model_mesh mesh;
	float time_s[KEYS], value[CLIPS][CHANNELS][KEYS][4];
	struct model_channel channel[CLIPS][CHANNELS];
	struct model_clip clip[CLIPS];
	struct model model;
};

static void begin(struct film *film)
{
	static const char *const names[NODES] = {"top", "crate", "lid"};

	memset(film, 0, sizeof(*film));
	film->primitive = (struct model_primitive){
		.vertex_count = 1, .position = film->position};
	film->mesh = (struct model_mesh){
		.primitive_count = 1, .primitive = &film->primitive};
	for (int i = 0; i < NODES; i++) {
		film->node[i] = (struct model_node){.name = names[i],
			.parent = i - 1,
			.in_scene = true,
			.rest = {{100, 50, -30}, {0, 0, 0, 1}, {1, 1, 1}},
			.mesh = i == LID ? 0 : -1,
			.skin = -1,
			.camera = -1};
	}
	for (int k = 0; k < KEYS; k++) {
		film->time_s[k] = 0.25f * (float)k;
	}
	for (int i = 0; i < CLIPS; i++) {
		film->clip[i] = (struct model_clip){.name = "clip",
			.duration_s = 2,
			.channel = film->channel[i]};
	}
	film->model = (struct model){.node = film->node,
		.node_count = NODES,
		.mesh = &film->mesh,
		.mesh_count = 1,
		.clip = film->clip,
		.clip_count = 1};
}

/* Adds a channel, whose keys have width numbers. */
static float *add_channel(
	struct film *film, int clip, int node, enum model_path path, int width)
{
	int i = film->clip[clip].channel_count++;

	film->channel[clip][i] = (struct model_channel){.node = node,
		.path = path,
		.interpolation = MODEL_LINEAR,
		.width = width,
		.key_count = KEYS,
		.time_s = film->time_s,
		.value = film->value[clip][i][0]};
	return film->value[clip][i][0];
}

/* Moves a node along an axis, from its place at rest. */
static void move(struct film *film, int clip, int node, int axis, float scale,
	const float way[KEYS])
{
	float *key = add_channel(film, clip, node, MODEL_TRANSLATION, 3);

	for (int k = 0; k < KEYS; k++) {
		for (int i = 0; i < 3; i++) {
			key[3 * k + i] = film->node[node].rest.translation[i] +
				(i == axis ? scale * way[k] : 0);
		}
	}
}

static void expect_root(const struct film *film, const char *root)
{
	char *text = NULL, wanted[64], *found;
	size_t size = 0;
	FILE *out = open_memstream(&text, &size);

	assert_non_null(out);
	assert_int_equal(sketch_write_motion(&film->model, out), 0);
	assert_int_equal(fclose(out), 0);
	found = strstr(text, "; A clip carries");
	if (root) {
		snprintf(wanted, sizeof(wanted), "\n;root = %s\n\n", root);
		assert_non_null(found);
		found = strstr(found, "\n;root");
		assert_non_null(found);
		assert_string_equal(found, wanted);
	} else {
		assert_null(found);
		assert_contains(text, "\nclips = yes\n\n");
	}
	free(text);
}

/* It ends at least 0.6 of its way from its start, along the ground. */
static void test_a_way_is_straight_enough(void **state)
{
	static const struct {
		float way[KEYS];
		bool goes;
	} rows[] = {{{0, 2, 1, 3, 2, 4, 5, 6, 6}, true},
		{{0, 2.25f, 1, 3, 2, 4, 5, 6, 6}, false},
		{{0, 2, 1, 3, 2, 4, 5, 6.25f, 6}, false},
		{{0, 1, 2, 3, 4, 5, 6, 7, 8}, true},
		{{0, 1, 2, 3, 4, 5, 6, 7, 0}, false},
		{{0, 0, 0, 0, 0, 0, 0, 0, 5}, true},
		{{0, 0, 0, 0, 0, 0, 0, 0, 0}, false}};
	static const float scale[] = {1, -1, 1.0f / 64};

	(void)state;
	for (int i = 0; i < 9 * (int)ARRAY_COUNT(rows); i++) {
		struct film film;
		bool goes = rows[i / 9].goes && i % 3 != 1;

		begin(&film);
		move(&film, 0, CRATE, i % 3, scale[i / 3 % 3], rows[i / 9].way);
		expect_root(&film, goes ? "crate" : NULL);
	}
}

static const float away[KEYS] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
static const float still[KEYS] = {0, 1, 0, 1, 0, 1, 0, 1, 0};

static void test_the_uppermost_node_that_goes_is_the_root(void **state)
{
	struct film film;

	(void)state;
	begin(&film);
	move(&film, 0, TOP, 2, 1, away);
	expect_root(&film, "top");
	move(&film, 0, CRATE, 2, 1, away);
	expect_root(&film, "top");
	begin(&film);
	move(&film, 0, TOP, 2, 1, still);
	move(&film, 0, CRATE, 2, 4, away);
	expect_root(&film, "crate");
	begin(&film);
	move(&film, 0, LID, 0, 1, away);
	expect_root(&film, "lid");
}

/* A quarter of a turn about z would make the way upright. */
static void test_a_clip_begins_with_the_model_at_rest(void **state)
{
	struct film film;
	float *key;

	(void)state;
	begin(&film);
	film.model.clip_count = 2;
	move(&film, 0, CRATE, 0, 1, still);
	key = add_channel(&film, 0, TOP, MODEL_ROTATION, 4);
	for (int k = 0; k < KEYS; k++) {
		key[4 * k + 2] = key[4 * k + 3] = 0.70710678f;
	}
	expect_root(&film, NULL);
	move(&film, 1, CRATE, 0, 1, away);
	expect_root(&film, "crate");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_way_is_straight_enough),
		cmocka_unit_test(test_the_uppermost_node_that_goes_is_the_root),
		cmocka_unit_test(test_a_clip_begins_with_the_model_at_rest),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
