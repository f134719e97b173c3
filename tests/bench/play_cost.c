/*
 * Plays a clip of a model as the viewer does, for the timing model
 * (tests/arm1136): region 1 samples the clip, region 2 poses the vertices.
 *
 *	play_cost MODEL CLIP RATE [INFLUENCES]
 *
 * Plays RATE frames a second from the clip's start to its end, but at most 300.
 * Each frame finds its data in memory, as after a whole picture is drawn, and
 * the code in L1. Prints "frames N". play_check.py compares the cycles with
 * those that limber compare predicts.
 */
#include <stdio.h>
#include <stdlib.h>

#include <jansson.h>

#include "app/anim/clip.h"
#include "app/scene/instance/instance.h"
#include "tests/arm1136/marker.h"

enum {
	FRAMES_MAX = 300,
	WARM_FRAMES = 2 /* before the first: they load the code */
};

static int play(struct instance *instance, const struct model_clip *clip,
	struct clip_cursor *cursor, double rate_hz)
{
	int frames = (int)((double)clip->duration_s * rate_hz);

	frames = frames < FRAMES_MAX ? frames : FRAMES_MAX;
	frames = frames > 1 ? frames : 1;
	for (int i = -WARM_FRAMES; i < frames; i++) {
		float time_s = i < 0 ? clip->duration_s * 0.5f * (float)-i
				     : (float)((double)i / rate_hz);

		if (i < 0) {
			clip_pose(clip, time_s, CLIP_AUTO, cursor,
				&instance->pose);
			instance_update(instance);
			continue;
		}
		MARKER_FLUSH(MARKER_DATA);
		MARKER_BEGIN(1);
		clip_pose(clip, time_s, CLIP_AUTO, cursor, &instance->pose);
		MARKER_END(1);
		MARKER_BEGIN(2);
		instance_update(instance);
		MARKER_END(2);
	}
	return frames;
}

int main(int argc, char **argv)
{
	struct log log = log_to_stderr(LOG_WARNING);
	struct clip_cursor cursor;
	struct instance *instance;
	struct model *model;
	int clip;

	/* With a random seed, addresses would differ from run to run. */
	json_object_seed(1);
	if (argc < 4 || model_load(argv[1], &log, &model) != 0) {
		fprintf(stderr,
			"usage: play_cost MODEL CLIP RATE [INFLUENCES]\n");
		return 2;
	}
	clip = model_find_clip(model, argv[2]);
	if (clip < 0 ||
		instance_create(model, kernel_find(NULL), &log, &instance) != 0) {
		fprintf(stderr, "%s: no clip %s\n", argv[1], argv[2]);
		return EXIT_FAILURE;
	}
	instance->normal_mapping = false;
	instance->max_influences = argc > 4 ? atoi(argv[4]) : 0;
	if (clip_cursor_init(&cursor, model, &instance->arena) != 0) {
		return EXIT_FAILURE;
	}
	printf("frames %d\n",
		play(instance, &model->clip[clip], &cursor, atof(argv[3])));
	instance_destroy(instance);
	model_destroy(model);
	return EXIT_SUCCESS;
}
