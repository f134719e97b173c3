/*
 * The viewer shows any model, which behaves as its character file says or as
 * `limber character` would write it (behaviour.h).
 */
#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "app/demo/demo_overlay.h"
#include "app/demo/viewer/behaviour.h"
#include "app/demo/viewer/behaviour_label.h"
#include "platform/base/file.h"

static const double check_s = 1.0; /* between checks of the file */

/* Watches the model's file for changes, once a second. */
struct file_watch {
	struct demo_env env; /* to reload the model with */
	uint64_t shown;      /* the stamp of the file last loaded or tried */
	uint64_t last;       /* the stamp at the last check */
	double next_s;
	bool broken; /* the file as it is now cannot be loaded */
};

struct demo {
	struct demo_base base;
	struct behaviour *behaviour;
	double now_s;
	struct file_watch watch;
};

/* The stamps of all files that are shown. */
static uint64_t stamp_files(const struct demo *demo)
{
	uint64_t model = file_stamp(demo->watch.env.model_path);

	return model == 0
		? 0
		: model ^ behaviour_stamp(&demo->watch.env, demo->behaviour);
}

static int viewer_prepare(struct demo *demo, const struct demo_env *env)
{
	int error = behaviour_create(env, &demo->base.actor, &demo->behaviour);

	if (error) {
		return error;
	}
	demo->watch.env = *env;
	demo->watch.shown = demo->watch.last = stamp_files(demo);
	return behaviour_init_stage(
		demo->behaviour, &demo->base, env, &demo->base.stage);
}

static void viewer_finish(struct demo *demo)
{
	behaviour_destroy(demo->behaviour);
}

/* The camera stays unless the model's size has changed by a quarter. */
static void reframe(struct demo *demo, float old_extent)
{
	struct stage *stage = &demo->base.stage;
	float ratio = demo->base.actor.extent / old_extent;
	struct stage fresh;

	if (ratio > 0.8f && ratio < 1.25f) {
		return;
	}
	if (behaviour_init_stage(demo->behaviour, &demo->base, &demo->watch.env,
		    &fresh) == 0) {
		stage_finish(stage, demo->base.gl);
		*stage = fresh;
	}
}

/*
 * Replaces the model and goes on with the same state; if the new one cannot be
 * loaded, the old one stays.
 */
static int reload(struct demo *demo)
{
	struct demo_env env = demo->watch.env;
	struct actor old = demo->base.actor, fresh;
	struct behaviour *before = demo->behaviour, *after;
	int error = actor_load(&fresh, &env);

	if (error) {
		return error;
	}
	if (env.clip && model_find_clip(fresh.model, env.clip) < 0) {
		env.clip = fresh.model->clip_count > 0 ? "0" : NULL;
	}
	behaviour_suspend(before);
	error = behaviour_create(&env, &fresh, &after);
	if (error) {
		behaviour_resume(before, env.log);
		actor_unload(&fresh, env.gl);
		return error;
	}
	character_go_on(after->character, before->character);
	demo->base.actor = fresh;
	demo->behaviour = after;
	reframe(demo, old.extent);
	demo_overlay_release(&demo->base);
	behaviour_destroy(before);
	actor_unload(&old, env.gl);
	return 0;
}

/* The stamp of a file that is still being written changes until the next check. */
static void check_file(struct demo *demo)
{
	struct file_watch *watch = &demo->watch;
	uint64_t stamp;
	bool settled;

	if (!watch->env.follow_file || demo->now_s < watch->next_s) {
		return;
	}
	watch->next_s = demo->now_s + check_s;
	stamp = stamp_files(demo);
	settled = stamp == watch->last;
	watch->last = stamp;
	if (stamp != 0 && settled && stamp != watch->shown) {
		watch->shown = stamp;
		watch->broken = reload(demo) != 0;
	}
}

static void viewer_update(struct demo *demo, double time_s)
{
	demo->now_s = time_s;
	check_file(demo);
	behaviour_update(demo->behaviour, &demo->base, time_s);
}

static void viewer_draw(struct demo *demo, int width, int height)
{
	behaviour_scene_draw(&demo->behaviour->scene, demo->behaviour->character,
		&demo->behaviour->bounds, &demo->base, width, height);
}

static double viewer_period_s(const struct demo *demo)
{
	return behaviour_period_s(demo->behaviour);
}

static void viewer_label(const struct demo *demo, struct hud *hud)
{
	struct hud_group group;

	behaviour_label_all(demo->behaviour->character, demo->behaviour->title,
		&demo->base.actor, hud);
	if (demo->watch.broken) {
		group = hud_group_begin(hud, HUD_BOTTOM_LEFT, NULL);
		hud_group_mark(&group, "new file is broken", "", hud_color_rose);
		hud_group_end(&group);
	}
}

static void viewer_get_motion(
	const struct demo *demo, struct overlay_motion *out)
{
	behaviour_get_motion(demo->behaviour, demo->base.actor.model, out);
}

static void viewer_press(struct demo *demo, const struct button_event *event)
{
	character_press(demo->behaviour->character, event);
}

static void viewer_print_buttons(const struct demo *demo, FILE *out)
{
	character_print_buttons(demo->behaviour->character, out);
}

/* The members that are the same for a model and for demos that are data. */
#define VIEWER_FUNCTIONS                                                \
	.size = sizeof(struct demo), .prepare = viewer_prepare,         \
	.finish = viewer_finish, .press = viewer_press,                 \
	.print_buttons = viewer_print_buttons, .update = viewer_update, \
	.draw = viewer_draw, .period_s = viewer_period_s,               \
	.label = viewer_label, .get_motion = viewer_get_motion

const struct demo_driver demo_driver_viewer = {
	.name = "viewer",
	.summary = "any model and its clips",
	VIEWER_FUNCTIONS,
};

/* assets/walker.character says what it does. */
const struct demo_driver demo_driver_walker = {
	.name = "walker",
	.summary = "skeletal: a figure that idles, walks, runs, waves, jumps",
	.asset = "walker.glb",
	VIEWER_FUNCTIONS,
};

/* assets/face.character says what it does. */
const struct demo_driver demo_driver_face = {
	.name = "face",
	.summary = "morphing: a head that changes its expression",
	.asset = "face.glb",
	VIEWER_FUNCTIONS,
};

/* assets/arm.character says what it does. */
const struct demo_driver demo_driver_arm = {
	.name = "arm",
	.summary = "hierarchical: a robot arm on pivots that loads a truck",
	.asset = "arm.glb",
	VIEWER_FUNCTIONS,
};
