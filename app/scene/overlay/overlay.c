#include "app/scene/overlay/overlay.h"

#include "platform/base/name_list.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

struct overlay_motion overlay_motion_none(void)
{
	return (struct overlay_motion){.clip = -1};
}

/* Marks the joints of all skins or, without skins, all nodes of the scene. */
static void find_bones(struct overlay *overlay)
{
	const struct model *model = overlay->subject.instance->model;

	for (int s = 0; s < model->skin_count; s++) {
		for (int j = 0; j < model->skin[s].joint_count; j++) {
			overlay->is_bone[model->skin[s].joint[j]] = 1;
		}
	}
	for (int n = 0; model->skin_count == 0 && n < model->node_count; n++) {
		overlay->is_bone[n] = model->node[n].in_scene;
	}
}

static int target_count(const struct model *model)
{
	int count = 0;

	for (int m = 0; m < model->mesh_count; m++) {
		if (model->mesh[m].target_count > count) {
			count = model->mesh[m].target_count;
		}
	}
	return count;
}

static bool can_choose(const struct overlay *overlay, int item)
{
	return overlay->chooses_target || overlay->is_bone[item];
}

static int item_count(const struct overlay *overlay)
{
	return overlay->chooses_target
		? overlay->target_count
		: overlay->subject.instance->model->node_count;
}

void overlay_choose(struct overlay *overlay, int step)
{
	int count = item_count(overlay);
	int item = overlay->chosen;

	for (int tried = 0; tried < count; tried++) {
		item = (item + step + count) % count;
		if (can_choose(overlay, item)) {
			overlay->chosen = item;
			return;
		}
	}
}

static const char *name_of(const struct overlay *overlay, int item)
{
	const struct model *model = overlay->subject.instance->model;

	if (!overlay->chooses_target) {
		return model->node[item].name;
	}
	for (int m = 0; m < model->mesh_count; m++) {
		if (item < model->mesh[m].target_count) {
			return model->mesh[m].target_name[item];
		}
	}
	return "";
}

const char *overlay_chosen_name(
	const struct overlay *overlay, char number[HUD_NAME_BYTES])
{
	if (item_count(overlay) == 0) {
		return "none";
	}
	return hud_name(name_of(overlay, overlay->chosen),
		overlay->chooses_target ? "target" : "node", overlay->chosen,
		number);
}

/*
 * Adds up how much each joint shares vertices with other joints: w (1 - w) for
 * each weight w. Rigid parts count by their vertices.
 */
static void sum_sharing(const struct overlay *overlay, float *sum)
{
	const struct instance *instance = overlay->subject.instance;

	for (int d = 0; d < instance->drawable_count; d++) {
		const struct drawable *drawable = &instance->drawable[d];
		const struct model_primitive *primitive = drawable->primitive;
		int count = primitive->vertex_count * primitive->influences;

		if (drawable->skin < 0) {
			sum[drawable->node] += (float)primitive->vertex_count;
			continue;
		}
		for (int i = 0; i < count; i++) {
			float w = primitive->weight[i];

			sum[instance->model->skin[drawable->skin]
					.joint[primitive->joint[i]]] +=
				w * (1.0f - w);
		}
	}
}

/* Chooses the joint that shares the most vertices. */
static void choose_most_shared(struct overlay *overlay)
{
	const struct model *model = overlay->subject.instance->model;
	float *sum = overlay->node_value;
	int most = -1;

	overlay->chosen = 0;
	if (overlay->chooses_target) {
		return;
	}
	sum_sharing(overlay, sum);
	for (int n = 0; n < model->node_count; n++) {
		if (overlay->is_bone[n] && (most < 0 || sum[n] > sum[most])) {
			most = n;
		}
	}
	overlay->chosen = most < 0 ? 0 : most;
}

static void add_names(struct name_choice *names, const void *context)
{
	const struct overlay *overlay = context;
	int count = item_count(overlay);

	for (int item = 0; item < count; item++) {
		if (can_choose(overlay, item) && name_of(overlay, item)[0]) {
			name_choice_add(names, name_of(overlay, item));
		}
	}
}

