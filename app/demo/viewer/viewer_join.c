#include "app/demo/viewer/viewer_join.h"

#include <errno.h>

int viewer_join_init(
	struct viewer_join *join, struct actor *actor, const struct log *log)
{
	struct arena *arena = &actor->instance->arena;
	int error = pose_init(&join->scratch, actor->model, arena);

	if (!error) {
		error = clip_cursor_init(
			&join->next_cursor, actor->model, arena);
	}
	if (error) {
		log_error(log,
			"%s: there is not enough memory to join the clips",
			actor->model->path);
	}
	return error;
}

void viewer_join_begin(struct viewer_join *join, const struct actor *actor,
	int clip, double time_s)
{
	const struct model *model = actor->model;
	int next = (clip + 1) % model->clip_count;

	join->clips = clip_join_frames(
		&model->clip[clip], &model->clip[next], CLIP_JOIN_FRAMES);
	join->clips.interpolation = actor->interpolation;
	join->time_s = time_s;
}

/* After the overlap the second clip becomes the first of a new pair. */
void viewer_join_run(
	struct viewer_join *join, struct actor *actor, int *clip, float step_s)
{
	double first_s = (double)join->clips.from->duration_s;

	join->time_s += (double)step_s;
	if (join->time_s >= first_s) {
		double into_s =
			join->time_s - first_s + (double)join->clips.overlap_s;

		*clip = (*clip + 1) % actor->model->clip_count;
		viewer_join_begin(join, actor, *clip, into_s);
	}
	clip_join_sample(&join->clips, (float)join->time_s, &actor->cursor,
		&join->next_cursor, &join->scratch, &actor->instance->pose);
}
