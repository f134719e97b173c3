/*
 * Compiles any text as a character file for a small model, and plays what was
 * accepted with every button. Expects a character or exactly one error.
 */
#include "app/character/character.h"
#include "tests/fuzz/fuzz_expect.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
	NODES = 6,
	TARGETS = 2,
	FRAMES = 12
};

/* hips - chest - arm - hand, a head with two shapes, a foot. */
static struct model_node nodes[NODES] = {
	{.name = "hips", .parent = -1},
	{.name = "chest", .parent = 0},
	{.name = "arm", .parent = 1},
	{.name = "hand", .parent = 2},
	{.name = "head", .parent = 1},
	{.name = "foot", .parent = 0},
};

static const char *target_names[TARGETS] = {"smile", ""};
static struct model_mesh mesh = {
	.name = "head", .target_count = TARGETS, .target_name = target_names};
static const float times[2] = {0.0f, 1.0f};
static const float turns[8] = {0.0f, 0.0f, 0.0f, 1.0f, 0.6f, 0.0f, 0.0f, 0.8f};
static struct model_channel channel = {.node = 2,
	.path = MODEL_ROTATION,
	.interpolation = MODEL_LINEAR,
	.unit = true,
	.width = 4,
	.key_count = 2,
	.time_s = times,
	.value = turns};
static struct model_clip clips[2] = {
	{.name = "walk",
		.duration_s = 1.0f,
		.channel_count = 1,
		.channel = &channel},
	{.name = ""},
};
static float rest_weights[TARGETS];

static struct model *make_model(struct memory_budget *budget)
{
	static struct model model;

	model = (struct model){.path = "small.glb",
		.format = "",
		.budget = budget,
		.node_count = NODES,
		.node = nodes,
		.mesh_count = 1,
		.mesh = &mesh,
		.clip_count = 2,
		.clip = clips,
		.weight_count = TARGETS,
		.rest_weights = rest_weights};
	for (int i = 0; i < NODES; i++) {
		nodes[i].mesh = nodes[i].skin = nodes[i].camera = -1;
		nodes[i].rest = (struct transform){
			{0.0f, 0.3f, 0.0f}, {0, 0, 0, 1}, {1, 1, 1}};
	}
	nodes[4].mesh = 0;
	return &model;
}

static void play(struct character *character)
{
	const struct pose *pose = &character->instance->pose;

	for (int frame = 0; frame < FRAMES; frame++) {
		struct character_frame now = {.time_s = 0.21 * frame,
			.motion_level = 0.5f,
			.eye = {0.0f, 1.0f, 3.0f}};

		for (int b = 0; b < BUTTON_COUNT; b++) {
			struct button_event event = {.button = (enum button)b,
				.down = (frame + b) % 5 < 2};

			character_press(character, &event);
		}
		character_update(character, &now);
		fuzz_expect(isfinite(pose->local[0].translation[0]));
	}
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct memory_budget budget = {.limit_bytes = 32 * 1024 * 1024};
	struct model *model = make_model(&budget);
	int errors = 0;
	struct log log = fuzz_log(&errors);
	struct instance *instance;
	struct character *character;
	FILE *file = size ? fmemopen((void *)data, size, "r") : NULL;

	if (!file) {
		return 0;
	}
	fuzz_expect(instance_create(
			    model, kernel_find("float"), &log, &instance) == 0);
	if (character_read(file, "x.character", instance, &log, &character) ==
		0) {
		fuzz_expect(errors == 0);
		play(character);
		character_destroy(character);
	} else {
		fuzz_expect(errors == 1);
	}
	instance_destroy(instance);
	fuzz_expect(budget.used_bytes == 0);
	fclose(file);
	return 0;
}