static int choose_named(struct overlay *overlay, const char *name)
{
	struct name_choice names = {.wanted = name};
	int count = item_count(overlay);

	for (int item = 0; item < count; item++) {
		if (can_choose(overlay, item) &&
			strcmp(name_of(overlay, item), name) == 0) {
			overlay->chosen = item;
			return 0;
		}
	}
	name_choice_list(&names, add_names, overlay);
	log_error(&overlay->log,
		"--show weights:%s: %s has no %s of that name: %s%s", name,
		overlay->subject.instance->model->path,
		overlay->chooses_target ? "morph target" : "joint or part",
		names.list.text[0] ? "give one of " : "none has a name",
		names.list.text);
	return -EINVAL;
}

static int widest_channel(const struct model *model)
{
	int width = 4;

	for (int c = 0; c < model->clip_count; c++) {
		for (int i = 0; i < model->clip[c].channel_count; i++) {
			int own = model->clip[c].channel[i].width;

			width = own > width ? own : width;
		}
	}
	return width;
}

static int take_memory(struct overlay *overlay)
{
	struct instance *instance = overlay->subject.instance;
	const struct model *model = instance->model;
	struct arena *arena = &overlay->arena;
	size_t nodes = (size_t)model->node_count;

	overlay->is_bone = ARENA_ARRAY(arena, uint8_t, nodes);
	overlay->node_value = ARENA_ARRAY(arena, float, nodes);
	overlay->sample =
		ARENA_ARRAY(arena, float, (size_t)widest_channel(model));
	if (!overlay->is_bone || !overlay->node_value || !overlay->sample ||
		overlay_heat_init(&overlay->heat, instance, arena) != 0) {
		return memory_budget_fail(
			arena->budget, model->path, &overlay->log);
	}
	overlay->target_count = target_count(model);
	overlay->chooses_target =
		model->skin_count == 0 && overlay->target_count > 0;
	return overlay_ghost_init(&overlay->ghost, instance,
		overlay->chooses_target, &overlay->log);
}

static int choose_first(struct overlay *overlay, const char *joint)
{
	find_bones(overlay);
	overlay->painted_choice = -1;
	choose_most_shared(overlay);
	return joint[0] ? choose_named(overlay, joint) : 0;
}

int overlay_create(const struct overlay_subject *subject, const struct gl *gl,
	const struct overlay_choice *choice, const struct log *log,
	struct overlay **out)
{
	struct overlay *overlay = calloc(1, sizeof(*overlay));
	int error;

	if (!overlay) {
		log_error(log, "there is not enough memory for the overlays");
		return -ENOMEM;
	}
	overlay->gl = gl;
	overlay->log = *log;
	overlay->subject = *subject;
	overlay->kinds = choice->kinds;
	overlay->arena = arena_within(subject->instance->model->budget);
	error = take_memory(overlay);
	if (!error) {
		error = choose_first(overlay, choice->joint);
	}
	if (error) {
		overlay_destroy(overlay);
		return error;
	}
	*out = overlay;
	return 0;
}

void overlay_destroy(struct overlay *overlay)
{
	if (overlay) {
		overlay_ghost_finish(&overlay->ghost);
		arena_release(&overlay->arena);
		free(overlay);
	}
}

/* Returns true if an overlay has anything to show for this motion. */
static bool applies(const struct overlay *overlay, enum overlay_kind kind,
	const struct overlay_motion *motion)
{
	const struct model *model = overlay->subject.instance->model;

	switch (kind) {
	case OVERLAY_SKELETON:
		return model->node_count > 1;
	case OVERLAY_WEIGHTS:
		return model->skin_count > 0 || overlay->chooses_target ||
			model->node_count > 1;
	case OVERLAY_KEYS:
		return motion->clip >= 0 || overlay->chooses_target;
	case OVERLAY_CURVE:
		return motion->clip >= 0 || motion->morphing;
	case OVERLAY_LAYERS:
		return motion->layer_count > 0;
	default:
		return true;
	}
}

void overlay_show_next(
	struct overlay *overlay, const struct overlay_motion *motion)
{
	int kind = 0;

	while (kind < OVERLAY_KINDS && !(overlay->kinds >> kind & 1)) {
		kind++;
	}
	kind = overlay->kinds ? kind + 1 : 0;
	while (kind < OVERLAY_KINDS &&
		!applies(overlay, (enum overlay_kind)kind, motion)) {
		kind++;
	}
	overlay->kinds = kind < OVERLAY_KINDS ? 1U << kind : 0;
}
