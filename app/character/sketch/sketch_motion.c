#include "app/character/sketch/sketch_motion.h"

#include "app/anim/clip.h"
#include "app/anim/pose.h"
#include "app/character/sketch/character_sketch.h"
#include "app/character/sketch/sketch_names.h"
#include "platform/base/scalar.h"

#include <errno.h>

enum {
	STEPS = 8
};

/* A node goes away if it ends at least this part of its way from its start. */
static const float away_part = 0.6f;

/* Arrays have an element for each node. */
struct search {
	struct pose pose;
	mat4 *world;
	bool *carries;  /* whether all that is shown hangs on the node */
	bool *is_named; /* whether a file can name it */
	float (*start)[2], (*at)[2]; /* of each node, along x and z */
	float *way;                  /* how long its way is */
};

/* Marks the nodes on which all that is shown hangs. */
static void find_carriers(struct search *search, const struct model *model)
{
	int top = model_find_carrier(model);

	while (top >= 0) {
		search->carries[top] = true;
		top = model->node[top].parent;
	}
}

static int init(
	struct search *search, const struct model *model, struct arena *arena)
{
	size_t count = (size_t)model->node_count;

	search->world = ARENA_ARRAY(arena, mat4, count);
	search->carries = ARENA_ARRAY(arena, bool, count);
	search->is_named = sketch_find_named_nodes(model, arena);
	search->start = arena_alloc(arena, count, sizeof(*search->start));
	search->at = arena_alloc(arena, count, sizeof(*search->at));
	search->way = ARENA_ARRAY(arena, float, count);
	if (!search->world || !search->carries || !search->is_named ||
		!search->start || !search->at || !search->way) {
		return -ENOMEM;
	}
	find_carriers(search, model);
	return pose_init(&search->pose, model, arena);
}

static float distance(const float a[2], const float b[2])
{
	float x = a[0] - b[0], z = a[1] - b[1];

	return scalar_sqrt(x * x + z * z);
}

/* Whether the clip moves a node that carries all. */
static bool may_carry(const struct search *search, const struct model_clip *clip)
{
	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];

		if (channel->path == MODEL_TRANSLATION && !channel->constant &&
			search->carries[channel->node]) {
			return true;
		}
	}
	return false;
}

/* Follows each node that carries all through the clip. */
static void follow(struct search *search, const struct model *model,
	const struct model_clip *clip)
{
	struct clip_cursor none = {0};

	pose_rest(&search->pose, model);
	for (int step = 0; step <= STEPS; step++) {
		clip_sample(clip, clip->duration_s * (float)step / (float)STEPS,
			&none, &search->pose);
		pose_world(&search->pose, model, NULL, search->world);
		for (int i = 0; i < model->node_count; i++) {
			const float *place = search->world[i][3];
			const float now[2] = {place[0], place[2]};
			float *start = search->start[i], *at = search->at[i];

			search->way[i] = step == 0
				? 0.0f
				: search->way[i] + distance(at, now);
			for (int axis = 0; axis < 2; axis++) {
				start[axis] =
					step == 0 ? now[axis] : start[axis];
				at[axis] = now[axis];
			}
		}
	}
}

/* Returns the uppermost node that a file can name and the clip carries away. */
static int find_carried(struct search *search, const struct model *model,
	const struct model_clip *clip)
{
	if (!may_carry(search, clip)) {
		return -1;
	}
	follow(search, model, clip);
	for (int i = 0; i < model->node_count; i++) {
		if (search->carries[i] && search->is_named[i] &&
			search->way[i] > 0.0f &&
			distance(search->start[i], search->at[i]) >=
				away_part * search->way[i]) {
			return i;
		}
	}
	return -1;
}

static int find_root(struct search *search, const struct model *model)
{
	int root = -1;

	for (int i = 0;
		i < model->clip_count && i < CHARACTER_SKETCH_CLIPS && root < 0;
		i++) {
		root = find_carried(search, model, &model->clip[i]);
	}
	return root;
}

int sketch_write_motion(const struct model *model, FILE *out)
{
	struct arena arena = arena_empty();
	struct search search;
	int error, root;

	if (model->clip_count == 0) {
		return 0;
	}
	fputs("; The ground moves as the lowest vertices of each clip do. With the names\n"
	      "; of two feet, feet = LEFT RIGHT, it goes with the foot on it.\n"
	      "[motion]\nclips = yes\n",
		out);
	error = init(&search, model, &arena);
	root = error ? -1 : find_root(&search, model);
	if (root >= 0) {
		fputs("; A clip carries this node away. Below what slides a little, too, the\n"
		      "; ground moves instead if root names it:\n;root = ",
			out);
		sketch_write_name(out, model->node[root].name);
		fputc('\n', out);
	}
	fputc('\n', out);
	arena_release(&arena);
	return error;
}
