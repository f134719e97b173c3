#include "app/demo/demo.h"

#include "app/demo/actor.h"
#include "app/demo/demo_overlay.h"
#include "platform/base/interrupt.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

extern const struct demo_driver demo_driver_walker;
extern const struct demo_driver demo_driver_arm;
extern const struct demo_driver demo_driver_face;
extern const struct demo_driver demo_driver_crowd;
extern const struct demo_driver demo_driver_duel;
extern const struct demo_driver demo_driver_tuner;

const struct demo_driver *const demo_registry[] = {
	&demo_driver_walker,
	&demo_driver_arm,
	&demo_driver_face,
	&demo_driver_crowd,
	&demo_driver_duel,
	&demo_driver_tuner,
	NULL,
};

const struct demo_driver *demo_find(const char *name)
{
	for (int i = 0; demo_registry[i]; i++) {
		if (strcmp(demo_registry[i]->name, name) == 0) {
			return demo_registry[i];
		}
	}
	return NULL;
}

/* Every demo's struct begins with a struct demo_base. */
static struct demo_base *base_of(struct demo *demo)
{
	return (struct demo_base *)demo;
}

int demo_create(const struct demo_driver *driver, const struct demo_env *env,
	struct demo **out)
{
	struct demo *demo = calloc(1, driver->size);
	int error = -ENOMEM;

	if (!demo) {
		log_error(env->log,
			"%s: there is not enough memory for the demo",
			driver->name);
		return error;
	}
	base_of(demo)->gl = env->gl;
	base_of(demo)->width = env->width;
	base_of(demo)->height = env->height;
	base_of(demo)->log = *env->log;
	error = actor_load(&base_of(demo)->actor, env);
	if (!error) {
		error = driver->prepare(demo, env);
	}
	if (!error) {
		error = live_init(&base_of(demo)->live, env->camera,
			env->camera_use, env->smooth, env->gl, env->log);
		live_set_stage(&base_of(demo)->live, &base_of(demo)->stage,
			(float)env->width / (float)env->height);
	}
	if (!error && env->overlays.kinds) {
		error = demo_overlay_make(driver, demo, &env->overlays);
	}
	if (interrupt_pending()) {
		error = -EINTR;
	}
	if (error) {
		demo_destroy(driver, demo);
		return error;
	}
	*out = demo;
	return 0;
}

void demo_destroy(const struct demo_driver *driver, struct demo *demo)
{
	if (demo) {
		struct demo_base *base = base_of(demo);

		overlay_destroy(base->overlay);
		if (driver->finish) {
			driver->finish(demo);
		}
		live_finish(&base->live, base->gl);
		stage_finish(&base->stage, base->gl);
		actor_unload(&base->actor, base->gl);
		free(demo);
	}
}

void demo_update_live(struct demo *demo, double time_s, int width, int height)
{
	struct demo_base *base = base_of(demo);

	live_update(&base->live, base->gl, &base->stage, time_s, width, height);
}

/* In a small picture, the overlays' labels replace the demo's. */
void demo_label(const struct demo_driver *driver, const struct demo *demo,
	struct hud *hud)
{
	const struct demo_base *base = (const struct demo_base *)demo;
	struct hud_mark before;

	if (base->overlay) {
		overlay_reserve_row(base->overlay, hud);
	}
	before = hud_mark(hud);
	driver->label(demo, hud);
	live_label(&base->live, hud);
	if (base->overlay && base->overlay->kinds &&
		!demo_overlay_label(driver, demo, base->overlay, hud)) {
		hud_go_back(hud, &before);
		(void)demo_overlay_label(driver, demo, base->overlay, hud);
	}
}

void demo_set_reduction(
	struct demo *demo, const struct demo_reduction *reduction)
{
	struct demo_base *base = base_of(demo);

	base->reduction = *reduction;
	actor_reduce(base);
}

void demo_set_rate(struct demo *demo, float frames_per_s)
{
	base_of(demo)->frames_per_s = frames_per_s;
}

/* Returns the amount of a button that does the same and is still held, or 0. */
static int amount_held(const struct demo_driver *driver, unsigned held,
	const struct demo_action *released)
{
	const struct demo_action *action = driver->action;

	while (action->summary &&
		!(action->held && action->run == released->run &&
			(held >> action->button & 1))) {
		action++;
	}
	return action->summary ? action->amount : 0;
}

static void run_action(
	struct demo *demo, const struct demo_action *action, int amount)
{
	if (action->run) {
		action->run(demo, amount);
	} else {
		bool *inverted = (bool *)((char *)demo + action->inverts);

		*inverted = !*inverted;
	}
}

void demo_press(const struct demo_driver *driver, struct demo *demo,
	const struct button_event *event)
{
	struct demo_base *base = base_of(demo);
	unsigned bit = 1u << event->button;

	if (driver->press) {
		driver->press(demo, event);
		return;
	}
	base->held = event->down ? base->held | bit : base->held & ~bit;
	for (const struct demo_action *action = driver->action; action->summary;
		action++) {
		if (action->button == event->button &&
			(event->down || action->held)) {
			run_action(demo, action,
				event->down ? action->amount
					    : amount_held(driver, base->held,
						      action));
		}
	}
}

void demo_next_camera_use(struct demo *demo)
{
	struct live *live = &base_of(demo)->live;

	if (live->feed) {
		live_next_use(live);
	}
}
