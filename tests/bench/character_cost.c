/*
 * Plays a character on the timing model (tests/arm1136). Region 1 is a frame of
 * two blended clips and a masked layer, region 2 the same during a transition,
 * region 3 a frame of one clip.
 *
 *	character_cost MODEL FRAMES
 *
 * MODEL is assets/walker.glb. Prints "joints N"; whoever reads the report of
 * the model divides by joints and frames.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <jansson.h>

#include "app/character/character.h"
#include "tests/arm1136/marker.h"

static char text[] =
	"[parameter speed]\nrange = 0 2\nstart = 1.5\n"
	"[state blend]\nblend = speed, idle 0, walk 1, run 2\n"
	"[state single]\nclip = walk\n"
	"[clip walk]\nmarks = 0 0.55\n[clip run]\nmarks = 0 0.35\n"
	"[layer wave]\nclip = wave\nmask = shoulder.R\nweight = 0.7\non = no\n"
	"[buttons]\nUP = on wave\nDOWN = go single\nLEFT = go blend\n"
	"RIGHT = off wave\n";

static void run(
	struct character *character, double *now_s, int frames, int region)
{
	for (int i = 0; i < frames; i++) {
		struct character_frame frame = {.time_s = *now_s};

		*now_s += 0.04;
		switch (region) {
		case 1:
			MARKER_BEGIN(1);
			character_update(character, &frame);
			MARKER_END(1);
			break;
		case 2:
			MARKER_BEGIN(2);
			character_update(character, &frame);
			MARKER_END(2);
			break;
		case 3:
			MARKER_BEGIN(3);
			character_update(character, &frame);
			MARKER_END(3);
			break;
		default:
			character_update(character, &frame);
		}
	}
}

static void press(struct character *character, enum button button)
{
	struct button_event event = {.button = button, .down = true};

	character_press(character, &event);
	event.down = false;
	character_press(character, &event);
}

int main(int argc, char **argv)
{
	struct log log = log_to_stderr(LOG_WARNING);
	struct model *model;
	struct instance *instance;
	struct character *character;
	FILE *file = fmemopen(text, strlen(text), "r");
	double now_s = 0.0;
	int frames = argc == 3 ? atoi(argv[2]) : 0;

	/* With a random seed, addresses would differ from run to run. */
	json_object_seed(1);
	if (frames < 1 || !file || model_load(argv[1], &log, &model) != 0) {
		fprintf(stderr, "usage: character_cost MODEL FRAMES\n");
		return 2;
	}
	if (instance_create(model, kernel_registry[0], &log, &instance) != 0 ||
		character_read(file, "cost.character", instance, &log,
			&character) != 0) {
		return EXIT_FAILURE;
	}
	press(character, BUTTON_UP);
	run(character, &now_s, 20, 0);
	run(character, &now_s, frames, 1);
	for (int i = 0; i < frames; i++) {
		press(character, i % 2 ? BUTTON_LEFT : BUTTON_DOWN);
		run(character, &now_s, 1, 0);
		run(character, &now_s, 1, 2);
	}
	press(character, BUTTON_DOWN);
	press(character, BUTTON_RIGHT);
	run(character, &now_s, 40, 0);
	run(character, &now_s, frames, 3);
	printf("joints %d\n", model->skin[0].joint_count);
	character_destroy(character);
	instance_destroy(instance);
	model_destroy(model);
	return EXIT_SUCCESS;
}
