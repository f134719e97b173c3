/*
 * Poses a model for each frame of a clip, for the timing model (tests/arm1136):
 * regions 1, 2 and 3 are sampling the clip, world matrices and palettes.
 *
 *	pose_cost MODEL CLIP FRAMES
 *
 * Plays the clip from its start at 25 frames a second and prints "joints N" for
 * all skins together, or the nodes where there is no skin. pose.sh divides.
 */
#include <stdio.h>
#include <stdlib.h>

#include <jansson.h>

#include "app/anim/clip.h"
#include "tests/arm1136/marker.h"

struct posing {
	const struct model *model;
	struct clip_cursor cursor;
	struct pose pose;
	mat4 *world;
	mat4 **palette;
};

static int prepare(struct posing *p, struct arena *arena)
{
	size_t skins = (size_t)p->model->skin_count;

	p->world = ARENA_ARRAY(arena, mat4, (size_t)p->model->node_count);
	p->palette = ARENA_ARRAY(arena, mat4 *, skins);
	if (!p->world || !p->palette) {
		return -1;
	}
	for (size_t i = 0; i < skins; i++) {
		p->palette[i] = ARENA_ARRAY(
			arena, mat4, (size_t)p->model->skin[i].joint_count);
		if (!p->palette[i]) {
			return -1;
		}
	}
	return pose_init(&p->pose, p->model, arena) ||
		clip_cursor_init(&p->cursor, p->model, arena);
}

static void pose_frame(
	struct posing *p, const struct model_clip *clip, float time_s)
{
	MARKER_BEGIN(1);
	clip_pose(clip, time_s, CLIP_AUTO, &p->cursor, &p->pose);
	MARKER_END(1);
	MARKER_BEGIN(2);
	pose_world(&p->pose, p->model, NULL, p->world);
	MARKER_END(2);
	MARKER_BEGIN(3);
	for (int i = 0; i < p->model->skin_count; i++) {
		pose_palette(&p->model->skin[i], (const mat4 *)p->world,
			p->palette[i]);
	}
	MARKER_END(3);
}

static int count_joints(const struct model *model)
{
	int joints = 0;

	for (int i = 0; i < model->skin_count; i++) {
		joints += model->skin[i].joint_count;
	}
	return joints > 0 ? joints : model->node_count;
}

int main(int argc, char **argv)
{
	struct log log = log_to_stderr(LOG_WARNING);
	struct arena arena = arena_empty();
	struct posing posing = {0};
	struct model *model;
	int clip;

	/* With a random seed, addresses would differ from run to run. */
	json_object_seed(1);
	if (argc != 4 || model_load(argv[1], &log, &model) != 0) {
		fprintf(stderr, "usage: pose_cost MODEL CLIP FRAMES\n");
		return 2;
	}
	clip = model_find_clip(model, argv[2]);
	posing.model = model;
	if (clip < 0 || prepare(&posing, &arena) != 0) {
		fprintf(stderr, "%s: no clip %s\n", argv[1], argv[2]);
		return EXIT_FAILURE;
	}
	clip_pose(&model->clip[clip], 0.0f, CLIP_AUTO, &posing.cursor,
		&posing.pose);
	for (int frame = 0; frame < atoi(argv[3]); frame++) {
		float duration_s = model->clip[clip].duration_s;

		pose_frame(&posing, &model->clip[clip],
			clip_time(frame / 25.0, duration_s, CLIP_LOOP));
	}
	printf("joints %d\n", count_joints(model));
	arena_release(&arena);
	model_destroy(model);
	return EXIT_SUCCESS;
}
