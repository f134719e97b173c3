/*
 * Plays a clip of a model as the viewer does, for the timing model
 * (tests/arm1136): region 1 samples the clip, region 2 poses the vertices.
 *
 *	play_cost MODEL CLIP RATE [INFLUENCES [WIDTH HEIGHT [MOMENTS]]]
 *
 * Plays RATE frames a second from the clip's start to its end, but at most 300;
 * CLIP "-" shows the rest pose once. Each frame finds its data in memory, as
 * after a whole picture is drawn, and the code in L1. With a size, region 3
 * draws 6 or so many moments of the clip without labels; with MOMENTS, the last
 * line prints what these pictures consist of, in the order of struct gl_counts.
 * Prints "frames N". play_check.py compares the cycles with those that
 * limber compare predicts.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <jansson.h>

#include "app/anim/clip.h"
#include "app/compare/cost/drawing.h"
#include "app/model/levels/levels_file.h"
#include "app/scene/instance/instance_play.h"
#include "tests/arm1136/marker.h"

enum {
	FRAMES_MAX = 300,
	MOMENTS = 6,
	WARM_FRAMES = 2 /* before the first: they load the code */
};

/* The box of a clip and of the rest pose, as limber compare frames them. */
static int begin_drawing(struct instance *instance, int clip, char **size,
	const struct log *log, struct drawing **out)
{
	struct bounds box = bounds_of_clip(instance, -1), shown = box;
	int error;

	if (clip >= 0) {
		shown = bounds_of_clip(instance, clip);
		bounds_join(&box, &shown);
	}
	error = drawing_create(
		instance, &box, atoi(size[0]), atoi(size[1]), log, out);
	if (!error) {
		drawing_frame(*out, &shown);
	}
	return error;
}

static void pose(struct instance *instance, const struct model_clip *clip,
	struct clip_cursor *cursor, double share)
{
	if (clip) {
		clip_pose(clip, clip->duration_s * (float)share, CLIP_AUTO,
			cursor, &instance->pose);
	}
	instance_update(instance);
}

static void print_counts(const struct gl_counts *counts)
{
	printf("counts %.0f %.0f %.0f %.0f %.0f %.0f %.0f %.0f %.0f",
		counts->calls, counts->listed, counts->vertices, counts->again,
		counts->single, counts->shaded, counts->hidden, counts->skipped,
		counts->fine);
	for (int i = 0; i < GL_WORK_KINDS; i++) {
		printf(" %.0f %.0f %.0f", counts->work[i].triangles,
			counts->work[i].rows, counts->work[i].pixels);
	}
	printf("\n");
}

static void count(struct instance *instance, const struct model_clip *clip,
	struct clip_cursor *cursor, struct drawing *drawing, int moments)
{
	struct gl_counts counts = {0};
	float extent = drawing_extent(instance);

	drawing_count(drawing, &counts, NULL);
	for (int i = 0; i < moments; i++) {
		pose(instance, clip, cursor, (i + 0.5) / moments);
		drawing_draw(drawing, instance, extent);
	}
	print_counts(&counts);
}

/* Draws the moments; counts what the pictures consist of if they are given. */
static void draw(struct instance *instance, const struct model_clip *played,
	struct clip_cursor *cursor, struct drawing *drawing, const char *given)
{
	int moments = given ? atoi(given) : MOMENTS;
	float extent = drawing_extent(instance);

	pose(instance, played, cursor, 0.0);
	drawing_draw(drawing, instance, extent); /* loads the code */
	for (int i = 0; i < moments; i++) {
		pose(instance, played, cursor, (i + 0.5) / moments);
		MARKER_BEGIN(3);
		drawing_draw(drawing, instance, extent);
		MARKER_END(3);
	}
	if (given) {
		count(instance, played, cursor, drawing, moments);
	}
}

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

/* Draws a picture, which chooses the levels of detail: facets are posed so. */
static int prepare_drawing(struct instance *instance, int clip,
	struct clip_cursor *cursor, char **size, const struct log *log,
	struct drawing **out)
{
	const struct model *model = instance->model;
	int error = begin_drawing(instance, clip, size, log, out);

	if (!error) {
		pose(instance, clip < 0 ? NULL : &model->clip[clip], cursor,
			0.0);
		drawing_draw(*out, instance, drawing_extent(instance));
	}
	return error;
}

/* Plays and draws the clip, or the rest pose if clip is -1. */
static int measure(struct instance *instance, int clip, int argc, char **argv,
	const struct log *log)
{
	const struct model *model = instance->model;
	const struct model_clip *played = clip < 0 ? NULL : &model->clip[clip];
	struct drawing *drawing = NULL;
	struct clip_cursor cursor;

	/* The timing model would take as long for drawing that comes later as
	   for all pictures: it waits for the first region. */
	if (clip_cursor_init(&cursor, model, &instance->arena) != 0 ||
		(argc > 6 &&
			prepare_drawing(instance, clip, &cursor, argv + 5, log,
				&drawing) != 0)) {
		return EXIT_FAILURE;
	}
	if (played) {
		printf("frames %d\n",
			play(instance, played, &cursor, atof(argv[3])));
	}
	if (drawing) {
		draw(instance, played, &cursor, drawing, argv[7]);
	}
	drawing_destroy(drawing);
	return EXIT_SUCCESS;
}

/* Creates an instance to play the clip; *clip becomes -1 for the rest pose. */
static struct instance *create(const struct model *model, const char *name,
	const struct log *log, int *clip)
{
	bool rests = strcmp(name, "-") == 0;
	struct instance *instance;

	*clip = rests ? -1 : model_find_clip(model, name);
	if ((*clip < 0 && !rests) ||
		instance_create_to_play(
			model, kernel_find(NULL), log, &instance) != 0) {
		return NULL;
	}
	instance->normal_mapping = false;
	return instance;
}

int main(int argc, char **argv)
{
	struct log log = log_to_stderr(LOG_WARNING);
	struct instance *instance;
	struct model *model;
	int clip, result;

	/* With a random seed, addresses would differ from run to run. */
	json_object_seed(1);
	if (argc < 4 || model_load(argv[1], &log, &model) != 0) {
		fprintf(stderr,
			"usage: play_cost MODEL CLIP RATE [INFLUENCES [WIDTH HEIGHT [MOMENTS]]]\n");
		return 2;
	}
	if (argc > 6 && levels_prepare(model, &log) != 0) {
		return EXIT_FAILURE;
	}
	instance = create(model, argv[2], &log, &clip);
	if (!instance) {
		fprintf(stderr, "%s: no clip %s\n", argv[1], argv[2]);
		return EXIT_FAILURE;
	}
	instance->max_influences = argc > 4 ? atoi(argv[4]) : 0;
	result = measure(instance, clip, argc, argv, &log);
	instance_destroy(instance);
	model_destroy(model);
	return result;
}
